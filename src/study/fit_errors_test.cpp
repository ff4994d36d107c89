// Errors against those of the specifications, in all their digits.
#include "study/fit_errors.h"

#include <gtest/gtest.h>

#include "lighting/lobe_reference.h"

namespace blysk::study {
namespace {

TEST(fit_errors, roots) {  // shading thesis, section 6.3
  EXPECT_NEAR(root_error(Root::taylor), 0.0498253, 5e-8);
  EXPECT_NEAR(root_error(Root::chebyshev), 0.0035814, 5e-8);
  EXPECT_NEAR(root_error(Root::shift), 0.0056311, 5e-8);
  EXPECT_NEAR(root_error(Root::exact), 0, 1e-15);
}

TEST(fit_errors, vectors) {  // relief specification, 2.2, 2.4, 2.6
  EXPECT_NEAR(normalisation_error(), 0.003509, 5e-7);
  EXPECT_NEAR(lyon_error(), 0.11665, 5e-6);
  EXPECT_NEAR(mid_vector_error(), 0.004, 5e-7);
  EXPECT_NEAR(half_sum_error(23), 0.020075, 5e-7);
}

TEST(fit_errors, rows_of_nine) {  // A-buffer specification, C.2 and C.3
  EXPECT_NEAR(step_cosine_error(), 0.000219, 1e-6);
  EXPECT_NEAR(step_weight_error(), 0.0400, 5e-5);
  EXPECT_NEAR(chebyshev_row_error(), 0.0256, 5e-5);
}

TEST(fit_errors, thirds) {  // shading thesis, sections 5.1 and 5.2
  EXPECT_NEAR(third_error(), 0.0078125, 1e-15);
  EXPECT_NEAR(printed_cubic_error(), 0.273, 5e-4);
}

TEST(fit_errors, lobes) {  // relief specification, 4.2: ratios of Schlick's lobe to W, k = 16, n = 256
  const LobeErrors w =
      lobe_errors([](double c) { return reference::w_lobe(c, reference::w_scale(256, 16), 16); }, 256);
  const LobeErrors schlick = lobe_errors([](double c) { return reference::schlick_lobe(c, 256); }, 256);
  EXPECT_NEAR(schlick.centre / w.centre, 7.03, 0.005);
  EXPECT_NEAR(schlick.bloom / w.bloom, 13.1, 0.05);
  EXPECT_NEAR(w.largest, 0.0130, 5e-5);
}

}  // namespace
}  // namespace blysk::study
