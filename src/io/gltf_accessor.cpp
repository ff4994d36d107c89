#include "io/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <type_traits>

namespace blysk::io::gltf {
namespace {

struct ShapeRow {
  std::string_view name;
  int components;
};
constexpr std::array<ShapeRow, 7> kShapes{
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

std::uint64_t size_of(Component component) {
  switch (component) {
    case Component::i8:
    case Component::u8:
      return 1;
    case Component::i16:
    case Component::u16:
      return 2;
    case Component::u32:
    case Component::f32:
      return 4;
  }
  return 4;
}

// Columns of matrices start at multiples of four bytes, which is seen in the small types.
std::uint64_t size_of(const Elements& elements) {
  const std::uint64_t one = size_of(elements.component);
  const auto columns = [one](std::uint64_t n) { return n * ((n * one + 3) / 4 * 4); };
  switch (elements.shape) {
    case Shape::mat2:
      return columns(2);
    case Shape::mat3:
      return columns(3);
    case Shape::mat4:
      return columns(4);
    default:
      return one * static_cast<std::uint64_t>(components(elements.shape));
  }
}

Component read_component(Context& context, Json json) {
  context.require(json, "componentType");
  const std::uint64_t number = context.whole(json, "componentType", 0, 65535, 5126);
  switch (number) {
    case 5120:
      return Component::i8;
    case 5121:
      return Component::u8;
    case 5122:
      return Component::i16;
    case 5123:
      return Component::u16;
    case 5125:
      return Component::u32;
    case 5126:
      return Component::f32;
    default:
      context.fail(json["componentType"],
                   std::to_string(number) + " is none of the component types 5120 to 5126");
      return Component::f32;
  }
}

Shape read_shape(Context& context, Json json) {
  context.require(json, "type");
  const std::string_view type = context.text(json, "type");
  for (std::size_t i = 0; i < kShapes.size(); ++i) {
    if (kShapes[i].name == type) return static_cast<Shape>(i);
  }
  context.fail(json["type"], in_quotes(type) + " is none of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
  return Shape::scalar;
}

template <class T>
T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

// Of unsigned components, as those of sparse indices are.
std::uint64_t load_index(Component component, const std::byte* from) {
  if (component == Component::u8) return load<std::uint8_t>(from);
  return component == Component::u16 ? load<std::uint16_t>(from) : load<std::uint32_t>(from);
}

template <class Out, class T>
Out convert(T value, bool normalized) {
  const auto out = static_cast<Out>(value);
  if (!normalized || !std::is_integral_v<T> || !std::is_same_v<Out, float>) return out;
  // The lowest signed value lies beyond -1.
  return std::max(out / static_cast<Out>(std::numeric_limits<T>::max()), static_cast<Out>(-1));
}

template <class T, class Out>
void convert_element(const std::byte* from, Out* to, int count, bool normalized) {
  for (int c = 0; c < count; ++c) {
    to[c] = convert<Out>(load<T>(from + static_cast<std::size_t>(c) * sizeof(T)), normalized);
  }
}

// Calls with a value of the C++ type of the component.
template <class Work>
void with_type(Component component, const Work& work) {
  switch (component) {
    case Component::i8:
      return work(std::int8_t{});
    case Component::u8:
      return work(std::uint8_t{});
    case Component::i16:
      return work(std::int16_t{});
    case Component::u16:
      return work(std::uint16_t{});
    case Component::u32:
      return work(std::uint32_t{});
    case Component::f32:
      return work(float{});
  }
}

}  // namespace

int components(Shape shape) { return kShapes[static_cast<std::size_t>(shape)].components; }
bool is_unsigned(Component component) {
  return component == Component::u8 || component == Component::u16 || component == Component::u32;
}
std::string_view shape_name(Shape shape) { return kShapes[static_cast<std::size_t>(shape)].name; }

Accessors::Accessors(Context& context, Json root, Buffers& buffers) : context_(context), buffers_(buffers) {
  if (context_.failed()) return;
  for (const Json& json : context_.list(root, "accessors")) {
    accessors_.push_back(parse(json));
    if (context_.failed()) return;
  }
}

Accessor Accessors::parse(Json json) {
  Accessor accessor;
  accessor.json = json;
  context_.require(json, "count");
  accessor.count = context_.whole(json, "count", 0, kMaxWhole, 0);
  accessor.normalized = context_.flag(json, "normalized", false);
  accessor.elements.view = context_.index(json, "bufferView", buffers_.views(), "buffer view");
  accessor.elements.offset = context_.whole(json, "byteOffset", 0, kMaxWhole, 0);
  accessor.elements.component = read_component(context_, json);
  accessor.elements.shape = read_shape(context_, json);
  if (const Json sparse = context_.object(json, "sparse")) parse_sparse(accessor, sparse);
  return accessor;
}

void Accessors::parse_sparse(Accessor& accessor, Json sparse) {
  const auto place = [&](std::string_view name) {
    context_.require(sparse, name);
    const Json json = context_.object(sparse, name);
    Elements elements;
    context_.require(json, "bufferView");
    elements.view = context_.index(json, "bufferView", buffers_.views(), "buffer view");
    elements.offset = context_.whole(json, "byteOffset", 0, kMaxWhole, 0);
    return elements;
  };
  context_.require(sparse, "count");
  accessor.sparse_count = context_.whole(sparse, "count", 0, accessor.count, 0);
  accessor.sparse_indices = place("indices");
  accessor.sparse_values = place("values");
  if (context_.failed()) return;
  accessor.sparse_indices.component = read_component(context_, sparse["indices"]);
  accessor.sparse_values.component = accessor.elements.component;
  accessor.sparse_values.shape = accessor.elements.shape;
  if (!is_unsigned(accessor.sparse_indices.component)) {
    context_.fail(sparse["indices"]["componentType"], "indices must be unsigned: 5121, 5123 or 5125");
  }
}

Accessors::Rows Accessors::rows(const Elements& elements, std::uint64_t count, Json where) {
  if (elements.view == kNone) return {};
  const std::span<const std::byte> bytes = buffers_.bytes(elements.view);
  if (context_.failed()) return {};
  const std::uint64_t size = size_of(elements);
  const std::uint64_t given = buffers_.stride(elements.view);
  const std::uint64_t stride = given == 0 ? size : given;
  const std::string view = "bufferViews[" + std::to_string(elements.view) + "]";
  if (stride < size) {
    context_.fail(where, "its elements have " + std::to_string(size) + " bytes, but the byteStride of " +
                             view + " is only " + std::to_string(stride));
    return {};
  }
  const bool starts_inside = elements.offset <= bytes.size() && bytes.size() - elements.offset >= size;
  const std::uint64_t fit = starts_inside ? (bytes.size() - elements.offset - size) / stride + 1 : 0;
  if (count > fit) {
    context_.fail(where, "its " + std::to_string(count) + " elements of " + std::to_string(size) +
                             " bytes do not fit into " + view + ", which has room for " +
                             std::to_string(fit));
    return {};
  }
  return count == 0 ? Rows{} : Rows{bytes.data() + elements.offset, stride};
}

Accessors::Parts Accessors::parts(const Accessor& accessor) {
  return {rows(accessor.elements, accessor.count, accessor.json),
          rows(accessor.sparse_indices, accessor.sparse_count, accessor.json),
          rows(accessor.sparse_values, accessor.sparse_count, accessor.json)};
}

void Accessors::check(int index) { static_cast<void>(parts((*this)[index])); }

template <class Out>
void Accessors::copy(const Accessor& accessor, const Target<Out>& target, bool normalized) {
  // Sparse elements are gone through whole for every range, and ranges may share them.
  if (!context_.allow(accessor.sparse_count, accessor.json)) return;
  const Parts from = parts(accessor);
  if (context_.failed()) return;
  const int n = components(accessor.elements.shape);
  const auto step = static_cast<std::size_t>(target.step);

  with_type(accessor.elements.component, [&]<class T>(T) {
    if (from.base.first == nullptr) {
      for (std::size_t i = 0; i < target.count; ++i) std::fill_n(target.to + i * step, n, Out{});
    } else if (std::is_same_v<T, Out> && n == target.step && from.base.stride == sizeof(Out) * step) {
      std::memcpy(target.to, from.base.first + target.first * from.base.stride,
                  target.count * from.base.stride);
    } else {
      const std::byte* row = from.base.first + target.first * from.base.stride;
      for (std::size_t i = 0; i < target.count; ++i) {
        convert_element<T>(row + i * from.base.stride, target.to + i * step, n, normalized);
      }
    }
    for (std::uint64_t k = 0; k < accessor.sparse_count; ++k) {
      const std::uint64_t element = load_index(accessor.sparse_indices.component,
                                               from.sparse_indices.first + k * from.sparse_indices.stride);
      if (element >= accessor.count) return fail_beyond(accessor, element);
      if (element < target.first || element - target.first >= target.count) continue;
      convert_element<T>(from.sparse_values.first + k * from.sparse_values.stride,
                         target.to + (element - target.first) * step, n, normalized);
    }
  });
}

void Accessors::fail_beyond(const Accessor& accessor, std::uint64_t element) {
  context_.fail(accessor.json["sparse"]["indices"], "index " + std::to_string(element) +
                                                        " is beyond the accessor's " +
                                                        std::to_string(accessor.count) + " elements");
}

void Accessors::read(int index, const Target<float>& target, bool integers_normalized) {
  const Accessor& accessor = (*this)[index];
  copy(accessor, target, accessor.normalized || integers_normalized);
}

void Accessors::read(int index, const Target<std::uint32_t>& target) { copy((*this)[index], target, false); }

}  // namespace blysk::io::gltf
