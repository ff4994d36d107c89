#include "io/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace blysk::io::gltf {
namespace {

std::uint64_t triangle_count(Mode mode, std::uint64_t corners) {
  if (mode == Mode::triangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

// Strips and fans to triangles. Strips are joined by triangles without area, which are left out without a
// word.
Array<std::uint32_t> to_triangles(Mode mode, const Array<std::uint32_t>& corners) {
  Array<std::uint32_t> triangles;
  triangles.reserve(3 * triangle_count(mode, corners.size()));
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    const bool fan = mode == Mode::triangle_fan;
    const std::size_t odd = i % 2;
    const std::uint32_t a = fan ? corners[i + 1] : corners[i];
    const std::uint32_t b = fan ? corners[i + 2] : corners[i + 1 + odd];
    const std::uint32_t c = fan ? corners[0] : corners[i + 2 - odd];
    if (a == b || b == c || c == a) continue;
    triangles.insert(triangles.end(), {a, b, c});
  }
  return triangles;
}

// In double precision, where the squares of the smallest and largest floats are in range.
Vec3f to_unit(Vec3f v, Vec3d fallback) {
  constexpr float kTolerance = 1e-6f;  // of the squared length: what rounding to float leaves
  return std::abs(dot(v, v) - 1.0f) <= kTolerance ? v : to_float(normalize(to_double(v), fallback));
}

void mend_normals(Array<Vec3f>& normals) {
  for (Vec3f& n : normals) n = to_unit(n, {0, 0, 1});
}

void mend_tangents(Array<Vec4f>& tangents) {
  for (Vec4f& t : tangents) {
    const Vec3f axis = to_unit({t.x, t.y, t.z}, {1, 0, 0});
    t = {axis.x, axis.y, axis.z, t.w < 0 ? -1.0f : 1.0f};
  }
}

float unit(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }  // not a number: 0

void mend_colors(Array<Vec4f>& colors) {
  for (Vec4f& c : colors) c = {unit(c.x), unit(c.y), unit(c.z), unit(c.w)};
}

void mend_texcoords(Array<Vec2f>& texcoords) {
  for (Vec2f& t : texcoords) t = {std::isfinite(t.x) ? t.x : 0, std::isfinite(t.y) ? t.y : 0};
}

}  // namespace

Meshes::Meshes(Context& context, Json root, Accessors& accessors)
    : context_(context), accessors_(accessors), materials_(context.list(root, "materials").size()) {
  for (const Json& json : context_.list(root, "meshes")) meshes_.push_back({json, false, {}});
}

const std::vector<Primitive>& Meshes::primitives(int mesh) {
  Entry& entry = meshes_[static_cast<std::size_t>(mesh)];
  if (entry.read) return entry.primitives;
  entry.read = true;
  context_.require(entry.json, "primitives");
  const std::string_view name = entry.json["name"].text();
  std::size_t number = 0;
  for (const Json& json : context_.list(entry.json, "primitives")) {
    const std::string place =
        "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(number++) + "]";
    // The name goes to the primitive and to its mesh.
    if (!context_.allow(2 * name.size(), json)) break;
    read_primitive(entry, json, name.empty() ? place : std::string(name));
    if (context_.failed()) break;
  }
  return entry.primitives;
}

void Meshes::read_primitive(Entry& entry, Json json, std::string name) {
  Primitive p;
  p.json = json;
  p.name = std::move(name);
  p.geometry.mode = static_cast<Mode>(context_.whole(json, "mode", 0, 6, 4));
  p.material = context_.index(json, "material", materials_, "material");
  p.geometry.indices = context_.index(json, "indices", accessors_.size(), "accessor");
  context_.require(json, "attributes");
  const Json attributes = context_.object(json, "attributes");
  if (context_.failed()) return;
  if (p.geometry.mode < Mode::triangles) {
    ++(p.geometry.mode == Mode::points ? points_ : lines_);
    return;
  }
  if (!attributes["POSITION"]) {
    ++without_positions_;
    return;
  }
  read_geometry(json, attributes, p.geometry);
  if (context_.failed()) return;
  const int corners = p.geometry.indices != kNone ? p.geometry.indices : p.geometry.position;
  p.triangles = triangle_count(p.geometry.mode, accessors_[corners].count);
  entry.primitives.push_back(std::move(p));
}

void Meshes::read_geometry(Json primitive, Json attributes, Geometry& g) {
  g.position = attribute(attributes, "POSITION", {Shape::vec3});
  if (context_.failed()) return;
  g.normal = attribute(attributes, "NORMAL", {Shape::vec3});
  g.color = attribute(attributes, "COLOR_0", {Shape::vec3, Shape::vec4});
  g.texcoord0 = attribute(attributes, "TEXCOORD_0", {Shape::vec2});
  g.texcoord1 = attribute(attributes, "TEXCOORD_1", {Shape::vec2});
  // Without normals the specification has tangents ignored.
  if (g.normal != kNone) g.tangent = attribute(attributes, "TANGENT", {Shape::vec4});
  for (const int used : {g.indices, g.position, g.normal, g.color, g.texcoord0, g.texcoord1, g.tangent}) {
    if (used != kNone) accessors_.check(used);
  }
  if (g.indices == kNone || context_.failed()) return;
  const Elements& elements = accessors_[g.indices].elements;
  if (elements.shape != Shape::scalar || !is_unsigned(elements.component)) {
    context_.fail(primitive["indices"], "accessor " + std::to_string(g.indices) +
                                            " must be SCALAR of type 5121, 5123 or 5125 to hold indices");
  }
}

