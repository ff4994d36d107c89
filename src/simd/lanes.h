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
#define BLYSK_EACH_PART for (int i = 0; i < kRegisters; ++i)
#define BLYSK_BINARY(Type, name, op)                          \
  friend BLYSK_INLINE Type name(Type a, Type b) {             \
    Type r;                                                   \
    BLYSK_EACH_PART r.part[i] = hn::op(a.part[i], b.part[i]); \
    return r;                                                 \
  }
#define BLYSK_COMPARE(Type, name, result)                           \
  friend BLYSK_INLINE Masks<kRegisters> name(Type a, Type b) {      \
    Masks<kRegisters> r;                                            \
    BLYSK_EACH_PART r.part[i] = hn::RebindMask(FloatTag(), result); \
    return r;                                                       \
  }

template <int kRegisters>
struct Masks {
  hn::Mask<FloatTag> part[kRegisters];
  BLYSK_BINARY(Masks, operator&, And)
  BLYSK_BINARY(Masks, operator|, Or)
  BLYSK_BINARY(Masks, and_not, AndNot)  // !a & b
};

template <int kRegisters>
struct Floats {
  hn::Vec<FloatTag> part[kRegisters];
  BLYSK_INLINE Floats() = default;
  BLYSK_INLINE Floats(float value) {  // NOLINT(google-explicit-constructor)
    BLYSK_EACH_PART part[i] = hn::Set(FloatTag(), value);
  }
  BLYSK_BINARY(Floats, operator+, Add)
  BLYSK_BINARY(Floats, operator-, Sub)
  BLYSK_BINARY(Floats, operator*, Mul)
  BLYSK_BINARY(Floats, operator/, Div)
  BLYSK_BINARY(Floats, min, Min)
  BLYSK_BINARY(Floats, max, Max)
  BLYSK_COMPARE(Floats, operator<, hn::Lt(a.part[i], b.part[i]))
  BLYSK_COMPARE(Floats, operator>, hn::Gt(a.part[i], b.part[i]))
  BLYSK_COMPARE(Floats, operator<=, hn::Le(a.part[i], b.part[i]))
  BLYSK_COMPARE(Floats, operator>=, hn::Ge(a.part[i], b.part[i]))
  BLYSK_COMPARE(Floats, operator==, hn::Eq(a.part[i], b.part[i]))
  BLYSK_COMPARE(Floats, operator!=, hn::Ne(a.part[i], b.part[i]))
};

template <int kRegisters>
struct Ints {
  hn::Vec<IntTag> part[kRegisters];
  BLYSK_INLINE Ints() = default;
  BLYSK_INLINE Ints(std::int32_t value) {  // NOLINT(google-explicit-constructor)
    BLYSK_EACH_PART part[i] = hn::Set(IntTag(), value);
  }
  BLYSK_BINARY(Ints, operator+, Add)
  BLYSK_BINARY(Ints, operator-, Sub)
  BLYSK_BINARY(Ints, operator*, Mul)
  BLYSK_BINARY(Ints, operator&, And)
  BLYSK_BINARY(Ints, operator|, Or)
  BLYSK_BINARY(Ints, operator^, Xor)
  BLYSK_BINARY(Ints, min, Min)
  BLYSK_BINARY(Ints, max, Max)
  BLYSK_COMPARE(Ints, operator<, hn::Lt(a.part[i], b.part[i]))
  BLYSK_COMPARE(Ints, operator>, hn::Gt(a.part[i], b.part[i]))
  BLYSK_COMPARE(Ints, operator<=, hn::Not(hn::Gt(a.part[i], b.part[i])))
  BLYSK_COMPARE(Ints, operator>=, hn::Not(hn::Lt(a.part[i], b.part[i])))
  BLYSK_COMPARE(Ints, operator==, hn::Eq(a.part[i], b.part[i]))
  BLYSK_COMPARE(Ints, operator!=, hn::Ne(a.part[i], b.part[i]))
};
#undef BLYSK_BINARY
#undef BLYSK_COMPARE

using F32 = Floats<kParts>;
using I32 = Ints<kParts>;
using Mask = Masks<kParts>;

/// Long runs of one triangle are shaded in registers' pairs: where sixteen lanes are one register, the
/// latency of a single chain of operations would leave half of the processor idle.
inline constexpr int kWideParts = kParts == 1 ? 2 : kParts;
inline constexpr int kWideLanes = kWideParts * kPartLanes;
using F32Wide = Floats<kWideParts>;

