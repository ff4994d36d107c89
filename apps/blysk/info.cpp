// blysk info: what is in a model file.
#include "blysk/version.h"
#include "json.h"
#include "scene_options.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::uint64_t vertices(const Scene& scene) {
  std::uint64_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.positions.size();
  return count;
}

std::string_view kind_text(Light::Kind kind) { return kind == Light::Kind::point ? "point" : "directional"; }

std::string_view alpha_text(AlphaMode mode) {
  constexpr std::string_view kNames[] = {"opaque", "mask", "blend"};
  return kNames[static_cast<int>(mode)];
}

std::vector<std::string> attributes(const Mesh& mesh) {
  std::vector<std::string> names;
  if (!mesh.normals.empty()) names.emplace_back("normals");
  if (!mesh.colors.empty()) names.emplace_back("colors");
  if (!mesh.texcoords.empty()) names.emplace_back("texcoords");
  if (!mesh.texcoords1.empty()) names.emplace_back("texcoords1");
  if (!mesh.tangents.empty()) names.emplace_back("tangents");
  return names;
}

Json meshes_json(const Scene& scene) {
  Json rows = Json::array();
  for (const Mesh& mesh : scene.meshes) {
    rows.push_back({{"name", mesh.name},
                    {"triangles", mesh.triangles()},
                    {"vertices", mesh.positions.size()},
                    {"attributes", attributes(mesh)}});
  }
  return rows;
}

Json texture_index(int index) { return index == Material::kNoTexture ? Json(nullptr) : Json(index); }

Json materials_json(const Scene& scene) {
  Json rows = Json::array();
  for (const Material& material : scene.materials) {
    rows.push_back({{"name", material.name},
                    {"color", json_vector(material.color)},
                    {"specular", json_vector(material.specular)},
                    {"shininess", material.shininess},
                    {"emission", json_vector(material.emission)},
                    {"opacity", material.opacity},
                    {"alpha_mode", alpha_text(material.alpha_mode)},
                    {"double_sided", material.double_sided},
                    {"unlit", material.unlit},
                    {"color_texture", texture_index(material.color_texture)},
                    {"normal_texture", texture_index(material.normal_texture)}});
  }
  return rows;
}

Json textures_json(const Scene& scene) {
  Json rows = Json::array();
  for (const TextureReference& texture : scene.textures) {
    rows.push_back({{"name", texture.name},
                    {"uri", texture.uri},
                    {"embedded", texture.uri.empty()},
                    {"mime_type", texture.mime_type},
                    {"bytes", texture.bytes.size()}});
  }
  return rows;
}

Json lights_json(const Scene& scene) {
  Json rows = Json::array();
  for (const Light& light : scene.lights) {
    rows.push_back({{"name", light.name},
                    {"kind", kind_text(light.kind)},
                    {"vector", json_vector(light.vector)},
                    {"color", json_vector(light.color)}});
  }
  return rows;
}

