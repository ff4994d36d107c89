// blysk/render.h - from a Scene to an Image.
//
//   blysk::Renderer renderer({.threads = 2});
//   auto scene = blysk::load_model("teapot.obj");
//   auto frame = renderer.render(*scene, {.width = 640, .height = 480});
//   blysk::write_picture(frame->image, "teapot.png", blysk::PictureFormat::png);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/fragments.h"
#include "blysk/image.h"
#include "blysk/limits.h"
#include "blysk/result.h"
#include "blysk/scene.h"

namespace blysk {

/// Instruction sets the kernels are built for. All give the same bytes.
enum class Isa { best, scalar, sse4, avx2, avx512, neon };
[[nodiscard]] std::string_view isa_name(Isa isa);
/// Those built into this library that this processor can run, best last.
[[nodiscard]] std::vector<Isa> available_isas();

enum class View { iso, front, back, left, right, top, bottom };

/// How frame_camera() looks at a scene.
struct Framing {
  View view = View::iso;
  double aspect = 16.0 / 9;  ///< width / height of the picture
  double fov_deg = 30;       ///< vertical, 1..170
  double zoom = 1;           ///< > 1 shows less of the scene, larger
  bool orthographic = false;
};

/// The camera whose picture all of the scene just fits into.
[[nodiscard]] Camera frame_camera(const Scene& scene, const Framing& framing);

enum class Cull {
  material,  ///< back faces of materials that are not double-sided
  none,
  back  ///< all back faces
};

enum class Interpolation { perspective, screen };

struct RenderOptions {
  int width = 1280, height = 720;     ///< 1..16384 each
  std::optional<Camera> camera;       ///< none: frame_camera() of the scene
  std::vector<Light> lights;          ///< none: the scene's; none there either: a key light
  float ambient = 0.15f;              ///< Ia
  std::string shading = "phong";      ///< as choose_method() reads it
  std::string lighting = "blinn";     ///< likewise
  std::string lobe = "power";         ///< likewise
  std::string antialias = "abuffer";  ///< likewise
  float max_error = 1.0f / 512;       ///< that "auto" shading may be off, as shown; 0..1
  Interpolation interpolation = Interpolation::perspective;
  Cull cull = Cull::material;
  Transfer transfer = Transfer::srgb;
  Vec4f background{0, 0, 0, 0};  ///< encoded (not linear) RGBA, 0..1
  bool want_depth = false, want_normal = false, want_id = false;
  bool want_fragments = false, want_coverage = false;
  bool want_complexity = false;  ///< FrameStatistics::complexity, which takes a pass of its own
  Limits limits;
};

struct FrameStatistics {
  std::uint64_t triangles_in = 0;      ///< of all instances
  std::uint64_t triangles_culled = 0;  ///< facing away, when culling
  std::uint64_t triangles_drawn =
      0;  ///< that reach a pixel centre (antialiased: may reach a sample) of the picture, hidden or not
  std::uint64_t pixels_covered = 0;    ///< wholly or in part
  std::uint64_t pixels_shared = 0;     ///< antialiased: that show more than one surface, or background too
  std::uint64_t fragments_shaded = 0;  ///< antialiased: of these pixels; each is one surface's samples
  std::uint64_t layers_generated = 0;  ///< of transparent triangles: in pixels, hidden or not
  std::uint64_t layers_merged = 0;     ///< that a pixel had no room for, so that two became one
  std::uint64_t pixels_merged = 0;     ///< with such layers
  std::uint64_t fragments_lost = 0;    ///< abuffer-*: dropped, or merged with another
  std::uint64_t fragments_hidden_on_arrival = 0;  ///< abuffer-*: wholly, by what their pixel had
  std::uint64_t fragments_removed_later = 0;      ///< abuffer-*: wholly hidden by one that came after
  std::uint64_t fragments_most_live = 0;          ///< abuffer-*: in one pixel at one time
  FragmentMemory fragment_memory;                 ///< of abuffer-*
  DepthComplexity complexity;                     ///< if wanted
  std::uint64_t memory_bytes = 0;                 ///< held by the renderer beyond scene and image
  double geometry_ms = 0, tiles_ms = 0, frame_ms = 0;
};

struct Frame {
  Image image;
  FloatImage depth;         ///< 0 near .. 1 far plane; 1 where nothing is
  FloatImage normal;        ///< world space, towards the viewer; 0 where nothing is
  Array<std::uint32_t> id;  ///< 1 + index of the triangle over all instances; 0 where nothing is
  /// Fragments of each pixel that are left when all triangles are drawn: with "none" 1 where anything is;
  /// with "abuffer" the opaque surfaces that its samples show and the transparent layers before them, seen or
  /// not, with 32 samples and "supersample" of all parts of the pixel together; with the others what is in
  /// the pixel's list.
  Array<std::uint32_t> fragments;
  FloatImage coverage;  ///< share of a pixel's samples that any surface covers, opaque or transparent; 0..1
  FrameStatistics statistics;
};

struct RendererOptions {
  int threads = 0;  ///< 0: one per processor
  Isa isa = Isa::best;
};

/// Owns threads and working memory; reuse one for many frames. Not for concurrent use.
class Renderer {
 public:
  explicit Renderer(const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  [[nodiscard]] Result<Frame> render(const Scene& scene, const RenderOptions& options);
  /// The same into a frame that is reused: no allocation once sizes are steady.
  [[nodiscard]] Status render(const Scene& scene, const RenderOptions& options, Frame& frame);

  [[nodiscard]] Isa isa() const;
  [[nodiscard]] int threads() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace blysk
