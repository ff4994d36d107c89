// Shading with the accelerated diffuse and specular components: of a row's normals, linear between unit ends,
// one polynomial in t (1 - t) gives the reciprocal length, the same for both halves and for all cosines.
//
// Based on: the shading thesis, chapter 3.1, section 6 of its specification. Differs in: row_method.h; the
// recurrences of p and M are evaluated in the pixel's own place; `minimax` fits the polynomial to each row.
#include "shading/row_method.h"
#include "shading/symmetric_row.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct SymmetricLaw : SymmetricRow {
  static constexpr int kRowSetting = 1, kEndsSetting = -1;
  static BLYSK_INLINE RowRoot root_of(const ShadeJob& job) { return static_cast<RowRoot>(job.settings[0]); }

  template <class Y, class M>
  static BLYSK_INLINE RootTerms<Y> turn_along(const ShadeJob& job, Y c, M& direct) {
    const RowRoot root = root_of(job);
    direct = direct | (c > Y(2.0f));
    if (root == RowRoot::minimax) {
      // A relative error of the root is n times as large in the lobe: half a step of 255.
      const Surface& s = job.draw->surface;
      const float power = s.model == LightingModel::lambert ? 1.0f : s.shininess;
      direct = direct | (own_root_error(c) * Y(power) > Y(1.0f / 510));
    }
    return root_terms(root, c);
  }
  template <class Y>
  static BLYSK_INLINE auto dot_of(const ShadeJob&, const RootTerms<Y>& turn, const LawEnds<Y>& ends,
                                  const Path<Y>& x) {
    return SymmetricRow::dot_along(turn, ends.first, ends.last, x);
  }

  template <class F, class P>
  static BLYSK_INLINE Point<P> point(const ShadeJob& job, const Turn<F>& turn, const RowPoint<P>& at) {
    return SymmetricRow::point(root_of(job), turn, at);
  }
};

}  // namespace

void shade_symmetric(const ShadeJob& job) { shade_draw<RowMethod<SymmetricLaw>, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