int Meshes::attribute(Json attributes, std::string_view name, std::initializer_list<Shape> shapes) {
  const Json json = attributes[name];
  const int index = context_.index(json, accessors_.size(), "accessor");
  if (index == kNone) return kNone;
  const Shape shape = accessors_[index].elements.shape;
  if (std::find(shapes.begin(), shapes.end(), shape) == shapes.end()) {
    std::string wanted;
    for (const Shape s : shapes) wanted += (wanted.empty() ? "" : " or ") + std::string(shape_name(s));
    context_.fail(json, "accessor " + std::to_string(index) + " is " + std::string(shape_name(shape)) +
                            "; it must be " + wanted);
    return kNone;
  }
  const int position = name == "POSITION" ? index : static_cast<int>(attributes["POSITION"].number());
  const std::uint64_t count = accessors_[index].count, positions = accessors_[position].count;
  if (count != positions) {
    context_.fail(json, "accessor " + std::to_string(index) + " has " + std::to_string(count) +
                            " elements, but POSITION has " + std::to_string(positions));
    return kNone;
  }
  return index;
}

std::uint32_t Meshes::geometry(const Primitive& primitive, std::vector<Mesh>& to) {
  const auto known = built_.find(primitive.geometry);
  if (known != built_.end()) return known->second;
  const auto index = static_cast<std::uint32_t>(to.size());
  to.push_back(build(primitive));
  built_.emplace(primitive.geometry, index);
  return index;
}

Mesh Meshes::build(const Primitive& primitive) {
  Mesh mesh;
  mesh.name = primitive.name;
  read_indices(primitive, mesh.indices);
  if (context_.failed() || mesh.indices.empty()) return mesh;

  // Exporters keep many primitives in one set of vertices; each takes the range that it uses.
  std::uint32_t first = mesh.indices[0], last = first;
  for (const std::uint32_t i : mesh.indices) {
    first = std::min(first, i);
    last = std::max(last, i);
  }
  const std::uint64_t vertices = accessors_[primitive.geometry.position].count;
  if (last >= vertices) {
    const Json indices = primitive.json["indices"];
    context_.fail(indices ? indices : primitive.json, "index " + std::to_string(last) + " is beyond the " +
                                                          std::to_string(vertices) + " vertices");
    return mesh;
  }
  if (first > 0) {
    for (std::uint32_t& i : mesh.indices) i -= first;
  }
  read_attributes(primitive, first, std::uint64_t{last} - first + 1, mesh);
  if (context_.failed()) return mesh;

  std::vector<std::string> problems;
  drop_bad_triangles(mesh, problems);
  for (const std::string& p : problems) context_.problem(p);
  mend_normals(mesh.normals);
  mend_tangents(mesh.tangents);
  mend_colors(mesh.colors);
  mend_texcoords(mesh.texcoords);
  return mesh;
}

void Meshes::read_indices(const Primitive& primitive, Array<std::uint32_t>& indices) {
  const Geometry& g = primitive.geometry;
  const std::uint64_t corners = accessors_[g.indices != kNone ? g.indices : g.position].count;
  const bool list = g.mode == Mode::triangles;
  if (corners > std::numeric_limits<std::uint32_t>::max()) {
    return context_.fail(primitive.json,
                         "has " + std::to_string(corners) + " corners; at most 2^32 - 1 can be read");
  }
  if (!context_.allow((corners + (list ? 0 : 3 * primitive.triangles)) * sizeof(std::uint32_t),
                      primitive.json)) {
    return;
  }
  indices.resize(corners);
  if (g.indices != kNone) {
    accessors_.read(g.indices, Target<std::uint32_t>{indices.data(), 0, corners, 1});
    if (context_.failed()) return;
  } else {
    std::iota(indices.begin(), indices.end(), 0u);
  }
  if (!list) {
    indices = to_triangles(g.mode, indices);
  } else if (corners % 3 != 0) {
    indices.resize(corners - corners % 3);
    context_.problem(primitive.json,
                     "left out the last " + std::to_string(corners % 3) + " corners, which make no triangle");
  }
}

void Meshes::read_attributes(const Primitive& primitive, std::uint64_t first, std::uint64_t count,
                             Mesh& mesh) {
  const Geometry& g = primitive.geometry;
  const auto read = [&](int accessor, auto& array, int floats, bool integers_normalized = false) {
    if (accessor == kNone) return;
    if (!context_.allow(count * sizeof(array[0]), primitive.json)) return;
    array.resize(count);
    accessors_.read(accessor, Target<float>{&array[0].x, first, count, floats}, integers_normalized);
  };
  read(g.position, mesh.positions, 3);
  read(g.normal, mesh.normals, 3);
  read(g.tangent, mesh.tangents, 4);
  read(g.texcoord0, mesh.texcoords, 2);
  read(g.texcoord1, mesh.texcoords1, 2);
  read(g.color, mesh.colors, 4, true);
  if (g.color != kNone && accessors_[g.color].elements.shape == Shape::vec3) {
    for (Vec4f& c : mesh.colors) c.w = 1;
  }
}

void Meshes::report() {
  const auto say = [&](std::uint64_t count, const std::string& what) {
    if (count > 0)
      context_.problem("left out " + std::to_string(count) + (count == 1 ? " primitive " : " primitives ") +
                       what);
  };
  say(points_, "of points; only triangles are drawn");
  say(lines_, "of lines; only triangles are drawn");
  say(without_positions_, "without POSITION");
}

}  // namespace blysk::io::gltf
