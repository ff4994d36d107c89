// simd/lanes.h - sixteen lanes of float or integer, whatever the processor has.
//
// A thin layer over Highway. Kernels (x_kernel.cpp) are compiled once per instruction set; a value is always
// sixteen lanes wide, in one, two or four registers (sixteen in the scalar build), so that blocks, masks and
// sums have the same shape, and pictures the same bytes, on all of them. Only exact operations are offered:
// no fused multiply-add, no approximate reciprocal.
//
// The functions are also given for plain float, so that one template serves a span (one triangle's values
// as floats) and gathered pixels (sixteen triangles' values as lanes), bit for bit alike.
#pragma once

#ifndef BLYSK_ISA
#error "lanes.h is for x_kernel.cpp files, which are compiled once per instruction set"
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

namespace blysk::BLYSK_ISA {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kLanes = 16;
using FloatTag = hn::CappedTag<float, kLanes>;
using IntTag = hn::Rebind<std::int32_t, FloatTag>;
inline constexpr int kPartLanes = static_cast<int>(hn::MaxLanes(FloatTag()));
inline constexpr int kParts = kLanes / kPartLanes;

#define BLYSK_INLINE inline __attribute__((always_inline))
#define BLYSK_EACH_PART for (int i = 0; i < kParts; ++i)

struct Mask {
  hn::Mask<FloatTag> part[kParts];
};

struct F32 {
  hn::Vec<FloatTag> part[kParts];
  BLYSK_INLINE F32() = default;
  BLYSK_INLINE F32(float value) {  // NOLINT(google-explicit-constructor)
    BLYSK_EACH_PART part[i] = hn::Set(FloatTag(), value);
  }
};

struct I32 {
  hn::Vec<IntTag> part[kParts];
  BLYSK_INLINE I32() = default;
  BLYSK_INLINE I32(std::int32_t value) {  // NOLINT(google-explicit-constructor)
    BLYSK_EACH_PART part[i] = hn::Set(IntTag(), value);
  }
};

#define BLYSK_BINARY(Type, name, op)                          \
  BLYSK_INLINE Type name(Type a, Type b) {                    \
    Type r;                                                   \
    BLYSK_EACH_PART r.part[i] = hn::op(a.part[i], b.part[i]); \
    return r;                                                 \
  }
BLYSK_BINARY(F32, operator+, Add)
BLYSK_BINARY(F32, operator-, Sub)
BLYSK_BINARY(F32, operator*, Mul)
BLYSK_BINARY(F32, operator/, Div)
BLYSK_BINARY(F32, min, Min)
BLYSK_BINARY(F32, max, Max)
BLYSK_BINARY(I32, operator+, Add)
BLYSK_BINARY(I32, operator-, Sub)
BLYSK_BINARY(I32, operator*, Mul)
BLYSK_BINARY(I32, operator&, And)
BLYSK_BINARY(I32, operator|, Or)
BLYSK_BINARY(I32, operator^, Xor)
BLYSK_BINARY(I32, min, Min)
BLYSK_BINARY(I32, max, Max)
BLYSK_BINARY(Mask, operator&, And)
BLYSK_BINARY(Mask, operator|, Or)
BLYSK_BINARY(Mask, and_not, AndNot)  // !a & b
#undef BLYSK_BINARY

#define BLYSK_COMPARE(name, result)                               \
  BLYSK_INLINE Mask name(F32 a, F32 b) {                          \
    Mask r;                                                       \
    BLYSK_EACH_PART r.part[i] = hn::result(a.part[i], b.part[i]); \
    return r;                                                     \
  }
#define BLYSK_COMPARE_INT(name, result)                             \
  BLYSK_INLINE Mask name(I32 a, I32 b) {                            \
    Mask r;                                                         \
    BLYSK_EACH_PART r.part[i] = hn::RebindMask(FloatTag(), result); \
    return r;                                                       \
  }
BLYSK_COMPARE(operator<, Lt)
BLYSK_COMPARE(operator>, Gt)
BLYSK_COMPARE(operator<=, Le)
BLYSK_COMPARE(operator>=, Ge)
BLYSK_COMPARE(operator==, Eq)
BLYSK_COMPARE(operator!=, Ne)
BLYSK_COMPARE_INT(operator<, hn::Lt(a.part[i], b.part[i]))
BLYSK_COMPARE_INT(operator>, hn::Gt(a.part[i], b.part[i]))
BLYSK_COMPARE_INT(operator<=, hn::Not(hn::Gt(a.part[i], b.part[i])))
BLYSK_COMPARE_INT(operator>=, hn::Not(hn::Lt(a.part[i], b.part[i])))
BLYSK_COMPARE_INT(operator==, hn::Eq(a.part[i], b.part[i]))
BLYSK_COMPARE_INT(operator!=, hn::Ne(a.part[i], b.part[i]))
#undef BLYSK_COMPARE_INT
#undef BLYSK_COMPARE

BLYSK_INLINE F32 select(Mask m, F32 yes, F32 no) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::IfThenElse(m.part[i], yes.part[i], no.part[i]);
  return r;
}

