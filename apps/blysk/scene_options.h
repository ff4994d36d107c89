// scene_options.h - from the options of a rendering subcommand to scenes, cameras and render options.
#pragma once

#include "arguments.h"
#include "blysk/limits.h"
#include "blysk/render.h"
#include "blysk/scene.h"

namespace blysk::command {

/// What can be told wrong before any file is read: options that exclude or need each other.
[[nodiscard]] Status check_scene_options(const Arguments& arguments);

[[nodiscard]] Limits limits_of(const Arguments& arguments);
[[nodiscard]] int threads_of(const Arguments& arguments);
/// Of --isa; ErrorCode::usage where this processor or build does not run it.
[[nodiscard]] Result<Isa> isa_of(const Arguments& arguments);

/// Reads one model; --max-triangles and --max-memory hold for shapes too.
[[nodiscard]] Result<Scene> load_within_limits(const std::string& path, bool may_be_empty,
                                               const Arguments& arguments);
/// Reads all models into one scene, upright and with the material overrides.
[[nodiscard]] Result<Scene> load_models(const Arguments& arguments);

/// Warns of what was wrong in the files: the first few, with --verbose all.
void warn_problems(const Scene& scene, const Arguments& arguments);

/// Everything but the outputs wanted beside the picture.
[[nodiscard]] Result<RenderOptions> render_options(const Arguments& arguments, const Scene& scene);

}  // namespace blysk::command
