// Inputs that once broke a reader: tests/incidents/NAME/input.FORMAT. Each loads, or says why not.
#include <filesystem>

#include "io/testing.h"

namespace blysk::io {
namespace {

TEST(incidents, none_comes_back) {
  std::size_t inputs = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(BLYSK_INCIDENTS)) {
    if (!entry.is_regular_file() || entry.path().stem() != "input") continue;
    SCOPED_TRACE(entry.path().string());
    ++inputs;
    Result<Scene> scene = load_model(entry.path().string());
    if (!scene) {
      EXPECT_NE(scene.error().code, ErrorCode::internal);
      EXPECT_FALSE(scene.error().message.empty());
      continue;
    }
    for (Mesh& mesh : scene->meshes) {
      expect_sound(mesh);
      make_normals(mesh, 30);
      expect_sound(mesh);
    }
  }
  EXPECT_GT(inputs, 0u);
}

}  // namespace
}  // namespace blysk::io
