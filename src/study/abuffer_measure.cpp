#include "study/abuffer_measure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "antialias/memory_bits.h"
#include "study/flat_picture.h"

namespace blysk::study {
namespace {

using antialias::Overflow;

constexpr int kBandRows = 8;

// Triangles of a picture by the bands of rows that they reach, in the order given.
std::vector<std::vector<std::uint32_t>> reaching(const StudyScene& scene) {
  std::vector<std::vector<std::uint32_t>> bands(
      static_cast<std::size_t>((scene.height + kBandRows - 1) / kBandRows));
  const auto last = static_cast<double>(bands.size() - 1);
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const auto& c = scene.triangles[i].corners;
    const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
    constexpr double kSnap = 1.0 / 256;  // corners move by up to half of it
    const double first = std::floor((top - kSnap) / kBandRows),
                 end = std::floor((bottom + kSnap) / kBandRows);
    if (end < 0 || first > last) continue;
    for (auto band = static_cast<std::size_t>(std::max(first, 0.0));
         band <= static_cast<std::size_t>(std::min(end, last)); ++band) {
      bands[band].push_back(i);
    }
  }
  return bands;
}

// Fragments of a region whose id is their triangle.
FragmentStream fragments_of(const StudyScene& scene, std::span<const std::uint32_t> triangles,
                            const Region& region, const antialias::SamplePattern& pattern) {
  FragmentStream stream;
  rasterise(scene.triangles, triangles, region, pattern, stream);
  for (antialias::Fragment& f : stream.fragments) f.id = triangles[f.id];
  return stream;
}

// Places of the triangles in an order of submission.
std::vector<std::uint32_t> ranks_of(const StudyScene& scene, const Submission& run) {
  const std::vector<std::uint32_t> order = submission_order(scene.triangles, run.order, run.seed);
  std::vector<std::uint32_t> ranks(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
  return ranks;
}

// The same fragments pixel by pixel, each pixel's as they are submitted, their place in the order as id.
FragmentStream submitted(const FragmentStream& stream, std::span<const std::uint32_t> ranks,
                         std::size_t pixels) {
  std::vector<std::size_t> start(pixels + 1);
  for (const std::uint32_t pixel : stream.pixels) ++start[pixel + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint64_t> keys(stream.fragments.size());  // rank, and place in the stream
  std::vector<std::size_t> next = start;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    keys[next[stream.pixels[i]]++] = std::uint64_t{ranks[stream.fragments[i].id]} << 32 | i;
  }
  FragmentStream sorted;
  sorted.fragments.reserve(keys.size());
  sorted.pixels.reserve(keys.size());
  for (std::size_t p = 0; p < pixels; ++p) {
    const auto first = keys.begin() + static_cast<std::ptrdiff_t>(start[p]),
               last = keys.begin() + static_cast<std::ptrdiff_t>(start[p + 1]);
    std::sort(first, last);
    for (auto key = first; key != last; ++key) {
      sorted.fragments.push_back(stream.fragments[*key & 0xffffffffu]);
      sorted.fragments.back().id = static_cast<std::uint32_t>(*key >> 32);
      sorted.pixels.push_back(static_cast<std::uint32_t>(p));
    }
  }
  return sorted;
}

// Lists without a limit: what variants are compared with, and which pixels a limit touches at all.
struct Unlimited {
  Picture picture;
  std::vector<std::uint32_t> generated, live, most_live;  // of each pixel
  antialias::ListStatistics statistics;
};

Unlimited unlimited(const FragmentStream& stream, std::size_t pixels) {
  const auto tile = make_tile({}, kPattern, pixels, pixels);
  tile->clear(pixels);
  Unlimited u;
  u.generated.resize(pixels);
  u.most_live.resize(pixels);
  for (std::size_t i = 0; i < stream.fragments.size(); ++i) {
    const std::uint32_t p = stream.pixels[i];
    tile->insert(p, stream.fragments[i]);
    ++u.generated[p];
    u.most_live[p] = std::max(u.most_live[p], static_cast<std::uint32_t>(tile->live(p)));
  }
  for (std::size_t p = 0; p < pixels; ++p) {
    u.live.push_back(static_cast<std::uint32_t>(tile->live(p)));
    u.picture.push_back(tile->resolve(p, kBackground));
  }
  u.statistics = tile->statistics();
  return u;
}

// The fragments of pixels that hold more than `most` at some time: elsewhere lists of so many are the
// unlimited ones, whatever they do when they are full. Pixels are numbered among themselves.
struct Crowd {
  FragmentStream stream;
  std::vector<std::size_t> pixels;
};

Crowd crowd_of(const FragmentStream& stream, const Unlimited& u, std::size_t most) {
  constexpr std::uint32_t kNone = ~0u;
  Crowd crowd;
  std::vector<std::uint32_t> number(u.most_live.size(), kNone);
  for (std::size_t p = 0; p < number.size(); ++p) {
    if (u.most_live[p] <= most) continue;
    number[p] = static_cast<std::uint32_t>(crowd.pixels.size());
    crowd.pixels.push_back(p);
  }
  if (crowd.pixels.empty()) return crowd;
  crowd.stream.fragments.reserve(stream.fragments.size());
  crowd.stream.pixels.reserve(stream.fragments.size());
  for (std::size_t i = 0; i < stream.fragments.size(); ++i) {
    const std::uint32_t n = number[stream.pixels[i]];
    if (n == kNone) continue;
    crowd.stream.fragments.push_back(stream.fragments[i]);
    crowd.stream.pixels.push_back(n);
  }
  return crowd;
}

// Pictures of variants of one band and order.
class BandPictures {
 public:
  BandPictures(const FragmentStream& stream, const FragmentStream& centres, const Unlimited& reference)
      : stream_(stream), centres_(centres), reference_(reference) {}

  [[nodiscard]] Picture of(const Variant& variant) {
    const std::size_t pixels = reference_.picture.size();
    if (variant.kind != Variant::Kind::lists) {
      const bool centre = variant.kind == Variant::Kind::zbuffer;
      const auto tile = make_tile(variant, kPattern, pixels, pixels);
      return picture_of(centre ? centres_ : stream_, *tile, pixels);
    }
    auto crowd = crowds_.find(variant.most);
    if (crowd == crowds_.end()) {
      crowd = crowds_.emplace(variant.most, crowd_of(stream_, reference_, variant.most)).first;
    }
    const std::vector<std::size_t>& places = crowd->second.pixels;
    Picture picture = reference_.picture;
    const auto tile = make_tile(variant, kPattern, places.size(), places.size());
    const Picture crowded = picture_of(crowd->second.stream, *tile, places.size());
    for (std::size_t i = 0; i < places.size(); ++i) picture[places[i]] = crowded[i];
    return picture;
  }

 private:
  const FragmentStream &stream_, &centres_;
  const Unlimited& reference_;
  std::map<std::size_t, Crowd> crowds_;  // by the limit
};

// Of one run in one band.
struct BandResult {
  std::vector<PictureError> errors;  // of each variant
  Unlimited unlimited;
};

std::vector<BandResult> measure_band(const StudyScene& scene, std::span<const std::uint32_t> triangles,
                                     const Region& region, std::span<const Submission> runs,
                                     std::span<const std::vector<std::uint32_t>> ranks) {
  const std::size_t pixels = region.pixels();
  const FragmentStream fragments = fragments_of(scene, triangles, region, kPattern),
                       centres = fragments_of(scene, triangles, region, antialias::kCentre);
  std::vector<BandResult> results;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const bool at_centre =
        std::ranges::find(runs[r].variants, Variant::Kind::zbuffer, &Variant::kind) != runs[r].variants.end();
    const FragmentStream stream = submitted(fragments, ranks[r], pixels),
                         at_centres = at_centre ? submitted(centres, ranks[r], pixels) : FragmentStream{};
    BandResult& result = results.emplace_back(BandResult{{}, unlimited(stream, pixels)});
    BandPictures pictures(stream, at_centres, result.unlimited);
    for (const Variant& variant : runs[r].variants) {
      result.errors.push_back(error_of(pictures.of(variant), result.unlimited.picture));
    }
  }
  return results;
}

Complexity complexity_of(const std::vector<std::vector<BandResult>>& bands, std::size_t run) {
  std::vector<std::uint32_t> generated, live;
  antialias::ListStatistics statistics;
  for (const std::vector<BandResult>& band : bands) {
    const Unlimited& u = band[run].unlimited;
    generated.insert(generated.end(), u.generated.begin(), u.generated.end());
    live.insert(live.end(), u.live.begin(), u.live.end());
    statistics += u.statistics;
  }
  const auto pixels = static_cast<double>(live.size());
  const auto of_generated = [&](std::uint64_t count) {
    return static_cast<double>(count) / std::max(1.0, static_cast<double>(statistics.generated));
  };
  const auto crowded = std::count_if(live.begin(), live.end(), [](std::uint32_t n) { return n > 3; });
  return {.generated = spread_of(std::move(generated)),
          .live = spread_of(std::move(live)),
          .most_live = statistics.most_live,
          .over_3 = static_cast<double>(crowded) / pixels,
          .hidden_on_arrival = of_generated(statistics.hidden_on_arrival),
          .removed_later = of_generated(statistics.removed_later)};
}

Measured measured_of(const std::vector<std::vector<BandResult>>& bands, std::size_t run,
                     std::size_t variants) {
  Measured measured = {complexity_of(bands, run), {}, {}};
  std::vector<PictureError> errors(variants);
  for (const std::vector<BandResult>& band : bands) {
    const BandResult& result = band[run];
    for (std::size_t v = 0; v < variants; ++v) errors[v] += result.errors[v];
    measured.live.insert(measured.live.end(), result.unlimited.live.begin(), result.unlimited.live.end());
  }
  for (const PictureError& error : errors) measured.quality.push_back(error.quality());
  return measured;
}

constexpr std::size_t kSplits[][2] = {{1, 1}, {1, 2}, {1, 3}, {1, 5}, {1, 7}, {2, 1}, {2, 2}, {2, 6}, {3, 5}};
constexpr std::size_t kMostMain = 3, kTotals[] = {2, 3, 4, 6, 8};

// Pixels that never hold two fragments need neither a pool nor a limit, and are not drawn again.
struct Contended {
  FragmentStream stream;  // of the other pixels, in submission order
  Unlimited unlimited;