BLYSK_INLINE I32 select(Mask m, I32 yes, I32 no) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::IfThenElse(hn::RebindMask(IntTag(), m.part[i]), yes.part[i], no.part[i]);
  return r;
}

BLYSK_INLINE F32 sqrt(F32 a) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::Sqrt(a.part[i]);
  return r;
}

template <int kBits>
BLYSK_INLINE I32 shift_left(I32 a) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::ShiftLeft<kBits>(a.part[i]);
  return r;
}

/// Arithmetic: the sign is kept.
template <int kBits>
BLYSK_INLINE I32 shift_right(I32 a) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::ShiftRight<kBits>(a.part[i]);
  return r;
}

/// Exact up to 2^24.
BLYSK_INLINE F32 to_float(I32 a) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::ConvertTo(FloatTag(), a.part[i]);
  return r;
}

/// Towards zero; |a| < 2^31.
BLYSK_INLINE I32 truncate(F32 a) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::ConvertTo(IntTag(), a.part[i]);
  return r;
}

/// To nearest, ties to even; |a| < 2^31.
BLYSK_INLINE I32 nearest(F32 a) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::NearestInt(a.part[i]);
  return r;
}

BLYSK_INLINE I32 bits_of(F32 a) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::BitCast(IntTag(), a.part[i]);
  return r;
}

BLYSK_INLINE F32 float_of_bits(I32 a) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::BitCast(FloatTag(), a.part[i]);
  return r;
}

// Memory. Pointers need no alignment.

BLYSK_INLINE F32 load(const float* p) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::LoadU(FloatTag(), p + i * kPartLanes);
  return r;
}

BLYSK_INLINE I32 load(const std::int32_t* p) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::LoadU(IntTag(), p + i * kPartLanes);
  return r;
}

BLYSK_INLINE I32 load(const std::uint32_t* p) { return load(reinterpret_cast<const std::int32_t*>(p)); }

BLYSK_INLINE void store(F32 a, float* p) {
  BLYSK_EACH_PART hn::StoreU(a.part[i], FloatTag(), p + i * kPartLanes);
}

BLYSK_INLINE void store(I32 a, std::int32_t* p) {
  BLYSK_EACH_PART hn::StoreU(a.part[i], IntTag(), p + i * kPartLanes);
}

BLYSK_INLINE void store(I32 a, std::uint32_t* p) { store(a, reinterpret_cast<std::int32_t*>(p)); }

/// Non-temporal; p is aligned to 64. hwy::FlushStream() orders it before what follows.
BLYSK_INLINE void store_past_caches(I32 a, std::uint32_t* p) {
  BLYSK_EACH_PART hn::Stream(a.part[i], IntTag(), reinterpret_cast<std::int32_t*>(p) + i * kPartLanes);
}

