// Coverage: the pipeline's pixels are those of exact arithmetic, one triangle alone and many side by side.
#include <gtest/gtest.h>

#include <string>

#include "raster/coverage_reference.h"
#include "render/testing.h"
#include "render/view.h"

namespace blysk {
namespace {

struct Size {
  int width, height;
};

// A corner in 1/256 pixel of the picture, as a world position of pixel_camera(); exact for |x|, |y| < 2^23.
Vec3f at_subpixel(Size size, double x, double y, float z = 0) {
  return {static_cast<float>((x - size.width * 128) / 256), static_cast<float>((size.height * 128 - y) / 256),
          z};
}

RenderOptions id_options(Size size, const Camera& camera) {
  RenderOptions o;
  o.antialias = "none";
  o.width = size.width;
  o.height = size.height;
  o.camera = camera;
  o.shading = "flat";
  o.cull = Cull::none;
  o.want_id = true;
  return o;
}

Projection projection_of(Size size, const Camera& camera) {
  const Result<ViewFrame> view = make_view(camera, Scene{}, size.width, size.height);
  Projection p{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) p.row[i][j] = static_cast<float>(view->screen.m[i][j]);
  }
  return p;
}

using Corners = std::array<Vec3f, 3>;

std::string text_of(const Corners& c) {
  std::string s;
  for (const Vec3f& p : c) {
    s += "(" + ::testing::PrintToString(p.x) + ", " + ::testing::PrintToString(p.y) + ", " +
         ::testing::PrintToString(p.z) + ") ";
  }
  return s;
}

// Renders single triangles into ids; memory and scene are reused.
class Alone {
 public:
  Alone(Size size, const Camera& camera) : options_(id_options(size, camera)) {
    scene_ = scene_of(mesh_of({{}, {}, {}}, {0, 1, 2}));
  }

  const Array<std::uint32_t>& ids(const Corners& c, Isa isa) {
    std::copy(c.begin(), c.end(), scene_.meshes[0].positions.begin());
    render_to(frame_, scene_, options_, isa);
    return frame_.id;
  }

 private:
  RenderOptions options_ = center_options();
  Scene scene_;
  Frame frame_;
};

// Rows of 0 and 1.
std::vector<std::uint32_t> covered_pixels(const reference::Triangle& t, Size size) {
  std::vector<std::uint32_t> r(static_cast<std::size_t>(size.width * size.height));
  reference::for_each_covered(t, size.width, size.height,
                              [&](int x, int y) { r[static_cast<std::size_t>(y * size.width + x)] = 1; });
  return r;
}

std::string first_difference(const std::vector<std::uint32_t>& expected, const Array<std::uint32_t>& actual,
                             Size size) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == actual[i]) continue;
    const auto at = static_cast<int>(i);
    return "pixel " + std::to_string(at % size.width) + "," + std::to_string(at / size.width) +
           ": expected " + std::to_string(expected[i]) + ", drawn " + std::to_string(actual[i]);
  }
  return "";
}

// Kinds of triangles, as corners in subpixels of a picture.
enum class Kind { dot, small, large, sliver, centred, level, degenerate, huge, between };
constexpr int kKinds = 9;

