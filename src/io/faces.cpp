#include "io/faces.h"

#include <algorithm>
#include <utility>

#include "io/polygon.h"
#include "io/share_equal.h"

namespace blysk::io {
namespace {

constexpr std::size_t kFacesPerBlock = 8192;

// Writes the triangles of one face at `out`; returns their end.
class FaceCutter {
 public:
  explicit FaceCutter(const Array<Vec3f>& positions) : positions_(positions) {}

  std::uint32_t* cut(std::span<const std::uint32_t> face, std::uint32_t* out) {
    if (face.size() < 3) return out;
    if (face.size() == 3) return std::copy(face.begin(), face.end(), out);
    points_.clear();
    for (const std::uint32_t vertex : face) points_.push_back(positions_[vertex]);
    local_.clear();
    triangulate({points_.data(), points_.size()}, local_);
    for (const std::uint32_t corner : local_) *out++ = face[corner];
    return out;
  }

 private:
  const Array<Vec3f>& positions_;
  Array<Vec3f> points_;
  Array<std::uint32_t> local_;
};

// Some faces that follow each other, and where they and their triangles begin.
struct FaceBlock {
  std::uint64_t corners = 0, triangles = 0, too_small = 0;

  void add(const FaceBlock& b) {
    corners += b.corners;
    triangles += b.triangles;
    too_small += b.too_small;
  }
};

// What the faces of each block have, and all together, last.
std::vector<FaceBlock> count_blocks(const Faces& faces, ThreadPool& pool) {
  const std::size_t count = faces.sizes.size();
  std::vector<FaceBlock> blocks((count + kFacesPerBlock - 1) / kFacesPerBlock + 1);
  pool.for_each(blocks.size() - 1, [&](int, std::size_t i) {
    FaceBlock own;
    for (std::size_t face = i * kFacesPerBlock; face < std::min(count, (i + 1) * kFacesPerBlock); ++face) {
      const std::uint32_t size = faces.sizes[face];
      own.corners += size;
      own.triangles += size < 3 ? 0 : size - 2;
      own.too_small += size < 3;
    }
    blocks[i] = own;
  });
  for (std::size_t i = 0; i + 1 < blocks.size(); ++i) blocks.back().add(blocks[i]);
  return blocks;
}

// Calls work(first face, end, first corner, first triangle) for every block, in parallel.
template <class Work>
void for_each_block(const Faces& faces, const std::vector<FaceBlock>& blocks, ThreadPool& pool,
                    const Work& work) {
  std::vector<FaceBlock> starts(blocks.size());
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    starts[i] = starts[i - 1];
    starts[i].add(blocks[i - 1]);
  }
  pool.for_each(blocks.size() - 1, [&](int, std::size_t i) {
    const std::size_t end = std::min(faces.sizes.size(), (i + 1) * kFacesPerBlock);
    work(i * kFacesPerBlock, end, starts[i].corners, starts[i].triangles);
  });
}

void cut_faces(const Faces& faces, const std::vector<FaceBlock>& blocks, Mesh& mesh, ThreadPool& pool) {
  mesh.indices.resize(3 * blocks.back().triangles);
  for_each_block(faces, blocks, pool,
                 [&](std::size_t face, std::size_t end, std::uint64_t corner, std::uint64_t triangle) {
                   FaceCutter cutter(mesh.positions);
                   const std::uint32_t* corners = faces.corners.data() + corner;
                   std::uint32_t* out = mesh.indices.data() + 3 * triangle;
                   for (; face < end; ++face) {
                     out = cutter.cut({corners, faces.sizes[face]}, out);
                     corners += faces.sizes[face];
                   }
                 });
}

// The colour of each triangle's face.
Array<Vec4f> triangle_colors(Faces& faces, const std::vector<FaceBlock>& blocks, ThreadPool& pool) {
  if (faces.sizes.empty()) return std::move(faces.colors);
  Array<Vec4f> colors(blocks.back().triangles);
  for_each_block(
      faces, blocks, pool, [&](std::size_t face, std::size_t end, std::uint64_t, std::uint64_t triangle) {
        for (; face < end; ++face) {
          const std::uint32_t size = faces.sizes[face];
          const std::size_t triangles = size < 3 ? 0 : size - 2;
          std::fill_n(colors.begin() + static_cast<std::ptrdiff_t>(triangle), triangles, faces.colors[face]);
          triangle += triangles;
        }
      });
  return colors;
}

struct ColoredVertex {
  std::uint32_t vertex;
  Vec4f color;

