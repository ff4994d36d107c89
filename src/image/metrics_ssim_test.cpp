#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "blysk/metrics.h"

namespace blysk {
namespace {

std::uint32_t gray(int v) { return 0xff000000u | static_cast<std::uint32_t>(v) * 0x10101u; }

// Two pictures that a few lines of any language can make: ramps, the second with a coarse pattern over it.
Image ramp(int width, int height, int pattern) {
  Image image;
  image.resize(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int v = (x * 7 + y * 5) % 200 + ((x / 3 + y / 2) % 2 == 0 ? pattern : 0);
      image.pixels[static_cast<std::size_t>(y * width + x)] = gray(v);
    }
  }
  return image;
}

// The definition, window by window, in two dimensions.
double ssim_by_definition(const Image& a, const Image& b) {
  double total = 0;
  int windows = 0;
  const auto value = [](const Image& image, int x, int y) {
    return static_cast<double>(image.pixels[static_cast<std::size_t>(y * image.width + x)] & 0xff);
  };
  for (int y = 5; y + 5 < a.height; ++y) {
    for (int x = 5; x + 5 < a.width; ++x, ++windows) {
      double weights = 0, ma = 0, mb = 0, va = 0, vb = 0, covariance = 0;
      for (int pass = 0; pass < 2; ++pass) {
        for (int j = -5; j <= 5; ++j) {
          for (int i = -5; i <= 5; ++i) {
            const double w = std::exp(-(i * i + j * j) / (2 * 1.5 * 1.5));
            const double p = value(a, x + i, y + j), q = value(b, x + i, y + j);
            if (pass == 0) {
              weights += w;
              ma += w * p;
              mb += w * q;
            } else {
              va += w * (p - ma) * (p - ma);
              vb += w * (q - mb) * (q - mb);
              covariance += w * (p - ma) * (q - mb);
            }
          }
        }
        if (pass == 0) {
          ma /= weights;
          mb /= weights;
        }
      }
      const double c1 = 6.5025, c2 = 58.5225;
      total += (2 * ma * mb + c1) * (2 * covariance / weights + c2) /
               ((ma * ma + mb * mb + c1) * (va / weights + vb / weights + c2));
    }
  }
  return total / windows;
}

TEST(ssim, is_its_definition) {
  for (const int pattern : {1, 9, 55}) {
    const Image a = ramp(31, 23, 0), b = ramp(31, 23, pattern);
    const Result<double> found = ssim(a, b);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, ssim_by_definition(a, b), 1e-10);
    EXPECT_EQ(*found, *ssim(b, a));
  }
}

TEST(ssim, orders_pictures_by_likeness) {
  const Image a = ramp(64, 48, 0);
  EXPECT_EQ(*ssim(a, a), 1);
  EXPECT_LT(*ssim(a, ramp(64, 48, 1)), 1);
  EXPECT_GT(*ssim(a, ramp(64, 48, 1)), *ssim(a, ramp(64, 48, 10)));
  EXPECT_GT(*ssim(a, ramp(64, 48, 10)), *ssim(a, ramp(64, 48, 50)));
}

TEST(ssim, constant_pictures_by_their_means) {
  Image a = ramp(11, 11, 0), b = a;
  for (std::uint32_t& p : a.pixels) p = gray(100);
  for (std::uint32_t& p : b.pixels) p = gray(120);
  EXPECT_NEAR(*ssim(a, b), (2 * 100.0 * 120 + 6.5025) / (100.0 * 100 + 120.0 * 120 + 6.5025), 1e-12);
}

TEST(ssim, weighs_colours_as_luma_and_ignores_alpha) {
  const Image a = ramp(16, 16, 0);
  Image green = a, blue = a, alpha = a;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    green.pixels[i] ^= 0x4000;
    blue.pixels[i] ^= 0x400000;
    alpha.pixels[i] ^= 0x40000000;
  }
  EXPECT_LT(*ssim(a, green), *ssim(a, blue));
  EXPECT_NEAR(*ssim(a, alpha), 1, 1e-12);
}

TEST(ssim, small_and_unequal_sizes) {
  EXPECT_TRUE(std::isnan(*ssim(ramp(10, 40, 0), ramp(10, 40, 5))));
  EXPECT_EQ(*ssim(ramp(3, 3, 0), ramp(3, 3, 0)), 1);
  EXPECT_EQ(ssim(ramp(12, 12, 0), ramp(12, 13, 0)).error().code, ErrorCode::input);
}

}  // namespace
}  // namespace blysk
