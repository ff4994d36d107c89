// simd/kernels.h - declarations of one instruction set's kernels, for the kernel files themselves.
#pragma once

#ifndef BLYSK_ISA
#error "kernels.h is for x_kernel.cpp files"
#endif

#include <cstddef>
#include <cstdint>

#include "blysk/vector.h"

namespace blysk {
struct TransformJob;
struct AssembleJob;
struct TileBuffers;
struct TileJob;
struct ShadeJob;
struct SampleJob;
struct GlassLayer;
struct ResolveJob;

namespace BLYSK_ISA {
void transform_vertices(const TransformJob& job);
void support(const Vec3f* points, std::size_t count, const Vec3f* axis, float* reach);
void assemble_triangles(AssembleJob& job);
int rasterize_tile(const TileJob& job);
int rasterize_samples(const SampleJob& job);
void resolve_samples(const ResolveJob& job);
void store_tile(const TileBuffers& tile, int width, int rows, std::uint32_t* to, std::size_t stride);
void shade_angular(const ShadeJob& job);
void shade_auto(const ShadeJob& job);
void shade_barycentric(const ShadeJob& job);
void shade_fast_normalize(const ShadeJob& job);
void shade_flat(const ShadeJob& job);
void shade_gouraud(const ShadeJob& job);
void shade_gouraud_constant(const ShadeJob& job);
void shade_quadratic(const ShadeJob& job);
void shade_cubic(const ShadeJob& job);
void shade_symmetric(const ShadeJob& job);
void shade_dichotomy(const ShadeJob& job);
void shade_lighting_texture(const ShadeJob& job);
void shade_parallel(const ShadeJob& job);
void shade_phong(const ShadeJob& job);
void write_normals(const ShadeJob& job);
}  // namespace BLYSK_ISA
}  // namespace blysk