  [[nodiscard]] std::uint64_t hash() const { return vertex * 0x9e3779b97f4a7c15u; }
  friend bool operator==(const ColoredVertex&, const ColoredVertex&) = default;
};

template <class T>
void pick(Array<T>& values, const SharedKeys<ColoredVertex>& shared, ThreadPool& pool) {
  if (values.empty()) return;
  Array<T> picked(shared.count());
  pool.for_each(shared.runs.size(), [&](int, std::size_t run) {
    T* to = picked.data() + shared.first[run];
    for (const ColoredVertex& key : shared.runs[run]) *to++ = values[key.vertex];
  });
  values = std::move(picked);
}

// Gives each vertex the colour of its triangles, and one copy of it to each other colour there.
void color_triangles(Mesh& mesh, const Array<Vec4f>& colors, ThreadPool& pool) {
  const auto each = [&](std::size_t begin, std::size_t end, const auto& take) {
    for (std::size_t corner = begin; corner < end; corner += 3) {
      for (std::size_t k = 0; k < 3; ++k) take(ColoredVertex{mesh.indices[corner + k], colors[corner / 3]});
    }
  };
  SharedKeys<ColoredVertex> shared = share_equal<ColoredVertex>(mesh.indices.size(), each, pool);
  pick(mesh.positions, shared, pool);
  pick(mesh.normals, shared, pool);
  pick(mesh.texcoords, shared, pool);
  mesh.colors.resize(shared.count());
  pool.for_each(shared.runs.size(), [&](int, std::size_t run) {
    Vec4f* to = mesh.colors.data() + shared.first[run];
    for (const ColoredVertex& key : shared.runs[run]) *to++ = key.color;
  });
  mesh.indices = std::move(shared.ids);
}

}  // namespace

std::string no_such_vertex(const std::string& who, const std::string& text, std::uint64_t vertices) {
  return who + " uses vertex " + text + ", but " +
         (vertices == 0 ? "there are none" : "they count from 0 to " + std::to_string(vertices - 1)) +
         "; save the model again";
}

std::string no_faces(std::uint64_t vertices) {
  if (vertices == 0) return "there are neither vertices nor faces";
  return vertices == 1 ? "there is 1 vertex, but no faces"
                       : "there are " + std::to_string(vertices) + " vertices, but no faces";
}

Status add_faces(const Source& source, Faces faces, Mesh& mesh, std::vector<std::string>& problems,
                 ThreadPool& pool) {
  const std::vector<FaceBlock> blocks = count_blocks(faces, pool);
  const FaceBlock& all = blocks.back();
  if (all.too_small == 0 && all.corners == 3 * faces.sizes.size()) faces.sizes = {};
  const std::uint64_t triangles = faces.sizes.empty() ? faces.corners.size() / 3 : all.triangles;
  const std::uint64_t per_corner = 4 + (faces.colors.empty() ? 0 : 72);
  if (Status s = check_limits(source, triangles, triangles * 3 * per_corner); !s) return s;
  if (Status s = check_index_width(source, triangles); !s) return s;
  if (all.too_small > 0) {
    problems.push_back("left out " + std::to_string(all.too_small) +
                       (all.too_small == 1 ? " face" : " faces") + " of fewer than three corners");
  }
  if (faces.sizes.empty()) {
    mesh.indices = std::move(faces.corners);
  } else {
    cut_faces(faces, blocks, mesh, pool);
  }
  if (!faces.colors.empty()) color_triangles(mesh, triangle_colors(faces, blocks, pool), pool);
  drop_bad_triangles(mesh, problems, pool);
  return Done{};
}

void add_mesh(Scene& scene, Mesh mesh) {
  if (mesh.indices.empty()) return;
  if (scene.materials.empty()) scene.materials.emplace_back();
  // Colours of vertices are the surface's whole colour.
  if (!mesh.colors.empty()) scene.materials[0].color = {1, 1, 1};
  Instance instance;
  instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
  instance.name = mesh.name;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(std::move(instance));
}

}  // namespace blysk::io
