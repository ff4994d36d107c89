#include "io/polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace blysk::io {
namespace {

Vec3d triangle_normal(Vec3f a, Vec3f b, Vec3f c) {
  const Vec3d o = to_double(a);
  return cross(to_double(b) - o, to_double(c) - o);
}

// Newell's: the sum of the fan's normals, whatever the shape.
Vec3d polygon_normal(std::span<const Vec3f> corners) {
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum = sum + triangle_normal(corners[0], corners[i], corners[i + 1]);
  }
  return sum;
}

// Whether every triangle of the fan from the first corner faces the polygon's way.
bool fan_covers(std::span<const Vec3f> corners, Vec3d normal) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    if (dot(triangle_normal(corners[0], corners[i], corners[i + 1]), normal) < 0) return false;
  }
  return true;
}

void add_fan(std::size_t corners, Array<std::uint32_t>& out) {
  for (std::uint32_t i = 1; i + 1 < corners; ++i) {
    out.push_back(0);
    out.push_back(i);
    out.push_back(i + 1);
  }
}

// Ear clipping in the plane of the two axes that the normal leans from most. Cost: corners x reflex corners
// at worst.
class EarCutter {
 public:
  EarCutter(std::span<const Vec3f> corners, Vec3d normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3d p = to_double(corners[i]);
      if (z >= x && z >= y) {
        points_.push_back(normal.z > 0 ? Vec2<double>{p.x, p.y} : Vec2<double>{p.y, p.x});
      } else if (x >= y) {
        points_.push_back(normal.x > 0 ? Vec2<double>{p.y, p.z} : Vec2<double>{p.z, p.y});
      } else {
        points_.push_back(normal.y > 0 ? Vec2<double>{p.z, p.x} : Vec2<double>{p.x, p.z});
      }
      previous_.push_back(i == 0 ? count - 1 : i - 1);
      next_.push_back(i + 1 == count ? 0 : i + 1);
      refused_.push_back(0);
    }
    choose_axis();
    for (std::uint32_t i = 0; i < count; ++i) {
      if (turn(i) < 0) reflex_.push_back(i);
    }
    std::sort(reflex_.begin(), reflex_.end(), [&](std::uint32_t p, std::uint32_t q) {
      return along(p) < along(q) || (along(p) == along(q) && p < q);
    });
  }

  void cut(Array<std::uint32_t>& out) {
    std::size_t left = points_.size();
    std::uint32_t at = 0;
    std::size_t refused_in_a_row = 0;
    while (left > 3) {
      // A polygon that crosses itself may have no ear at all: then any corner must do.
      if (refused_in_a_row < left && (refused_[at] != 0 || !is_ear(at))) {
        refused_[at] = 1;
        ++refused_in_a_row;
        at = next_[at];
        continue;
      }
      add(at, out);
      remove(at);
      --left;
      refused_in_a_row = 0;
      at = previous_[at];
    }
    add(at, out);
  }

 private:
  // Twice the area of a, b, c: positive counter-clockwise.
  static double area(Vec2<double> a, Vec2<double> b, Vec2<double> c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  double turn(std::uint32_t i) const { return area(points_[previous_[i]], points_[i], points_[next_[i]]); }

  double along(std::uint32_t i) const { return by_y_ ? points_[i].y : points_[i].x; }

  // Reflex corners are kept sorted along the axis on which the polygon's edges are the shorter, compared with
  // the whole: an ear then meets few of them.
  void choose_axis() {
    Vec2<double> edges, lo = points_[0], hi = points_[0];
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec2<double> a = points_[i], b = points_[next_[i]];
      edges = {edges.x + std::abs(a.x - b.x), edges.y + std::abs(a.y - b.y)};
      lo = {std::min(lo.x, a.x), std::min(lo.y, a.y)};
      hi = {std::max(hi.x, a.x), std::max(hi.y, a.y)};
    }
    by_y_ = edges.y * (hi.x - lo.x) < edges.x * (hi.y - lo.y);
  }

  bool is_ear(std::uint32_t i) const {
    const Vec2<double> a = points_[previous_[i]], b = points_[i], c = points_[next_[i]];
    if (area(a, b, c) < 0) return false;
    const double lowest = std::min({along(previous_[i]), along(i), along(next_[i])});
    const double highest = std::max({along(previous_[i]), along(i), along(next_[i])});
    auto at = std::lower_bound(reflex_.begin(), reflex_.end(), lowest,
                               [&](std::uint32_t p, double limit) { return along(p) < limit; });
    for (; at != reflex_.end() && along(*at) <= highest; ++at) {
      const std::uint32_t r = *at;
      if (r == previous_[i] || r == i || r == next_[i]) continue;
      const Vec2<double> p = points_[r];
      if (p == a || p == b || p == c) continue;
      if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
    }
    return true;
  }

  // Only the neighbours' state changes: they may be ears now, and convex ones no longer stand in the way.
  void remove(std::uint32_t cut) {
    const std::uint32_t before = previous_[cut], after = next_[cut];
    next_[before] = after;
    previous_[after] = before;
    refused_[before] = refused_[after] = 0;
    std::erase_if(reflex_,
                  [&](std::uint32_t r) { return r == cut || ((r == before || r == after) && turn(r) >= 0); });
  }

  void add(std::uint32_t i, Array<std::uint32_t>& out) const {
    out.push_back(previous_[i]);
    out.push_back(i);
    out.push_back(next_[i]);
  }

  std::vector<Vec2<double>> points_;
  std::vector<std::uint32_t> previous_, next_, reflex_;
  bool by_y_ = false;
  std::vector<char> refused_;  // no ear when last looked at, and nothing beside it has changed since
};

}  // namespace

void triangulate(std::span<const Vec3f> corners, Array<std::uint32_t>& local_indices) {
  if (corners.size() < 3) return;
  if (corners.size() == 3) {
    local_indices.insert(local_indices.end(), {0, 1, 2});
    return;
  }
  const Vec3d normal = polygon_normal(corners);
  if (corners.size() > kMostEarCorners || fan_covers(corners, normal)) {
    add_fan(corners.size(), local_indices);
  } else {
    EarCutter(corners, normal).cut(local_indices);
  }
}

}  // namespace blysk::io
