#include "math/float4.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "blysk/array.h"

namespace blysk {
namespace {

Array<Vec3f> random_vectors(std::size_t count) {
  std::mt19937 random(11);
  Array<Vec3f> vectors(count);
  for (Vec3f& v : vectors) {
    for (float* component : {&v.x, &v.y, &v.z}) *component = static_cast<float>(random()) * 1e-3f - 2e6f;
  }
  return vectors;
}

TEST(float4, products_have_the_bits_of_those_of_vectors) {
  const Array<Vec3f> v = random_vectors(4000);
  for (std::size_t i = 0; i + 3 < v.size(); i += 4) {
    const Float4 a = load4(&v[i]), b = load4(&v[i + 1]), c = load4(&v[i + 2]), d = load4(&v[i + 3]);
    ASSERT_EQ(to_vector(cross(a, b)), cross(v[i], v[i + 1]));
    const Float4 products = dots(a, b, c, d);
    ASSERT_EQ(products[0], dot(v[i], v[i + 1]));
    ASSERT_EQ(products[1], dot(v[i], v[i + 2]));
    ASSERT_EQ(products[2], dot(v[i], v[i + 3]));
    ASSERT_EQ(products[3], dot(v[i], v[i]));
  }
}

TEST(float4, masks) {
  EXPECT_NE(all3(Mask4{-1, -1, -1, 0})[0], 0);
  EXPECT_EQ(all3(Mask4{-1, -1, 0, -1})[0], 0);
  EXPECT_EQ(all3(Mask4{-1, 0, -1, -1})[0], 0);
  EXPECT_EQ(all3(Mask4{0, -1, -1, -1})[0], 0);
  EXPECT_TRUE(none4(Mask4{}));
  EXPECT_FALSE(none4(Mask4{0, 0, 0, -1}));
  const Float4 m = magnitude(Float4{-1.5f, 2, -0.0f, -3e38f});
  EXPECT_EQ(m[0], 1.5f);
  EXPECT_EQ(m[1], 2.0f);
  EXPECT_FALSE(std::signbit(m[2]));
  EXPECT_EQ(m[3], 3e38f);
}

}  // namespace
}  // namespace blysk
