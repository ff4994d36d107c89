// A small texture of light for each triangle, fetched bilinearly: pixels are independent and cheap.
//
// Based on: per-fragment paper, the polygon-shading processor; A-buffer specification, C.6 - C.8. Differs in:
// edges are exact and alike in both triangles; N.L is signed and clamped when it is fetched; a level is taken
// by the setting `texel` (the paper's is one pixel), and only where it pays and holds the highlight: other
// triangles are Phong's, pixel by pixel. Between the corners normals are without perspective.
#include "shading/mixed_normals.h"
#include "shading/shade_tile.h"
#include "shading/texture_cache.h"
#include "shading/texture_cell.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct TexturedJob : ShadeJob {
  TextureCache* cache;
};

// Steps of an edge by size alone, 0 where no texture pays.
template <class F>
BLYSK_INLINE Integer<F> steps_by_size(const ShadeJob& job, const Corners<F>& c) {
  using I = Integer<F>;
  constexpr float kTexels[] = {4, 2, 1};
  const int finest = job.settings[0] == 0 ? kTextureSteps : kTextureSteps / 2;
  const float texel = kTexels[job.settings[1]] * kSubpixels;
  F longest(0.0f);
  for (int k = 0; k < 3; ++k) {
    const int next = k == 2 ? 0 : k + 1;
    const F dx = c.x[next] - c.x[k], dy = c.y[next] - c.y[k];
    longest = max(longest, dx * dx + dy * dy);
  }
  I steps(0);
  const F twice = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
  const F area = float_of_bits(bits_of(twice) & I(0x7fffffff));
  for (int n = 1; n <= finest; n *= 2) {
    const float least = texel * static_cast<float>(n);
    steps = select(longest >= F(least * least), I(n), steps);
  }
  const F points = to_float((steps + I(1)) * (steps + I(2)));  // twice
  const auto pays = area >= points * F(kTexturePay * kSubpixels * kSubpixels);
  steps = select(pays, steps, I(0));
  return select(c.unplaced, I(0), steps);
}

struct LightingTexture {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    NormalPlane<F> normal;
    Integer<F> index, steps;  // by size
    bool any_texture;
    RowFrame<F> frame;  // where there is any
  };
  template <class F>
  struct Span {
    V3<F> normal;
    decltype(F() < F()) direct;  // Phong's, pixel by pixel
    RowStart<F> start;
    Integer<F> base;  // of the words of the texture
    F steps;
  };

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    t.normal = fetch_normal_plane(job, t.corners);
    t.index = index;
    t.steps = steps_by_size(job, t.corners);
    t.any_texture = any(t.steps > Integer<F>(0)) && job.draw->surface.lamps <= kTextureLamps;
    if (t.any_texture) {
      Corners<F> sorted = t.corners;
      sort_corners(sorted);
      t.frame = row_frame(sorted);
    }
    return t;
  }

  // Textures may have left the cache since the triangle was set up.
  static BLYSK_INLINE void find_texture(const TexturedJob& job, std::int32_t index, std::int32_t by_size,
                                        std::int32_t& base, float& steps) {
    base = 0;
    steps = 0;
    if (by_size == 0) return;
    const int slot = job.cache->find(job, index, by_size);
    base = slot * TextureCache::kSlotStride;
    steps = static_cast<float>(job.cache->steps(slot));
  }

  static BLYSK_INLINE void find_textures(const TexturedJob& job, const Triangle<float>& t, Span<float>& s) {
    find_texture(job, t.index, t.steps, s.base, s.steps);
  }
  template <int kRegisters>
  static BLYSK_INLINE void find_textures(const TexturedJob& job, const Triangle<Floats<kRegisters>>& t,
                                         Span<Floats<kRegisters>>& s) {
    constexpr int kCount = kRegisters * kPartLanes;
    std::uint32_t indices[kCount], sizes[kCount];
    std::int32_t base[kCount];
    float steps[kCount];
    store_all(t.index, indices);
    store_all(t.steps, sizes);
    for (int i = 0; i < kCount; ++i) {
      if (i > 0 && indices[i] == indices[i - 1]) {
        base[i] = base[i - 1];
        steps[i] = steps[i - 1];
        continue;
      }
      find_texture(job, static_cast<std::int32_t>(indices[i]), static_cast<std::int32_t>(sizes[i]), base[i],
                   steps[i]);
    }
    load_all(base, s.base);
    load_all(steps, s.steps);
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob& job, const Triangle<F>& t, F y) {
    Span<F> s;
    s.normal = row_normal(t.normal, y);
    s.base = Integer<F>(0);
    s.steps = F(0.0f);
    if (t.any_texture) {
      const auto& textured = static_cast<const TexturedJob&>(job);
      textured.cache->start();
      find_textures(textured, t, s);
      s.start = row_start(t.frame, y);
    }
    s.direct = s.steps == F(0.0f);
    return s;
  }

  template <class F, class P>
  static BLYSK_INLINE Intensity<P> fetch_light(const TexturedJob& job, const Triangle<F>& t, const Span<F>& s,
                                               P x) {
    const Surface& surface = job.draw->surface;
    const TextureCell<P> c = texture_cell(t.frame, s.start, s.steps, s.base, x);
    const auto between = [&](const P v[4]) {
      const P b = v[1] - v[0], d = v[2] - v[0];
      return (((v[0] + c.x * b) + c.y * d) + c.xy * ((v[3] - v[2]) - b)) * P(1.0f / kTextureOne);
    };
    Intensity<P> sum = own_intensity<P>(surface);
    for (int lamp = 0; lamp < surface.lamps; ++lamp) {
      P cos_l[4], lobe[4];
      for (int k = 0; k < 4; ++k) {
        const Integer<P> word = gather(job.cache->words() + lamp * kTextureWords, c.at[k]);
        cos_l[k] = to_float(shift_right<16>(shift_left<16>(word)));
        lobe[k] = to_float(shift_right<16>(word));
      }
      add_lamp(surface, surface.lamp[lamp], between(cos_l), between(lobe), sum);
    }
    return sum;
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Intensity<P> light_directly(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s,
                                                  P x, Y y, P nearness) {
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = or_viewer(normal_along(t.normal, s.normal, x), viewer);
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    return light_point(job.draw->surface, n, viewer, where);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s, P x, Y y,
                                   P nearness) {
    if (all(s.direct)) return compose(job, t.corners, x, y, light_directly(job, t, s, x, y, nearness));
    Intensity<P> light = fetch_light(static_cast<const TexturedJob&>(job), t, s, x);
    if (any(s.direct)) {
      const Intensity<P> own = light_directly(job, t, s, x, y, nearness);
      light = {choose(s.direct, own.diffuse, light.diffuse), choose(s.direct, own.specular, light.specular)};
    }
    return compose(job, t.corners, x, y, light);
  }
};

}  // namespace

void shade_lighting_texture(const ShadeJob& job) {
  TextureCache cache;
  TexturedJob textured;
  static_cast<ShadeJob&>(textured) = job;
  textured.cache = &cache;
  shade_draw<LightingTexture, ColorSink>(textured);
}

}  // namespace blysk::BLYSK_ISA