/// Writes the lanes of m. The others may be rewritten with what they held: all sixteen must be memory of this
/// thread.
BLYSK_INLINE void store_masked(Mask m, F32 a, float* p) {
  BLYSK_EACH_PART hn::BlendedStore(a.part[i], m.part[i], FloatTag(), p + i * kPartLanes);
}

BLYSK_INLINE void store_masked(Mask m, I32 a, std::uint32_t* p) {
  BLYSK_EACH_PART hn::BlendedStore(a.part[i], hn::RebindMask(IntTag(), m.part[i]), IntTag(),
                                   reinterpret_cast<std::int32_t*>(p) + i * kPartLanes);
}

/// Writes the lanes of m one after the other and returns how many; sixteen may be overwritten.
BLYSK_INLINE int store_compressed(Mask m, I32 a, std::int32_t* p) {
  // Compressed in a register and stored whole: a masked store could not be read back at once.
  int n = 0;
  BLYSK_EACH_PART {
    const auto mask = hn::RebindMask(IntTag(), m.part[i]);
    hn::StoreU(hn::Compress(a.part[i], mask), IntTag(), p + n);
    n += static_cast<int>(hn::CountTrue(IntTag(), mask));
  }
  return n;
}

BLYSK_INLINE I32 gather(const std::int32_t* base, I32 index) {
  I32 r;
  BLYSK_EACH_PART r.part[i] = hn::GatherIndex(IntTag(), base, index.part[i]);
  return r;
}

BLYSK_INLINE I32 gather(const std::uint32_t* base, I32 index) {
  return gather(reinterpret_cast<const std::int32_t*>(base), index);
}

BLYSK_INLINE F32 gather(const float* base, I32 index) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::GatherIndex(FloatTag(), base, index.part[i]);
  return r;
}

/// Sixteen rows of four floats, each at base + stride * index, as four columns: what gather() would give for
/// four neighbouring elements, at a quarter of the loads. All four floats of every row must be readable.
template <int kStride>
BLYSK_INLINE void gather_rows(const float* base, I32 index, F32 columns[4]) {
  std::int32_t at[kLanes];
  BLYSK_EACH_PART hn::StoreU(index.part[i], IntTag(), at + i * kPartLanes);
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < kLanes; ++i) {
    for (int k = 0; k < 4; ++k)
      columns[k].part[i] = hn::LoadU(FloatTag(), base + std::ptrdiff_t{kStride} * at[i] + k);
  }
#else
  const hn::Full128<float> row_tag;
  BLYSK_EACH_PART {
    // Register k holds the rows k, k + 4, ... of this part, one a 128-bit block; then each block is
    // transposed.
    hn::Vec<FloatTag> r[4];
    for (int k = 0; k < 4; ++k) {
      const auto row = [&](int block) {
        return hn::LoadU(row_tag, base + std::ptrdiff_t{kStride} * at[i * kPartLanes + 4 * block + k]);
      };
#if HWY_TARGET == HWY_AVX3
      const hn::Full256<float> half;
      r[k] = hn::Combine(FloatTag(), hn::Combine(half, row(3), row(2)), hn::Combine(half, row(1), row(0)));
#elif HWY_TARGET == HWY_AVX2
      r[k] = hn::Combine(FloatTag(), row(1), row(0));
#else
      r[k] = row(0);
#endif
    }
    const FloatTag d;
    const hn::RepartitionToWide<FloatTag> wide;
    const auto low01 = hn::BitCast(wide, hn::InterleaveLower(d, r[0], r[1]));
    const auto low23 = hn::BitCast(wide, hn::InterleaveLower(d, r[2], r[3]));
    const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(d, r[0], r[1]));
    const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(d, r[2], r[3]));
    columns[0].part[i] = hn::BitCast(d, hn::InterleaveLower(wide, low01, low23));
    columns[1].part[i] = hn::BitCast(d, hn::InterleaveUpper(wide, low01, low23));
    columns[2].part[i] = hn::BitCast(d, hn::InterleaveLower(wide, high01, high23));
    columns[3].part[i] = hn::BitCast(d, hn::InterleaveUpper(wide, high01, high23));
  }
