// The table itself.
#include "options.h"

#include <algorithm>
#include <cstdlib>

#include "blysk/limits.h"
#include "blysk/methods.h"
#include "blysk/model.h"
#include "blysk/render.h"
#include "blysk/study.h"
#include "subcommands.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr double kFar = 1e30;                // largest coordinate that stays clear of overflow when squared
constexpr double kMaxSide = 16384;           // include/blysk/image.h
constexpr double kExact = 9007199254740992;  // 2^53: whole numbers up to here are exact in a double

std::vector<std::string> method_names(MethodKind kind) {
  std::vector<std::string> names;
  for (const Method& method : methods()) {
    if (method.kind == kind) names.emplace_back(method.name);
  }
  return names;
}

// "; quadratic:form=..., segments=..." where methods have settings.
std::string settings_of(MethodKind kind) {
  std::string text;
  for (const Method& method : methods()) {
    if (method.kind != kind || method.settings.empty()) continue;
    std::vector<std::string> names;
    for (const MethodSetting& setting : method.settings) names.push_back(std::string(setting.name) + "=");
    text += (text.empty() ? "; settings: " : ", ") + std::string(method.name) + ":" + join(names, ",");
  }
  return text;
}

std::vector<std::string> with_all(std::vector<std::string> names) {
  names.emplace_back("all");
  return names;
}

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  for (const Study& study : studies()) names.emplace_back(study.name);
  return names;
}

std::string study_helps() {
  std::vector<std::string> helps;
  for (const Study& study : studies())
    helps.push_back(std::string(study.name) + " is about " + std::string(study.help));
  return join(helps, "; ");
}

std::vector<std::string> isa_names() {
  std::vector<std::string> names;
  for (const Isa isa : {Isa::best, Isa::scalar, Isa::sse4, Isa::avx2, Isa::avx512, Isa::neon}) {
    names.emplace_back(isa_name(isa));
  }
  return names;
}

std::vector<Option> output_options() {
  return {
      {.name = "output",
       .letter = 'o',
       .type = Type::path,
       .value = "OUT",
       .group = Group::output,
       .example = "teapot.png",
       .help = "picture to write, in the format of its extension: .png, .ppm (no alpha) or .pfm (floats); "
               "- is standard output, a PNG unless --format says otherwise"},
      {.name = "output",
       .letter = 'o',
       .type = Type::path,
       .value = "DIR",
       .group = Group::output,
       .users = kReplicate,
       .without = "no plots",
       .example = "plots",
       .help = "folder to write the plots to, as SVG"},
      {.name = "format",
       .type = Type::choice,
       .value = "FORMAT",
       .group = Group::output,
       .choices = {"png", "ppm", "pfm"},
       .without = "the extension of OUT",
       .example = "png",
       .help = "format of the picture"},
      {.name = "size",
       .type = Type::size,
       .value = "WxH",
       .group = Group::output,
       .users = kDraw,
       .low = 1,
       .high = kMaxSide,
       .initial = std::to_string(RenderOptions{}.width) + "x" + std::to_string(RenderOptions{}.height),
       .example = "640x480",
       .help = "picture size in pixels"},
      {.name = "aov",
       .type = Type::choices,
       .value = "LIST",
       .group = Group::output,
       .choices = {"depth", "normal", "id", "fragments", "coverage"},
       .without = "none",
       .example = "depth,normal",
       .help = "further pictures, written beside OUT as NAME.depth.png and so on: depth 0 near to 1 far, "
               "world-space normals, triangle ids counted from 1, red being their lowest byte, how many "
               "fragments "
               "each pixel holds, in false colours with a key, and the share of its samples that anything "
               "covers"},
      {.name = "aov-format",
       .type = Type::choices,
       .value = "LIST",
       .group = Group::output,
       .choices = {"png", "pfm", "csv"},
       .without = "png; pfm where OUT is one",
       .example = "png,csv",
       .help =
           "how --aov is written: as pictures to look at, or as exact numbers: floats, or text with a line "
           "for each row of the picture, its numbers separated by commas (of normals three a pixel)"},
      {.name = "difference",
       .type = Type::path,
       .value = "OUT",
       .group = Group::output,
       .users = kCompare,
       .without = "none",
       .example = "difference.png",
       .help =
           "write the error map in false colours, with a labelled colour bar: the largest difference of any "
           "channel of each pixel, equal ones black; of several candidates one each, OUT.1.png and so on, or "
           "OUT.METHOD.png"},
      {.name = "report",
       .type = Type::path,
       .value = "OUT.html",
       .group = Group::output,
       .users = kCompare,
       .without = "none",
       .example = "report.html",
       .help = "write one HTML page that needs nothing else: the table, the pictures, their error maps"},
  };
}

