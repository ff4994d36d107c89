// Sums of samples to colours: the mean of a pixel, divided by its alpha, encoded.
#include "antialias/sample_tile.h"
#include "shading/encode.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {

void resolve_samples(const ResolveJob& job) {
  SampleBuffers& s = *job.samples;
  for (int i = s.pixels; i < s.pixels + kLanes; ++i) s.pixel[i] = 0;  // lanes past the last must be sound
  for (int i = 0; i < s.pixels; i += kLanes) {
    F32 sum[4];
    gather_rows<4>(s.sum, load(s.pixel + i), sum);
    // An opaque pixel divides by 16, which is exact. Clear ones have colour 0.
    const F32 alpha = max(sum[3], F32(1e-20f));
    const I32 rgb = pack_rgb(job.transfer, Rgb<F32>{sum[0] / alpha, sum[1] / alpha, sum[2] / alpha});
    const I32 opacity = nearest(sum[3] * F32(255.0f / kSamples));
    std::uint32_t color[kLanes];
    store((rgb & I32(0xffffff)) | shift_left<24>(opacity), color);
    const int count = min(s.pixels - i, kLanes);
    for (int k = 0; k < count; ++k) job.buffers->color[s.pixel[i + k]] = color[k];
  }
}

}  // namespace blysk::BLYSK_ISA
