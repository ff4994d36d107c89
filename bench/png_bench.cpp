// What follows a finished 1920x1080 picture: PNG and the hash. "time" is for all pixels; "bytes" is the file.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>

#include "blysk/image.h"

namespace blysk {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

// A cheap hash of two coordinates.
std::uint32_t scatter(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u;
  h ^= h >> 15;
  h *= 0xc2b2ae3du;
  return h ^ h >> 13;
}

std::uint32_t opaque(float red, float green, float blue) {
  const auto code = [](float v) {
    return static_cast<std::uint32_t>(255 * (v < 0 ? 0 : v > 1 ? 1 : v) + 0.5f);
  };
  return code(red) | code(green) << 8 | code(blue) << 16 | 0xff000000;
}

// A lit ball on a transparent ground; `rough` tilts its surface in patches of 4x4 pixels.
std::uint32_t ball(int x, int y, float rough) {
  float u = static_cast<float>(x - kWidth / 2) / 480, v = static_cast<float>(y - kHeight / 2) / 480;
  if (u * u + v * v >= 1) return 0;
  const std::uint32_t patch = scatter(static_cast<std::uint32_t>(x / 4), static_cast<std::uint32_t>(y / 4));
  u += rough * static_cast<float>(patch & 255) / 255;
  v += rough * static_cast<float>(patch >> 8 & 255) / 255;
  const float w = std::sqrt(std::fmax(0.0f, 1 - u * u - v * v));
  const float diffuse = std::fmax(0.0f, 0.45f * u - 0.55f * v + 0.7f * w);
  float shine = std::fmax(0.0f, 0.25f * u - 0.3f * v + 0.92f * w);
  for (int i = 0; i < 5; ++i) shine *= shine;
  return opaque(0.1f + 0.7f * diffuse + 0.4f * shine, 0.1f + 0.5f * diffuse + 0.4f * shine,
                0.1f + 0.3f * diffuse + 0.4f * shine);
}

template <class Pixel>
Image picture(Pixel pixel) {
  Image image;
  image.resize(kWidth, kHeight);
  std::size_t i = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) image.pixels[i++] = pixel(x, y);
  }
  return image;
}

const Image& smooth() {
  static const Image image = picture([](int x, int y) { return ball(x, y, 0); });
  return image;
}
const Image& detailed() {
  static const Image image = picture([](int x, int y) { return ball(x, y, 0.2f); });
  return image;
}
const Image& flat() {
  static const Image image = picture([](int, int) { return 0xff804020u; });
  return image;
}
const Image& noise() {
  static const Image image = picture([](int x, int y) {
    return scatter(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) | 0xff000000;
  });
  return image;
}

void png(benchmark::State& state, const Image& image) {
  const PictureOptions options{.compression = static_cast<int>(state.range(0)),
                               .threads = static_cast<int>(state.range(1)),
                               .alpha = state.range(2) != 0};
  std::size_t size = 0;
  for (auto _ : state) {
    const Array<std::uint8_t> bytes = encode_png(image, options);
    size = bytes.size();
    benchmark::DoNotOptimize(bytes.data());
  }
  state.counters["bytes"] = static_cast<double>(size);
}

void shapes_of_png(benchmark::internal::Benchmark* b) {
  b->ArgNames({"level", "threads", "alpha"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int alpha : {1, 0}) {
    for (const int threads : {1, 2}) b->Args({1, threads, alpha});
  }
  b->Args({6, 2, 1});
}

BENCHMARK_CAPTURE(png, smooth, smooth())->Apply(shapes_of_png);
BENCHMARK_CAPTURE(png, detailed, detailed())->Apply(shapes_of_png);
BENCHMARK_CAPTURE(png, flat, flat())->Apply(shapes_of_png);
BENCHMARK_CAPTURE(png, noise, noise())->Apply(shapes_of_png);

void hash(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(sha256(noise()));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * kWidth * kHeight * 4);
}
BENCHMARK(hash)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace blysk
