// blysk compare: how far pictures, or shading methods on a model, are from a reference.
#include <algorithm>
#include <filesystem>

#include "blysk/version.h"
#include "comparison.h"
#include "json.h"
#include "outputs.h"
#include "scene_options.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

// Options that say something about pictures alone; all others are about rendering.
constexpr std::string_view kPictureOptions[] = {"difference",     "report",  "max-nmse",
                                                "max-difference", "threads", "max-memory",
                                                "json",           "quiet",   "verbose"};

Status check_output_file(const Arguments& arguments, std::string_view name) {
  const Value* path = arguments.find(name);
  if (path == nullptr) return Done{};
  if (path->text == "-") {
    return usage_error("--" + std::string(name), "needs a file; standard output holds the table");
  }
  return check_place(path->text);
}

Status check_compare_options(const Arguments& arguments) {
  if (const Value* map = arguments.find("difference")) {
    if (const Result<PictureFormat> format = picture_format(map->text); !format) return format.error();
  }
  for (const char* name : {"difference", "report"}) {
    if (const Status status = check_output_file(arguments, name); !status) return status;
  }
  if (arguments.has("methods")) return check_scene_options(arguments);

  for (const Given& given : arguments.given()) {
    const std::string_view name = given.option->name;
    if (std::ranges::find(kPictureOptions, name) != std::end(kPictureOptions)) continue;
    return usage_error("--" + std::string(name), "is about rendering a model; it needs --methods");
  }
  if (arguments.operands().size() < 2) {
    return usage_error("blysk compare",
                       "needs a reference and a candidate picture, or a model and --methods, for example: "
                       "blysk compare expected.png actual.png");
  }
  if (std::ranges::count(arguments.operands(), "-") > 1) {
    return usage_error("-", "standard input can be read only once");
  }
  return Done{};
}

// "name.ID.png" for "name.png".
std::string path_with(const std::string& path, const std::string& id) {
  if (id.empty()) return path;
  std::filesystem::path named = path;
  const std::string extension = named.extension().string();
  named.replace_extension();
  return named.string() + "." + id + extension;
}

Json picture_json(const Compared& picture) {
  return {{"name", picture.name}, {"size", {picture.width, picture.height}}, {"sha256", picture.hash}};
}

// What has no number is null: the PSNR of equal pictures, all errors of pictures of another size.
Json candidate_json(const Compared& candidate, const Comparison& comparison) {
  Json json = picture_json(candidate);
  json["equal"] = candidate.equal;
  const auto& difference = candidate.difference;
  json["nmse"] = difference ? Json(difference->nmse) : Json();
  json["class"] = difference ? Json(nmse_class(difference->nmse)) : Json();
  json["psnr_db"] = difference ? Json(difference->psnr_db) : Json();
  json["ssim"] = difference ? Json(candidate.similarity) : Json();
  json["max_difference"] = difference ? Json(difference->max_difference) : Json();
  json["different_pixels"] = difference ? Json(difference->different_pixels) : Json();
  if (!candidate.map_path.empty()) json["difference"] = candidate.map_path;
  if (comparison.of_methods()) {
    json["ms"] = json_ms(candidate.frame_ms);
    json["speed_up"] = comparison.reference.frame_ms / candidate.frame_ms;
  }
  return json;
}

Json to_json(const Comparison& comparison, bool equal, const Arguments& arguments) {
  Json reference = picture_json(comparison.reference);
  Json json = {{"version", version()}, {"equal", equal}};
  if (comparison.of_methods()) {
    json["input"] = arguments.operands();
    reference["ms"] = json_ms(comparison.reference.frame_ms);
  }
  json["reference"] = std::move(reference);
  json["candidates"] = Json::array();
  for (const Compared& candidate : comparison.candidates) {
    json["candidates"].push_back(candidate_json(candidate, comparison));
  }
  return json;
}

std::string size_text(const Compared& picture) {
  return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

Status tell(const Comparison& comparison, const Arguments& arguments) {
  const bool quiet = arguments.has("quiet");
  for (const Compared& candidate : comparison.candidates) {
    if (candidate.difference || quiet) continue;
    say(candidate.name + ": " + size_text(candidate) + " pixels, but the reference " +
        comparison.reference.name + " has " + size_text(comparison.reference));
  }
  if (arguments.has("verbose") && !quiet) {
    say(comparison.reference.name + ": " + comparison.reference.hash);
    for (const Compared& candidate : comparison.candidates) say(candidate.name + ": " + candidate.hash);
  }
  if (quiet || arguments.has("json")) return Done{};
  const auto rows = comparison_rows(comparison);
  return rows.size() < 2 ? Status(Done{}) : print(table(rows));
}

}  // namespace

Compared compared(std::string name, Image image) {
  Compared picture;
  picture.name = std::move(name);
  picture.width = image.width;
  picture.height = image.height;
  picture.hash = sha256(image);
  picture.image = std::move(image);
  return picture;
}