std::vector<Option> camera_options() {
  return {
      {.name = "view",
       .type = Type::choice,
       .value = "VIEW",
       .group = Group::camera,
       .choices = {"iso", "front", "back", "left", "right", "top", "bottom"},
       .initial = "iso",
       .example = "front",
       .help = "side from which the whole model is framed"},
      {.name = "zoom",
       .type = Type::number,
       .value = "F",
       .group = Group::camera,
       .low = 0.01,
       .high = 1000,
       .initial = "1",
       .example = "1.5",
       .help = "how much larger than framed the model appears"},
      {.name = "eye",
       .type = Type::point,
       .value = "x,y,z",
       .group = Group::camera,
       .low = -kFar,
       .high = kFar,
       .without = "framed by --view",
       .example = "3,2,5",
       .help = "place the camera here instead of framing the model"},
      {.name = "target",
       .type = Type::point,
       .value = "x,y,z",
       .group = Group::camera,
       .low = -kFar,
       .high = kFar,
       .without = "the middle of the model",
       .example = "0,0.5,0",
       .help = "point that the camera at --eye looks at"},
      {.name = "up",
       .type = Type::direction,
       .value = "x,y,z",
       .group = Group::camera,
       .low = -kFar,
       .high = kFar,
       .initial = "0,1,0",
       .example = "0,0,1",
       .help = "direction that is up in the picture of the camera at --eye"},
      {.name = "fov",
       .type = Type::number,
       .value = "DEG",
       .group = Group::camera,
       .low = 1,
       .high = 170,
       .initial = number_text(Camera{}.fov_deg),
       .example = "30",
       .help = "vertical field of view in degrees; overrides that of --camera"},
      {.name = "camera",
       .type = Type::text,
       .value = "NAME|INDEX",
       .group = Group::camera,
       .without = "framed by --view",
       .example = "0",
       .help = "a camera of the model file, by its name or its number as blysk info lists it"},
      {.name = "orthographic",
       .type = Type::optional_number,
       .value = "[HEIGHT]",
       .group = Group::camera,
       .low = 1e-30,
       .high = kFar,
       .without = "perspective",
       .example = "2.5",
       .help =
           "parallel projection, HEIGHT world units high (a file named like a number must be written ./2); "
           "without HEIGHT the whole model fits"},
      {.name = "up-axis",
       .type = Type::choice,
       .value = "AXIS",
       .group = Group::camera,
       .choices = {"y", "z"},
       .initial = "y",
       .example = "z",
       .help = "axis that is up in the model files; z turns them so that what is made for printing or CAD "
               "stands"},
  };
}

std::vector<Option> light_options() {
  return {
      {.name = "light",
       .type = Type::light,
       .value = "x,y,z[,r,g,b]",
       .group = Group::light,
       .repeatable = true,
       .low = -kFar,
       .high = kFar,
       .without = "the file's lights, else a key light from above the camera's left shoulder",
       .example = "1,2,3,1,0.9,0.8",
       .help = "a directional light from this direction in world space; its colour may exceed 1"},
      {.name = "point-light",
       .type = Type::point_light,
       .value = "x,y,z[,r,g,b]",
       .group = Group::light,
       .repeatable = true,
       .low = -kFar,
       .high = kFar,
       .without = "as for --light",
       .example = "0,4,2",
       .help = "a point light at this place in world space; its colour may exceed 1"},
      {.name = "ambient",
       .type = Type::number,
       .value = "F",
       .group = Group::light,
       .low = 0,
       .high = 1000,
       .initial = number_text(RenderOptions{}.ambient),
       .example = "0.1",
       .help = "ambient intensity"},
  };
}