  [[nodiscard]] Picture picture(antialias::FragmentTile& tile) const {
    Picture picture = unlimited.picture;
    for (std::size_t p = 0; p < picture.size(); ++p) {
      if (holds_two(p)) picture[p] = tile.resolve(p, kBackground);
    }
    return picture;
  }
  [[nodiscard]] Picture drawn(antialias::FragmentTile& tile) const {
    tile.clear(unlimited.picture.size());
    stream.insert_into(tile);
    return picture(tile);
  }
  [[nodiscard]] bool holds_two(std::size_t pixel) const { return unlimited.most_live[pixel] > 1; }
};

Contended contended(const FragmentStream& all, std::size_t pixels) {
  Contended c = {{}, unlimited(all, pixels)};
  for (std::size_t i = 0; i < all.fragments.size(); ++i) {
    if (!c.holds_two(all.pixels[i])) continue;
    c.stream.fragments.push_back(all.fragments[i]);
    c.stream.pixels.push_back(all.pixels[i]);
  }
  return c;
}

// Lists of at most N fragments: their picture, and for each number of main places the peak of what is beyond.
struct Fixed {
  Picture picture;
  std::uint64_t bytes = 0;
  std::uint64_t peak[kMostMain + 1] = {};
};

Fixed fixed_lists(const Contended& drawing, std::size_t most) {
  const std::size_t pixels = drawing.unlimited.picture.size();
  const FragmentStream& stream = drawing.stream;
  const auto tile = make_tile({.overflow = Overflow::m1, .most = most}, kPattern, pixels, pixels);
  tile->clear(pixels);
  Fixed fixed;
  std::uint64_t used[kMostMain + 1] = {};
  const auto beyond = [](std::size_t n, std::size_t main) { return n > main ? n - main : 0; };
  for (std::size_t i = 0; i < stream.fragments.size(); ++i) {
    const std::size_t before = tile->live(stream.pixels[i]);
    tile->insert(stream.pixels[i], stream.fragments[i]);
    const std::size_t after = tile->live(stream.pixels[i]);
    for (std::size_t main = 1; main <= kMostMain; ++main) {
      used[main] = used[main] + beyond(after, main) - beyond(before, main);
      fixed.peak[main] = std::max(fixed.peak[main], used[main]);
    }
  }
  fixed.bytes = tile->bytes();
  fixed.picture = drawing.picture(*tile);
  return fixed;
}

MemoryRow memory_row(const Contended& drawing, std::size_t main, std::size_t extra, const Fixed& fixed) {
  const Picture& reference = drawing.unlimited.picture;
  const std::size_t pixels = reference.size();
  MemoryRow row = {.main = main, .extra = extra, .peak = fixed.peak[main]};
  const antialias::BufferShape shape = {pixels, main, extra, row.peak, kPattern.count};
  row.pooled = antialias::pooled_bits(shape);
  row.fixed = antialias::fixed_bits(shape);
  row.ratio = antialias::memory_ratio(shape);
  row.nmse = error_of(fixed.picture, reference).quality().nmse;
  const auto pool_of = [&](std::uint64_t slots) {
    const Variant pool = {.kind = Variant::Kind::pool,
                          .overflow = Overflow::m1,
                          .main = main,
                          .extra = extra,
                          .pool = static_cast<std::size_t>(slots)};
    return make_tile(pool, kPattern, pixels, pixels);
  };
  const auto shown = [&](std::uint64_t slots) { return drawing.drawn(*pool_of(slots)); };
  const auto pool = pool_of(row.peak);
  row.same_picture = drawing.drawn(*pool) == fixed.picture;
  row.pooled_bytes = pool->bytes();
  row.fixed_bytes = fixed.bytes;
  row.half = error_of(shown(row.peak / 2), reference).quality().nmse;
  row.quarter = error_of(shown(row.peak / 4), reference).quality().nmse;
  return row;
}

}  // namespace

