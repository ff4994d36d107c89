// Golden pictures: scenes that `blysk verify` does not reach, by their hashes in hashes.txt.
//
// When pictures change on purpose: look at those that a failing run writes, then run the tests once more with
// BLYSK_BLESS=1 in the environment and commit hashes.txt.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "blysk/shapes.h"
#include "render/testing.h"

namespace blysk {
namespace {

const std::string kHashes = BLYSK_GOLDEN "/hashes.txt";
const std::filesystem::path kPictures = BLYSK_GOLDEN_OUT;

struct Golden {
  std::string name;
  Scene scene;
  RenderOptions options;
};

Scene shape_scene(const char* text) { return std::move(*make_shape(text)); }

Camera camera_at(Vec3d eye, Vec3d target, double fov_deg) {
  Camera c;
  c.eye = eye;
  c.target = target;
  c.fov_deg = fov_deg;
  return c;
}

Light lamp(Light::Kind kind, Vec3d vector, Vec3f color) {
  Light light;
  light.kind = kind;
  light.vector = vector;
  light.color = color;
  return light;
}

// Loose triangles around the origin, every corner with a colour and a normal of its own.
Scene confetti(std::uint64_t seed, int count, float size) {
  Random random(seed);
  const auto vector = [&] {
    const float x = random.signed_unit(), y = random.signed_unit(), z = random.signed_unit();
    return Vec3f{x, y, z};
  };
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3f middle = vector();
    for (int k = 0; k < 3; ++k) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(middle + vector() * size);
      mesh.normals.push_back(to_float(normalize(to_double(vector()))));
      const Vec3f c = vector();
      mesh.colors.push_back({c.x * c.x, c.y * c.y, c.z * c.z, 1});
    }
  }
  Material m;
  m.color = {1, 1, 1};
  return scene_of(std::move(mesh), m);
}

// Thin triangles around one corner.
Scene fan(int blades) {
  Mesh mesh;
  mesh.positions.push_back({0.02f, 0.01f, 0});
  mesh.colors.push_back({1, 1, 1, 1});
  for (int i = 0; i <= blades; ++i) {
    // A square's border, walked around once.
    const float t = 4.0f * static_cast<float>(i) / static_cast<float>(blades), along = t - std::floor(t);
    const int side = static_cast<int>(t) % 4;
    const float a = 2 * along - 1, x[4] = {a, 1, -a, -1}, y[4] = {-1, a, 1, -a};
    mesh.positions.push_back({x[side], y[side], i % 2 == 0 ? 0.1f : -0.1f});
    mesh.colors.push_back({i % 3 == 0 ? 1.0f : 0.2f, i % 3 == 1 ? 1.0f : 0.2f, i % 3 == 2 ? 1.0f : 0.2f, 1});
    if (i > 0) {
      const auto last = static_cast<std::uint32_t>(i + 1);
      mesh.indices.insert(mesh.indices.end(), {0, last - 1, last});
    }
  }
  return scene_of(std::move(mesh));
}

// One shape five times: moved, turned, stretched, mirrored, another material each.
Scene crowd(const char* text) {
  Scene one = shape_scene(text), all;
  all.meshes = one.meshes;
  for (int i = 0; i < 5; ++i) {
    Material m;
    m.color = {0.2f + 0.15f * static_cast<float>(i), 0.5f, 0.9f - 0.15f * static_cast<float>(i)};
    m.specular = {0.1f * static_cast<float>(i), 0.2f, 0.3f};
    m.shininess = i == 0 ? 1.0f : i == 1 ? 7.5f : 20.0f * static_cast<float>(i);
    m.double_sided = i % 2 == 0;
    m.emission = i == 3 ? Vec3f{0.1f, 0, 0.2f} : Vec3f{};
    m.unlit = i == 4;
    all.materials.push_back(m);
    const double s = 0.5 + 0.1 * i;
    Instance instance;
    instance.material = static_cast<std::uint32_t>(i);
    instance.transform = translation({i - 2.0, 0.3 * i - 0.6, -0.4 * i}) * rotation({0, 1, 0}, 0.7 * i) *
                         scaling({i % 2 == 1 ? -s : s, s * (1 + 0.5 * i), s});
    all.instances.push_back(instance);
  }
  return all;
}

