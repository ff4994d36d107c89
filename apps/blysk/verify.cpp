// blysk verify: built-in scenes, their bytes compared with the hashes that this version publishes.
//
// A scene is a line of `blysk render`, so that whoever sees a difference can look at it. Every method of the
// registry has one of its own. When pictures change on purpose, after building and looking at them:
//
//   blysk verify --print > apps/blysk/verify_hashes.inc
//
// then build again; `blysk verify` must say that all is the same.

#include "blysk/methods.h"
#include "blysk/version.h"
#include "json.h"
#include "scene_options.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

struct Published {
  std::string_view name, hash;
};

constexpr Published kPublished[] = {
#include "verify_hashes.inc"
    {"", ""},
};

struct Check {
  std::string name, line;
};

// What the methods' own scenes do not reach: cameras, clipping, culling, lights, colours, crowds.
constexpr std::string_view kScenes[][2] = {
    {"default", "shape:teapot"},
    {"orthographic", "shape:cylinder --orthographic --cull back --view front"},
    {"inside", "shape:torus --eye 0,0,0 --target 1,0.2,0.3 --fov 120"},
    {"odd-size", "shape:trefoil --size 257x131 --zoom 2.5"},
    {"screen", "shape:plane --interpolation screen --shading gouraud --point-light 0.3,0.4,0.2 --fov 100"},
    {"point-lights",
     "shape:sphere --point-light 2,2,2,1,0.5,0.2 --point-light -2,1,2,0.2,0.5,1 --ambient 0.05"},
    {"lights", "shape:cube --light 1,2,3,0.7,0.7,0.6 --light -1,0,1,0.1,0.2,0.4 --specular 0,0,0"},
    {"transfer-none", "shape:icosphere --transfer none --color 0.9,0.2,0.1 --shininess 200"},
    {"background", "shape:teapot --background 0.2,0.4,0.6,0.5 --view back --up-axis z"},
    {"terrain", "shape:terrain --view left"},
    {"triangles", "shape:triangles --camera 0 --background transparent"},
    {"spheres", "shape:spheres --camera 0 --specular 0.5,0.5,0.5"},
    {"materials", "shape:xfighter"},
    {"several", "shape:cube shape:sphere shape:torus --view top"},
    // Triangles that `auto` interpolates, by planes, by surfaces, and some not.
    {"interpolated", "shape:sphere?detail=24 --shading auto --size 600x400"},
    {"interpolated-lights",
     "shape:teapot?detail=16 --shading auto --interpolation screen --lobe w16 --light 1,2,3,0.6,0.5,0.4 "
     "--light -3,1,1,0.2,0.3,0.4 --size 900x600"},
};

std::vector<Check> checks() {
  constexpr std::string_view kSize = " --size 256x192";
  std::vector<Check> all;
  for (const auto& [name, line] : kScenes) {
    const bool sized = line.find("--size") != std::string_view::npos;
    all.push_back({std::string(name), std::string(line) + std::string(sized ? "" : kSize)});
  }
  for (const Method& method : methods()) {
    const std::string kind(kind_name(method.kind));
    // Large triangles show most of what tells shading methods apart, small ones of the rest.
    const std::string scene = method.kind == MethodKind::shading ? "shape:sphere?detail=6 --shininess 10"
                                                                 : "shape:trefoil --shininess 32";
    // Its pixels are up to 256 each.
    const std::string_view size = method.name == "supersample" ? " --size 64x48" : kSize;
    for (const std::string& variant : method_variants(method)) {
      all.push_back({kind + "-" + variant,
                     scene + " --specular 0.6,0.6,0.6 --" + kind + " " + variant + std::string(size)});
    }
  }
  return all;
}

// A check and what came of it.
struct Outcome {
  Check check;
  std::string_view published;       // empty: none
  std::vector<std::string> hashes;  // one of each renderer

  [[nodiscard]] bool agree() const {
    return std::ranges::all_of(hashes, [&](const std::string& hash) { return hash == hashes.front(); });
  }
  [[nodiscard]] bool ok() const { return agree() && hashes.front() == published; }
};

std::string_view published_hash(std::string_view name) {
  for (const Published& row : kPublished) {
    if (row.name == name) return row.hash;
  }
  return "";
}

