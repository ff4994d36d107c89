// The triangles that the kernel leaves: large ones, and ones that cross the near or far plane or the guard
// band.
//
// Clipping: I. Sutherland, G. Hodgman. Reentrant polygon clipping. 1974. In homogeneous coordinates and
// double precision; an edge is always cut from its lesser end, so that two triangles that share it get the
// same point.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>

#include "geometry/assemble.h"

namespace blysk {
namespace {

struct ClipVertex {
  double x, y, z, w;            // subpixels, nearness, each times w
  const ScreenVertex* snapped;  // of an original vertex that has its place on the screen
};

// Three corners, one more for each of six planes.
struct Polygon {
  std::array<ClipVertex, 9> v;
  int size = 0;
  void add(const ClipVertex& c) { v[static_cast<std::size_t>(size++)] = c; }
};

// To near, far and the four guard planes.
double plain_distance(const ClipVertex& v, int plane) {
  switch (plane) {
    case 0:
      return v.w - v.z;
    case 1:
      return v.z;
    case 2:
      return kGuardBand * v.w - v.x;
    case 3:
      return kGuardBand * v.w + v.x;
    case 4:
      return kGuardBand * v.w - v.y;
    default:
      return kGuardBand * v.w + v.y;
  }
}

// Inside is >= 0. A vertex that has its place is inside even where rounding says otherwise: the triangles
// around it that are not clipped meet it where it stands.
double distance(const ClipVertex& v, int plane) {
  const double d = plain_distance(v, plane);
  return v.snapped != nullptr ? std::max(d, 0.0) : d;
}

ClipVertex cut(ClipVertex a, ClipVertex b, int plane) {
  if (std::tie(b.x, b.y, b.z, b.w) < std::tie(a.x, a.y, a.z, a.w)) std::swap(a, b);
  const double da = distance(a, plane), db = distance(b, plane);
  const double t = da / (da - db);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), a.w + t * (b.w - a.w),
          nullptr};
}

void clip(Polygon& polygon, int plane) {
  Polygon out;
  for (int i = 0; i < polygon.size; ++i) {
    const ClipVertex& a = polygon.v[static_cast<std::size_t>(i)];
    const ClipVertex& b = polygon.v[static_cast<std::size_t>((i + 1) % polygon.size)];
    const bool a_in = distance(a, plane) >= 0, b_in = distance(b, plane) >= 0;
    if (a_in) out.add(a);
    if (a_in != b_in) out.add(cut(a, b, plane));
  }
  polygon = out;
}

ClipVertex to_clip(const Vec3f& p, const Projection& m, const ScreenVertex& screen) {
  const auto row = [&](int i) {
    return double{m.row[i][0]} * double{p.x} + double{m.row[i][1]} * double{p.y} +
           double{m.row[i][2]} * double{p.z} + double{m.row[i][3]};
  };
  return {row(0), row(1), row(2), row(3), screen.x != kUnplaced ? &screen : nullptr};
}

struct Corner {
  std::int32_t x, y;
  float nearness;
};

Corner place(const ClipVertex& v) {
  if (v.snapped != nullptr) return {v.snapped->x, v.snapped->y, v.snapped->nearness};
  constexpr double kGuard = kGuardBand;  // cutting may leave a point an ulp outside
  const double q = 1.0 / v.w;
  const auto snap = [=](double c) {
    return static_cast<std::int32_t>(std::nearbyint(std::clamp(c, -kGuard, kGuard)));
  };
  return {snap(v.x * q), snap(v.y * q), static_cast<float>(std::clamp(v.z * q, 0.0, 1.0))};
}

// Whether a tile, as the places that are looked at, lies wholly on the outer side of the edge a -> b.
bool outside(const LargeEntry& e, int a, int b, std::int64_t x0, std::int64_t y0, std::int64_t x1,
             std::int64_t y1) {
  const std::int64_t dx = std::int64_t{e.x[b]} - e.x[a], dy = std::int64_t{e.y[b]} - e.y[a];
  const std::int64_t px = dy < 0 ? x1 : x0, py = dx > 0 ? y1 : y0;  // the corner that lies farthest inside
  return dx * (py - e.y[a]) - dy * (px - e.x[a]) < 0;
}

