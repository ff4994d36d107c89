// simd/kernels.h - declarations of one instruction set's kernels, for the kernel files themselves.
#pragma once

#ifndef BLYSK_ISA
#error "kernels.h is for x_kernel.cpp files"
#endif

namespace blysk {
struct TransformJob;
struct AssembleJob;
struct TileJob;
struct ShadeJob;

namespace BLYSK_ISA {
void transform_vertices(const TransformJob& job);
void assemble_triangles(AssembleJob& job);
int rasterize_tile(const TileJob& job);
void shade_flat(const ShadeJob& job);
void shade_gouraud(const ShadeJob& job);
void shade_phong(const ShadeJob& job);
void write_normals(const ShadeJob& job);
}  // namespace BLYSK_ISA
}  // namespace blysk