std::vector<Option> material_options() {
  return {
      {.name = "color",
       .type = Type::color,
       .value = "r,g,b",
       .group = Group::material,
       .low = 0,
       .high = 1,
       .without = "the file's colours",
       .example = "0.8,0.3,0.1",
       .help = "linear colour of everything, in place of the files' materials and vertex colours"},
      {.name = "specular",
       .type = Type::color,
       .value = "r,g,b",
       .group = Group::material,
       .low = 0,
       .high = 1,
       .without = "the file's",
       .example = "0.4,0.4,0.4",
       .help = "linear colour of highlights"},
      {.name = "shininess",
       .type = Type::number,
       .value = "N",
       .group = Group::material,
       .low = 1,
       .high = 1000,
       .without = "the file's",
       .example = "64",
       .help = "exponent of the lobe: the higher, the smaller the highlight"},
      {.name = "opacity",
       .type = Type::number,
       .value = "F",
       .group = Group::material,
       .low = 0,
       .high = 1,
       .without = "the file's",
       .example = "0.4",
       .help = "0 is clear, 1 opaque; --antialias none shows everything as opaque"},
      {.name = "crease",
       .type = Type::number,
       .value = "DEG",
       .group = Group::material,
       .low = 0,
       .high = 180,
       .without = "60; STL and glTF stay flat",
       .example = "30",
       .help =
           "for files without normals: edges that bend more than this stay sharp; 0 shows every face flat"},
      {.name = "cull",
       .type = Type::choice,
       .value = "FACES",
       .group = Group::material,
       .choices = {"material", "none", "back"},
       .initial = "material",
       .example = "back",
       .help = "back faces left out: those of materials that are not double-sided, none, or all"},
  };
}

std::vector<Option> method_options() {
  return {
      {.name = "shading",
       .type = Type::method,
       .value = "METHOD",
       .group = Group::method,
       .choices = method_names(MethodKind::shading),
       .kind = MethodKind::shading,
       .initial = RenderOptions{}.shading,
       .example = RenderOptions{}.shading,
       .help = "how intensity reaches every pixel of a triangle; blysk methods describes them all"},
      {.name = "lighting",
       .type = Type::method,
       .value = "MODEL",
       .group = Group::method,
       .users = kDraw,
       .choices = method_names(MethodKind::lighting),
       .kind = MethodKind::lighting,
       .initial = RenderOptions{}.lighting,
       .example = RenderOptions{}.lighting,
       .help = "how light, normal and view give an intensity"},
      {.name = "lobe",
       .type = Type::method,
       .value = "NAME",
       .group = Group::method,
       .users = kDraw,
       .choices = method_names(MethodKind::lobe),
       .kind = MethodKind::lobe,
       .initial = RenderOptions{}.lobe,
       .example = RenderOptions{}.lobe,
       .help = "how highlights fall off"},
      {.name = "max-error",
       .type = Type::number,
       .value = "F",
       .group = Group::method,
       .users = kDraw,
       .low = 0,
       .high = 1,
       .initial = number_text(RenderOptions{}.max_error),
       .example = "0.004",
       .help = "how far from phong --shading auto may be, 1 is white"},
      {.name = "antialias",
       .type = Type::method,
       .value = "METHOD",
       .group = Group::method,
       .users = kDraw,
       .choices = method_names(MethodKind::antialias),
       .kind = MethodKind::antialias,
       .initial = RenderOptions{}.antialias,
       .example = RenderOptions{}.antialias,
       .help = "how edges are smoothed; none is one sample at each pixel's centre"},
      {.name = "interpolation",
       .type = Type::choice,
       .value = "WAY",
       .group = Group::method,
       .users = kDraw,
       .choices = {"perspective", "screen"},
       .initial = "perspective",
       .example = "screen",
       .help =
           "how normals and colours run across a triangle: perspective-correct, or linear in the picture"},
      {.name = "methods",
       .type = Type::methods,
       .value = "LIST|all",
       .group = Group::method,
       .users = kCompare,
       .choices = with_all(method_names(MethodKind::shading)),
       .without = "pictures are compared",
       .example = "gouraud,flat",
       .help = "render the models with each of these shading methods and compare them with --reference"},
      {.name = "reference",
       .type = Type::method,
       .value = "METHOD",
       .group = Group::method,
       .users = kCompare,
       .choices = method_names(MethodKind::shading),
       .kind = MethodKind::shading,
       .initial = RenderOptions{}.shading,
       .example = RenderOptions{}.shading,
       .help = "shading method that the others of --methods are measured against"},
  };
}