Result<Outcome> run_check(const Check& check, std::vector<Renderer>& renderers) {
  const Result<Arguments> arguments = parse_arguments(subcommands().front(), split(check.line, ' '));
  if (!arguments) return arguments.error();
  const Result<Scene> scene = load_models(*arguments);
  if (!scene) return scene.error();
  const Result<RenderOptions> options = render_options(*arguments, *scene);
  if (!options) return options.error();

  Outcome outcome = {check, published_hash(check.name), {}};
  for (Renderer& renderer : renderers) {
    const Result<Frame> frame = renderer.render(*scene, *options);
    if (!frame) return frame.error();
    outcome.hashes.push_back(sha256(frame->image));
  }
  return outcome;
}

std::string outcome_line(const Outcome& outcome, const std::vector<Renderer>& renderers) {
  std::string name = outcome.check.name;
  name.resize(std::max<std::size_t>(name.size(), 24), ' ');
  if (outcome.ok()) return "ok         " + name + " " + outcome.hashes.front();
  std::string line = "DIFFERENT  " + name;
  for (std::size_t i = 0; i < renderers.size(); ++i) {
    line += " " + std::string(isa_name(renderers[i].isa())) + ":" + outcome.hashes[i];
  }
  return line + " published:" + (outcome.published.empty() ? "none" : std::string(outcome.published)) +
         " (blysk render " + outcome.check.line + ")";
}

Json outcome_json(const Outcome& outcome, const std::vector<Renderer>& renderers) {
  Json hashes = Json::object();
  for (std::size_t i = 0; i < renderers.size(); ++i) {
    hashes[std::string(isa_name(renderers[i].isa()))] = outcome.hashes[i];
  }
  return {{"name", outcome.check.name},
          {"command", "blysk render " + outcome.check.line},
          {"ok", outcome.ok()},
          {"published", outcome.published.empty() ? Json(nullptr) : Json(outcome.published)},
          {"hashes", std::move(hashes)}};
}

Result<std::vector<Renderer>> make_renderers(const Arguments& arguments) {
  const Result<Isa> wanted = isa_of(arguments);
  if (!wanted) return wanted.error();
  std::vector<Renderer> renderers;
  for (const Isa isa : arguments.has("isa") ? std::vector{*wanted} : available_isas()) {
    renderers.emplace_back(RendererOptions{.threads = threads_of(arguments), .isa = isa});
  }
  return renderers;
}

}  // namespace

Result<int> run_verify(const Arguments& arguments) {
  Result<std::vector<Renderer>> renderers = make_renderers(arguments);
  if (!renderers) return renderers.error();
  const bool as_source = arguments.has("print"), as_json = arguments.has("json");
  if (as_source && as_json) return usage_error("--print", "cannot stand beside --json");

  Json rows = Json::array();
  std::size_t bad = 0, count = 0;
  for (const Check& check : checks()) {
    const Result<Outcome> outcome = run_check(check, *renderers);
    if (!outcome) return outcome.error();
    const bool good = as_source ? outcome->agree() : outcome->ok();
    const std::string line = outcome_line(*outcome, *renderers);
    bad += good ? 0 : 1;
    ++count;
    if (as_json) {
      rows.push_back(outcome_json(*outcome, *renderers));
    } else if (!as_source) {
      if (const Status status = print(line + "\n"); !status) return status.error();
    } else if (good) {
      const std::string row = "    {\"" + check.name + "\", \"" + outcome->hashes.front() + "\"},\n";
      if (const Status status = print(row); !status) return status.error();
    } else {
      say(line);
    }
  }

  if (as_json) {
    const Json document = {{"version", version()},
                           {"threads", renderers->front().threads()},
                           {"ok", bad == 0},
                           {"scenes", std::move(rows)}};
    if (const Status status = print_json(document); !status) return status.error();
  }
  std::vector<std::string> names;
  for (const Renderer& renderer : *renderers) names.emplace_back(isa_name(renderer.isa()));
  say(counted(count, "scene") + " on " + join(names, ", ") + ": " +
      (bad > 0     ? std::to_string(bad) + " different"
       : as_source ? "the same bytes on each"
                   : "the same bytes as published"));
  return bad == 0 ? 0 : 1;
}

}  // namespace blysk::command