std::array<Vec2<double>, 3> random_corners(Random& random, Kind kind, Size size) {
  const std::int64_t w = size.width * 256, h = size.height * 256;
  const auto near_picture = [&] {
    return Vec2<double>{double(whole(random, -512, w + 512)), double(whole(random, -512, h + 512))};
  };
  const auto around = [&](Vec2<double> c, std::int64_t reach) {
    return Vec2<double>{c.x + double(whole(random, -reach, reach)),
                        c.y + double(whole(random, -reach, reach))};
  };
  const Vec2<double> c = near_picture();
  switch (kind) {
    case Kind::dot: {
      const std::int64_t reach = whole(random, 25, 512);  // sides of 0.2 to 4 pixels
      return {around(c, reach), around(c, reach), around(c, reach)};
    }
    case Kind::small: {
      const std::int64_t reach = whole(random, 256, 64 * 256);
      return {around(c, reach), around(c, reach), around(c, reach)};
    }
    case Kind::large:
      return {around(c, 200 * 256), around(c, 200 * 256), around(c, 200 * 256)};
    case Kind::sliver: {
      const Vec2<double> d = around(c, std::int64_t{1} << whole(random, 8, 16));
      const double t = uniform(random, -0.2, 1.2);
      return {c, d, around({std::round(c.x + t * (d.x - c.x)), std::round(c.y + t * (d.y - c.y))}, 3)};
    }
    case Kind::centred: {
      const auto snap = [](Vec2<double> v) {
        return Vec2<double>{std::floor(v.x / 256) * 256 + 128, std::floor(v.y / 256) * 256 + 128};
      };
      const std::int64_t reach = std::int64_t{1} << whole(random, 8, 15);
      return {snap(around(c, reach)), snap(around(c, reach)), snap(around(c, reach))};
    }
    case Kind::level: {  // level and upright edges, some through centres
      const auto grid = [](double v) { return std::round(v / 128) * 128; };
      const Vec2<double> d = around(c, std::int64_t{1} << whole(random, 8, 15));
      return {{{grid(c.x), grid(c.y)}, {grid(d.x), grid(c.y)}, {grid(c.x), grid(d.y)}}};
    }
    case Kind::degenerate: {
      const Vec2<double> d = around(c, 5000);
      if (whole(random, 0, 1) == 0) return {c, d, c};
      return {{{c.x, c.y}, {d.x, d.y}, {2 * d.x - c.x, 2 * d.y - c.y}}};
    }
    case Kind::huge: {
      const std::int64_t reach = std::int64_t{1} << whole(random, 17, 21);
      return {around(c, reach), around(c, reach), around(c, reach)};
    }
    case Kind::between:
      break;  // not on the grid of 1/256, ties of rounding among them
  }
  const auto off_grid = [&](Vec2<double> v) {
    return Vec2<double>{v.x + double(whole(random, 0, 7)) / 8, v.y + double(whole(random, 0, 7)) / 8};
  };
  return {off_grid(around(c, 2000)), off_grid(around(c, 2000)), off_grid(around(c, 2000))};
}

TEST(coverage, single_triangles_are_exact) {
  constexpr int kTriangles = 10000;
  constexpr Size kSizes[] = {{64, 64}, {97, 75}, {130, 66}, {31, 140}, {1, 1}, {200, 150}};
  Random random(1);
  std::array<int, kKinds> with_pixels{};
  for (int i = 0; i < kTriangles; ++i) {
    const Size size = kSizes[static_cast<std::size_t>(i / 50) % std::size(kSizes)];
    const Camera camera = pixel_camera(size.height);
    const Projection projection = projection_of(size, camera);
    const auto kind = static_cast<Kind>(i % kKinds);
    const auto wanted = random_corners(random, kind, size);

    Corners corners;
    reference::Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = at_subpixel(size, wanted[k].x, wanted[k].y);
      const auto place = reference::place(projection, corners[k]);
      ASSERT_TRUE(place.has_value());
      if (kind != Kind::between) {
        ASSERT_EQ(double(place->x), wanted[k].x);
        ASSERT_EQ(double(place->y), wanted[k].y);
      }
      triangle.corner[k] = *place;
    }
    const std::vector<std::uint32_t> expected = covered_pixels(triangle, size);
    with_pixels[static_cast<std::size_t>(kind)] +=
        std::count(expected.begin(), expected.end(), 1u) > 0 ? 1 : 0;
    Alone alone(size, camera);
    for (const Isa isa : available_isas()) {
      const auto& ids = alone.ids(corners, isa);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), ids.begin()))
          << isa_name(isa) << ", triangle " << i << ", " << size.width << "x" << size.height << ": "
          << text_of(corners) << first_difference(expected, ids, size);
    }
  }
  for (int k = 0; k < kKinds; ++k) {
    const int n = with_pixels[static_cast<std::size_t>(k)];
    EXPECT_TRUE(static_cast<Kind>(k) == Kind::degenerate ? n == 0 : n > 50) << "kind " << k << ": " << n;
  }
}

TEST(coverage, perspective_is_exact_after_snapping) {
  constexpr Size kSize = {150, 110};
  Random random(2);
  int covering = 0, placed = 0;
  for (int i = 0; i < 3000; ++i) {
    Camera camera;
    camera.eye = random_direction(random) * uniform(random, 3, 9);
    camera.target = random_direction(random);
    camera.fov_deg = uniform(random, 5, 120);
    camera.near_distance = 0.01;
    camera.far_distance = 50;
    const double reach = std::pow(2.0, uniform(random, -6, 1));
    const Vec3d c = random_direction(random);
    Corners corners;
    for (Vec3f& p : corners) p = to_float(c + random_direction(random) * reach);

    const Projection projection = projection_of(kSize, camera);
    reference::Triangle triangle;
    bool whole_on_screen = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = reference::place(projection, corners[k]);
      whole_on_screen = whole_on_screen && place.has_value();
      if (place) triangle.corner[k] = *place;
    }
    if (!whole_on_screen) continue;
    ++placed;
    const std::vector<std::uint32_t> expected = covered_pixels(triangle, kSize);
    covering += std::count(expected.begin(), expected.end(), 1u) > 0 ? 1 : 0;
    Alone alone(kSize, camera);
    for (const Isa isa : available_isas()) {
      const auto& ids = alone.ids(corners, isa);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), ids.begin()))
          << isa_name(isa) << ", triangle " << i << ": " << text_of(corners)
          << first_difference(expected, ids, kSize);
    }
  }
  EXPECT_GT(placed, 2900);
  EXPECT_GT(covering, 1000);
}

