// scene/normals.h - make_normals() with threads of the caller.
#pragma once

#include <cstddef>

#include "blysk/scene.h"
#include "core/threads.h"

namespace blysk {

/// Meshes of fewer triangles are done before helpers are awake.
inline constexpr std::size_t kTrianglesWorthThreads = 20000;

/// Capacity for the attributes of `vertices`, of which make_normals() will copy some where there are creases:
/// then it need not move all to another place, whose first touch costs more than the rest of it.
inline constexpr std::size_t with_room_for_creases(std::size_t vertices) { return vertices + vertices / 16; }

/// As make_normals(mesh, crease_deg). The normals do not depend on the number of threads.
void make_normals(Mesh& mesh, double crease_deg, ThreadPool& pool);

/// Gives the normals of a file length one; those that cannot have it (zero, not finite) become the
/// area-weighted normals of their vertices. Normals of length one within 1e-3 stay as they are.
void mend_normals(Mesh& mesh);

}  // namespace blysk
