// Shading by angular interpolation: the normals of a row turn by equal angles, so that their cosines need no
// normal and no root.
//
// Based on: the shading thesis, chapter 3.2, section 7 of its specification. Differs in: row_method.h;
// angular_row.h.
#include "shading/angular_row.h"
#include "shading/row_method.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct AngularLaw : AngularRow {
  static constexpr int kWalkSetting = 0, kEndsSetting = 1, kRowSetting = 2;
  template <class Y, class M>
  static BLYSK_INLINE Turn<Y> turn_along(const ShadeJob&, Y c, M& direct) {
    direct = direct | (c > Y(2.0f));
    return turn_of(min(c, Y(2.0f)));
  }
  template <class Y>
  static BLYSK_INLINE Dot<Y> dot_of(const ShadeJob& job, const Turn<Y>& turn, const LawEnds<Y>& ends,
                                    const Path<Y>& x) {
    const Dot<Y> d = dot_along(turn, ends.first, ends.last, x);
    if (job.settings[kWalkSetting] == 0 || !x.far) return d;
    return from_foot(d, turn.angle, max(ends.length * Y(1.0f / kSubpixels), Y(1.0f)));
  }

  template <class F, class P>
  static BLYSK_INLINE Point<P> point(const ShadeJob&, const Turn<F>& turn, const RowPoint<P>& at) {
    return AngularRow::point(turn, at);
  }
};

}  // namespace

void shade_angular(const ShadeJob& job) { shade_draw<RowMethod<AngularLaw>, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