// Triangles that cross the planes of the view or the guard band: whatever lies 1/128 pixel inside or outside
// of all edges must be drawn, or not.
TEST(coverage, clipped_triangles_keep_to_their_edges) {
  constexpr Size kSize = {120, 90};
  constexpr double kBand = 2;
  Random random(3);
  int clipped = 0, inside = 0, outside = 0;
  for (int i = 0; i < 1500; ++i) {
    Camera camera;
    camera.eye = random_direction(random);
    camera.target = camera.eye + random_direction(random);
    camera.fov_deg = i % 3 == 0 ? uniform(random, 1, 10) : uniform(random, 30, 150);
    camera.near_distance = std::pow(10.0, uniform(random, -2, 0));
    camera.far_distance = camera.near_distance + uniform(random, 1, 20);
    Corners corners;
    for (Vec3f& p : corners)
      p = to_float(camera.eye + random_direction(random) * std::pow(10.0, uniform(random, -1, 1.5)));

    const Projection projection = projection_of(kSize, camera);
    const bool whole_on_screen = std::all_of(corners.begin(), corners.end(), [&](const Vec3f& p) {
      return reference::place(projection, p).has_value();
    });
    if (whole_on_screen) continue;
    ++clipped;
    const reference::HomogeneousTriangle triangle(projection, corners);
    std::vector<double> depth;
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) depth.push_back(triangle.depth_inside(x, y));
    }
    Alone alone(kSize, camera);
    for (const Isa isa : available_isas()) {
      const auto& ids = alone.ids(corners, isa);
      for (std::size_t k = 0; k < depth.size(); ++k) {
        if (std::abs(depth[k]) <= kBand) continue;
        (depth[k] > 0 ? inside : outside) += 1;
        ASSERT_EQ(ids[k], depth[k] > 0 ? 1u : 0u)
            << isa_name(isa) << ", triangle " << i << ": " << text_of(corners) << "pixel " << k % kSize.width
            << "," << k / kSize.width << " lies " << depth[k] << " subpixels inside";
      }
    }
  }
  EXPECT_GT(clipped, 1000);
  EXPECT_GT(inside, 100000);
  EXPECT_GT(outside, 100000);
}

// Every triangle of a mesh alone, and the whole mesh at once.
struct Tally {
  std::vector<int> hits;            // triangles that cover the pixel when alone
  std::vector<std::uint32_t> last;  // 1 + the last of them
  Array<std::uint32_t> whole;       // ids of the mesh
};

Tally tally(const Mesh& mesh, Size size, const Camera& camera, Isa isa) {
  Tally t;
  t.whole = render_frame(scene_of(mesh), id_options(size, camera), isa).id;
  t.hits.resize(t.whole.size());
  t.last.resize(t.whole.size());
  Alone alone(size, camera);
  for (std::size_t i = 0; i < mesh.triangles(); ++i) {
    const std::uint32_t* v = &mesh.indices[3 * i];
    const auto& ids = alone.ids({mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]}, isa);
    for (std::size_t p = 0; p < ids.size(); ++p) {
      if (ids[p] == 0) continue;
      ++t.hits[p];
      t.last[p] = static_cast<std::uint32_t>(i) + 1;
    }
  }
  return t;
}

bool everywhere(int, int) { return true; }

// No pixel belongs to two triangles, and every one that `must` belongs to one, with and without the others.
template <class Must>
void expect_watertight(const Mesh& mesh, Size size, const Camera& camera, Must must) {
  for (const Isa isa : available_isas()) {
    const Tally t = tally(mesh, size, camera, isa);
    for (std::size_t p = 0; p < t.hits.size(); ++p) {
      const int x = static_cast<int>(p) % size.width, y = static_cast<int>(p) / size.width;
      const auto where = [&] {
        return std::string(isa_name(isa)) + ", pixel " + std::to_string(x) + "," + std::to_string(y);
      };
      ASSERT_GE(t.hits[p], must(x, y) ? 1 : 0) << where();
      ASSERT_LE(t.hits[p], 1) << where();
      ASSERT_EQ(t.whole[p], t.last[p]) << where();
    }
  }
}

