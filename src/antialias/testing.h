// antialias/testing.h - fragments and lists as the specification's cases write them.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "antialias/fragment_lists.h"

namespace blysk::antialias::examples {

inline Fragment fragment(std::uint32_t id, Mask mask, Vec3f rgb, float z, float zx = 0, float zy = 0,
                         float alpha = 1) {
  return {.mask = mask, .rgb = rgb, .z = z, .zx = zx, .zy = zy, .alpha = alpha, .id = id, .object = id};
}

/// One pixel of a variant after fragments have arrived.
inline FragmentLists pixel_of(const FragmentListOptions& options, std::initializer_list<Fragment> fragments) {
  FragmentLists lists(options);
  lists.clear(1);
  for (const Fragment& f : fragments) lists.insert(0, f);
  return lists;
}

inline std::vector<Mask> masks_of(FragmentLists& lists) {
  std::vector<Mask> masks;
  for (const Fragment& f : lists.fragments(0)) masks.push_back(f.mask);
  return masks;
}

inline void expect_colour(Vec3d is, Vec3d wanted, double within = 1e-5) {
  EXPECT_NEAR(is.x, wanted.x, within);
  EXPECT_NEAR(is.y, wanted.y, within);
  EXPECT_NEAR(is.z, wanted.z, within);
}

}  // namespace blysk::antialias::examples