template <int kRegisters>
BLYSK_INLINE Floats<kRegisters> select(Masks<kRegisters> m, Floats<kRegisters> yes, Floats<kRegisters> no) {
  Floats<kRegisters> r;
  BLYSK_EACH_PART r.part[i] = hn::IfThenElse(m.part[i], yes.part[i], no.part[i]);
  return r;
}

template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> select(Masks<kRegisters> m, Ints<kRegisters> yes, Ints<kRegisters> no) {
  Ints<kRegisters> r;
  BLYSK_EACH_PART r.part[i] = hn::IfThenElse(hn::RebindMask(IntTag(), m.part[i]), yes.part[i], no.part[i]);
  return r;
}

#define BLYSK_UNARY(To, name, From, result)              \
  template <int kRegisters>                              \
  BLYSK_INLINE To<kRegisters> name(From<kRegisters> a) { \
    To<kRegisters> r;                                    \
    BLYSK_EACH_PART r.part[i] = result;                  \
    return r;                                            \
  }
BLYSK_UNARY(Floats, sqrt, Floats, hn::Sqrt(a.part[i]))
/// Exact up to 2^24.
BLYSK_UNARY(Floats, to_float, Ints, hn::ConvertTo(FloatTag(), a.part[i]))
/// Towards zero; |a| < 2^31.
BLYSK_UNARY(Ints, truncate, Floats, hn::ConvertTo(IntTag(), a.part[i]))
/// To nearest, ties to even; |a| < 2^31.
BLYSK_UNARY(Ints, nearest, Floats, hn::NearestInt(a.part[i]))
BLYSK_UNARY(Ints, bits_of, Floats, hn::BitCast(IntTag(), a.part[i]))
BLYSK_UNARY(Floats, float_of_bits, Ints, hn::BitCast(FloatTag(), a.part[i]))
#undef BLYSK_UNARY

template <int kBits, int kRegisters>
BLYSK_INLINE Ints<kRegisters> shift_left(Ints<kRegisters> a) {
  Ints<kRegisters> r;
  BLYSK_EACH_PART r.part[i] = hn::ShiftLeft<kBits>(a.part[i]);
  return r;
}

/// Arithmetic: the sign is kept.
template <int kBits, int kRegisters>
BLYSK_INLINE Ints<kRegisters> shift_right(Ints<kRegisters> a) {
  Ints<kRegisters> r;
  BLYSK_EACH_PART r.part[i] = hn::ShiftRight<kBits>(a.part[i]);
  return r;
}

#undef BLYSK_EACH_PART
#define BLYSK_EACH_PART for (int i = 0; i < kParts; ++i)

// Memory. Pointers need no alignment.

BLYSK_INLINE F32 load(const float* p) {
  F32 r;
  BLYSK_EACH_PART r.part[i] = hn::LoadU(FloatTag(), p + i * kPartLanes);
  return r;
}

BLYSK_INLINE F32Wide load_wide(const float* p) {
  F32Wide r;
  for (int i = 0; i < kWideParts; ++i) r.part[i] = hn::LoadU(FloatTag(), p + i * kPartLanes);
  return r;
}