// A sheet of cells that covers the picture with room to spare; corners are moved at random, up to nearly half
// a cell.
Mesh jittered_grid(Random& random, Size size, double cell, double jitter) {
  const int columns = static_cast<int>(size.width / cell) + 4,
            rows = static_cast<int>(size.height / cell) + 4;
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      const auto move = [&] { return uniform(random, -jitter, jitter); };
      const double px = (x - 1.5 + move()) * cell, py = (y - 1.5 + move()) * cell;
      positions.push_back(at_subpixel(size, std::round(px * 256), std::round(py * 256)));
    }
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const auto a = static_cast<std::uint32_t>(y * (columns + 1) + x), b = a + 1;
      const auto c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
      const bool falling = random.unit() < 0.5f;
      if (falling) {
        indices.insert(indices.end(), {a, c, d, a, d, b});
      } else {
        indices.insert(indices.end(), {a, c, b, b, c, d});
      }
      // Half of them face away.
      if (random.unit() < 0.5f) std::swap(indices[indices.size() - 1], indices[indices.size() - 2]);
    }
  }
  return mesh_of(positions, indices);
}

TEST(coverage, grids_have_no_gap_and_no_overlap) {
  Random random(4);
  const struct {
    Size size;
    double cell;
  } sheets[] = {{{24, 16}, 0.7},  {{40, 30}, 2.5},   {{130, 70}, 11},
                {{200, 140}, 70}, {{150, 130}, 400}, {{64, 64}, 4000}};
  for (const auto& sheet : sheets) {
    for (const double jitter : {0.0, 0.24}) {
      SCOPED_TRACE(sheet.cell);
      expect_watertight(jittered_grid(random, sheet.size, sheet.cell, jitter), sheet.size,
                        pixel_camera(sheet.size.height), everywhere);
    }
  }
}

// Long thin triangles around one point; the point and some edges lie on pixel centres.
TEST(coverage, fans_have_no_gap_and_no_overlap) {
  Random random(5);
  for (const int spokes : {3, 8, 64, 500}) {
    constexpr Size kSize = {99, 70};
    std::vector<double> angles;
    for (int i = 0; i < spokes; ++i)
      angles.push_back(i * 2 * 3.14159265358979 / spokes + uniform(random, 0, 1e-3));
    std::vector<Vec3f> positions = {at_subpixel(kSize, 128 + 256 * 40, 128 + 256 * 33)};
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < spokes; ++i) {
      const double reach = 256 * uniform(random, 300, 3000);
      const double a = angles[static_cast<std::size_t>(i)];
      positions.push_back(at_subpixel(kSize, std::round(128 + 256 * 40 + reach * std::cos(a)),
                                      std::round(128 + 256 * 33 + reach * std::sin(a))));
      indices.insert(indices.end(), {0u, static_cast<std::uint32_t>(i + 1),
                                     static_cast<std::uint32_t>((i + 1) % spokes + 1)});
    }
    SCOPED_TRACE(spokes);
    expect_watertight(mesh_of(positions, indices), kSize, pixel_camera(kSize.height), everywhere);
  }
}

// Strips of thin triangles, each edge shared by two.
TEST(coverage, strips_have_no_gap_and_no_overlap) {
  Random random(6);
  constexpr Size kSize = {140, 40};
  for (const double step : {0.3, 1.7, 9.0}) {
    std::vector<Vec3f> positions;
    std::vector<std::uint32_t> indices;
    const int columns = static_cast<int>(kSize.width / step) + 40;
    for (int i = 0; i < columns; ++i) {
      const double slant = uniform(random, -0.2, 0.2);
      positions.push_back(at_subpixel(kSize, std::round((i - 15 + slant) * step * 256), -300));
      positions.push_back(
          at_subpixel(kSize, std::round((i - 15 - slant) * step * 256), kSize.height * 256 + 300));
      if (i == 0) continue;
      const auto a = static_cast<std::uint32_t>(2 * i - 2);
      indices.insert(indices.end(), {a, a + 1, a + 2, a + 2, a + 1, a + 3});
    }
    SCOPED_TRACE(step);
    expect_watertight(mesh_of(positions, indices), kSize, pixel_camera(kSize.height), everywhere);
  }
}