std::vector<Golden> golden_pictures() {
  using Kind = Light::Kind;
  std::vector<Golden> all;
  const auto add = [&](const char* name, Scene scene, const Camera& camera) -> RenderOptions& {
    RenderOptions o;
    o.antialias = "none";
    o.width = 217;
    o.height = 161;
    o.camera = camera;
    o.lights = {lamp(Kind::directional, {1, 2, 1.5}, {0.8f, 0.8f, 0.75f})};
    o.ambient = 0.2f;
    all.push_back({name, std::move(scene), o});
    return all.back().options;
  };
  add("crowd", crowd("teapot?detail=5"), camera_at({0.5, 1.5, 6}, {0, 0, -0.5}, 45))
      .lights.push_back(lamp(Kind::point, {0, 1, 2}, {0.5f, 0.3f, 0.3f}));
  {
    Camera camera = camera_at({3, 2, 4}, {0, 0, 0}, 45);
    camera.height = 4;
    add("crowd-culled", crowd("cube?detail=3"), camera).cull = Cull::back;
  }
  {
    Scene scene = shape_scene("torus?detail=30");
    scene.meshes[0].normals.clear();
    add("no-normals", scene, camera_at({1, 2, 2}, {0, 0, 0}, 45)).lights = {
        lamp(Kind::point, {0, 2, 1}, {1, 1, 1})};
  }
  add("colors", confetti(1, 60, 0.8f), camera_at({2, 1, 4}, {0, 0, 0}, 40));
  add("colors-screen", confetti(1, 60, 0.8f), camera_at({2, 1, 4}, {0, 0, 0}, 40)).interpolation =
      Interpolation::screen;
  {
    RenderOptions& o =
        add("colors-from-inside", confetti(2, 80, 1.5f), camera_at({0.1, 0.2, 0.1}, {1, 0, 0.5}, 120));
    o.camera->near_distance = 0.01;
    o.camera->far_distance = 10;
  }
  {
    Scene scene = shape_scene("cube");
    scene.instances[0].transform = scaling({300, 300, 300});
    RenderOptions& o = add("guard-band", scene, camera_at({0.3, 1, 0}, {300, 60, -300}, 1));
    o.cull = Cull::none;  // from inside
    o.camera->near_distance = 0.5;
    o.camera->far_distance = 1000;
  }
  {
    RenderOptions& o = add("dots", shape_scene("trefoil?detail=1200"), camera_at({0, 2, 3.2}, {0, 0, 0}, 40));
    o.transfer = Transfer::none;
    o.lighting = "phong";
  }
  {
    RenderOptions& o = add("lambert", shape_scene("icosphere?detail=5"), camera_at({0, 1, 3}, {0, 0, 0}, 45));
    o.lighting = "lambert";
    o.lights.clear();
    for (int i = 0; i < 16; ++i) {
      o.lights.push_back(lamp(
          i % 3 == 0 ? Kind::point : Kind::directional, {2.0 - 0.3 * i, 1 + 0.1 * i, 3.0 - i * 0.2},
          {0.02f + 0.01f * static_cast<float>(i % 5), 0.06f, 0.09f - 0.01f * static_cast<float>(i % 4)}));
    }
  }
  add("near-plane", shape_scene("terrain?detail=60"), camera_at({0, 0.3, 0.8}, {0, 0.1, -1}, 100));
  add("slivers", fan(700), camera_at({0, 0, 3}, {0, 0, 0}, 40));
  {
    Scene scene = shape_scene("sphere?detail=40");
    scene.materials[0].shininess = 123.4f;
    scene.materials[0].specular = {0.9f, 0.8f, 0.7f};
    RenderOptions& o = add("highlight", scene, camera_at({0, 0, 3}, {0, 0, 0}, 45));
    o.lighting = "phong";
    o.background = {0.1f, 0.2f, 0.3f, 0.5f};
  }
  // With sixteen samples: edges, slivers, what is behind what, and glass of every kind.
  for (std::size_t i = 0, count = all.size(); i < count; ++i) {
    Golden g = all[i];
    g.name += "-sampled";
    g.options.antialias = "abuffer";
    all.push_back(std::move(g));
  }
  for (const float alpha : {1.0f, 0.0f}) {
    Scene scene = crowd("teapot?detail=5");
    scene.append(fan(40));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      scene.materials[i].opacity = 0.25f + 0.15f * static_cast<float>(i);
      scene.materials[i].alpha_mode = i == 1   ? AlphaMode::opaque
                                      : i == 2 ? AlphaMode::mask
                                               : AlphaMode::blend;
    }
    RenderOptions& o =
        add(alpha > 0 ? "glass" : "glass-alone", scene, camera_at({0.5, 1.5, 6}, {0, 0, -0.5}, 45));
    o.antialias = "abuffer";
    o.background = {0.1f, 0.4f, 0.3f, alpha};
    o.lights.push_back(lamp(Kind::point, {0, 1, 2}, {0.5f, 0.3f, 0.3f}));
  }
  return all;
}

