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

// The scalar build is there to compare with: its sixteen lanes, inlined everywhere, would take minutes to
// compile.
#if HWY_TARGET == HWY_SCALAR
#define BLYSK_INLINE inline
#else
#define BLYSK_INLINE inline __attribute__((always_inline))
#endif

// A statement for each register i of n. It is written out, because a loop in every one of thousands of
// operations was most of what the compiler had to do; the scalar build's sixteen stay a loop.
#define BLYSK_EACH(n, ...)                           \
  if constexpr ((n) > 4) {                           \
    for (int i = 0; i < (n); ++i) __VA_ARGS__;       \
  } else {                                           \
    BLYSK_ONE(0, __VA_ARGS__)                        \
    if constexpr ((n) > 1) BLYSK_ONE(1, __VA_ARGS__) \
    if constexpr ((n) > 2) BLYSK_ONE(2, __VA_ARGS__) \
    if constexpr ((n) > 3) BLYSK_ONE(3, __VA_ARGS__) \
  }
#define BLYSK_ONE(number, ...)  \
  {                             \
    constexpr int i = (number); \
    __VA_ARGS__;                \
  }
#define BLYSK_BINARY(Type, name, op)                                  \
  friend BLYSK_INLINE Type name(Type a, Type b) {                     \
    Type r;                                                           \
    BLYSK_EACH(kRegisters, r.part[i] = hn::op(a.part[i], b.part[i])); \
    return r;                                                         \
  }
#define BLYSK_COMPARE(Type, name, result)                                   \
  friend BLYSK_INLINE Masks<kRegisters> name(Type a, Type b) {              \
    Masks<kRegisters> r;                                                    \
    BLYSK_EACH(kRegisters, r.part[i] = hn::RebindMask(FloatTag(), result)); \
    return r;                                                               \
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
    BLYSK_EACH(kRegisters, part[i] = hn::Set(FloatTag(), value));
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
    BLYSK_EACH(kRegisters, part[i] = hn::Set(IntTag(), value));
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
  BLYSK_EACH(kRegisters, r.part[i] = hn::IfThenElse(m.part[i], yes.part[i], no.part[i]));
  return r;
}

template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> select(Masks<kRegisters> m, Ints<kRegisters> yes, Ints<kRegisters> no) {
  Ints<kRegisters> r;
  BLYSK_EACH(kRegisters,
             r.part[i] = hn::IfThenElse(hn::RebindMask(IntTag(), m.part[i]), yes.part[i], no.part[i]));
  return r;
}

#define BLYSK_UNARY(To, name, From, result)              \
  template <int kRegisters>                              \
  BLYSK_INLINE To<kRegisters> name(From<kRegisters> a) { \
    To<kRegisters> r;                                    \
    BLYSK_EACH(kRegisters, r.part[i] = result);          \
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
  BLYSK_EACH(kRegisters, r.part[i] = hn::ShiftLeft<kBits>(a.part[i]));
  return r;
}

/// Arithmetic: the sign is kept.
template <int kBits, int kRegisters>
BLYSK_INLINE Ints<kRegisters> shift_right(Ints<kRegisters> a) {
  Ints<kRegisters> r;
  BLYSK_EACH(kRegisters, r.part[i] = hn::ShiftRight<kBits>(a.part[i]));
  return r;
}

// Memory. Pointers need no alignment.

template <int kRegisters>
BLYSK_INLINE void load_all(const float* p, Floats<kRegisters>& a) {
  BLYSK_EACH(kRegisters, a.part[i] = hn::LoadU(FloatTag(), p + i * kPartLanes));
}

template <int kRegisters>
BLYSK_INLINE void load_all(const std::int32_t* p, Ints<kRegisters>& a) {
  BLYSK_EACH(kRegisters, a.part[i] = hn::LoadU(IntTag(), p + i * kPartLanes));
}

BLYSK_INLINE F32 load(const float* p) {
  F32 r;
  load_all(p, r);
  return r;
}

