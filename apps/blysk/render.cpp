// blysk render: models to a picture.
#include <sys/resource.h>

#include "blysk/version.h"
#include "fragment_report.h"
#include "json.h"
#include "outputs.h"
#include "scene_options.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

// Milliseconds of each stage.
struct Times {
  double load = 0, geometry = 0, tiles = 0, frame = 0, write = 0, total = 0;
};

// All that is told about a render.
struct Told {
  const Arguments& arguments;
  const Outputs& outputs;
  const Scene& scene;
  const Camera& camera;
  const Renderer& renderer;
  const Frame& frame;
  const Times& times;
};

// Renders as often as --repeat says; medians of the stages.
Status render_frames(Renderer& renderer, const Scene& scene, const RenderOptions& options, int repeat,
                     Frame& frame, Times& times) {
  std::vector<double> geometry, tiles, whole;
  for (int i = 0; i < repeat; ++i) {
    if (const Status status = renderer.render(scene, options, frame); !status) return status;
    geometry.push_back(frame.statistics.geometry_ms);
    tiles.push_back(frame.statistics.tiles_ms);
    whole.push_back(frame.statistics.frame_ms);
  }
  times.geometry = median(std::move(geometry));
  times.tiles = median(std::move(tiles));
  times.frame = median(std::move(whole));
  return Done{};
}

// Largest memory that the process has held.
std::uint64_t peak_bytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

// A file, or several.
Json plane_json(const Outputs& outputs, const std::string& plane) {
  if (outputs.plane_formats.size() == 1) return plane_path(outputs, plane, outputs.plane_formats.front());
  Json paths = Json::array();
  for (const PlaneFormat format : outputs.plane_formats) paths.push_back(plane_path(outputs, plane, format));
  return paths;
}

Json to_json(const Told& told) {
  const FrameStatistics& statistics = told.frame.statistics;
  Json json = {
      {"version", version()},
      {"input", told.arguments.operands()},
      {"output", told.outputs.path},
      {"size", {told.frame.image.width, told.frame.image.height}},
      {"threads", told.renderer.threads()},
      {"simd", isa_name(told.renderer.isa())},
      {"triangles",
       {{"in", statistics.triangles_in},
        {"culled", statistics.triangles_culled},
        {"drawn", statistics.triangles_drawn}}},
      {"pixels", {{"covered", statistics.pixels_covered}}},
      {"fragments", fragments_json(statistics)},
      {"memory", {{"renderer", statistics.memory_bytes}, {"peak", peak_bytes()}}},
      {"ms",
       {{"load", json_ms(told.times.load)},
        {"geometry", json_ms(told.times.geometry)},
        {"tiles", json_ms(told.times.tiles)},
        {"write", json_ms(told.times.write)},
        {"frame", json_ms(told.times.frame)},
        {"total", json_ms(told.times.total)}}},
      {"sha256", sha256(told.frame.image)},
  };
  if (statistics.fragment_memory.main_bytes > 0) json["memory"]["buffers"] = buffers_json(statistics);
  if (told.arguments.has("repeat")) json["repeat"] = static_cast<int>(told.arguments.number("repeat"));
  for (const std::string& plane : told.outputs.planes) json["aov"][plane] = plane_json(told.outputs, plane);
  return json;
}

std::string point_text(Vec3d p) { return number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z); }

// Where transparency is no longer exact.
void warn_merged(const FrameStatistics& s) {
  if (s.layers_merged == 0) return;
  warn(counted(s.layers_merged, "transparent layer") + " in " + counted(s.pixels_merged, "pixel") +
       " went into others: a pixel keeps 64; the farthest are inexact");
}

void say_details(const Told& told) {
  const Camera& camera = told.camera;
  const std::string lens = camera.height > 0 ? "--orthographic " + number_text(camera.height)
                                             : "--fov " + number_text(camera.fov_deg);
  say("camera: --eye " + point_text(camera.eye) + " --target " + point_text(camera.target) + " --up " +
      point_text(camera.up) + " " + lens);
  say("renderer: " + counted(static_cast<std::uint64_t>(told.renderer.threads()), "thread") + ", " +
      std::string(isa_name(told.renderer.isa())) + ", " +
      count_text(told.frame.statistics.memory_bytes >> 10) + " KiB; process at most " +
      count_text(peak_bytes() >> 10) + " KiB");
  say("sha256: " + sha256(told.frame.image));
}

void say_summary(const Told& told) {
  const FrameStatistics& statistics = told.frame.statistics;
  const Times& times = told.times;
  const auto ms = [](std::string_view stage, double value) {
    return std::string(stage) + " " + fixed_text(value, 1) + " ms";
  };
  const std::string where = told.outputs.to_stdout() ? "standard output" : told.outputs.path;
  say(where + ": " + std::to_string(told.frame.image.width) + "x" + std::to_string(told.frame.image.height) +
      ", " + counted(statistics.triangles_in, "triangle") + ", " + count_text(statistics.triangles_drawn) +
      " drawn, " + counted(statistics.pixels_covered, "pixel") + " covered");
  say(join({ms("load", times.load), ms("geometry", times.geometry), ms("tiles", times.tiles),
            ms("write", times.write), ms("total", times.total)},
           ", "));
}

}  // namespace

Result<int> run_render(const Arguments& arguments) {
  Stopwatch whole, stage;
  if (const Status status = check_scene_options(arguments); !status) return status.error();
  const Result<Outputs> outputs = outputs_of(arguments);
  if (!outputs) return outputs.error();
  const bool quiet = arguments.has("quiet");
  Progress progress(!quiet);
  Times times;

  const std::vector<std::string>& models = arguments.operands();
  progress.phase("reading " + (models.size() == 1 ? models.front() : counted(models.size(), "model")));
  stage.start();
  const Result<Scene> scene = load_models(arguments);
  if (!scene) return scene.error();
  times.load = stage.lap_ms();

  Result<RenderOptions> options = render_options(arguments, *scene);
  if (!options) return options.error();
  want_planes(*outputs, *options);
  options->want_complexity = arguments.has("statistics");
  if (const Status s = check_planes(scene->triangles(), *options, *outputs); !s) return s.error();

  progress.phase("rendering");
  Renderer renderer({.threads = threads_of(arguments), .isa = *isa_of(arguments)});
  Frame frame;
  const int repeat = static_cast<int>(arguments.number("repeat"));
  if (const Status s = render_frames(renderer, *scene, *options, repeat, frame, times); !s) return s.error();

  progress.phase("writing " + outputs->path);
  stage.start();
  const PictureOptions picture = {.threads = threads_of(arguments), .alpha = options->background.w < 1};
  if (const Status status = write_outputs(frame, *outputs, picture); !status) return status.error();
  times.write = stage.lap_ms();
  times.total = whole.lap_ms();
  progress.finish();

  const Told told = {arguments, *outputs, *scene, *options->camera, renderer, frame, times};
  if (!quiet) {
    warn_problems(*scene, arguments);
    warn_merged(frame.statistics);
    if (arguments.has("verbose")) say_details(told);
    if (arguments.has("verbose") || arguments.has("statistics")) say_fragments(frame.statistics);
    say_summary(told);
  }
  if (arguments.has("json")) {
    if (const Status status = print_json(to_json(told)); !status) return status.error();
  }
  return 0;
}

}  // namespace blysk::command