std::vector<Option> picture_options() {
  return {
      {.name = "background",
       .type = Type::background,
       .value = "COLOUR",
       .group = Group::picture,
       .initial = "0.93,0.94,0.95",
       .example = "#203040",
       .help = "what is seen where no model is; the values are those of the picture, not linear light"},
      {.name = "transfer",
       .type = Type::choice,
       .value = "FUNCTION",
       .group = Group::picture,
       .choices = {"srgb", "none"},
       .initial = "srgb",
       .example = "none",
       .help = "how linear light becomes bytes: encoded as sRGB, or 0..1 straight to 0..255"},
  };
}

std::vector<Option> work_options() {
  return {
      {.name = "threads",
       .type = Type::integer,
       .value = "N",
       .group = Group::work,
       .users = kDraw | kInfo | kVerify | kReplicate,
       .low = 1,
       .high = 1024,
       .without = "one per processor",
       .example = "2",
       .help = "threads to work with; the bytes do not depend on it"},
      {.name = "isa",
       .type = Type::choice,
       .value = "SET",
       .group = Group::work,
       .users = kDraw | kVerify,
       .choices = isa_names(),
       .without = "the best that this processor runs; verify takes them all",
       .example = "scalar",
       .help = "instruction set to work with; the bytes do not depend on it"},
      {.name = "repeat",
       .type = Type::integer,
       .value = "N",
       .group = Group::work,
       .users = kDraw,
       .low = 1,
       .high = 1e6,
       .initial = "1",
       .example = "9",
       .help = "render the loaded scene N times and report the median time of each stage"},
      {.name = "max-triangles",
       .type = Type::integer,
       .value = "N",
       .group = Group::work,
       .users = kDraw | kInfo | kReplicate,
       .low = 1,
       .high = kExact,
       .initial = std::to_string(Limits{}.max_triangles),
       .example = "1000000",
       .help = "stop with status 5 rather than take a model of more triangles"},
      {.name = "max-memory",
       .type = Type::bytes,
       .value = "BYTES",
       .group = Group::work,
       .users = kDraw | kInfo | kReplicate,
       .low = 1,
       .high = kExact,
       .initial = std::to_string(Limits{}.max_memory >> 30) + "G",
       .example = "512M",
       .help = "stop with status 5 rather than take more memory for a model or a frame"},
  };
}

std::vector<Option> report_options() {
  return {
      {.name = "max-nmse",
       .type = Type::number,
       .value = "X",
       .group = Group::report,
       .users = kCompare,
       .low = 0,
       .high = 1e6,
       .without = "any difference is one",
       .example = "0.0001",
       .help = "pictures up to this normalised mean square error count as equal; alpha is no part of it"},
      {.name = "max-difference",
       .type = Type::integer,
       .value = "N",
       .group = Group::report,
       .users = kCompare,
       .low = 0,
       .high = 255,
       .without = "any difference is one",
       .example = "2",
       .help =
           "pictures of which no channel differs by more count as equal; beside --max-nmse both must hold"},
      {.name = "study",
       .type = Type::choice,
       .value = "NAME",
       .group = Group::work,
       .users = kReplicate,
       .choices = study_names(),
       .without = "all of them",
       .example = "shading",
       .help = "which of the papers' subjects is measured again: " + study_helps()},
      {.name = "scenes",
       .type = Type::choices,
       .value = "LIST",
       .group = Group::work,
       .users = kReplicate,
       .choices = abuffer_scenes(),
       .without = "all",
       .example = "soup-5,grass",
       .help = "with --study abuffer: measure in these scenes only"},
      {.name = "quick",
       .group = Group::work,
       .users = kReplicate,
       .help = "small pictures, few repetitions: to see that it works; the times mean little"},
      {.name = "statistics",
       .group = Group::report,
       .help = "count the fragments of every pixel, hidden ones too, and tell how they are distributed, in "
               "words and by --json; the count takes time, which the times hold"},
      {.name = "print",
       .group = Group::report,
       .users = kVerify,
       .help = "print the table of hashes that this build gives, for its source, and compare nothing"},
      {.name = "json",
       .group = Group::report,
       .users = kDraw | kInfo | kMethods | kVerify | kReplicate,
       .help = "make standard output one JSON document"},
      {.name = "markdown",
       .group = Group::report,
       .users = kMethods | kMan | kReplicate,
       .help = "print Markdown"},
      {.name = "quiet",
       .letter = 'q',
       .group = Group::report,
       .users = kDraw | kReplicate,
       .help = "say nothing but errors"},
      {.name = "verbose",
       .letter = 'v',
       .group = Group::report,
       .users = kDraw,
       .help = "say what was wrong in the files, where the camera stands, and what did the work"},
      {.name = "help",
       .letter = 'h',
       .group = Group::report,
       .users = ~0u,
       .help = "print what the subcommand does and its options"},
  };
}

