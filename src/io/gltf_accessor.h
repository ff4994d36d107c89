// io/gltf_accessor.h - accessors: typed, strided, normalised and sparse arrays in buffer views.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "io/gltf_buffers.h"
#include "io/gltf_context.h"

namespace blysk::io::gltf {

/// Component types by their numbers in the file.
enum class Component : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

enum class Shape : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };

/// Where elements lie; one of them without a view is all zeros.
struct Elements {
  int view = kNone;
  std::uint64_t offset = 0;
  Component component = Component::f32;
  Shape shape = Shape::scalar;
};

struct Accessor {
  Json json;
  Elements elements;
  bool normalized = false;
  std::uint64_t count = 0;
  std::uint64_t sparse_count = 0;
  Elements sparse_indices, sparse_values;
};

/// Where elements first .. first + count - 1 of an accessor go.
template <class T>
struct Target {
  T* to = nullptr;
  std::uint64_t first = 0, count = 0;
  int step = 1;  ///< between elements of `to`; at least the accessor's components
};

class Accessors {
 public:
  Accessors(Context& context, Json root, Buffers& buffers);

  [[nodiscard]] std::size_t size() const { return accessors_.size(); }
  [[nodiscard]] const Accessor& operator[](int index) const {
    return accessors_[static_cast<std::size_t>(index)];
  }

  /// Fails unless all elements lie in their buffer views, and those in their data.
  void check(int index);
  /// Writes elements as floats: integers by their value or, when normalised, as 0..1 or -1..1, which
  /// `integers_normalized` asks for whatever the file says.
  void read(int index, const Target<float>& target, bool integers_normalized = false);
  /// The same for unsigned integers as they are.
  void read(int index, const Target<std::uint32_t>& target);

 private:
  // Elements in memory; none where an accessor without a view is all zeros.
  struct Rows {
    const std::byte* first = nullptr;
    std::uint64_t stride = 0;
  };
  struct Parts {
    Rows base, sparse_indices, sparse_values;
  };

  [[nodiscard]] Accessor parse(Json json);
  void parse_sparse(Accessor& accessor, Json sparse);
  [[nodiscard]] Rows rows(const Elements& elements, std::uint64_t count, Json where);
  [[nodiscard]] Parts parts(const Accessor& accessor);
  template <class Out>
  void copy(const Accessor& accessor, const Target<Out>& target, bool normalized);
  void fail_beyond(const Accessor& accessor, std::uint64_t element);

  Context& context_;
  Buffers& buffers_;
  std::vector<Accessor> accessors_;
};

/// Components of an element.
[[nodiscard]] int components(Shape shape);
[[nodiscard]] bool is_unsigned(Component component);
/// "VEC3".
[[nodiscard]] std::string_view shape_name(Shape shape);

}  // namespace blysk::io::gltf
