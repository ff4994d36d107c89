// shading/second_order.h - a quadratic surface in a triangle's own coordinates, and a row of it by each of
// the thesis' formulas.
//
// Based on: the shading thesis, chapter 2.1; sections 4.2 to 4.4 of its specification. Differs in: the
// recurrences run from one block of sixteen pixels to the next, from the block that the triangle's own row
// begins in, and start anew every 128 pixels (section 14, item 7): a pixel's value depends on its row alone.
// Their first three values come from (2.9), (2.3) and (2.5).
#pragma once

#include "shading/row.h"

namespace blysk::BLYSK_ISA {

/// f + s (a + c s) + v ((b + e s) + d v), where s runs down the long edge and v over to the middle corner.
template <class F>
struct SecondOrder {
  F f, a, c, b, e, d;
};

/// From values at top, bottom, middle, and between top-bottom, top-middle, bottom-middle.
template <class F>
BLYSK_INLINE SecondOrder<F> second_order(const F i[6], F bend) {
  const F two(2.0f), four(4.0f);
  SecondOrder<F> q;
  q.f = i[0];
  q.a = four * i[3] - (F(3.0f) * i[0] + i[1]);
  q.c = two * (i[0] + i[1]) - four * i[3];
  const F b = four * i[4] - (F(3.0f) * i[0] + i[2]);
  const F d = two * (i[0] + i[2]) - four * i[4];
  const F e = four * ((i[0] + i[5]) - (i[3] + i[4]));
  // u, the bottom corner's weight, is s - bend v.
  q.b = b - bend * q.a;
  q.e = e - bend * (two * q.c);
  q.d = d - bend * (e - bend * q.c);
  return q;
}

/// What a row leaves of it: p0 + v (p1 + d v).
template <class F>
struct RowParabola {
  F p0, p1;
};

template <class F>
BLYSK_INLINE RowParabola<F> along_row(const SecondOrder<F>& q, F s) {
  return {q.f + s * (q.a + s * q.c), q.b + s * q.e};
}

/// (2.9), (2.2), (2.3), (2.5), (2.7), (2.8) and the latter by doubling instead of multiplication; the
/// registry's form= in its order.
enum class RowForm { horner, direct, step, pair, triple, values, values_shift };

constexpr bool runs_along(RowForm form) { return form != RowForm::horner && form != RowForm::direct; }

inline constexpr int kStrideBits = 4;
inline constexpr int kStrides = 8;  ///< before a recurrence starts anew

/// Where a pixel stands on its row.
template <class P>
struct RowPlace {
  P v;                 ///< its own; for recurrences that of the pixel which they start from
  Integer<P> strides;  ///< from there
};

/// x in subpixels, `right` its right_of(), `first` the row's first column.
template <RowForm kForm, class F, class P>
BLYSK_INLINE RowPlace<P> row_place(const RowFrame<F>& f, P x, P right, Integer<F> first) {
  using I = Integer<P>;
  if constexpr (!runs_along(kForm)) return {right * P(f.over), I(0)};
  constexpr int kPixelBits = kSubpixelBits + kStrideBits;
  const I blocks = shift_right<kPixelBits>(truncate(x)) - I(shift_right<kStrideBits>(first));
  const I strides = max(blocks, I(0)) & I(kStrides - 1);
  return {(right - to_float(shift_left<kPixelBits>(strides))) * P(f.over), strides};
}

template <RowForm kForm, class F, class P>
BLYSK_INLINE P row_value(const RowFrame<F>& f, const SecondOrder<F>& q, const RowParabola<F>& row, F s,
                         const RowPlace<P>& at) {
  using I = Integer<P>;
  const P v = at.v;
  if constexpr (kForm == RowForm::direct) {
    return ((((v * v * P(q.d) + P(s * s * q.c)) + v * P(s) * P(q.e)) + v * P(q.b)) + P(s * q.a)) + P(q.f);
  }
  const P start = P(row.p0) + v * (P(row.p1) + v * P(q.d));
  if constexpr (!runs_along(kForm)) return start;

  const F stride = f.over * F(static_cast<float>(kSubpixels << kStrideBits));
  const P bend = P(stride * stride * q.d);  // the formulas' A
  const P twice = bend + bend;
  const auto step = [&](P from) { return P(stride) * (from * P(q.d + q.d) + P(row.p1)) + bend; };
  // Values of three neighbouring blocks.
  P before = start, last = start, value = start, x = v, result = start;
  for (int k = 1; k < kStrides; ++k) {
    const auto not_there = at.strides >= I(k);
    if (!any(not_there)) break;
    P next;
    if (kForm == RowForm::step || k == 1) {
      next = value + step(x);
      x = x + P(stride);
    } else if (kForm == RowForm::pair || k == 2) {
      next = (value + value - last) + twice;
    } else if (kForm == RowForm::triple) {
      next = ((value + last) - before) + (twice + twice);
    } else if (kForm == RowForm::values) {
      next = (P(3.0f) * value - P(3.0f) * last) + before;
    } else {
      next = ((((value + value) + value) - (last + last)) - last) + before;
    }
    before = last;
    last = value;
    value = next;
    result = select(not_there, value, result);
  }
  return result;
}

/// A row of one triangle or of sixteen, and how to read it.
template <class F>
struct FormedRow {
  const RowFrame<F>& frame;
  const RowStart<F>& start;
  Integer<F> first, last;  ///< columns; only for forms that run along the row, and for segments

  template <RowForm kForm, class P>
  BLYSK_INLINE P value(const SecondOrder<F>& q, const RowParabola<F>& row, P x) const {
    const P right = right_of(frame, start, x);
    return row_value<kForm>(frame, q, row, start.s, row_place<kForm>(frame, x, right, first));
  }

  template <class P>
  __attribute__((noinline)) P value(RowForm form, const SecondOrder<F>& q, const RowParabola<F>& row,
                                    P x) const {
    switch (form) {
      case RowForm::horner:
        return value<RowForm::horner>(q, row, x);
      case RowForm::direct:
        return value<RowForm::direct>(q, row, x);
      case RowForm::step:
        return value<RowForm::step>(q, row, x);
      case RowForm::pair:
        return value<RowForm::pair>(q, row, x);
      case RowForm::triple:
        return value<RowForm::triple>(q, row, x);
      case RowForm::values:
        return value<RowForm::values>(q, row, x);
      case RowForm::values_shift:
        return value<RowForm::values_shift>(q, row, x);
    }
    __builtin_unreachable();
  }

  /// Straight lines between points 2^bits pixels apart, from the first pixel on; what is left of the row
  /// after the last whole segment is not straightened. Section 4.4 of the specification.
  template <class P>
  BLYSK_INLINE P segment_value(RowForm form, int bits, const SecondOrder<F>& q, const RowParabola<F>& row,
                               P x) const {
    using I = Integer<P>;
    const P length(static_cast<float>(kSubpixels << bits)), inverse = P(1.0f) / length;
    const P from_first = x - P(to_float(shift_left<kSubpixelBits>(first) + Integer<F>(kSubpixels / 2)));
    const P within = max(from_first, P(0.0f));
    const P offset = from_first - to_float(truncate(within * inverse)) * length;
    const P begin = x - offset, end = begin + length;
    const auto whole = shift_right<kSubpixelBits>(truncate(end)) <= I(last);
    const P at_begin = value(form, q, row, select(whole, begin, x));
    const P at_end = value(form, q, row, select(whole, end, x));
    return at_begin + (at_end - at_begin) * (offset * inverse);
  }
};

}  // namespace blysk::BLYSK_ISA
