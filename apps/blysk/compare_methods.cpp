// Shading methods on one scene: each is rendered and timed as the reference is.
#include <algorithm>

#include "blysk/methods.h"
#include "comparison.h"
#include "scene_options.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

// Those of --methods in their order, each once, without the reference.
std::vector<std::string> candidates_of(const Arguments& arguments) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    const bool known = std::ranges::find(names, name) != names.end();
    if (!known && name != arguments.text("reference")) names.push_back(name);
  };
  for (const std::string& wanted : split_methods(arguments.text("methods"))) {
    if (wanted != "all") add(wanted);
    for (const Method& method : methods()) {
      if (wanted == "all" && method.kind == MethodKind::shading) add(std::string(method.name));
    }
  }
  return names;
}

// A picture and its time: the median of --repeat frames after one that warms caches and memory.
Result<Compared> render_method(const std::string& method, const Scene& scene, RenderOptions options,
                               Renderer& renderer, int repeat) {
  options.shading = method;
  Frame frame;
  if (const Status status = renderer.render(scene, options, frame); !status) return status.error();
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    if (const Status status = renderer.render(scene, options, frame); !status) return status.error();
    times.push_back(frame.statistics.frame_ms);
  }
  Compared picture = compared(method, std::move(frame.image));
  picture.title = choose_method(MethodKind::shading, method)->method->title;
  picture.frame_ms = median(std::move(times));
  return picture;
}

}  // namespace

Result<Comparison> compare_methods(const Arguments& arguments) {
  const std::vector<std::string> names = candidates_of(arguments);
  const std::string reference_name = arguments.text("reference");
  if (names.empty()) {
    return usage_error("--methods", "names none but the reference " + reference_name +
                                        "; add another, or choose another --reference");
  }
  Progress progress(!arguments.has("quiet"));
  progress.phase("reading " + join(arguments.operands(), ", "));
  const Result<Scene> scene = load_models(arguments);
  if (!scene) return scene.error();
  const Result<RenderOptions> options = render_options(arguments, *scene);
  if (!options) return options.error();

  Renderer renderer({.threads = threads_of(arguments), .isa = *isa_of(arguments)});
  const int repeat = static_cast<int>(arguments.number("repeat"));
  const auto render = [&](const std::string& name) {
    progress.phase("rendering " + name);
    return render_method(name, *scene, *options, renderer, repeat);
  };
  Result<Compared> reference = render(reference_name);
  if (!reference) return reference.error();
  Judge judge(arguments, std::move(*reference));
  for (const std::string& name : names) {
    Result<Compared> candidate = render(name);
    if (!candidate) return candidate.error();
    const std::string id = names.size() > 1 ? name : "";
    if (const Status status = judge.take(std::move(*candidate), id); !status) return status.error();
  }
  progress.finish();
  if (!arguments.has("quiet")) warn_problems(*scene, arguments);

  Comparison& comparison = judge.comparison();
  comparison.models = join(arguments.operands(), ", ");
  comparison.setting = counted(scene->triangles(), "triangle") + ", " + std::to_string(options->width) + "x" +
                       std::to_string(options->height) + ", " +
                       counted(static_cast<std::uint64_t>(renderer.threads()), "thread") + ", " +
                       std::string(isa_name(renderer.isa())) + ", times: median of " +
                       counted(static_cast<std::uint64_t>(repeat), "frame");
  return std::move(comparison);
}

}  // namespace blysk::command