// A ball of triangles around the eye: every pixel sees one of them, and most of them cross a plane of the
// view, go behind the eye or beyond the guard band.
Mesh room(Random& random, Vec3d eye, int detail) {
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;
  const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, fresh] = known.try_emplace(at, static_cast<std::uint32_t>(positions.size()));
    if (fresh) {
      const Vec3d d = normalize(Vec3d{double(at[0]), double(at[1]), double(at[2])});
      positions.push_back(to_float(eye + d * uniform(random, 4, 5)));
    }
    return entry->second;
  };
  for (int side = 0; side < 6; ++side) {
    const Vec3d n = axes[side / 2] * (side % 2 == 0 ? 1.0 : -1.0), u = axes[(side / 2 + 1) % 3],
                v = cross(n, u);
    const auto corner = [&](int i, int j) {
      const Vec3d p = n * detail + u * (2 * i - detail) + v * (2 * j - detail);
      return vertex({static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)});
    };
    for (int i = 0; i < detail; ++i) {
      for (int j = 0; j < detail; ++j) {
        indices.insert(indices.end(), {corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
        indices.insert(indices.end(), {corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
      }
    }
  }
  return mesh_of(positions, indices);
}

TEST(coverage, a_room_around_the_eye_has_no_gap) {
  Random random(7);
  constexpr Size kSize = {80, 60};
  for (const double fov : {1.0, 20.0, 90.0, 140.0}) {
    for (int i = 0; i < 8; ++i) {
      Camera camera;
      camera.eye = random_direction(random) * 3;
      camera.target = camera.eye + random_direction(random);
      camera.fov_deg = fov;
      camera.near_distance = 0.05;
      camera.far_distance = 20;
      SCOPED_TRACE(fov);
      expect_watertight(room(random, camera.eye, i % 2 == 0 ? 1 : 5), kSize, camera, everywhere);
    }
  }
}

// Two triangles share an edge that begins on the near plane, but for rounding. One of them lies wholly in the
// view, the other goes on behind the eye and is clipped: along the edge every pixel must still belong to
// exactly one.
TEST(coverage, an_edge_from_the_near_plane_is_shared) {
  Random random(8);
  constexpr Size kSize = {160, 120};
  int along_edge = 0;
  for (int i = 0; i < 4000; ++i) {
    Camera camera;
    camera.eye = random_direction(random) * 2;
    camera.target = camera.eye + random_direction(random);
    camera.fov_deg = uniform(random, 20, 100);
    camera.near_distance = uniform(random, 0.01, 0.5);
    camera.far_distance = 20;
    const Result<ViewFrame> view = make_view(camera, Scene{}, kSize.width, kSize.height);
    ASSERT_TRUE(view);
    const auto at = [&](double depth, double reach) {
      const Vec3d ray = view->forward + view->right * uniform(random, -reach, reach) +
                        view->up * uniform(random, -reach, reach);
      return to_float(camera.eye + ray * depth);
    };
    const Vec3f a = at(camera.near_distance, 3), b = at(uniform(random, 1, 5), 0.5);
    const Vec3f behind = to_float(camera.eye - view->forward + random_direction(random) * 0.5);
    const Vec3f inside = at(uniform(random, 1, 5), 0.5);

    const Projection projection = projection_of(kSize, camera);
    if (!reference::place(projection, a) || !reference::place(projection, inside)) continue;
    const reference::HomogeneousTriangle clipped(projection, {a, b, behind}),
        whole(projection, {a, b, inside});
    Alone alone(kSize, camera);
    const auto first = alone.ids({a, b, behind}, Isa::best);
    const auto& second = alone.ids({b, a, inside}, Isa::best);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        // The edge is the third of both; on one side of it lies each triangle.
        constexpr double kBand = 4;
        if (std::abs(clipped.distance(2, x, y)) > kBand || clipped.depth_inside_but(2, x, y) < kBand ||
            whole.depth_inside_but(2, x, y) < kBand) {
          continue;
        }
        if ((clipped.distance(2, x, y) > 0) == (whole.distance(2, x, y) > 0)) continue;  // both on one side
        ++along_edge;
        const auto p = static_cast<std::size_t>(y * kSize.width + x);
        ASSERT_EQ(first[p] + second[p], 1u)
            << i << ": " << text_of({a, b, behind}) << text_of({b, a, inside}) << "pixel " << x << "," << y;
      }
    }
  }
  EXPECT_GT(along_edge, 1000);
}

}  // namespace
}  // namespace blysk