// The same options for one more subcommand.
std::vector<Option> also(Users user, std::vector<Option> rows) {
  for (Option& row : rows) row.users |= user;
  return rows;
}

std::string number_range(const Option& option) {
  return number_text(option.low) + " to " + number_text(option.high);
}

// A range that only keeps arithmetic from overflowing is no news to a reader.
bool range_is_news(const Option& option) { return option.high < kFar && option.high < kExact; }

}  // namespace

std::string_view group_title(Group group) {
  constexpr std::string_view kTitles[kGroups] = {
      "Output", "Camera", "Light", "Material and faces", "Methods", "Colours", "Work and limits", "Report"};
  return kTitles[static_cast<int>(group)];
}

const std::vector<Option>& options() {
  static const std::vector<Option> all = [] {
    std::vector<Option> rows;
    for (const auto& part :
         {output_options(), also(kCompare, camera_options()), also(kCompare, light_options()),
          also(kCompare, material_options()), method_options(), also(kCompare, picture_options()),
          work_options(), report_options()}) {
      rows.insert(rows.end(), part.begin(), part.end());
    }
    return rows;
  }();
  return all;
}

const std::vector<Subcommand>& subcommands() {
  static const std::vector<Subcommand> all = {
      {.name = "render",
       .user = kRender,
       .run = run_render,
       .help = "turn one or several models into a picture",
       .operand = "MODEL...",
       .operand_help = "a file (OBJ, STL, PLY, OFF, glTF, GLB), - for standard input, or a built-in shape; "
                       "several are shown together",
       .least = 1,
       .most = 10000,
       .examples =
           {{"render teapot.obj -o teapot.png", "a picture of a file"},
            {"render shape:teapot -o teapot.png --size 640x480 --background transparent",
             "a built-in shape on nothing"},
            {"render part.stl -o part.png --up-axis z --view front --orthographic --color 0.3,0.5,0.8",
             "a part for printing, upright, without perspective"},
            {"render - -o - --format png < model.glb > model.png", "from a pipe to a pipe"},
            {"render shape:teapot -o teapot.png --repeat 9 --json", "times and the picture's hash"}}},
      {.name = "compare",
       .user = kCompare,
       .run = run_compare,
       .help = "measure how far pictures, or shading methods on a model, are from a reference",
       .operand = "REFERENCE CANDIDATE...|MODEL...",
       .operand_help =
           "pictures (PNG, or PPM of type P6), the reference first; the status is 1 if one differs. With "
           "--methods models, as for blysk render, and the status is 1 only beyond --max-nmse or "
           "--max-difference",
       .least = 1,
       .most = 10000,
       .examples = {{"compare expected.png actual.png", "status 0 if every pixel is the same, 1 if not"},
                    {"compare expected.png actual.png --max-difference 2 --difference difference.png",
                     "two levels are forgiven; where the pictures differ"},
                    {"compare expected.png actual.png --json", "the same for programs"},
                    {"compare shape:teapot --methods all --repeat 3 --report teapot.html",
                     "errors, times and pictures of all shading methods on one page"}}},
      {.name = "replicate",
       .user = kReplicate,
       .run = run_replicate,
       .help = "measure the papers' tables and claims again, and say which hold",
       .operand = "[MODEL...]",
       .operand_help = "files or built-in shapes to measure besides the study's own scenes",
       .least = 0,
       .most = 100,
       .examples = {{"replicate --study shading --quick", "does it work? without --quick the times count"},
                    {"replicate --study shading --quick --json", "for programs"},
                    {"replicate --study shading bunny.ply dragon.ply",
                     "errors and frames of these models too"},
                    {"replicate --study abuffer --scenes soup-5", "one scene"},
                    {"replicate --study shading --quick --markdown -o . > replication.md",
                     "a page with plots"}}},
      {.name = "info",
       .user = kInfo,
       .run = run_info,
       .help = "tell what is in a model file",
       .operand = "MODEL",
       .operand_help = "a file, - for standard input, or a built-in shape",
       .least = 1,
       .most = 1,
       .examples = {{"info teapot.obj", "counts, bounds, materials, cameras, problems"},
                    {"info shape:teapot --json", "the same for programs"}}},
      {.name = "methods",
       .user = kMethods,
       .run = run_methods,
       .help = "list the methods that can be selected, the default of each kind first",
       .examples = {{"methods", "names, titles and sources"},
                    {"methods --json", "every field"},
                    {"methods --markdown", "for a web page"}}},
      {.name = "verify",
       .user = kVerify,
       .run = run_verify,
       .help = "render built-in scenes and compare their bytes with the hashes that this version publishes",
       .examples = {{"verify", "every instruction set of this processor"},
                    {"verify --isa scalar --threads 1", "one of them"}}},
      {.name = "man",
       .user = kMan,
       .run = run_man,
       .help = "print the manual page",
       .examples = {{"man | man -l -", "read it"}, {"man --markdown", "for a web page"}}},
      {.name = "completion",
       .user = kCompletion,
       .run = run_completion,
       .help = "print a script that completes command lines",
       .operand = "SHELL",
       .operand_help = "the shell it is for",
       .least = 1,
       .most = 1,
       .operand_choices = {"bash"},
       .examples = {{"completion bash > ~/.local/share/bash-completion/completions/blysk",
                     "for every new shell"}}},
  };
  return all;
}