BLYSK_INLINE F32Wide load_wide(const float* p) {
  F32Wide r;
  load_all(p, r);
  return r;
}

BLYSK_INLINE Ints<kWideParts> load_wide(const std::int32_t* p) {
  Ints<kWideParts> r;
  load_all(p, r);
  return r;
}

BLYSK_INLINE I32 load(const std::int32_t* p) {
  I32 r;
  load_all(p, r);
  return r;
}

BLYSK_INLINE I32 load(const std::uint32_t* p) { return load(reinterpret_cast<const std::int32_t*>(p)); }

template <int kRegisters>
BLYSK_INLINE void store_all(Floats<kRegisters> a, float* p) {
  BLYSK_EACH(kRegisters, hn::StoreU(a.part[i], FloatTag(), p + i * kPartLanes));
}

template <int kRegisters>
BLYSK_INLINE void store_all(Ints<kRegisters> a, std::int32_t* p) {
  BLYSK_EACH(kRegisters, hn::StoreU(a.part[i], IntTag(), p + i * kPartLanes));
}

template <int kRegisters>
BLYSK_INLINE void store_all(Ints<kRegisters> a, std::uint32_t* p) {
  store_all(a, reinterpret_cast<std::int32_t*>(p));
}

BLYSK_INLINE void store(F32 a, float* p) { store_all(a, p); }
BLYSK_INLINE void store(I32 a, std::int32_t* p) { store_all(a, p); }
BLYSK_INLINE void store(I32 a, std::uint32_t* p) { store_all(a, p); }

/// Non-temporal; p is aligned to 64. hwy::FlushStream() orders it before what follows.
template <int kRegisters>
BLYSK_INLINE void store_past_caches(Ints<kRegisters> a, std::uint32_t* p) {
  auto* q = reinterpret_cast<std::int32_t*>(p);
  BLYSK_EACH(kRegisters, hn::Stream(a.part[i], IntTag(), q + i * kPartLanes));
}

/// Writes the lanes of m. The others may be rewritten with what they held: all of them must be memory of this
/// thread.
template <int kRegisters>
BLYSK_INLINE void store_masked(Masks<kRegisters> m, Floats<kRegisters> a, float* p) {
  BLYSK_EACH(kRegisters, hn::BlendedStore(a.part[i], m.part[i], FloatTag(), p + i * kPartLanes));
}

template <int kRegisters>
BLYSK_INLINE void store_masked(Masks<kRegisters> m, Ints<kRegisters> a, std::uint32_t* p) {
  auto* q = reinterpret_cast<std::int32_t*>(p);
  BLYSK_EACH(kRegisters,
             hn::BlendedStore(a.part[i], hn::RebindMask(IntTag(), m.part[i]), IntTag(), q + i * kPartLanes));
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

BLYSK_INLINE int store_part_compressed(hn::Mask<FloatTag> m, hn::Vec<IntTag> a, std::int32_t* p) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(FloatTag(), m, bits);
  const auto lanes = hn::LoadU(hn::Rebind<std::uint8_t, IntTag>(), kCompressTable.lane[bits[0]]);
  const auto index = hn::IndicesFromVec(IntTag(), hn::PromoteTo(IntTag(), lanes));
  hn::StoreU(hn::TableLookupLanes(a, index), IntTag(), p);
  return __builtin_popcount(bits[0]);
}
#else
BLYSK_INLINE int store_part_compressed(hn::Mask<FloatTag> m, hn::Vec<IntTag> a, std::int32_t* p) {
  const auto mask = hn::RebindMask(IntTag(), m);
  hn::StoreU(hn::Compress(a, mask), IntTag(), p);
  return static_cast<int>(hn::CountTrue(IntTag(), mask));
}
#endif

/// Writes the lanes of m one after the other and returns how many; as many as there are lanes may be
/// overwritten.
template <int kRegisters>
BLYSK_INLINE int store_compressed(Masks<kRegisters> m, Ints<kRegisters> a, std::int32_t* p) {
  // Compressed in a register and stored whole: a masked store could not be read back at once.
  int n = 0;
  BLYSK_EACH(kRegisters, n += store_part_compressed(m.part[i], a.part[i], p + n));
  return n;
}