#endif
}

/// De-interleaves 48 values x y z x y z ...
BLYSK_INLINE void load_interleaved(const float* p, F32& x, F32& y, F32& z) {
  BLYSK_EACH_PART hn::LoadInterleaved3(FloatTag(), p + 3 * i * kPartLanes, x.part[i], y.part[i], z.part[i]);
}

BLYSK_INLINE void load_interleaved(const std::uint32_t* p, I32& x, I32& y, I32& z) {
  const auto* q = reinterpret_cast<const std::int32_t*>(p);
  BLYSK_EACH_PART hn::LoadInterleaved3(IntTag(), q + 3 * i * kPartLanes, x.part[i], y.part[i], z.part[i]);
}

/// Interleaves into 64 values a b c d a b c d ...
BLYSK_INLINE void store_interleaved(I32 a, I32 b, I32 c, I32 d, std::int32_t* p) {
  BLYSK_EACH_PART hn::StoreInterleaved4(a.part[i], b.part[i], c.part[i], d.part[i], IntTag(),
                                        p + 4 * i * kPartLanes);
}

/// first, first + 1, ...
BLYSK_INLINE I32 iota(std::int32_t first) {
  alignas(64) static constexpr std::int32_t kNumbers[kLanes] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                                8, 9, 10, 11, 12, 13, 14, 15};
  return load(kNumbers) + I32(first);
}

// Masks as bits, lane 0 lowest.

BLYSK_INLINE unsigned to_bits(Mask m) {
#if HWY_TARGET == HWY_AVX3
  return static_cast<unsigned>(m.part[0].raw);
#else
  unsigned r = 0;
  BLYSK_EACH_PART {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), m.part[i], bytes);
    r |= static_cast<unsigned>(bytes[0]) << (i * kPartLanes);
  }
  return r;
#endif
}

/// The lanes whose bits are set.
BLYSK_INLINE Mask lanes_of(unsigned bits) {
  Mask r;
  BLYSK_EACH_PART {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits >> (i * kPartLanes)),
                                   static_cast<std::uint8_t>(bits >> (i * kPartLanes + 8))};
    r.part[i] = hn::LoadMaskBits(FloatTag(), bytes);
  }
  return r;
}

/// The lanes 0 .. end - 1.
BLYSK_INLINE Mask lanes_below(int end) { return iota(0) < I32(end); }

BLYSK_INLINE bool any(Mask m) { return to_bits(m) != 0; }

// Plain floats, alike in every bit.

BLYSK_INLINE float select(bool m, float yes, float no) { return m ? yes : no; }
BLYSK_INLINE float min(float a, float b) { return a < b ? a : b; }
BLYSK_INLINE float max(float a, float b) { return a > b ? a : b; }
BLYSK_INLINE std::int32_t min(std::int32_t a, std::int32_t b) { return a < b ? a : b; }
BLYSK_INLINE std::int32_t max(std::int32_t a, std::int32_t b) { return a > b ? a : b; }
BLYSK_INLINE std::int64_t clamp(std::int64_t v, std::int64_t low, std::int64_t high) {
  return v < low ? low : (v > high ? high : v);
}
BLYSK_INLINE float sqrt(float a) { return __builtin_sqrtf(a); }
BLYSK_INLINE std::int32_t bits_of(float a) { return __builtin_bit_cast(std::int32_t, a); }
BLYSK_INLINE float float_of_bits(std::int32_t a) { return __builtin_bit_cast(float, a); }
template <int kBits>
BLYSK_INLINE std::int32_t shift_right(std::int32_t a) {
  return a >> kBits;
}
template <int kBits>
BLYSK_INLINE std::int32_t shift_left(std::int32_t a) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) << kBits);
}
BLYSK_INLINE float to_float(std::int32_t a) { return static_cast<float>(a); }
BLYSK_INLINE std::int32_t truncate(float a) { return static_cast<std::int32_t>(a); }

#undef BLYSK_EACH_PART

}  // namespace blysk::BLYSK_ISA
