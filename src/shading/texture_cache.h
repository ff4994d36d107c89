// shading/texture_cache.h - lighting textures of a tile's triangles.
//
// A texture is the light of evenly spaced points of a triangle, i steps towards corner 1 and j towards corner
// 2, i + j <= steps. Of each lamp a word: N.L and cos^n as 16-bit fixed point. Points of an edge depend on
// its two corners alone, and on neither's rank, so that neighbours agree in every bit.
#pragma once

#include "shading/arc.h"
#include "shading/lit_triangle.h"
#include "shading/texture_cell.h"

namespace blysk::BLYSK_ISA {

/// Unit normals of one edge or of all points.
template <int kCount>
struct NormalRun {
  float x[kCount], y[kCount], z[kCount];

  BLYSK_INLINE void set(int i, const V3<float>& n) {
    x[i] = n.x;
    y[i] = n.y;
    z[i] = n.z;
  }
  [[nodiscard]] BLYSK_INLINE V3<float> at(int i) const { return {x[i], y[i], z[i]}; }
};

/// Halves the angle between the ends until there are steps + 1 normals.
BLYSK_INLINE void halve_edge(const V3<float>& a, const V3<float>& b, int steps,
                             NormalRun<kTextureRow + kLanes>& edge) {
  edge.set(0, a);
  edge.set(steps, b);
  float c = dot(a, b);
  for (int step = steps / 2; step > 0; step /= 2) {
    const float square = 2 + 2 * c, scale = reciprocal_root(square);
    c = square * scale * 0.5f;
    for (int i = step; i < steps; i += 2 * step) {
      const V3<float> left = edge.at(i - step), right = edge.at(i + step);
      edge.set(i, {(left.x + right.x) * scale, (left.y + right.y) * scale, (left.z + right.z) * scale});
    }
  }
}

/// Textures of the triangles that were asked for last.
class TextureCache {
 public:
  TextureCache() {
    for (std::int32_t& id : id_) id = -1;
    for (std::uint32_t& word : words_[0]) word = 0;
  }

  /// Those found since stay.
  BLYSK_INLINE void start() { ++now_; }

  /// The place of a triangle's texture; steps() of it is 0 if it has none. At most kKept between two starts.
  BLYSK_INLINE int find(const ShadeJob& job, std::int32_t triangle, int steps) {
    for (int i = 0; i < kRoom; i += kLanes) {
      const unsigned bits = to_bits(load(id_ + i) == I32(triangle));
      if (bits == 0) continue;
      const int slot = i + __builtin_ctz(bits);
      used_[slot] = now_;
      return slot;
    }
    return build(job, triangle, steps);
  }

  [[nodiscard]] BLYSK_INLINE int steps(int slot) const { return steps_[slot]; }
  [[nodiscard]] BLYSK_INLINE const std::uint32_t* words() const { return words_[0]; }
  /// From a texture's first word to the next one's.
  static constexpr int kSlotStride = kTextureLamps * kTextureWords + kLanes;

 private:
  static constexpr int kKept = 2 * kLanes, kSlots = kKept + 8, kRoom = kKept + kLanes;

  __attribute__((noinline)) int build(const ShadeJob& job, std::int32_t triangle, int steps) {
    do {
      hand_ = hand_ + 1 < kSlots ? hand_ + 1 : 0;
    } while (used_[hand_] == now_);
    used_[hand_] = now_;
    id_[hand_] = triangle;
    const auto t = fetch_lit_triangle<float>(job, triangle);
    V3<float> corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = unit(t.normal[k]);
    steps_[hand_] = holds_highlight(job, t, corner, steps) ? steps : 0;
    if (steps_[hand_] != 0) fill(job, t, corner, steps, words_[hand_]);
    return hand_;
  }

  static BLYSK_INLINE V3<float> unit(const V3<float>& n) {
    const float scale = reciprocal_root(max(dot(n, n), 1e-30f));
    return {n.x * scale, n.y * scale, n.z * scale};
  }

  // Whether all corners show the side that is lit, and neither normals nor directions turn too much from
  // point to point for the lobe.
  static bool holds_highlight(const ShadeJob& job, const LitTriangle<float>& t, const V3<float> (&corner)[3],
                              int steps) {
    const Surface& s = job.draw->surface;
    const Corners<float>& c = t.corners;
    V3<float> view[3], at[3];
    for (int k = 0; k < 3; ++k) {
      const V3<float> v = viewer_at(job, c.x[k], c.y[k]);
      view[k] = unit(v);
      at[k] = point_at(job, c.x[k], c.y[k], c.nearness[k], v);
    }
    const auto chord = [](const V3<float>& a, const V3<float>& b) { return 2.0f - 2.0f * dot(a, b); };
    float most = 0, lowest = 1;
    for (int k = 0; k < 3; ++k) {
      if (!(dot(corner[k], view[k]) > 0)) return false;
      const int next = k == 2 ? 0 : k + 1;
      float turn = chord(corner[k], corner[next]) + 0.25f * chord(view[k], view[next]);
      for (int i = 0; i < s.lamps; ++i) {
        if (!s.lamp[i].point) continue;
        const float* p = s.lamp[i].vector;
        const auto towards = [&](const V3<float>& from) {
          return unit({p[0] - from.x, p[1] - from.y, p[2] - from.z});
        };
        turn = turn + 0.25f * chord(towards(at[k]), towards(at[next]));
      }
      most = max(most, turn);
      lowest = min(lowest, dot(corner[k], corner[next]));
    }
    const float n = s.model == LightingModel::lambert ? 1.0f : max(s.shininess, 1.0f);
    return lowest > static_cast<float>(kLowestArc) &&
           most * n <= static_cast<float>(kTextureTurn * steps * steps);
  }