Json cameras_json(const Scene& scene) {
  Json rows = Json::array();
  for (const Camera& camera : scene.cameras) {
    Json row = {{"name", camera.name},
                {"eye", json_vector(camera.eye)},
                {"target", json_vector(camera.target)},
                {"up", json_vector(camera.up)}};
    if (camera.height > 0) {
      row["height"] = camera.height;
    } else {
      row["fov_deg"] = camera.fov_deg;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json to_json(const Scene& scene, const std::string& input) {
  const Bounds bounds = scene.bounds();
  Json box = nullptr;
  if (!bounds.empty()) {
    box = {{"lo", json_vector(bounds.lo)},
           {"hi", json_vector(bounds.hi)},
           {"size", json_vector(bounds.hi - bounds.lo)}};
  }
  return {{"version", version()},
          {"input", input},
          {"triangles", scene.triangles()},
          {"vertices", vertices(scene)},
          {"instances", scene.instances.size()},
          {"bounds", std::move(box)},
          {"meshes", meshes_json(scene)},
          {"materials", materials_json(scene)},
          {"textures", textures_json(scene)},
          {"lights", lights_json(scene)},
          {"cameras", cameras_json(scene)},
          {"problems", scene.problems}};
}

std::string vector_text(Vec3d v) {
  return rounded_text(v.x) + "," + rounded_text(v.y) + "," + rounded_text(v.z);
}
std::string vector_text(Vec3f v) { return vector_text(to_double(v)); }

// What the rows of a section are counted by, then what they say.
template <class Items, class Row>
std::string section(std::string_view title, const Items& items, const Row& row_of) {
  if (items.empty()) return "";
  Rows rows;
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::vector<std::string> row = row_of(items[i]);
    row.insert(row.begin(), "  " + std::to_string(i));
    rows.push_back(std::move(row));
  }
  return std::string(title) + "\n" + table(rows);
}

std::string name_text(const std::string& name) { return name.empty() ? "(no name)" : printable(name); }

std::vector<std::string> material_row(const Material& material) {
  std::vector<std::string> row = {name_text(material.name), "color " + vector_text(material.color),
                                  "specular " + vector_text(material.specular),
                                  "shininess " + number_text(material.shininess)};
  std::vector<std::string> notes;
  if (material.alpha_mode != AlphaMode::opaque) {
    notes.push_back(std::string(alpha_text(material.alpha_mode)) + " " + number_text(material.opacity));
  }
  if (material.double_sided) notes.emplace_back("double-sided");
  if (material.unlit) notes.emplace_back("unlit");
  if (material.color_texture != Material::kNoTexture) {
    notes.push_back("texture " + std::to_string(material.color_texture));
  }
  row.push_back(join(notes, ", "));
  return row;
}

std::vector<std::string> camera_row(const Camera& camera) {
  return {name_text(camera.name), "eye " + vector_text(camera.eye), "target " + vector_text(camera.target),
          camera.height > 0 ? "orthographic " + number_text(camera.height)
                            : "fov " + number_text(camera.fov_deg)};
}

std::vector<std::string> texture_row(const TextureReference& texture) {
  if (!texture.uri.empty()) return {name_text(texture.name), printable(texture.uri)};
  return {name_text(texture.name),
          "embedded " + printable(texture.mime_type) + ", " + counted(texture.bytes.size(), "byte")};
}

std::string to_text(const Scene& scene, const std::string& input) {
  const Bounds bounds = scene.bounds();
  Rows rows = {{"model", printable(input)},
               {"triangles", count_text(scene.triangles())},
               {"vertices", count_text(vertices(scene))},
               {"meshes", count_text(scene.meshes.size())},
               {"instances", count_text(scene.instances.size())}};
  if (!bounds.empty()) {
    rows.push_back({"bounds", vector_text(bounds.lo) + " to " + vector_text(bounds.hi)});
    rows.push_back({"size", vector_text(bounds.hi - bounds.lo)});
  }
  return table(rows) +
         section("meshes", scene.meshes,
                 [](const Mesh& mesh) -> std::vector<std::string> {
                   return {name_text(mesh.name), counted(mesh.triangles(), "triangle"),
                           count_text(mesh.positions.size()) + " vertices", join(attributes(mesh), ", ")};
                 }) +
         section("materials", scene.materials, material_row) +
         section("textures", scene.textures, texture_row) +
         section("lights", scene.lights,
                 [](const Light& light) -> std::vector<std::string> {
                   return {name_text(light.name), std::string(kind_text(light.kind)),
                           vector_text(light.vector), "color " + vector_text(light.color)};
                 }) +
         section("cameras", scene.cameras, camera_row) +
         section("problems", scene.problems,
                 [](const std::string& problem) { return std::vector<std::string>{printable(problem)}; });
}

}  // namespace

Result<int> run_info(const Arguments& arguments) {
  const std::string& input = arguments.operands().front();
  const Result<Scene> scene = load_within_limits(input, true, arguments);
  if (!scene) return scene.error();
  const Status status =
      arguments.has("json") ? print_json(to_json(*scene, input)) : print(to_text(*scene, input));
  if (!status) return status.error();
  return 0;
}

}  // namespace blysk::command