std::map<std::string, std::string> read_hashes() {
  std::map<std::string, std::string> hashes;
  std::ifstream file(kHashes);
  for (std::string name, hash; file >> name >> hash;) hashes[name] = hash;
  return hashes;
}

template <class T>
std::string hash_of(const Array<T>& values) {
  return sha256(std::span(reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)));
}

// The hashes of this run beside those that are known.
class Ledger {
 public:
  /// Whether the hash is the known one; if not, and this run does not bless, the test fails.
  bool enter(const std::string& name, const std::string& hash) {
    actual_[name] = hash;
    const auto known = expected_.find(name);
    if (known != expected_.end() && known->second == hash) return true;
    if (!blessing_) {
      ADD_FAILURE() << name << (known == expected_.end() ? " is new" : " has changed") << ": see "
                    << kPictures << "; if it is right, run this test with BLYSK_BLESS=1 and commit "
                    << kHashes;
    }
    return false;
  }

  void close() const {
    for (const auto& [name, hash] : expected_) {
      EXPECT_TRUE(blessing_ || actual_.contains(name))
          << name << " is in " << kHashes << ", but no such scene is";
    }
    if (!blessing_) return;
    std::ofstream file(kHashes, std::ios::trunc);
    for (const auto& [name, hash] : actual_) file << name << " " << hash << "\n";
  }

 private:
  std::map<std::string, std::string> expected_ = read_hashes(), actual_;
  bool blessing_ = std::getenv("BLYSK_BLESS") != nullptr;
};

TEST(golden, pictures_have_their_hashes) {
  Ledger ledger;
  std::filesystem::create_directories(kPictures);
  for (Golden& g : golden_pictures()) {
    for (const char* shading : {"phong", "gouraud", "flat"}) {
      g.options.shading = shading;
      const std::string name = g.name + "-" + shading;
      const Frame frame = render_frame(g.scene, g.options);
      EXPECT_GT(frame.statistics.pixels_covered, 3000u) << name;
      if (ledger.enter(name, sha256(frame.image))) continue;
      EXPECT_TRUE(write_picture(frame.image, kPictures / (name + ".png"), PictureFormat::png));
    }
    g.options.want_depth = g.options.want_normal = g.options.want_id = true;
    const Frame frame = render_frame(g.scene, g.options);
    if (!ledger.enter(g.name + "-depth", hash_of(frame.depth.values))) {
      EXPECT_TRUE(write_picture(frame.depth, kPictures / (g.name + "-depth.png"), PictureFormat::png));
    }
    if (!ledger.enter(g.name + "-normal", hash_of(frame.normal.values))) {
      EXPECT_TRUE(write_picture(frame.normal, kPictures / (g.name + "-normal.png"), PictureFormat::png));
    }
    ledger.enter(g.name + "-id", hash_of(frame.id));
  }
  ledger.close();
}

}  // namespace
}  // namespace blysk
