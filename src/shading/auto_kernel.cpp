// For each triangle the cheapest shading whose error is bounded: linear light where fetch_linear_light() says
// that it fits, else curved light where fetch_curved_light() does, else Phong shading.
//
// docs/auto.md explains the choice. It depends on the triangle alone. Rows of a tile are taken together:
// first its triangles are found, then they are set up sixteen at a time, then its pixels are shaded, run by
// run; each triangle is set up once, and not for every pixel.
#include "shading/auto_ways.h"
#include "shading/phong.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

// Pixels of a row of the tile as bits.
using RowBits = std::uint64_t;
static_assert(kTileSize == 64);

BLYSK_INLINE int lowest(RowBits bits) { return __builtin_ctzll(bits); }

// Neighbouring pixels of one triangle in a row.
struct Run {
  std::uint8_t first, last;
  std::uint16_t number;  // the triangle's
};

// Triangles of some rows of a tile, numbered from 1 as they appear.
class Census {
 public:
  BLYSK_INLINE void clear() {
    count_ = runs_ = 0;
    triangle_[0] = -1;
    std::memset(place_, 0, sizeof place_);
  }
  [[nodiscard]] BLYSK_INLINE int count() const { return count_; }
  [[nodiscard]] BLYSK_INLINE int runs() const { return runs_; }
  [[nodiscard]] BLYSK_INLINE Run run(int i) const { return run_[i]; }
  [[nodiscard]] BLYSK_INLINE bool has_room_for_row() const { return count_ + kTileSize <= kMostTriangles; }

  // Of a row with these ids; runs of its pixels end at `ends`.
  BLYSK_INLINE void add_row(const std::uint32_t* id, RowBits pixels, RowBits ends) {
    RowBits starts = pixels & ~((pixels & ~ends) << 1);
    int count = count_, runs = runs_;
    for (; starts != 0; starts &= starts - 1, ends &= ends - 1) {
      const int first = lowest(starts);
      const auto triangle = static_cast<std::int32_t>(id[first]);
      std::uint32_t at = (id[first] * 2654435769u) >> (32 - kBits);
      std::int32_t number = place_[at];
      // Whether it is new cannot be foreseen: nothing branches on that alone.
      while (__builtin_expect(static_cast<int>(number != 0) & static_cast<int>(triangle_[number] != triangle),
                              0)) {
        at = (at + 1) & (kPlaces - 1);
        number = place_[at];
      }
      const int is_new = static_cast<int>(number == 0);
      count += is_new;
      number |= -is_new & count;
      triangle_[number] = triangle;
      place_[at] = static_cast<std::uint16_t>(number);
      run_[runs++] = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(lowest(ends)),
                      static_cast<std::uint16_t>(number)};
    }
    count_ = count;
    runs_ = runs;
  }

  // Ids by number; there is one for 0, and for lanes past the last.
  BLYSK_INLINE const std::int32_t* ids() {
    triangle_[0] = triangle_[1];
    for (int i = 1; i <= kLanes; ++i) triangle_[count_ + i] = triangle_[1];
    return triangle_;
  }

 private:
  static constexpr int kBits = 12, kPlaces = 1 << kBits;

  int count_ = 0, runs_ = 0;
  std::uint16_t place_[kPlaces];  // numbers by hash
  std::int32_t triangle_[kTriangleRoom];
  Run run_[kTilePixels];
};

// Twice the area of the pixels that are a triangle's own. Where pixels are sampled, those that an edge
// crosses are shared: |dx| + |dy| of them, half of whose area is the triangle's.
BLYSK_INLINE float own_size(const Corners<float>& c, bool in_samples) {
  if (c.unplaced) return 0.0f;
  float size = doubled_area(c);
  for (int k = 0; in_samples && k < 3; ++k) {
    const int next = (k + 1) % 3;
    size -= (magnitude(c.x[next] - c.x[k]) + magnitude(c.y[next] - c.y[k])) * float{kSubpixels};
  }
  return max(size, 0.0f);
}

class AutoShader {
 public:
  explicit BLYSK_INLINE AutoShader(const ShadeJob& job)
      : job_(job), phong_(job), curved_(has_curved_light(*job.draw)) {}

