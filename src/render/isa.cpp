// Which instruction sets are built in, and which this processor has.
#include <algorithm>
#include <iterator>

#include "render/kernels.h"

namespace blysk {

#define BLYSK_DECLARE(name)     \
  namespace isa_##name {        \
    extern const Kernels table; \
  }
#ifdef BLYSK_HAVE_ISA_scalar
BLYSK_DECLARE(scalar)
#endif
#ifdef BLYSK_HAVE_ISA_sse4
BLYSK_DECLARE(sse4)
#endif
#ifdef BLYSK_HAVE_ISA_avx2
BLYSK_DECLARE(avx2)
#endif
#ifdef BLYSK_HAVE_ISA_avx512
BLYSK_DECLARE(avx512)
#endif
#ifdef BLYSK_HAVE_ISA_neon
BLYSK_DECLARE(neon)
#endif
#undef BLYSK_DECLARE

namespace {

// From the slowest to the fastest.
const std::vector<const Kernels*>& runnable() {
  static const std::vector<const Kernels*> list = [] {
    std::vector<const Kernels*> r;
#ifdef BLYSK_HAVE_ISA_scalar
    r.push_back(&isa_scalar::table);
#endif
#if defined(__x86_64__)
    __builtin_cpu_init();
    const bool sse4 =
        __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
    const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                        __builtin_cpu_supports("avx512vl");
#ifdef BLYSK_HAVE_ISA_sse4
    if (sse4) r.push_back(&isa_sse4::table);
#endif
#ifdef BLYSK_HAVE_ISA_avx2
    if (avx2) r.push_back(&isa_avx2::table);
#endif
#ifdef BLYSK_HAVE_ISA_avx512
    if (avx512) r.push_back(&isa_avx512::table);
#endif
#endif
#ifdef BLYSK_HAVE_ISA_neon
    r.push_back(&isa_neon::table);
#endif
    return r;
  }();
  return list;
}

}  // namespace

std::string_view isa_name(Isa isa) {
  switch (isa) {
    case Isa::scalar:
      return "scalar";
    case Isa::sse4:
      return "sse4";
    case Isa::avx2:
      return "avx2";
    case Isa::avx512:
      return "avx512";
    case Isa::neon:
      return "neon";
    case Isa::best:
      break;
  }
  return "best";
}

std::vector<Isa> available_isas() {
  std::vector<Isa> r;
  std::transform(runnable().begin(), runnable().end(), std::back_inserter(r),
                 [](const Kernels* k) { return k->isa; });
  return r;
}

const Kernels& kernels(Isa isa) {
  for (const Kernels* k : runnable()) {
    if (k->isa == isa) return *k;
  }
  return *runnable().back();
}

}  // namespace blysk
