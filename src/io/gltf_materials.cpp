#include "io/gltf_materials.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/uri.h"

namespace blysk::io::gltf {
namespace {

float unit(double value) { return value > 0 ? static_cast<float>(std::min(value, 1.0)) : 0.0f; }

Vec3f color_of(std::span<const double> values) { return {unit(values[0]), unit(values[1]), unit(values[2])}; }

// What pbrMetallicRoughness says of a surface besides its opacity.
struct Surface {
  Vec3f base{1, 1, 1};
  float metallic = 1;
  float roughness = 1;
};

// From metal and roughness to diffuse, specular and exponent.
//
// A microfacet lobe of width alpha = roughness^2 has the shape of a Blinn lobe with n = 2 / alpha^2 - 2, and,
// to reflect the same light, a peak of F0 * (n + 2) / 8 relative to a white diffuse surface. Highlights of
// smooth surfaces then exceed what a picture can show and those of rough metals glare, so the peak is cut at
// kBrightest. Metals have no diffuse light but mirror their surroundings, which are not drawn: half of their
// colour stands for that.
void set_surface(Material& material, const Surface& s) {
  constexpr float kDielectric = 0.04f;  // reflectance of glass, plastic, paint
  constexpr float kBrightest = 0.8f;
  constexpr float kMetalDiffuse = 0.5f;
  const float alpha = std::max(s.roughness * s.roughness, 1e-3f);
  const float n = std::clamp(2 / (alpha * alpha) - 2, 1.0f, 1000.0f);
  const auto f0 = [&](float base) { return kDielectric + (base - kDielectric) * s.metallic; };
  const Vec3f peak = Vec3f{f0(s.base.x), f0(s.base.y), f0(s.base.z)} * ((n + 2) / 8);
  const float brightest = std::max({peak.x, peak.y, peak.z});
  material.specular = peak * (brightest > kBrightest ? kBrightest / brightest : 1.0f);
  material.shininess = n;
  material.color = s.base * (1 - s.metallic * (1 - kMetalDiffuse));
}

// Texture indices to those of Scene::textures, where each image stands once. What many materials share is
// looked at once, so that time stays in proportion to the file's size.
class Textures {
 public:
  Textures(Context& context, Json root, Buffers& buffers, Scene& scene)
      : context_(context),
        buffers_(buffers),
        scene_(scene),
        textures_(context.list(root, "textures")),
        images_(context.list(root, "images")),
        by_texture_(textures_.size()),
        by_image_(images_.size()) {}

  /// The texture that a material's member names.
  int read(Json owner, std::string_view name) {
    const Json info = context_.object(owner, name);
    if (!info) return Material::kNoTexture;
    context_.require(info, "index");
    const int texture = context_.index(info, "index", textures_.size(), "texture");
    if (texture == kNone) return Material::kNoTexture;
    std::optional<int>& known = by_texture_[static_cast<std::size_t>(texture)];
    if (!known) known = read_texture(textures_[static_cast<std::size_t>(texture)]);
    return *known;
  }

 private:
  int read_texture(Json texture) {
    // Without a source the image is in a format that an extension adds.
    const int image = context_.index(texture, "source", images_.size(), "image");
    if (image == kNone) return Material::kNoTexture;
    std::optional<int>& known = by_image_[static_cast<std::size_t>(image)];
    if (!known) {
      TextureReference reference = read_image(images_[static_cast<std::size_t>(image)]);
      if (context_.failed()) return Material::kNoTexture;
      known = static_cast<int>(scene_.textures.size());
      scene_.textures.push_back(std::move(reference));
    }
    return *known;
  }

  TextureReference read_image(Json image) {
    TextureReference reference;
    reference.name = image["name"].text();
    reference.mime_type = context_.text(image, "mimeType");
    const std::string_view uri = context_.text(image, "uri");
    const int view = context_.index(image, "bufferView", buffers_.views(), "buffer view");
    if (view != kNone) {
      const std::span<const std::byte> bytes = buffers_.bytes(view);
      if (!context_.allow(bytes.size(), image)) return reference;
      reference.bytes.resize(bytes.size());
      if (!bytes.empty()) std::memcpy(reference.bytes.data(), bytes.data(), bytes.size());
    } else if (is_data_uri(uri)) {
      if (!context_.allow(data_uri_bound(uri), image)) return reference;
      Result<DataUri> data = decode_data_uri(uri);
      if (!data) {
        context_.fail(image["uri"], data.error().message);
        return reference;
      }
      reference.bytes = std::move(data->bytes);
      if (reference.mime_type.empty()) reference.mime_type = std::move(data->mime_type);
    } else {
      reference.uri = uri;
    }
    return reference;
  }

  Context& context_;
  Buffers& buffers_;
  Scene& scene_;
  std::vector<Json> textures_, images_;
  std::vector<std::optional<int>> by_texture_, by_image_;
};

AlphaMode read_alpha_mode(Context& context, Json json) {
  const std::string_view mode = context.text(json, "alphaMode");
  if (mode == "MASK") return AlphaMode::mask;
  if (mode == "BLEND") return AlphaMode::blend;
  if (!mode.empty() && mode != "OPAQUE") {
    context.problem(json["alphaMode"],
                    in_quotes(mode) + " is none of OPAQUE, MASK, BLEND and was taken as OPAQUE");
  }
  return AlphaMode::opaque;
}

Material read_material(Context& context, Json json, Textures& textures) {
  Material material;
  material.name = json["name"].text();
  const Json pbr = context.object(json, "pbrMetallicRoughness");
  std::array<double, 4> base{1, 1, 1, 1};
  context.numbers(pbr, "baseColorFactor", base);
  Surface surface{color_of(base), unit(context.number(pbr, "metallicFactor", 1)),
                  unit(context.number(pbr, "roughnessFactor", 1))};
  // The factors only scale the texture. As pictures are not read here, it counts as half of everything.
  if (pbr["metallicRoughnessTexture"]) {
    surface.metallic *= 0.5f;
    surface.roughness *= 0.5f;
  }
  set_surface(material, surface);
  material.color_texture = textures.read(pbr, "baseColorTexture");
  material.normal_texture = textures.read(json, "normalTexture");

  // Likewise the emissive texture: it is mostly black, so its factor alone would make the whole surface glow.
  std::array<double, 3> emissive{0, 0, 0};
  context.numbers(json, "emissiveFactor", emissive);
  if (!json["emissiveTexture"]) material.emission = color_of(emissive);

  material.alpha_mode = read_alpha_mode(context, json);
  material.alpha_cutoff = unit(context.number(json, "alphaCutoff", 0.5));
  material.opacity = material.alpha_mode == AlphaMode::opaque ? 1 : unit(base[3]);
  material.double_sided = context.flag(json, "doubleSided", false);
  material.unlit = static_cast<bool>(extension(context, json, "KHR_materials_unlit"));
  if (material.unlit) {
    material.color = surface.base;
    material.specular = {0, 0, 0};
  }
  return material;
}

}  // namespace

void read_materials(Context& context, Json root, Buffers& buffers, Scene& scene) {
  if (context.failed()) return;
  Textures textures(context, root, buffers, scene);
  for (const Json& json : context.list(root, "materials")) {
    scene.materials.push_back(read_material(context, json, textures));
    if (context.failed()) return;
  }
}

Material default_material() {
  Material material;
  set_surface(material, {});
  material.double_sided = false;
  return material;
}

}  // namespace blysk::io::gltf
