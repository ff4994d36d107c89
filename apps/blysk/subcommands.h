// subcommands.h - what each subcommand runs, one file each.
#pragma once

#include "arguments.h"
#include "blysk/result.h"

namespace blysk::command {

/// Each gives the exit status, 0 or 1, or why it failed.
[[nodiscard]] Result<int> run_render(const Arguments& arguments);
[[nodiscard]] Result<int> run_compare(const Arguments& arguments);
[[nodiscard]] Result<int> run_info(const Arguments& arguments);
[[nodiscard]] Result<int> run_methods(const Arguments& arguments);
[[nodiscard]] Result<int> run_replicate(const Arguments& arguments);
[[nodiscard]] Result<int> run_verify(const Arguments& arguments);
[[nodiscard]] Result<int> run_man(const Arguments& arguments);
[[nodiscard]] Result<int> run_completion(const Arguments& arguments);

}  // namespace blysk::command
