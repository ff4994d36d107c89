// The polynomials against libm in double precision; their comments quote the errors measured here.
#define HWY_COMPILE_ONLY_SCALAR  // floats only; a build for ARM would ask for its own flags
#define BLYSK_ISA isa_approx_test
#include "simd/approx.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/random.h"

namespace blysk::isa_approx_test {
namespace {

float after(float v) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(v) + 1); }

double relative_error(float v, double exact) { return std::abs(static_cast<double>(v) - exact) / exact; }

// The figure in a function's comment: neither exceeded nor far from what is measured.
void expect_quoted(double measured, double quoted) {
  EXPECT_LE(measured, quoted);
  EXPECT_GE(measured, 0.9 * quoted);
}

// Scaling x by 4 scales the root by a power of two: [1, 4) says it all.
TEST(approx, reciprocal_root) {
  double worst = 0;
  for (float x = 1; x < 4; x = after(x)) {
    worst = std::max(worst, relative_error(reciprocal_root(x), 1 / std::sqrt(static_cast<double>(x))));
  }
  expect_quoted(worst, 1.2e-6);
  for (const float scale : {0x1p-122f, 0x1p-60f, 0x1p60f, 0x1p120f}) {
    EXPECT_EQ(reciprocal_root(1.7f * scale), reciprocal_root(1.7f) / std::sqrt(scale));
  }
}

TEST(approx, log2) {
  double worst = 0;
  const auto measure = [&](float x) {
    const double exact = std::log2(static_cast<double>(x)), ulp = std::ldexp(1.0, std::ilogb(exact) - 23);
    worst = std::max(worst, std::abs(static_cast<double>(log2_poly(x)) - exact) - ulp);
  };
  for (float x = 0.5f; x < 2; x = after(x)) {
    if (x != 1) measure(x);
  }
  EXPECT_EQ(log2_poly(1.0f), 0.0f);
  Random random(1);
  for (int i = 0; i < 1000000; ++i)
    measure(std::ldexp(1 + random.unit(), static_cast<int>(random.next() % 252) - 126));
  expect_quoted(worst, 1e-7);
}

TEST(approx, exp2) {
  double worst = 0;
  const auto measure = [&](float x) {
    worst = std::max(worst, relative_error(exp2_poly(x), std::exp2(static_cast<double>(x))));
  };
  for (float x = 0.5f; x < 2; x = after(x)) measure(x);
  Random random(2);
  for (int i = 0; i < 1000000; ++i) measure(random.unit() * 253 - 126);
  expect_quoted(worst, 2.5e-7);
  EXPECT_EQ(exp2_poly(0.0f), 1.0f);
  EXPECT_EQ(exp2_poly(-500.0f), 0x1p-126f);
}

TEST(approx, power) {
  Random random(3);
  double worst = 0;
  for (int i = 0; i < 3000000; ++i) {
    const float x = 1 - random.unit(), n = 0.5f + 500 * random.unit() * random.unit();
    const double wide = static_cast<double>(x), exact = std::pow(wide, static_cast<double>(n));
    if (exact < 1e-30) continue;
    const double exponent = static_cast<double>(n) * std::abs(std::log2(wide));
    worst = std::max(worst, relative_error(power_poly(x, n), exact) / (1 + exponent));
  }
  expect_quoted(worst, 2.4e-7);
}

template <class Function>
void expect_same_bits(Function function, float low, float high) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    float in[kLanes], out[kLanes];
    for (float& v : in) v = low + (high - low) * random.unit();
    store(function(load(in)), out);
    for (int k = 0; k < kLanes; ++k) ASSERT_EQ(bits_of(out[k]), bits_of(function(in[k]))) << in[k];
  }
}

TEST(approx, lanes_have_the_bits_of_floats) {
  expect_same_bits([](auto x) { return reciprocal_root(x); }, 1e-30f, 1e4f);
  expect_same_bits([](auto x) { return log2_poly(x); }, 1e-30f, 4);
  expect_same_bits([](auto x) { return exp2_poly(x); }, -130, 127);
  expect_same_bits([](auto x) { return power_poly(x, 77.7f); }, 1e-30f, 1);
}

}  // namespace
}  // namespace blysk::isa_approx_test
