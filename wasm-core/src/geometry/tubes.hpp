// Stems: one smooth tapering tube along each axis of a skeleton.
#pragma once

#include <span>

#include "geometry/mesh.hpp"
#include "geometry/skeleton.hpp"

namespace panicle {

// A contiguous run of the stem mesh: the rachis (−1) or one first-order axis with its pedicels.
struct StemPart {
  std::int32_t axis = -1;
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_index = 0, index_count = 0;
};

struct StemMesh {
  Mesh mesh;
  std::vector<std::uint32_t> internode;  // per vertex: index of the internode it belongs to
  std::vector<StemPart> parts;           // in the order −1, 0, 1, …; together they cover the mesh
};

struct TubeOptions {
  std::uint32_t sides = 12;  // 3 … 64
  // A mesh that would have more gets fewer sides, then fewer rings. 60 bytes each: what the limits on internodes
  // allow still fits memory.
  std::uint64_t most_vertices = 10'000'000;
};

// Sweeps the skeleton. Positions come out in the skeleton's unit times `scale`. u runs once round, v along the
// axis, one unit of v to one circumference so that a bark texture keeps its proportions.
StemMesh sweep_stems(std::span<const Internode> skeleton, const TubeOptions& options, float scale);

}  // namespace panicle