template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> gather(const std::uint32_t* base, Ints<kRegisters> index) {
  const auto* from = reinterpret_cast<const std::int32_t*>(base);
  Ints<kRegisters> r;
  BLYSK_EACH(kRegisters, r.part[i] = hn::GatherIndex(IntTag(), from, index.part[i]));
  return r;
}

template <int kRegisters>
BLYSK_INLINE Floats<kRegisters> gather(const float* base, Ints<kRegisters> index) {
  Floats<kRegisters> r;
  BLYSK_EACH(kRegisters, r.part[i] = hn::GatherIndex(FloatTag(), base, index.part[i]));
  return r;
}

#if HWY_TARGET != HWY_SCALAR
/// Of one register's rows: register k holds the rows k, k + 4, ... of this part, one a 128-bit block; then
/// each block is transposed.
template <int kStride>
BLYSK_INLINE void transpose_rows(const float* base, const std::int32_t* at, hn::Vec<FloatTag>& a,
                                 hn::Vec<FloatTag>& b, hn::Vec<FloatTag>& c, hn::Vec<FloatTag>& d) {
  const FloatTag tag;
  const hn::Full128<float> row_tag;
  const auto rows = [&](int k) __attribute__((always_inline)) {
    const auto row = [&](int block) __attribute__((always_inline)) {
      return hn::LoadU(row_tag, base + std::ptrdiff_t{kStride} * at[4 * block + k]);
    };
#if HWY_TARGET == HWY_AVX3
    const hn::Full256<float> half;
    return hn::Combine(tag, hn::Combine(half, row(3), row(2)), hn::Combine(half, row(1), row(0)));
#elif HWY_TARGET == HWY_AVX2
    return hn::Combine(tag, row(1), row(0));
#else
    return row(0);
#endif
  };
  const auto r0 = rows(0), r1 = rows(1), r2 = rows(2), r3 = rows(3);
  const hn::RepartitionToWide<FloatTag> wide;
  const auto low01 = hn::BitCast(wide, hn::InterleaveLower(tag, r0, r1));
  const auto low23 = hn::BitCast(wide, hn::InterleaveLower(tag, r2, r3));
  const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(tag, r0, r1));
  const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(tag, r2, r3));
  a = hn::BitCast(tag, hn::InterleaveLower(wide, low01, low23));
  b = hn::BitCast(tag, hn::InterleaveUpper(wide, low01, low23));
  c = hn::BitCast(tag, hn::InterleaveLower(wide, high01, high23));
  d = hn::BitCast(tag, hn::InterleaveUpper(wide, high01, high23));
}
#endif

/// Rows of four floats, each at base + stride * index, as four columns: what gather() would give for four
/// neighbouring elements, at a quarter of the loads. All four floats of every row must be readable.
template <int kStride, int kRegisters>
BLYSK_INLINE void gather_rows(const float* base, Ints<kRegisters> index, Floats<kRegisters> columns[4]) {
  std::int32_t at[kRegisters * kPartLanes];
  store_all(index, at);
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < kRegisters; ++i) {
    for (int k = 0; k < 4; ++k)
      columns[k].part[i] = hn::LoadU(FloatTag(), base + std::ptrdiff_t{kStride} * at[i] + k);
  }
#else
  BLYSK_EACH(kRegisters, transpose_rows<kStride>(base, at + i * kPartLanes, columns[0].part[i],
                                                 columns[1].part[i], columns[2].part[i], columns[3].part[i]));
#endif
}

/// De-interleaves x y z x y z ...
template <int kRegisters>
BLYSK_INLINE void load_interleaved(const float* p, Floats<kRegisters>& x, Floats<kRegisters>& y,
                                   Floats<kRegisters>& z) {
  BLYSK_EACH(kRegisters,
             hn::LoadInterleaved3(FloatTag(), p + 3 * i * kPartLanes, x.part[i], y.part[i], z.part[i]));
}

