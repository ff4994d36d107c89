// shading/encode.h - linear colours to the bytes of a picture.
#pragma once

#include "blysk/image.h"
#include "image/transfer.h"
#include "lighting/lighting.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

/// 0..1 to 0..255 in the low byte by the transfer function (image/transfer.h is the model); the highest byte
/// is not clean. Colours are not negative: neither lights nor materials are.
template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> encode(Transfer transfer, Floats<kRegisters> v) {
  using F = Floats<kRegisters>;
  using I = Ints<kRegisters>;
  // Adding 2^23 leaves the nearest integer in the low bits (and 0x4b above them, which pack() lets fall out).
  if (transfer == Transfer::none) return bits_of(min(v, F(1.0f)) * F(255.0f) + F(8388608.0f));
  const I bits = bits_of(min(max(v, F(kSrgbLowest)), F(kSrgbHighest)));
  const I segment =
      gather(kSrgbSegments, shift_right<20>(bits - I(static_cast<std::int32_t>(kSrgbLowestBits))));
  const I base = shift_left<9>(shift_right<16>(segment) & I(0xffff));
  return shift_right<16>(base + (segment & I(0xffff)) * (shift_right<12>(bits) & I(0xff)));
}

/// Red in the lowest byte; the highest is not clean.
template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> pack_rgb(Transfer transfer, const Rgb<Floats<kRegisters>>& c) {
  const Ints<kRegisters> rg = encode(transfer, c.x) | shift_left<8>(encode(transfer, c.y));
  return rg | shift_left<16>(encode(transfer, c.z));
}

}  // namespace blysk::BLYSK_ISA