BLYSK_INLINE Ints<kWideParts> load_wide(const std::int32_t* p) {
  Ints<kWideParts> r;
  for (int i = 0; i < kWideParts; ++i) r.part[i] = hn::LoadU(IntTag(), p + i * kPartLanes);
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

template <int kRegisters>
BLYSK_INLINE void load_all(const float* p, Floats<kRegisters>& a) {
  for (int i = 0; i < kRegisters; ++i) a.part[i] = hn::LoadU(FloatTag(), p + i * kPartLanes);
}

template <int kRegisters>
BLYSK_INLINE void store_all(Floats<kRegisters> a, float* p) {
  for (int i = 0; i < kRegisters; ++i) hn::StoreU(a.part[i], FloatTag(), p + i * kPartLanes);
}

template <int kRegisters>
BLYSK_INLINE void store_all(Ints<kRegisters> a, std::uint32_t* p) {
  for (int i = 0; i < kRegisters; ++i) {
    hn::StoreU(a.part[i], IntTag(), reinterpret_cast<std::int32_t*>(p) + i * kPartLanes);
  }
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

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4
/// For each mask of a register its lanes, one after the other. Highway 1.0.3 has such a table too, but not a
/// static one: gcc copies it to the stack, 1 KB, whenever it is used.
struct CompressTable {
  std::uint8_t lane[1 << kPartLanes][kPartLanes];
  constexpr CompressTable() : lane() {
    for (int bits = 0; bits < 1 << kPartLanes; ++bits) {
      int n = 0;
      for (int i = 0; i < kPartLanes; ++i) {
        if ((bits >> i & 1) != 0) lane[bits][n++] = static_cast<std::uint8_t>(i);
      }
    }
  }
};
inline constexpr CompressTable kCompressTable;
#endif

/// Writes the lanes of m one after the other and returns how many; sixteen may be overwritten.
BLYSK_INLINE int store_compressed(Mask m, I32 a, std::int32_t* p) {
  // Compressed in a register and stored whole: a masked store could not be read back at once.
  int n = 0;
  BLYSK_EACH_PART {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(FloatTag(), m.part[i], bits);
    const auto lanes = hn::LoadU(hn::Rebind<std::uint8_t, IntTag>(), kCompressTable.lane[bits[0]]);
    const auto index = hn::IndicesFromVec(IntTag(), hn::PromoteTo(IntTag(), lanes));
    hn::StoreU(hn::TableLookupLanes(a.part[i], index), IntTag(), p + n);
    n += __builtin_popcount(bits[0]);
#else
    const auto mask = hn::RebindMask(IntTag(), m.part[i]);
    hn::StoreU(hn::Compress(a.part[i], mask), IntTag(), p + n);
    n += static_cast<int>(hn::CountTrue(IntTag(), mask));
#endif
  }
  return n;
}

template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> gather(const std::uint32_t* base, Ints<kRegisters> index) {
  Ints<kRegisters> r;
  for (int i = 0; i < kRegisters; ++i) {
    r.part[i] = hn::GatherIndex(IntTag(), reinterpret_cast<const std::int32_t*>(base), index.part[i]);
  }
  return r;
}

template <int kRegisters>
BLYSK_INLINE Floats<kRegisters> gather(const float* base, Ints<kRegisters> index) {
  Floats<kRegisters> r;
  for (int i = 0; i < kRegisters; ++i) r.part[i] = hn::GatherIndex(FloatTag(), base, index.part[i]);
  return r;
}

/// Sixteen rows of four floats, each at base + stride * index, as four columns: what gather() would give for
/// four neighbouring elements, at a quarter of the loads. All four floats of every row must be readable.
template <int kStride, int kRegisters>
BLYSK_INLINE void gather_rows(const float* base, Ints<kRegisters> index, Floats<kRegisters> columns[4]) {
  std::int32_t at[kRegisters * kPartLanes];
  for (int i = 0; i < kRegisters; ++i) hn::StoreU(index.part[i], IntTag(), at + i * kPartLanes);
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < kLanes; ++i) {
    for (int k = 0; k < 4; ++k)
      columns[k].part[i] = hn::LoadU(FloatTag(), base + std::ptrdiff_t{kStride} * at[i] + k);
  }
#else
  const hn::Full128<float> row_tag;
  for (int i = 0; i < kRegisters; ++i) {
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

/// Four columns as rows of four floats.
template <int kRegisters>
BLYSK_INLINE void store_rows(Floats<kRegisters> a, Floats<kRegisters> b, Floats<kRegisters> c,
                             Floats<kRegisters> d, float* p) {
  for (int i = 0; i < kRegisters; ++i) {
    hn::StoreInterleaved4(a.part[i], b.part[i], c.part[i], d.part[i], FloatTag(), p + 4 * i * kPartLanes);
  }
}

/// first, first + 1, ...
template <int kRegisters = kParts>
BLYSK_INLINE Ints<kRegisters> iota(std::int32_t first) {
  alignas(64) static constexpr std::int32_t kNumbers[2 * kLanes] = {
      0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
      16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
  Ints<kRegisters> r;
  for (int i = 0; i < kRegisters; ++i) r.part[i] = hn::Load(IntTag(), kNumbers + i * kPartLanes);
  return r + Ints<kRegisters>(first);
}

// Masks as bits, lane 0 lowest.

template <int kRegisters>
BLYSK_INLINE unsigned to_bits(Masks<kRegisters> m) {
  unsigned r = 0;
  for (int i = 0; i < kRegisters; ++i) {
#if HWY_TARGET == HWY_AVX3
    const unsigned bits = static_cast<unsigned>(m.part[i].raw);
#else
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), m.part[i], bytes);
    const unsigned bits = bytes[0];
#endif
    r |= bits << (i * kPartLanes);
  }
  return r;
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

template <int kRegisters>
BLYSK_INLINE bool any(Masks<kRegisters> m) {
  return to_bits(m) != 0;
}

// Plain floats, alike in every bit.

BLYSK_INLINE float select(bool m, float yes, float no) { return m ? yes : no; }
BLYSK_INLINE std::int32_t select(bool m, std::int32_t yes, std::int32_t no) { return m ? yes : no; }
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
