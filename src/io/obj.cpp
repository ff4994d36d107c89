// Wavefront OBJ: polygons with materials. Free-form curves and surfaces, points and lines are left out.
// A mesh is what one object or group has of one material.
#include <algorithm>
#include <map>

#include "io/faces.h"
#include "io/mtl.h"
#include "io/obj_mesh.h"
#include "io/obj_parse.h"
#include "io/obj_text.h"
#include "io/reader.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

constexpr std::size_t kMostMaterialsNamed = 8;  // materials that one sentence lists

std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void report_omissions(const ObjText& text, const ObjOmissions& o, std::vector<std::string>& problems) {
  const auto line = [&](std::size_t offset) { return "in line " + std::to_string(text.line_of(offset)); };
  if (o.short_faces > 0) {
    problems.push_back("left out " + count_of(o.short_faces, "face", "faces") +
                       " of fewer than 3 corners, the first " + line(o.first_short_face));
  }
  if (o.points > 0)
    problems.push_back("left out " + count_of(o.points, "point statement", "point statements"));
  if (o.lines > 0) problems.push_back("left out " + count_of(o.lines, "line statement", "line statements"));
  if (o.unknown > 0) {
    problems.push_back("left out " + count_of(o.unknown, "statement", "statements") +
                       " that Blysk does not know, the first is " + in_quotes(o.first_keyword) + " " +
                       line(o.first_unknown));
  }
  if (o.texcoords) problems.push_back("faces refer to texture coordinates, but the file has none");
  if (o.normals) problems.push_back("faces refer to normals, but the file has none");
}

// Adds materials and the textures they name to the scene, once each.
class MaterialList {
 public:
  MaterialList(const MtlLibrary& library, Scene& scene) : library_(library), scene_(scene) {}

  // The index of the material.
  std::uint32_t add(std::string_view name) {
    const auto [at, is_new] = indices_.try_emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
    if (!is_new) return at->second;
    const MtlMaterial* known = name.empty() ? nullptr : library_.find(name);
    Material material = known == nullptr ? Material{} : known->material;
    material.name = printable(name);
    if (known != nullptr) {
      material.color_texture = texture(known->color_map);
      material.normal_texture = texture(known->normal_map);
    } else if (!name.empty() && missing_++ < kMostMaterialsNamed) {
      missing_names_ += (missing_names_.empty() ? "" : ", ") + in_quotes(name);
    }
    scene_.materials.push_back(std::move(material));
    return at->second;
  }

  void report() {
    if (missing_ == 0) return;
    if (missing_ > kMostMaterialsNamed)
      missing_names_ += " and " + std::to_string(missing_ - kMostMaterialsNamed) + " more";
    scene_.problems.push_back("no material file defines " + missing_names_ + ", so the default stands in");
  }

 private:
  int texture(const std::string& file) {
    if (file.empty()) return Material::kNoTexture;
    const auto [at, is_new] = textures_.try_emplace(file, static_cast<int>(scene_.textures.size()));
    if (is_new) scene_.textures.emplace_back().uri = file;
    return at->second;
  }

  const MtlLibrary& library_;
  Scene& scene_;
  std::map<std::string_view, std::uint32_t> indices_;
  std::map<std::string, int> textures_;
  std::size_t missing_ = 0;
  std::string missing_names_;
};

// "object", "group", "object/group"; the material's where the file names neither.
std::string name_of(const ObjPart& part) {
  const auto& [object, group] = part.name;
  if (object.empty() && group.empty()) return printable(part.material);
  if (object.empty() || group.empty() || object == group) return printable(group.empty() ? object : group);
  return printable(object) + "/" + printable(group);
}

Status check_size(const Source& source, const ObjFile& file) {
  const std::size_t corners = file.corner_positions.size();
  if (corners >= ObjFile::kNone) {
    return Error{ErrorCode::limit, "has more than 4294967294 face corners", source.name, 0};
  }
  // At the worst, each corner becomes a vertex with everything, beside the lists of the file.
  const bool attributes = !file.corner_texcoords.empty() || !file.corner_normals.empty();
  const std::uint64_t bytes = corners * (attributes ? 64u : 16u) + file.positions.size() * 32u;
  return check_limits(source, corners - 2 * file.faces, bytes);
}

}  // namespace

Result<Scene> read_obj(const Source& source) {
  ObjText text(source.text());
  Result<ObjFile> file = parse_obj(source, text);
  if (!file) return file.error();
  if (Status s = check_size(source, *file); !s) return s.error();

  Scene scene;
  if (file->faces == 0 && file->omissions.short_faces == 0)
    scene.problems.push_back(no_faces(file->positions.size()));
  report_omissions(text, file->omissions, scene.problems);
  MtlLibrary library;
  for (const ObjEvent& event : file->events) {
    if (event.kind == ObjEvent::Kind::library) library.load(source, event.text, scene.problems);
  }
  if (file->faces == 0) return scene;
  const auto [parts, joined] = find_parts(*file);
  if (joined) {
    scene.problems.push_back("has more than " + std::to_string(kMostGroups) +
                             " groups, which are joined: there is a mesh for each material");
  }
  smooth_groups(*file, parts);
  const ModelOptions& options = source.options;
  const Array<std::uint32_t> normals =
      crease_normals(*file, parts, options.crease_deg.value_or(ModelOptions::kCreaseDeg), options.threads);
  std::vector<Mesh> meshes = make_meshes(std::move(*file), parts, normals);

  MaterialList materials(library, scene);
  std::size_t largest = 0;
  for (const Mesh& mesh : meshes) largest = std::max(largest, mesh.triangles());
  ThreadPool pool(largest < kTrianglesWorthThreads ? 1 : options.threads);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    Mesh& mesh = meshes[i];
    mesh.name = name_of(parts[i]);
    drop_bad_triangles(mesh, scene.problems, pool);
    if (mesh.indices.empty()) continue;
    mend_normals(mesh);
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    instance.material = materials.add(parts[i].material);
    instance.name = mesh.name;
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back(std::move(instance));
  }
  materials.report();
  return scene;
}

}  // namespace blysk::io
