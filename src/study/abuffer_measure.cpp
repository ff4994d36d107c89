#include "study/abuffer_measure.h"

#include <algorithm>

#include "antialias/memory_bits.h"
#include "study/flat_picture.h"

namespace blysk::study {
namespace {

using antialias::Overflow;

struct Band {
  std::vector<PictureError> errors;  // of each variant
  std::vector<std::uint32_t> generated, live;
  antialias::ListStatistics statistics;
};

Band measure_band(const StudyScene& scene, std::span<const std::uint32_t> order, const Region& region,
                  std::span<const Variant> variants) {
  Band band;
  FragmentStream stream, centres;
  rasterise(scene.triangles, order, region, kPattern, stream);
  stream.sort_by_pixel(region.pixels());
  rasterise(scene.triangles, order, region, antialias::kCentre, centres);

  const auto unlimited = make_tile({}, kPattern, region.pixels(), scene.pixels());
  const Picture reference = picture_of(stream, *unlimited, region.pixels());
  band.statistics = unlimited->statistics();
  band.generated.resize(region.pixels());
  for (const std::uint32_t pixel : stream.pixels) ++band.generated[pixel];
  for (std::size_t p = 0; p < region.pixels(); ++p) {
    band.live.push_back(static_cast<std::uint32_t>(unlimited->live(p)));
  }
  for (const Variant& variant : variants) {
    const auto tile = make_tile(variant, kPattern, region.pixels(), scene.pixels());
    const FragmentStream& input = variant.kind == Variant::Kind::zbuffer ? centres : stream;
    band.errors.push_back(error_of(picture_of(input, *tile, region.pixels()), reference));
  }
  return band;
}

Complexity complexity_of(std::span<const Band> bands) {
  std::vector<std::uint32_t> generated, live;
  antialias::ListStatistics statistics;
  for (const Band& band : bands) {
    generated.insert(generated.end(), band.generated.begin(), band.generated.end());
    live.insert(live.end(), band.live.begin(), band.live.end());
    statistics += band.statistics;
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

constexpr std::size_t kSplits[][2] = {{1, 1}, {1, 2}, {1, 3}, {1, 5}, {1, 7}, {2, 1}, {2, 2}, {2, 6}, {3, 5}};
constexpr std::size_t kMostMain = 3, kTotals[] = {2, 3, 4, 6, 8};

// Lists of at most N fragments: their picture, and for each number of main places the peak of what is beyond.
struct Fixed {
  Picture picture;
  std::uint64_t bytes = 0;
  std::uint64_t peak[kMostMain + 1] = {};
};

Fixed fixed_lists(const FragmentStream& stream, std::size_t pixels, std::size_t most) {
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
  for (std::size_t p = 0; p < pixels; ++p) fixed.picture.push_back(tile->resolve(p, kBackground));
  return fixed;
}

MemoryRow memory_row(const FragmentStream& stream, std::size_t pixels, std::size_t main, std::size_t extra,
                     const Fixed& fixed, const Picture& reference) {
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
  const auto shown = [&](std::uint64_t slots) { return picture_of(stream, *pool_of(slots), pixels); };
  const auto pool = pool_of(row.peak);
  row.same_picture = picture_of(stream, *pool, pixels) == fixed.picture;
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

Measured measure(const StudyScene& scene, Order order, std::uint64_t seed, std::span<const Variant> variants,
                 ThreadPool& threads) {
  constexpr int kRows = 8;
  const std::vector<std::uint32_t> indices = submission_order(scene.triangles, order, seed);
  std::vector<Band> bands(static_cast<std::size_t>((scene.height + kRows - 1) / kRows));
  threads.for_each(bands.size(), [&](int, std::size_t i) {
    const int top = static_cast<int>(i) * kRows;
    const Region region = {0, top, scene.width, std::min(kRows, scene.height - top)};
    bands[i] = measure_band(scene, indices, region, variants);
  });
  std::vector<PictureError> errors(variants.size());
  for (const Band& band : bands) {
    for (std::size_t v = 0; v < variants.size(); ++v) errors[v] += band.errors[v];
  }
  Measured measured = {complexity_of(bands), {}, {}};
  for (const Band& band : bands) {
    measured.live.insert(measured.live.end(), band.live.begin(), band.live.end());
  }
  for (const PictureError& error : errors) measured.quality.push_back(error.quality());
  return measured;
}

std::vector<MemoryRow> measure_memory(const StudyScene& scene, Order order, std::uint64_t seed,
                                      ThreadPool& threads) {
  FragmentStream stream;
  rasterise(scene.triangles, submission_order(scene.triangles, order, seed),
            {0, 0, scene.width, scene.height}, kPattern, stream);
  const Picture reference =
      picture_of(stream, *make_tile({}, kPattern, scene.pixels(), scene.pixels()), scene.pixels());
  std::vector<Fixed> fixed(kTotals[std::size(kTotals) - 1] + 1);
  std::vector<MemoryRow> rows(std::size(kSplits));
  threads.for_each(std::size(kTotals), [&](int, std::size_t i) {
    fixed[kTotals[i]] = fixed_lists(stream, scene.pixels(), kTotals[i]);
  });
  threads.for_each(rows.size(), [&](int, std::size_t i) {
    const auto [main, extra] = kSplits[i];
    rows[i] = memory_row(stream, scene.pixels(), main, extra, fixed[main + extra], reference);
  });
  return rows;
}

}  // namespace blysk::study
