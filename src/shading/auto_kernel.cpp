// For each triangle the cheapest shading whose error is bounded: linear light where fetch_linear_light() says
// that it fits, else Phong shading.
//
// docs/auto.md explains the choice. It depends on the triangle alone. Rows of a tile are taken together:
// first its triangles are found, then they are set up sixteen at a time, then its pixels are shaded; each
// triangle is set up once, and not for every pixel.
#include "shading/linear_light.h"
#include "shading/phong.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

// Triangles of some rows of a tile, numbered from 1 as they appear.
class Census {
 public:
  static constexpr int kMost = 1024;

  BLYSK_INLINE void clear() {
    count_ = 0;
    triangle_[0] = -1;
    std::memset(place_, 0, sizeof place_);
  }
  [[nodiscard]] BLYSK_INLINE int count() const { return count_; }
  [[nodiscard]] BLYSK_INLINE bool has_room_for_row() const { return count_ + kTileSize <= kMost; }

  BLYSK_INLINE std::int32_t number(std::int32_t triangle) {
    std::uint32_t at = (static_cast<std::uint32_t>(triangle) * 2654435769u) >> (32 - kBits);
    std::int32_t number = place_[at];
    // Whether it is new cannot be foreseen: nothing branches on that alone.
    while (__builtin_expect(static_cast<int>(number != 0) & static_cast<int>(triangle_[number] != triangle),
                            0)) {
      at = (at + 1) & (kPlaces - 1);
      number = place_[at];
    }
    const int is_new = static_cast<int>(number == 0);
    count_ += is_new;
    number |= -is_new & count_;
    triangle_[number] = triangle;
    place_[at] = static_cast<std::uint16_t>(number);
    return number;
  }

  /// By number; there is one for 0, and for lanes past the last.
  BLYSK_INLINE const std::int32_t* triangles() {
    triangle_[0] = triangle_[1];
    for (int i = 1; i <= kLanes; ++i) triangle_[count_ + i] = triangle_[1];
    return triangle_;
  }

 private:
  static constexpr int kBits = 12, kPlaces = 1 << kBits;

  int count_ = 0;
  std::uint16_t place_[kPlaces];  // numbers by hash
  std::int32_t triangle_[kMost + 1 + kLanes];
};

// Three rows of four numbers a triangle, as pixels want them: colour and whether it is Phong's; slopes in x
// and the corner's x; slopes in y and the corner's y.
class Planes {
 public:
  __attribute__((noinline)) void set_up(const ShadeJob& job, const std::int32_t* triangles, int count) {
    for (int i = 0; i <= count; i += kLanes) {
      const auto light = fetch_linear_light<F32>(job, load(triangles + i));
      const F32 phong = select(light.fits, F32(0.0f), F32(1.0f));
      put(0, i, light.at, phong);
      put(1, i, light.per_x, light.x);
      put(2, i, light.per_y, light.y);
    }
  }

  [[nodiscard]] BLYSK_INLINE bool is_phong(int number) const { return row_[0][4 * number + 3] > 0; }

  [[nodiscard]] BLYSK_INLINE LinearLight<float> of(int number) const {
    const auto rgb = [&](int row) {
      const float* r = row_[row] + 4 * number;
      return Rgb<float>{r[0], r[1], r[2]};
    };
    return {row_[1][4 * number + 3], row_[2][4 * number + 3], rgb(0), rgb(1), rgb(2), 0, true};
  }

  // Of sixteen pixels of `count` neighbouring runs, whose triangles' numbers are given; `run` says of which
  // each pixel is. Returns which pixels are Phong's.
  BLYSK_INLINE unsigned gather(const std::int32_t* numbers, int count, I32 run,
                               LinearLight<F32>& light) const {
    F32 phong[4], x[4], y[4];
#if HWY_TARGET == HWY_AVX3
    if (__builtin_expect(count <= kFew, 1)) {
      spread(row_[0], numbers, run, phong);
      spread(row_[1], numbers, run, x);
      spread(row_[2], numbers, run, y);
    } else
#endif
    {
      const I32 number = blysk::BLYSK_ISA::gather(reinterpret_cast<const std::uint32_t*>(numbers),
                                                  min(max(run, I32(0)), I32(count - 1)));
      gather_rows<4>(row_[0], number, phong);
      gather_rows<4>(row_[1], number, x);
      gather_rows<4>(row_[2], number, y);
    }
    light = {x[3], y[3], {phong[0], phong[1], phong[2]}, {x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {}, {}};
    return to_bits(phong[3] > F32(0.0f));
  }

 private:
  BLYSK_INLINE void put(int row, int at, const Rgb<F32>& c, F32 fourth) {
    store_interleaved(bits_of(c.x), bits_of(c.y), bits_of(c.z), bits_of(fourth),
                      reinterpret_cast<std::int32_t*>(row_[row] + 4 * at));
  }

#if HWY_TARGET == HWY_AVX3
  static constexpr int kFew = 8;  // runs whose rows two registers hold

  // What gather_rows() gives, with a load for every run instead of every pixel.
  static BLYSK_INLINE void spread(const float* rows, const std::int32_t* numbers, I32 run, F32 columns[4]) {
    const hn::Full128<float> row_tag;
    const hn::Full256<float> half;
    const auto row = [&](int i) { return hn::LoadU(row_tag, rows + 4 * numbers[i]); };
    const auto four = [&](int i) {
      return hn::Combine(FloatTag(), hn::Combine(half, row(i + 3), row(i + 2)),
                         hn::Combine(half, row(i + 1), row(i)));
    };
    const auto low = four(0), high = four(4);
    const I32 first = shift_left<2>(run);
    for (int k = 0; k < 4; ++k) {
      columns[k].part[0].raw = _mm512_permutex2var_ps(low.raw, (first + I32(k)).part[0].raw, high.raw);
    }
  }
#endif

  alignas(64) float row_[3][4 * (Census::kMost + 1 + kLanes)];
};

class AutoShader {
 public:
  explicit BLYSK_INLINE AutoShader(const ShadeJob& job) : job_(job), phong_(job) {}