const std::vector<ExitStatus>& exit_statuses() {
  static const std::vector<ExitStatus> all = {
      {0, "done"},
      {1, "pictures differ (compare, verify)"},
      {2, "wrong usage"},
      {3, "an input cannot be read or is not valid"},
      {4, "the output cannot be written"},
      {5, "a limit was reached, or memory ran out"},
      {70, "a bug in blysk"},
      {130, "interrupted; nothing half-written is left"},
  };
  return all;
}

const Option& option(std::string_view name) {
  for (const Option& row : options()) {
    if (row.name == name) return row;
  }
  std::abort();
}

std::vector<const Option*> options_of(const Subcommand& subcommand) {
  std::vector<const Option*> found;
  for (const Option& row : options()) {
    if ((row.users & subcommand.user) != 0) found.push_back(&row);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Option* a, const Option* b) { return a->group < b->group; });
  return found;
}

std::string domain(const Option& option) {
  switch (option.type) {
    case Type::flag:
    case Type::text:
    case Type::path:
      return "";
    case Type::choice:
      return "one of " + join(option.choices, ", ");
    case Type::method:
      return "one of " + join(option.choices, ", ") + settings_of(option.kind);
    case Type::methods:
      return "some of " + join(option.choices, ", ") + ", comma-separated";
    case Type::choices:
      return "some of " + join(option.choices, ", ") + ", comma-separated";
    case Type::integer:
      return range_is_news(option) ? "a whole number, " + number_range(option)
                                   : "a whole number, " + number_text(option.low) + " or more";
    case Type::number:
      return "a number, " + number_range(option);
    case Type::optional_number:
      return "a number over 0, or nothing";
    case Type::bytes:
      return "a whole number, also with K, M, G or T";
    case Type::size:
      return "width x height, each " + number_range(option);
    case Type::point:
      return "three numbers";
    case Type::direction:
      return "three numbers, not all 0";
    case Type::light:
      return "three numbers, not all 0, or six, the last three 0 to " + number_text(kMaxLight);
    case Type::point_light:
      return "three numbers or six, the last three 0 to " + number_text(kMaxLight);
    case Type::color:
      return "three numbers, each " + number_range(option);
    case Type::background:
      return "r,g,b or r,g,b,a, each 0 to 1, or #rrggbb, or #rrggbbaa, or transparent";
  }
  return "";
}

std::string default_text(const Option& option) {
  return option.initial.empty() ? std::string(option.without) : option.initial;
}

std::string signature(const Option& option) {
  std::string text = option.letter != 0 ? std::string{'-', option.letter, ',', ' '} : std::string();
  text += "--" + std::string(option.name);
  if (!option.value.empty()) text += " " + std::string(option.value);
  return text;
}

}  // namespace blysk::command