Judge::Judge(const Arguments& arguments, Compared reference) : arguments_(arguments) {
  comparison_.reference = std::move(reference);
}

Status Judge::take(Compared candidate, const std::string& id) {
  const Image& reference = comparison_.reference.image;
  if (const Result<Difference> difference = blysk::compare(reference, candidate.image)) {
    candidate.difference = *difference;
    candidate.similarity = *ssim(reference, candidate.image);
    candidate.equal = is_equal(*difference);
    if (const Status status = write_map(candidate, id); !status) return status;
  }
  if (!arguments_.has("report")) candidate.image = {};
  comparison_.candidates.push_back(std::move(candidate));
  return Done{};
}

bool Judge::is_equal(const Difference& difference) const {
  const Value* nmse = arguments_.find("max-nmse");
  const Value* levels = arguments_.find("max-difference");
  if (nmse == nullptr && levels == nullptr) return difference.different_pixels == 0;
  return (nmse == nullptr || difference.nmse <= nmse->numbers[0]) &&
         (levels == nullptr || difference.max_difference <= levels->numbers[0]);
}

Status Judge::write_map(Compared& candidate, const std::string& id) const {
  if (!arguments_.has("difference")) return Done{};
  const Result<Image> map = difference_picture(comparison_.reference.image, candidate.image);
  if (!map) return map.error();
  candidate.map_path = path_with(arguments_.text("difference"), id);
  return write_picture(*map, candidate.map_path, *picture_format(candidate.map_path),
                       {.threads = threads_of(arguments_), .alpha = false});
}

Result<Comparison> compare_pictures(const Arguments& arguments) {
  const std::vector<std::string>& paths = arguments.operands();
  const Limits limits = limits_of(arguments);
  Result<Image> reference = read_picture(paths.front(), limits);
  if (!reference) return reference.error();
  Judge judge(arguments, compared(paths.front(), std::move(*reference)));
  for (std::size_t i = 1; i < paths.size(); ++i) {
    Result<Image> candidate = read_picture(paths[i], limits);
    if (!candidate) return candidate.error();
    const std::string id = paths.size() > 2 ? std::to_string(i) : "";
    if (const Status s = judge.take(compared(paths[i], std::move(*candidate)), id); !s) return s.error();
  }
  return std::move(judge.comparison());
}

std::vector<std::vector<std::string>> comparison_rows(const Comparison& comparison) {
  const bool timed = comparison.of_methods();
  std::vector<std::vector<std::string>> rows = {{timed ? "METHOD" : "CANDIDATE", "VERDICT", "NMSE", "CLASS",
                                                 "PSNR", "SSIM", "MAX DIFFERENCE", "DIFFERENT PIXELS"}};
  const auto add_time = [&](const Compared& picture) {
    if (!timed) return;
    rows.back().push_back(fixed_text(picture.frame_ms, 2) + " ms");
    rows.back().push_back(fixed_text(comparison.reference.frame_ms / picture.frame_ms, 2) + "x");
  };
  if (timed) {
    rows.front().insert(rows.front().end(), {"FRAME", "SPEED-UP"});
    rows.push_back({comparison.reference.name, "reference", "-", "-", "-", "-", "-", "-"});
    add_time(comparison.reference);
  }
  for (const Compared& candidate : comparison.candidates) {
    if (!candidate.difference) continue;
    const Difference& d = *candidate.difference;
    const double pixels = static_cast<double>(candidate.width) * static_cast<double>(candidate.height);
    const double percent = 100 * static_cast<double>(d.different_pixels) / pixels;
    rows.push_back({printable(candidate.name), candidate.equal ? "equal" : "different", rounded_text(d.nmse),
                    std::string(nmse_class(d.nmse)), fixed_text(d.psnr_db, 2) + " dB",
                    fixed_text(candidate.similarity, 5), std::to_string(d.max_difference),
                    count_text(d.different_pixels) + " (" + fixed_text(percent, 2) + " %)"});
    add_time(candidate);
  }
  return rows;
}

Result<int> run_compare(const Arguments& arguments) {
  if (const Status status = check_compare_options(arguments); !status) return status.error();
  const Result<Comparison> comparison =
      arguments.has("methods") ? compare_methods(arguments) : compare_pictures(arguments);
  if (!comparison) return comparison.error();
  if (arguments.has("report")) {
    const Result<std::string> page = comparison_page(*comparison);
    if (!page) return page.error();
    if (const Status s = write_file(*page, arguments.text("report")); !s) return s.error();
  }

  const bool equal = std::ranges::all_of(comparison->candidates, &Compared::equal);
  if (const Status status = tell(*comparison, arguments); !status) return status.error();
  if (arguments.has("json")) {
    if (const Status s = print_json(to_json(*comparison, equal, arguments)); !s) return s.error();
  }
  // That methods differ is what is measured; it is a failure only where a bound was set.
  const bool bounded = arguments.has("max-nmse") || arguments.has("max-difference");
  return equal || (comparison->of_methods() && !bounded) ? 0 : 1;
}

}  // namespace blysk::command