  BLYSK_INLINE void shade() {
    for (int row = 0; row < job_.height;) {
      census_.clear();
      runs_ = 0;
      const int first = row;
      while (row < job_.height && census_.has_room_for_row()) number_row(row++);
      if (census_.count() == 0) continue;
      store(I32(0), run_ + runs_);
      planes_.set_up(job_, census_.triangles(), census_.count());
      for (int r = first; r < row; ++r) {
        for (int column = 0; column < job_.width;) column += shade_block(r, column);
      }
    }
    phong_.flush();
    // Surfaces that share a pixel with others are few: all are Phong's.
    if (job_.samples != nullptr) phong_.shade_fragments();
  }

 private:
  BLYSK_INLINE void number_row(int row) {
    const I32 first(static_cast<std::int32_t>(job_.draw->id_base));
    std::int32_t triangle[kTileSize + kLanes], at[kTileSize + kLanes];
    int runs = 0;
    for (int column = 0; column < job_.width; column += kLanes) {
      const unsigned mine = phong_.own_pixels(row, column);
      if (mine == 0) continue;
      const int here = row * kTileSize + column;
      const I32 id = load(job_.buffers->id + here);
      const unsigned ends = to_bits(id != load(job_.buffers->id + here + 1));
      const Mask starts = lanes_of(mine & (ends << 1 | 1));
      store_compressed(starts, id - first, triangle + runs);
      runs += store_compressed(starts, iota(here), at + runs);
    }
    // What a run writes too much is overwritten by those that follow.
    for (int i = 0; i < runs; ++i) {
      run_[runs_] = census_.number(triangle[i]);
      store(I32(runs_++), run_of_ + at[i]);
    }
  }

  BLYSK_INLINE int shade_block(int row, int column) {
    const unsigned mine = phong_.own_pixels(row, column);
    if (mine == 0) return kLanes;
    const int at = row * kTileSize + column;
    const float y = static_cast<float>((job_.y + row) * kSubpixels + kSubpixels / 2);
    const F32 x = centers(iota(job_.x + column));
    const std::int32_t first = run_of_[at + __builtin_ctz(mine)];
    const std::int32_t last = run_of_[at + 31 - __builtin_clz(mine)];
    if (first == last) {
      if (planes_.is_phong(run_[first])) return phong_.shade_block(row, column, mine);
      put(at, mine, shown_at(planes_.of(run_[first]), x, y));
      return kLanes;
    }
    LinearLight<F32> light;
    const I32 run = load(run_of_ + at) - I32(first);
    const unsigned phong = mine & planes_.gather(run_ + first, last - first + 1, run, light);
    if (phong != mine) put(at, mine & ~phong, shown_at(light, x, y));
    return phong == 0 ? kLanes : phong_.shade_block(row, column, phong);
  }

  BLYSK_INLINE void put(int at, unsigned pixels, const Rgb<F32>& shown) {
    // Adding 2^23 leaves the nearest integer in the low bits.
    const auto code = [](F32 v) { return bits_of(v + F32(8388608.0f)); };
    const I32 blue = shift_left<16>(code(shown.z)) | I32(static_cast<std::int32_t>(0xff000000));
    const I32 red_green = (code(shown.x) & I32(0xff)) | shift_left<8>(code(shown.y) & I32(0xff));
    store_masked(lanes_of(pixels), red_green | blue, job_.buffers->color + at);
  }

  const ShadeJob& job_;
  DrawShader<Phong, ColorSink> phong_;
  Census census_;
  Planes planes_;
  // Runs of one triangle in a row, at most one a pixel: their triangles' numbers, and the run of each pixel.
  int runs_ = 0;
  std::int32_t run_[kTilePixels + kLanes], run_of_[kTilePixels + kLanes];
};

}  // namespace

void shade_auto(const ShadeJob& job) {
  if (!has_linear_light(*job.draw)) return shade_phong(job);
  AutoShader(job).shade();
}

}  // namespace blysk::BLYSK_ISA