template <int kRegisters>
BLYSK_INLINE void load_interleaved(const std::uint32_t* p, Ints<kRegisters>& x, Ints<kRegisters>& y,
                                   Ints<kRegisters>& z) {
  const auto* q = reinterpret_cast<const std::int32_t*>(p);
  BLYSK_EACH(kRegisters,
             hn::LoadInterleaved3(IntTag(), q + 3 * i * kPartLanes, x.part[i], y.part[i], z.part[i]));
}

/// Interleaves into a b c d a b c d ...
template <int kRegisters>
BLYSK_INLINE void store_interleaved(Ints<kRegisters> a, Ints<kRegisters> b, Ints<kRegisters> c,
                                    Ints<kRegisters> d, std::int32_t* p) {
  BLYSK_EACH(kRegisters, hn::StoreInterleaved4(a.part[i], b.part[i], c.part[i], d.part[i], IntTag(),
                                               p + 4 * i * kPartLanes));
}

/// Four columns as rows of four floats.
template <int kRegisters>
BLYSK_INLINE void store_rows(Floats<kRegisters> a, Floats<kRegisters> b, Floats<kRegisters> c,
                             Floats<kRegisters> d, float* p) {
  BLYSK_EACH(kRegisters, hn::StoreInterleaved4(a.part[i], b.part[i], c.part[i], d.part[i], FloatTag(),
                                               p + 4 * i * kPartLanes));
}

/// first, first + 1, ...
template <int kRegisters = kParts>
BLYSK_INLINE Ints<kRegisters> iota(std::int32_t first) {
  alignas(64) static constexpr std::int32_t kNumbers[2 * kLanes] = {
      0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
      16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
  Ints<kRegisters> r;
  BLYSK_EACH(kRegisters, r.part[i] = hn::Load(IntTag(), kNumbers + i * kPartLanes));
  return r + Ints<kRegisters>(first);
}

// Masks as bits, lane 0 lowest.

BLYSK_INLINE unsigned part_to_bits(hn::Mask<FloatTag> m, int first) {
#if HWY_TARGET == HWY_AVX3
  return static_cast<unsigned>(m.raw) << first;
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(FloatTag(), m, bytes);
  return static_cast<unsigned>(bytes[0]) << first;
#endif
}

template <int kRegisters>
BLYSK_INLINE unsigned to_bits(Masks<kRegisters> m) {
  unsigned r = 0;
  BLYSK_EACH(kRegisters, r |= part_to_bits(m.part[i], i * kPartLanes));
  return r;
}

BLYSK_INLINE hn::Mask<FloatTag> part_of_bits(unsigned bits, int first) {
  const unsigned own = bits >> first;
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(own), static_cast<std::uint8_t>(own >> 8)};
  return hn::LoadMaskBits(FloatTag(), bytes);
}

/// The lanes whose bits are set.
template <int kRegisters = kParts>
BLYSK_INLINE Masks<kRegisters> lanes_of(unsigned bits) {
  Masks<kRegisters> r;
  BLYSK_EACH(kRegisters, r.part[i] = part_of_bits(bits, i * kPartLanes));
  return r;
}

/// The lanes 0 .. end - 1.
BLYSK_INLINE Mask lanes_below(int end) { return iota(0) < I32(end); }

template <int kRegisters>
BLYSK_INLINE bool any(Masks<kRegisters> m) {
  return to_bits(m) != 0;
}
template <int kRegisters>
BLYSK_INLINE bool all(Masks<kRegisters> m) {
  return to_bits(m) == (2u << (kRegisters * kPartLanes - 1)) - 1;
}

// Plain floats, alike in every bit.

BLYSK_INLINE bool any(bool m) { return m; }
BLYSK_INLINE bool all(bool m) { return m; }
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

}  // namespace blysk::BLYSK_ISA