Spread spread_of(std::vector<std::uint32_t> counts) {
  if (counts.empty()) return {};
  double sum = 0;
  for (const std::uint32_t n : counts) sum += n;
  std::sort(counts.begin(), counts.end());
  return {sum / static_cast<double>(counts.size()), counts.back(), counts[(counts.size() - 1) * 99 / 100]};
}

std::vector<Measured> measure(const StudyScene& scene, std::span<const Submission> runs,
                              ThreadPool& threads) {
  const std::vector<std::vector<std::uint32_t>> triangles = reaching(scene);
  std::vector<std::vector<std::uint32_t>> ranks(runs.size());
  threads.for_each(runs.size(), [&](int, std::size_t r) { ranks[r] = ranks_of(scene, runs[r]); });
  std::vector<std::vector<BandResult>> bands(triangles.size());
  threads.for_each(bands.size(), [&](int, std::size_t i) {
    const int top = static_cast<int>(i) * kBandRows;
    const Region region = {0, top, scene.width, std::min(kBandRows, scene.height - top)};
    bands[i] = measure_band(scene, triangles[i], region, runs, ranks);
  });
  std::vector<Measured> measured;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    measured.push_back(measured_of(bands, r, runs[r].variants.size()));
  }
  return measured;
}

std::vector<MemoryRow> measure_memory(const StudyScene& scene, Order order, std::uint64_t seed,
                                      ThreadPool& threads) {
  FragmentStream stream;
  rasterise(scene.triangles, submission_order(scene.triangles, order, seed),
            {0, 0, scene.width, scene.height}, kPattern, stream);
  const Contended drawing = contended(stream, scene.pixels());
  std::vector<Fixed> fixed(kTotals[std::size(kTotals) - 1] + 1);
  std::vector<MemoryRow> rows(std::size(kSplits));
  threads.for_each(std::size(kTotals),
                   [&](int, std::size_t i) { fixed[kTotals[i]] = fixed_lists(drawing, kTotals[i]); });
  threads.for_each(rows.size(), [&](int, std::size_t i) {
    const auto [main, extra] = kSplits[i];
    rows[i] = memory_row(drawing, main, extra, fixed[main + extra]);
  });
  return rows;
}

}  // namespace blysk::study