  // Some triangles, spread over the mesh, stand for all. Those that fit have to have kSetUpPixels a triangle
  // that is looked at, and a share of all pixels: docs/auto.md, "When a draw is Phong's".
  BLYSK_INLINE bool pays() {
    constexpr float kSetUpPixels = 5, kShare = 1.0f / 3;
    const std::uint32_t first = job_.draw->id_base, triangles = job_.draw->id_count;
    constexpr int kMost = 8 * kLanes;
    const int samples = max(min(static_cast<int>(triangles / kLanes), kMost - 1), kLanes - 1);
    std::int32_t ids[kMost];
    ids[0] = static_cast<std::int32_t>(first);
    for (int i = 1; i < kMost; ++i) {
      const std::uint64_t middle = 2 * static_cast<unsigned>(min(i, samples)) - 1;
      ids[i] = static_cast<std::int32_t>(first + triangles * middle / (2 * static_cast<unsigned>(samples)));
    }
    set_up(ids, samples);
    float all = 0, fitting = 0;
    for (int i = 1; i <= samples; ++i) {
      const auto c = fetch_corners<float>(job_, ids[i] - static_cast<std::int32_t>(first));
      const float size = own_size(c, job_.draw->in_samples);
      all += size;
      if (planes_.way(i) != kPhong) fitting += size;
    }
    return fitting >= kShare * all + static_cast<float>(samples) * pixels_size(kSetUpPixels);
  }

  BLYSK_INLINE void shade() {
    for (int row = 0; row < job_.height;) {
      census_.clear();
      const int first = row;
      for (; row < job_.height && census_.has_room_for_row(); ++row) number_row(row);
      if (census_.count() == 0) continue;
      set_up(census_.ids(), census_.count());
      for (int r = first, begin = 0; r < row; begin = ends_[r++]) shade_row(r, begin);
    }
    phong_.flush();
    // Surfaces that share a pixel with others come one a triangle: all are Phong's.
    if (job_.samples != nullptr) phong_.shade_fragments();
  }

 private:
  BLYSK_INLINE void set_up(const std::int32_t* ids, int count) {
    planes_.set_up(job_, ids, count, left_);
    if (curved_ && left_.count > 0) surfaces_.set_up(job_, left_, planes_);
  }

  BLYSK_INLINE void number_row(int row) {
    const std::uint32_t* id = job_.buffers->id + row * kTileSize;
    RowBits pixels = 0, changes = 0;
    for (int column = 0; column < job_.width; column += kLanes) {
      pixels |= RowBits{phong_.own_pixels(row, column)} << column;
      changes |= RowBits{to_bits(load(id + column) != load(id + column + 1))} << column;
    }
    // Past the last column, too, a triangle ends.
    census_.add_row(id, pixels, pixels & (changes | ~(pixels >> 1)));
    ends_[row] = census_.runs();
  }

  // Runs from `begin` on, of which `ends_` knows where the row's end.
  BLYSK_INLINE void shade_row(int row, int begin) {
    const float y = static_cast<float>((job_.y + row) * kSubpixels + kSubpixels / 2);
    std::uint32_t* color = job_.buffers->color + row * kTileSize;
    RowBits phong = 0;
    for (int r = begin; r < ends_[row]; ++r) {
      const Run run = census_.run(r);
      const RowBits pixels = (RowBits{2} << (run.last - run.first)) - 1;
      const Way way = planes_.way(run.number);
      if (way == kPhong) {
        phong |= pixels << run.first;
        continue;
      }
      const RunPixels to{static_cast<float>((job_.x + run.first) * kSubpixels + kSubpixels / 2), y, pixels,
                         color + run.first};
      if (way == kPlane) {
        planes_.shade(run.number, to);
      } else {
        surfaces_.shade(way, to);
      }
    }
    for (int column = 0; column < kTileSize && phong >> column != 0;) {
      column += phong_.shade_block(row, column, static_cast<unsigned>(phong >> column) & 0xffff);
    }
  }

  const ShadeJob& job_;
  DrawShader<Phong, ColorSink> phong_;
  const bool curved_;
  Census census_;
  Undecided left_;
  Planes planes_;
  Surfaces surfaces_;
  int ends_[kTileSize];  // of each row's runs
};

// Apart, because the shader is large, and what goes by it should not run on top of it.
__attribute__((noinline)) bool find_whether_it_pays(const ShadeJob& job) { return AutoShader(job).pays(); }
__attribute__((noinline)) void shade_by_choice(const ShadeJob& job) { AutoShader(job).shade(); }

// Whether interpolation makes up for what it costs to find out; the same for the whole draw, so that the
// picture does not depend on who asks.
bool pays(const ShadeJob& job) {
  std::uint8_t& known = job.draw->interpolation_pays;
  std::uint8_t verdict = __atomic_load_n(&known, __ATOMIC_RELAXED);
  if (verdict == Draw::kUnknown) {
    verdict = find_whether_it_pays(job) ? Draw::kPays : Draw::kDoesNotPay;
    __atomic_store_n(&known, verdict, __ATOMIC_RELAXED);
  }
  return verdict == Draw::kPays;
}

}  // namespace

void shade_auto(const ShadeJob& job) {
  if (!has_linear_light(*job.draw) || !pays(job)) return shade_phong(job);
  shade_by_choice(job);
}

}  // namespace blysk::BLYSK_ISA
