#include "blysk/fragments.h"

namespace blysk {

std::uint64_t FragmentHistogram::pixels() const {
  std::uint64_t sum = 0;
  for (const Bin& bin : bins) sum += bin.pixels;
  return sum;
}

std::uint64_t FragmentHistogram::total() const {
  std::uint64_t sum = 0;
  for (const Bin& bin : bins) sum += bin.pixels * bin.fragments;
  return sum;
}

double FragmentHistogram::mean() const {
  return bins.empty() ? 0 : static_cast<double>(total()) / static_cast<double>(pixels());
}

// Of the pixels in ascending order the last one of the first 99 %.
std::uint32_t FragmentHistogram::p99() const {
  if (bins.empty()) return 0;
  std::uint64_t left = (pixels() - 1) * 99 / 100;
  auto bin = bins.begin();
  for (; left >= bin->pixels; ++bin) left -= bin->pixels;
  return bin->fragments;
}

std::uint32_t FragmentHistogram::most() const { return bins.empty() ? 0 : bins.back().fragments; }

}  // namespace blysk
