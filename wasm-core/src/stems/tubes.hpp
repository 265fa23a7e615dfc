// Stems as a mesh: one smooth tapering tube along each axis of a skeleton.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "stems/stems.hpp"

namespace panicle {

// A part of the stem mesh: the tubes of one group.
struct StemPart : MeshRange {
  std::int32_t group = 0;
};

struct StemMesh {
  Mesh mesh;
  std::vector<std::uint32_t> segment;  // per vertex: index of the segment it belongs to
  std::vector<StemPart> parts;         // in ascending order of groups; together they cover the mesh
};

// How a picture of bark lies on tubes: its sides in the segments' unit. Around a tube lies a whole number of quarters
// of its width, as many as fit best, and along it the picture keeps its proportions. Columns of the picture a quarter
// apart must be alike, so that no seam shows. Where a tube gets thinner, quarters vanish gradually beside the seam.
struct BarkScale {
  float width = 0;  // 0: the picture's width lies once around every tube
  float height = 0;
};

// The widened foot of a trunk that replaces the lower end of its tube.
struct RootFlare {
  std::uint32_t segment = 0;  // that the trunk begins with
  float widening = 0;         // by how much wider it is at the ground, in radii
  float height = 0;           // from which on it widens, above the ground
  float depth = 0;            // how far it continues below the ground
  std::uint64_t seed = 1;     // of its spurs
};

struct TubeOptions {
  std::uint32_t sides = 12;  // 3 … 64
  // A mesh that would have more gets fewer sides, then fewer rings. 60 bytes each: meshes of as many segments as the
  // limit allows fit memory.
  std::uint64_t max_vertices = 10'000'000;
  // Axes that begin thinner than this, in the segments' unit, get `thin_sides` sides and about half the rings: of tubes
  // a few pixels wide no more would be seen.
  float thin = 0;
  std::uint32_t thin_sides = 6;
  // Thin axes get about one ring a node and bend: for thousands of twigs.
  bool thin_plain = false;
  // Whether branches begin with a collar (stems/collar.hpp) on a parent that continues.
  bool collars = false;
  BarkScale bark = {};
  std::span<const RootFlare> flares = {};
};

// Sweeps the stems. Positions come out in the segments' unit times `scale`. u runs once round, v along the
// axis, one unit of v to one circumference so that a bark texture keeps its proportions; with TubeOptions::bark by its
// scale.
StemMesh sweep_stems(const Stems& stems, const TubeOptions& options, float scale);

}  // namespace panicle