  static void fill(const ShadeJob& job, const LitTriangle<float>& t, const V3<float> (&corner)[3], int steps,
                   std::uint32_t* words) {
    NormalRun<kTextureRow + kLanes> ab, ac, bc;
    halve_edge(corner[0], corner[1], steps, ab);
    halve_edge(corner[0], corner[2], steps, ac);
    halve_edge(corner[1], corner[2], steps, bc);
    for (int j = 0; j <= steps; ++j) {
      for (int first = 0; first <= steps - j; first += kLanes) {
        const I32 i = iota(first);
        const V3<F32> n = row_normals(ab, ac.at(j), bc.at(j), steps, i, first, j);
        store_lit(job, t, n, steps, i, j, words);
      }
    }
  }

  // Points of row j: from edge ac to edge bc.
  static BLYSK_INLINE V3<F32> row_normals(const NormalRun<kTextureRow + kLanes>& ab, const V3<float>& left,
                                          const V3<float>& right, int steps, I32 i, int first, int j) {
    if (j == 0) return {load(ab.x + first), load(ab.y + first), load(ab.z + first)};
    const auto lanes = [](const V3<float>& v) { return V3<F32>{F32(v.x), F32(v.y), F32(v.z)}; };
    const int length = steps - j;
    const F32 place =
        min(to_float(i + i) * F32(1.0f / static_cast<float>(max(length, 1))) - F32(1.0f), F32(1.0f));
    const V3<F32> n = along_any(lanes(left), lanes(right), F32(min(dot(left, right), 1.0f)), place);
    const auto is_left = i == I32(0), is_right = i >= I32(length);
    const auto choose_end = [&](F32 inner, float l, float r) {
      return select(is_left, F32(l), select(is_right, F32(r), inner));
    };
    return {choose_end(n.x, left.x, right.x), choose_end(n.y, left.y, right.y),
            choose_end(n.z, left.z, right.z)};
  }

  static BLYSK_INLINE void store_lit(const ShadeJob& job, const LitTriangle<float>& t, const V3<F32>& n,
                                     int steps, I32 i, int j, std::uint32_t* words) {
    const Surface& s = job.draw->surface;
    const Corners<float>& c = t.corners;
    // Steps are a power of two: weights are exact, and so is the sum's independence of the corners' order.
    const F32 step(1.0f / static_cast<float>(steps));
    const I32 within = min(i, I32(steps - j));
    const F32 w1 = to_float(within) * step, w2 = F32(static_cast<float>(j)) * step,
              w0 = to_float(I32(steps - j) - within) * step;
    const auto mixed = [&](const float(&v)[3]) { return (w0 * F32(v[0]) + w1 * F32(v[1])) + w2 * F32(v[2]); };
    const F32 x = mixed(c.x), y = mixed(c.y), nearness = mixed(c.nearness);
    const V3<F32> viewer = viewer_at(job, x, y);
    const Stance<F32> stance = take_stance(n, F32(1.0f), viewer, I32(0));
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    const auto fixed = [](F32 v) {
      constexpr float kOne = kTextureOne;
      return truncate(min(max(v, F32(-1.0f)), F32(1.0f)) * F32(kOne) + F32(kOne + 0.5f)) -
             I32(static_cast<std::int32_t>(kOne));
    };
    const Mask inside = lanes_below(steps - j + 1 - to_int(i));
    for (int lamp = 0; lamp < s.lamps; ++lamp) {
      const LampAngles<F32> a = lamp_angles(s, s.lamp[lamp], stance, where);
      I32 word = fixed(a.cos_l) & I32(0xffff);
      if (s.model != LightingModel::lambert) {
        word = word | shift_left<16>(fixed(lobe_of_argument(min(a.lobe, F32(1.0f)), s)));
      }
      store_masked(inside, word, words + lamp * kTextureWords + j * kTextureRow + to_int(i));
    }
  }

  // The first of a run of integers.
  static BLYSK_INLINE int to_int(I32 i) { return hn::GetLane(i.part[0]); }

  std::int32_t id_[kRoom];
  std::int32_t steps_[kSlots];
  std::uint32_t used_[kSlots] = {};
  std::uint32_t now_ = 1;
  int hand_ = 0;
  std::uint32_t words_[kSlots][kSlotStride];
};

}  // namespace blysk::BLYSK_ISA
