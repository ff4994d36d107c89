#include "render/subpixels.h"

#include <algorithm>

namespace blysk {
namespace {

// All samples of a part; `columns` and `rows` are where their centroid lies, in columns and rows of samples.
std::int32_t whole_part(int at, float column, float row) {
  const auto sum = [](float place) { return static_cast<std::int32_t>(2 * kSamples * place); };
  return at | kSamples << kFragmentSamplesShift | sum(column) << kFragmentColumnsShift |
         sum(row) << kFragmentRowsShift;
}

void add_fragment(SampleBuffers& s, std::uint32_t id, std::int32_t place, float nearness) {
  s.fragment_id[s.fragments] = static_cast<std::int32_t>(id);
  s.fragment_place[s.fragments] = place;
  s.fragment_nearness[s.fragments] = nearness;
  s.fragment_weight[s.fragments] = kSamples;
  ++s.fragments;
}

bool is_simple(std::uint32_t id) { return id < kManySurfaces; }

// Calls visit(place of the pixel, its first part).
template <class Visit>
void for_each_pixel(const Subpixels& cut, int width, int height, Visit visit) {
  for (int row = 0; row < height / cut.down; ++row) {
    for (int column = 0; column < width / cut.across; ++column) {
      visit(row * kTileSize + column, row * cut.down * kTileSize + column * cut.across);
    }
  }
}

template <class Visit>
void for_each_part(const Subpixels& cut, int first, Visit visit) {
  for (int i = 0; i < cut.count(); ++i) visit(first + i / cut.across * kTileSize + i % cut.across);
}

}  // namespace

ViewFrame in_subpixels(ViewFrame view, const Subpixels& subpixels) {
  // Powers of two: nothing is rounded.
  const auto scale = [](double* row, int by) {
    for (int k = 0; k < 4; ++k) row[k] *= by;
  };
  scale(view.screen.m[0], subpixels.across);
  scale(view.screen.m[1], subpixels.down);
  for (int k = 0; k < 3; ++k) {
    view.rays.direction_x[k] /= static_cast<float>(subpixels.across);
    view.rays.origin_x[k] /= static_cast<float>(subpixels.across);
    view.rays.direction_y[k] /= static_cast<float>(subpixels.down);
    view.rays.origin_y[k] /= static_cast<float>(subpixels.down);
  }
  return view;
}

void SubpixelTile::list_simple(const Subpixels& subpixels, const TileJob& job, const Vec4f& background,
                               SampleBuffers& samples) {
  TileBuffers& b = *job.buffers;
  ids_.assign(b.id, b.id + kTilePixels);
  const float clear[] = {background.x, background.y, background.z, background.w};
  const auto list = [&](int at) {
    float* sum = samples.sum + 4 * at;
    if (is_simple(ids_[static_cast<std::size_t>(at)])) {
      constexpr float kMiddle = 1.5f;
      std::fill_n(sum, 4, 0.0f);
      add_fragment(samples, b.id[at], whole_part(at, kMiddle, kMiddle), b.nearness[at]);
      b.id[at] = kManySurfaces;
    } else if (b.id[at] == kNoTriangle) {
      for (int k = 0; k < 4; ++k) sum[k] = kSamples * clear[k];
    }
  };
  for_each_pixel(subpixels, job.width, job.height, [&](int, int first) {
    if (subpixels.centered && is_simple(b.id[first]) && b.id[first] == b.id[first + 1]) {
      constexpr float kBetween = 3.5f;  // the halves' common edge, in the left one's columns
      std::fill_n(samples.sum + 4 * first, 8, 0.0f);
      b.nearness[first] = b.nearness[first + 1] = (b.nearness[first] + b.nearness[first + 1]) * 0.5f;
      add_fragment(samples, b.id[first], whole_part(first, kBetween, 1.5f), b.nearness[first]);
      b.id[first] = b.id[first + 1] = kManySurfaces;
      return;
    }
    for_each_part(subpixels, first, list);
  });
}

void SubpixelTile::restore(TileBuffers& buffers) const {
  for (int i = 0; i < kTilePixels; ++i) {
    const std::uint32_t id = ids_[static_cast<std::size_t>(i)];
    if (is_simple(id)) buffers.id[i] = id;
  }
}

void SubpixelTile::join_sums(const Subpixels& subpixels, const TileJob& job, SampleBuffers& samples) const {
  const auto id = [&](int at) { return ids_[static_cast<std::size_t>(at)]; };
  samples.pixels = 0;
  for_each_pixel(subpixels, job.width, job.height, [&](int at, int first) {
    double mean[4] = {};
    bool covered = false;
    for_each_part(subpixels, first, [&](int part) {
      for (int k = 0; k < 4; ++k) mean[k] += double{samples.sum[4 * part + k]};
      covered = covered || id(part) != kNoTriangle;
    });
    const bool once = subpixels.centered && is_simple(id(first)) && id(first) == id(first + 1);
    const double share = once ? 1 : 1.0 / subpixels.count();
    for (int k = 0; k < 4; ++k) samples.sum[4 * at + k] = static_cast<float>(mean[k] * share);
    if (covered) samples.pixel[samples.pixels++] = at;
  });
}

// In place, like all joining: a pixel's parts never lie before it.
void join_counts(const Subpixels& subpixels, std::uint32_t* counts) {
  for_each_pixel(subpixels, kTileSize, kTileSize, [&](int at, int first) {
    std::uint32_t sum = 0;
    for_each_part(subpixels, first, [&](int part) { sum += counts[part]; });
    counts[at] = sum;
  });
}

void join_surfaces(const Subpixels& subpixels, TileBuffers& buffers, float* normals) {
  for_each_pixel(subpixels, kTileSize, kTileSize, [&](int at, int first) {
    int best = first;
    for_each_part(subpixels, first, [&](int part) {
      if (buffers.nearness[part] > buffers.nearness[best]) best = part;
    });
    buffers.id[at] = buffers.id[best];
    buffers.nearness[at] = buffers.nearness[best];
    if (normals != nullptr) std::copy_n(normals + 3 * best, 3, normals + 3 * at);
  });
}

}  // namespace blysk
