// Rows are first taken to have as many corners each as the first one; where that is wrong, a look at each
// row's count tells where the next begins. Blocks of rows are converted in parallel.
#include "io/ply_faces.h"

#include <algorithm>
#include <atomic>

#include "io/ply_values.h"
#include "io/ply_vertices.h"

namespace blysk::io {
namespace {

constexpr std::size_t kRowsPerBlock = 8192;

// Negative counts and indices of 32 bits are read as huge ones, which nothing has.
bool is_usual(PlyType type) {
  return is_integer(type) && (size_of(type) == 4 || type == PlyType::uint8 || type == PlyType::uint16);
}

template <class F>
decltype(auto) with_unsigned(PlyType type, F&& f) {
  if (size_of(type) == 1) return f(std::uint8_t{});
  if (size_of(type) == 2) return f(std::uint16_t{});
  return f(std::uint32_t{});
}

}  // namespace

bool is_index_list(const PlyProperty& p) {
  return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}

std::vector<std::size_t> face_color_properties(const PlyElement& element) {
  std::vector<std::size_t> found;
  unsigned channels = 0;
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& p = element.properties[i];
    const int channel = p.is_list ? -1 : ply_color_channel(p.name);
    if (channel < 0) continue;
    found.push_back(i);
    channels |= 1u << channel;
  }
  constexpr unsigned kRgb = 7;
  if ((channels & kRgb) != kRgb) found.clear();
  return found;
}

struct PlyFaceRows::Plan {
  struct Block {
    std::size_t offset, corner;  // of the first row, of its first corner
  };
  std::vector<Block> blocks;
  std::size_t corners = 0, bytes = 0;
  std::size_t each = 0;  // corners of every row; 0: they differ
};

PlyFaceRows::PlyFaceRows(const PlyElement& element, PlyFormat format, bool with_colors)
    : count_(element.count), format_(format) {
  const PlyProperty* list = nullptr;
  const std::vector<std::size_t> colors =
      with_colors ? face_color_properties(element) : std::vector<std::size_t>{};
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& p = element.properties[i];
    if (p.is_list) {
      if (list != nullptr || !is_index_list(p)) return;
      list = &p;
      continue;
    }
    std::size_t& offset = list != nullptr ? behind_ : before_;
    if (std::find(colors.begin(), colors.end(), i) != colors.end())
      colors_.push_back({ply_color_channel(p.name), p.type, list != nullptr, offset});
    offset += size_of(p.type);
  }
  if (list == nullptr || format == PlyFormat::ascii) return;
  count_type_ = list->count_type;
  index_type_ = list->type;
  usable_ = is_usual(count_type_) && is_usual(index_type_);
}

std::size_t PlyFaceRows::read(std::span<const std::byte> rows, std::uint64_t vertices, Faces& faces,
                              ThreadPool& pool) const {
  return with_unsigned(count_type_, [&](auto count) {
    return with_unsigned(index_type_, [&](auto index) {
      using Count = decltype(count);
      using Index = decltype(index);
      return format_ == PlyFormat::big_endian ? read_as<Count, Index, true>(rows, vertices, faces, pool)
                                              : read_as<Count, Index, false>(rows, vertices, faces, pool);
    });
  });
}

template <class Count, class Index, bool kSwap>
std::size_t PlyFaceRows::read_as(std::span<const std::byte> rows, std::uint64_t vertices, Faces& faces,
                                 ThreadPool& pool) const {
  Plan plan;
  const auto convert = [&] {
    Faces read;
    read.corners.resize(plan.corners);
    if (plan.each != 3) read.sizes.resize(count_);
    if (!colors_.empty()) read.colors.resize(count_);
    std::atomic<bool> all = true;
    pool.for_each(plan.blocks.size(), [&](int, std::size_t block) {
      if (all.load(std::memory_order_relaxed) &&
          !fill<Count, Index, kSwap>(plan, block, rows.data(), vertices, read))
        all.store(false, std::memory_order_relaxed);
    });
    if (all) faces = std::move(read);
    return all.load();
  };
  if (guess<Count, kSwap>(rows, plan) && convert()) return plan.bytes;
  plan = {};
  return scan<Count, kSwap>(rows, plan) && convert() ? plan.bytes : 0;
}

// All rows like the first; false where they would go on behind the end.
template <class Count, bool kSwap>
bool PlyFaceRows::guess(std::span<const std::byte> rows, Plan& plan) const {
  const std::size_t least = before_ + sizeof(Count) + behind_;
  if (count_ == 0 || rows.size() < least) return false;
  plan.each = load<Count, kSwap>(rows.data() + before_);
  const std::uint64_t row_bytes = least + std::uint64_t{plan.each} * size_of(index_type_);
  if (plan.each == 0 || rows.size() / row_bytes < count_) return false;
  for (std::size_t row = 0; row < count_; row += kRowsPerBlock)
    plan.blocks.push_back({row * row_bytes, row * plan.each});
  plan.corners = count_ * plan.each;
  plan.bytes = count_ * row_bytes;
  return true;
}

// False where the rows go on behind the end.
template <class Count, bool kSwap>
bool PlyFaceRows::scan(std::span<const std::byte> rows, Plan& plan) const {
  const std::size_t index_bytes = size_of(index_type_), least = before_ + sizeof(Count) + behind_;
  std::size_t at = 0;
  for (std::uint64_t row = 0; row < count_; ++row) {
    if (row % kRowsPerBlock == 0) plan.blocks.push_back({at, plan.corners});
    if (rows.size() - at < least) return false;
    const Count count = load<Count, kSwap>(rows.data() + at + before_);
    at += least;
    if ((rows.size() - at) / index_bytes < count) return false;
    at += index_bytes * count;
    plan.corners += count;
  }
  plan.bytes = at;
  return true;
}

// False where a vertex is out of range, or a row is not as planned.
template <class Count, class Index, bool kSwap>
bool PlyFaceRows::fill(const Plan& plan, std::size_t block, const std::byte* rows, std::uint64_t vertices,
                       Faces& faces) const {
  const std::byte* row = rows + plan.blocks[block].offset;
  std::uint32_t* corner = faces.corners.data() + plan.blocks[block].corner;
  const std::size_t end = std::min<std::size_t>(count_, (block + 1) * kRowsPerBlock);
  Index largest = 0;
  for (std::size_t face = block * kRowsPerBlock; face < end; ++face) {
    const Count count = load<Count, kSwap>(row + before_);
    if (plan.each != 0 && count != plan.each) return false;
    const std::byte* index = row + before_ + sizeof(Count);
    for (Count k = 0; k < count; ++k, index += sizeof(Index)) {
      const Index vertex = load<Index, kSwap>(index);
      largest = std::max(largest, vertex);
      *corner++ = vertex;
    }
    if (!faces.sizes.empty()) faces.sizes[face] = count;
    if (!colors_.empty()) faces.colors[face] = color<kSwap>(row, index);
    row = index + behind_;
  }
  return largest < vertices;
}

template <bool kSwap>
Vec4f PlyFaceRows::color(const std::byte* row, const std::byte* list_end) const {
  Vec4f color{0, 0, 0, 1};
  for (const Color& c : colors_) {
    const std::byte* at = (c.behind_list ? list_end : row) + c.offset;
    const double value = with_type(
        c.type, [&](auto t) -> double { return static_cast<double>(load<decltype(t), kSwap>(at)); });
    (&color.x)[c.channel] = ply_color(c.channel, c.type, value);
  }
  return color;
}

}  // namespace blysk::io