// Bins one triangle; true if it reaches a tile.
bool bin_large(AssembleJob& job, LargeEntry e) {
  const std::int64_t area = (std::int64_t{e.x[1]} - e.x[0]) * (std::int64_t{e.y[2]} - e.y[0]) -
                            (std::int64_t{e.x[2]} - e.x[0]) * (std::int64_t{e.y[1]} - e.y[0]);
  if (area == 0) return false;
  if (area < 0) {
    std::swap(e.x[1], e.x[2]);
    std::swap(e.y[1], e.y[2]);
    std::swap(e.nearness[1], e.nearness[2]);
  }
  const int reach = reach_of(job.sampling);
  const auto first = [reach](std::int32_t v) { return first_pixel(v, reach); };
  const auto last = [reach](std::int32_t v) { return last_pixel(v, reach); };
  const int left = std::max(first(std::min({e.x[0], e.x[1], e.x[2]})), 0);
  const int top = std::max(first(std::min({e.y[0], e.y[1], e.y[2]})), 0);
  const int right = std::min(last(std::max({e.x[0], e.x[1], e.x[2]})), job.width - 1);
  const int bottom = std::min(last(std::max({e.y[0], e.y[1], e.y[2]})), job.height - 1);
  if (left > right || top > bottom) return false;

  bool reached = false;
  for (int ty = top >> kTileBits; ty <= bottom >> kTileBits; ++ty) {
    for (int tx = left >> kTileBits; tx <= right >> kTileBits; ++tx) {
      const auto center = [](int pixel) { return std::int64_t{pixel} * kSubpixels + kSubpixels / 2; };
      const std::int64_t x0 = center(std::max(left, tx * kTileSize)) - reach,
                         x1 = center(std::min(right, tx * kTileSize + kTileSize - 1)) + reach;
      const std::int64_t y0 = center(std::max(top, ty * kTileSize)) - reach,
                         y1 = center(std::min(bottom, ty * kTileSize + kTileSize - 1)) + reach;
      if (outside(e, 1, 2, x0, y0, x1, y1) || outside(e, 2, 0, x0, y0, x1, y1) ||
          outside(e, 0, 1, x0, y0, x1, y1))
        continue;
      Bin& bin = job.bins[bin_index(static_cast<std::size_t>(ty * job.tiles_x + tx),
                                    job.transparent ? Stream::glass_large : Stream::large)];
      if (static_cast<std::size_t>(bin.end - bin.cursor) < sizeof e) job.owner->grow(bin);
      std::memcpy(bin.cursor, &e, sizeof e);
      bin.cursor += sizeof e;
      reached = true;
    }
  }
  return reached;
}

// The sign of the area of the visible part, from homogeneous coordinates (triangles of unplaced vertices have
// no other).
double signed_area(const Polygon& p) {
  double area = 0;
  for (int i = 2; i < p.size; ++i) {
    const auto at = [&](int k) {
      const Corner c = place(p.v[static_cast<std::size_t>(k)]);
      return std::pair<double, double>{c.x, c.y};
    };
    const auto [x0, y0] = at(0);
    const auto [x1, y1] = at(i - 1);
    const auto [x2, y2] = at(i);
    area += (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
  }
  return area;
}

}  // namespace

void assemble_rest(AssembleJob& job, const Vec3f* positions, const Projection& projection) {
  for (std::size_t r = 0; r < job.rest_count; ++r) {
    const std::uint32_t* corner = job.indices + std::size_t{3} * job.rest[r];
    Polygon polygon;
    bool placed = true;
    for (int k = 0; k < 3; ++k) {
      const ScreenVertex& screen = job.vertices[std::size_t{job.vertex_base} + corner[k]];
      placed = placed && screen.x != kUnplaced;
      polygon.add(to_clip(positions[corner[k]], projection, screen));
    }
    for (int plane = 0; !placed && plane < 6 && polygon.size > 0; ++plane) clip(polygon, plane);
    if (polygon.size < 3) continue;

    if (job.drop != DropArea::none) {
      const double area = signed_area(polygon);
      if (job.drop == DropArea::negative ? area < 0 : area > 0) {
        ++job.culled;
        continue;
      }
    }
    bool reached = false;
    for (int i = 2; i < polygon.size; ++i) {
      LargeEntry e{job.id_base + job.rest[r], {}, {}, {}};
      const int fan[3] = {0, i - 1, i};
      for (int k = 0; k < 3; ++k) {
        const Corner c = place(polygon.v[static_cast<std::size_t>(fan[k])]);
        e.x[k] = c.x;
        e.y[k] = c.y;
        e.nearness[k] = c.nearness;
      }
      reached |= bin_large(job, e);
    }
    job.drawn += reached ? 1 : 0;
  }
}

}  // namespace blysk
