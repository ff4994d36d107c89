// shading/texture_cell.h - the four points of a lighting texture around a pixel.
#pragma once

#include "math/lighting_texture.h"
#include "shading/row.h"

namespace blysk::BLYSK_ISA {

inline constexpr int kTextureRow = kTextureSteps + 1;
inline constexpr int kTextureWords = kTextureRow * kTextureRow;

/// Words of the points, and how much the pixel is of each. Lanes beside the triangle read its nearest point:
/// whatever x is, all words are the texture's own.
template <class P>
struct TextureCell {
  Integer<P> at[4];  ///< (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)
  P x, y, xy;
};

/// `steps` an edge, 0 where there is no texture; its words start at `base`.
template <class F, class P>
BLYSK_INLINE TextureCell<P> texture_cell(const RowFrame<F>& frame, const RowStart<F>& start, F texture_steps,
                                         Integer<F> base, P x) {
  using I = Integer<P>;
  const P zero(0.0f), one(1.0f), steps = max(P(texture_steps), one);
  const P over = min(max(right_of(frame, start, x) * P(frame.over), zero), one);
  const P down = min(max(P(start.s) - P(frame.bend) * over, zero), one - over);
  const P column = down * steps, row = over * steps;
  const I last = truncate(steps) - I(1);
  const I j = min(truncate(row), last), i = min(truncate(column), last - j);
  TextureCell<P> c;
  c.x = column - to_float(i);
  c.y = row - to_float(j);
  // The last cells of each row are cut by the edge: linear.
  const auto cut = i + j >= last;
  c.xy = select(cut, zero, c.x * c.y);
  c.at[0] = I(base) + (j * I(kTextureRow) + i);
  c.at[1] = c.at[0] + I(1);
  c.at[2] = c.at[0] + I(kTextureRow);
  c.at[3] = select(cut, c.at[0], c.at[2] + I(1));
  return c;
}

}  // namespace blysk::BLYSK_ISA
