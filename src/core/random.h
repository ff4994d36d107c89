// core/random.h - a seeded stream of random numbers with the same values everywhere.
//
// Based on: Steele, Lea, Flood. Fast splittable pseudorandom number generators. 2014 (the SplitMix64 mixer).
#pragma once

#include <cstdint>

namespace blysk {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1): a multiple of 2^-24.
  float unit() { return static_cast<float>(next() >> 40) * 0x1p-24f; }
  /// Uniform in [-1, 1): a multiple of 2^-23.
  float signed_unit() { return unit() * 2 - 1; }

 private:
  std::uint64_t state_;
};

}  // namespace blysk
