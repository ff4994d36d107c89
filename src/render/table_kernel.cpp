// The table of this instruction set's kernels.
#include "render/kernels.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {

namespace {
constexpr ShadingKernel kShadings[] = {
    {"phong", shade_phong},
    {"gouraud", shade_gouraud},
    {"flat", shade_flat},
    {"gouraud-constant", shade_gouraud_constant},
    {"quadratic", shade_quadratic},
    {"cubic", shade_cubic},
    {"symmetric", shade_symmetric},
    {"angular", shade_angular},
    {"fast-normalize", shade_fast_normalize},
    {"barycentric", shade_barycentric},
    {"parallel", shade_parallel},
    {"dichotomy", shade_dichotomy},
    {"lighting-texture", shade_lighting_texture},
    {"auto", shade_auto},
};
}

extern const Kernels table;
const Kernels table = {
    BLYSK_ISA_ENUM,
    support,
    transform_vertices,
    assemble_triangles,
    rasterize_tile,
    rasterize_samples,
    resolve_samples,
    store_tile,
    write_normals,
    kShadings,
    static_cast<int>(sizeof kShadings / sizeof kShadings[0]),
};

}  // namespace blysk::BLYSK_ISA
