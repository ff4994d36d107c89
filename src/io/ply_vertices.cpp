#include "io/ply_vertices.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <type_traits>

#include "io/ply_values.h"
#include "math/srgb.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

constexpr std::size_t kRowsTogether = 1024;  // rows that stay in the first cache while every column passes

// 32-bit integers hold the same 0..255 as bytes do.
double largest(PlyType type) {
  switch (type) {
    case PlyType::int16:
    case PlyType::uint16:
      return 65535;
    case PlyType::float32:
    case PlyType::float64:
      return 1;
    default:
      return 255;
  }
}

// Beyond the range of float: infinite.
float to_single(double value) {
  constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
  if (value > kMost) return std::numeric_limits<float>::infinity();
  if (value < -kMost) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(value);
}

float tone(PlyType type, double value) {
  const double most = largest(type);
  if (most != 255) return static_cast<float>(srgb_to_linear(value / most));
  return srgb_to_linear(static_cast<std::uint8_t>(value > 0 ? std::min(value, 255.0) + 0.5 : 0.0));
}

float alpha(PlyType type, double value) {
  return value > 0 ? static_cast<float>(std::min(value / largest(type), 1.0)) : 0.0f;
}

}  // namespace

float ply_color(int channel, PlyType type, double value) {
  return channel == 3 ? alpha(type, value) : tone(type, value);
}

int ply_color_channel(std::string_view name) {
  if (name.starts_with("diffuse_")) name.remove_prefix(8);
  constexpr std::string_view kNames[][2] = {{"red", "r"}, {"green", "g"}, {"blue", "b"}, {"alpha", "a"}};
  for (int channel = 0; channel < 4; ++channel) {
    if (name == kNames[channel][0] || name == kNames[channel][1]) return channel;
  }
  return -1;
}

PlyVertices::PlyVertices(const PlyElement& element) : count_(element.count) {
  std::size_t offset = 0;
  bool taken[5][4] = {};  // attribute, component
  for (const PlyProperty& property : element.properties) {
    Column column = find_column(property);
    if (property.is_list) column.attribute = Attribute::none;
    bool& twice = taken[static_cast<int>(column.attribute)][column.component];
    if (twice) column.attribute = Attribute::none;
    twice = true;
    column.type = property.type;
    column.offset = offset;
    offset += size_of(property.type);
    columns_.push_back(column);
  }
  const auto drop = [&](Attribute attribute, int components) {
    if (has(attribute, components)) return;
    for (Column& c : columns_) {
      if (c.attribute == attribute) c.attribute = Attribute::none;
    }
  };
  drop(Attribute::normal, 3);
  drop(Attribute::color, 3);
  drop(Attribute::texcoord, 2);
}

PlyVertices::Column PlyVertices::find_column(const PlyProperty& property) {
  struct Name {
    std::string_view name;
    Attribute attribute;
    int component;
  };
  static constexpr Name kNames[] = {
      {"x", Attribute::position, 0},         {"y", Attribute::position, 1},
      {"z", Attribute::position, 2},         {"nx", Attribute::normal, 0},
      {"ny", Attribute::normal, 1},          {"nz", Attribute::normal, 2},
      {"s", Attribute::texcoord, 0},         {"t", Attribute::texcoord, 1},
      {"u", Attribute::texcoord, 0},         {"v", Attribute::texcoord, 1},
      {"texture_u", Attribute::texcoord, 0}, {"texture_v", Attribute::texcoord, 1},
      {"texture_s", Attribute::texcoord, 0}, {"texture_t", Attribute::texcoord, 1}};
  Column column;
  for (const Name& n : kNames) {
    if (n.name != property.name) continue;
    column.attribute = n.attribute;
    column.component = n.component;
  }
  if (const int channel = ply_color_channel(property.name); channel >= 0) {
    column.attribute = Attribute::color;
    column.component = channel;
  }
  return column;
}

// Components 0..components-1 are all there.
bool PlyVertices::has(Attribute attribute, int components) const {
  int found = 0;
  for (const Column& c : columns_) found += c.attribute == attribute && c.component < components;
  return found == components;
}

std::uint64_t PlyVertices::bytes_per_vertex() const {
  return sizeof(Vec3f) + (has(Attribute::normal, 3) ? sizeof(Vec3f) : 0) +
         (has_colors() ? sizeof(Vec4f) : 0) + (has(Attribute::texcoord, 2) ? sizeof(Vec2f) : 0);
}

void PlyVertices::allocate(Mesh& mesh) {
  const bool normals = has(Attribute::normal, 3);
  if (!normals) mesh.positions.reserve(with_room_for_creases(count_));
  mesh.positions.resize(count_);
  if (normals) mesh.normals.resize(count_);
  if (has(Attribute::texcoord, 2)) mesh.texcoords.resize(count_);
  if (has_colors()) {
    if (has(Attribute::color, 4)) {
      mesh.colors.resize(count_);
    } else {
      mesh.colors.resize(count_, Vec4f{0, 0, 0, 1});
    }
  }
  for (Column& c : columns_) {
    const auto aim = [&](float* first, std::size_t step) {
      c.first = first + c.component;
      c.step = step;
    };
    if (count_ == 0) c.attribute = Attribute::none;
    switch (c.attribute) {
      case Attribute::none:
        break;
      case Attribute::position:
        aim(&mesh.positions[0].x, 3);
        break;
      case Attribute::normal:
        aim(&mesh.normals[0].x, 3);
        break;
      case Attribute::color:
        aim(&mesh.colors[0].x, 4);
        break;
      case Attribute::texcoord:
        aim(&mesh.texcoords[0].x, 2);
        break;
    }
  }
}

void PlyVertices::store(std::size_t vertex, std::size_t property, double value) const {
  const Column& c = columns_[property];
  if (c.attribute == Attribute::none) return;
  float& to = c.first[vertex * c.step];
  if (c.attribute != Attribute::color) {
    to = to_single(value);
  } else {
    to = ply_color(c.component, c.type, value);
  }
}

template <class T, bool kSwap>
void PlyVertices::store_block(const Column& c, const std::byte* rows, std::size_t row_bytes,
                              std::size_t begin, std::size_t end) {
  const std::byte* from = rows + begin * row_bytes + c.offset;
  float* to = c.first + begin * c.step;
  const auto each = [&](auto convert) {
    for (std::size_t i = begin; i < end; ++i, from += row_bytes, to += c.step)
      *to = convert(load<T, kSwap>(from));
  };
  if (c.attribute == Attribute::color) {
    const PlyType type = c.type;
    if (c.component == 3) {
      each([type](T v) { return alpha(type, static_cast<double>(v)); });
    } else {
      each([type](T v) { return tone(type, static_cast<double>(v)); });
    }
  } else if constexpr (std::is_same_v<T, double>) {
    each(to_single);
  } else {
    each([](T v) { return static_cast<float>(v); });
  }
}

void PlyVertices::store_rows(const std::byte* rows, std::size_t row_bytes, PlyFormat format,
                             ThreadPool& pool) const {
  pool.for_each((count_ + kRowsTogether - 1) / kRowsTogether, [&](int, std::size_t block) {
    const std::size_t begin = block * kRowsTogether, end = std::min(count_, begin + kRowsTogether);
    for (const Column& c : columns_) {
      if (c.attribute == Attribute::none) continue;
      with_type(c.type, [&](auto t) {
        using T = decltype(t);
        if (format == PlyFormat::big_endian) {
          store_block<T, true>(c, rows, row_bytes, begin, end);
        } else {
          store_block<T, false>(c, rows, row_bytes, begin, end);
        }
      });
    }
  });
}

}  // namespace blysk::io
