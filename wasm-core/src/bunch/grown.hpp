// What a growth gives back: the one thing that scene, exporters and panels read, in metres.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bunch/plan.hpp"
#include "geometry/mesh.hpp"
#include "geometry/skeleton.hpp"
#include "geometry/tubes.hpp"

namespace panicle::bunch {

struct Counts {
  std::uint32_t end_structures = 0;
  std::uint32_t internodes = 0;
  std::uint32_t pedicels = 0;
  std::uint32_t berries = 0;
  std::uint32_t withered = 0;
  std::uint32_t cut = 0;  // internodes that found no room; they and what they would have borne are in no other count
};

struct Grown {
  Plan plan;
  std::optional<Plan> second;
  Counts counts;
  std::vector<Internode> internodes;  // parents first
  std::vector<Berry> berries;
  std::optional<StemMesh> stem;
  std::optional<Mesh> berry;
  std::vector<std::string> notes;
  std::uint64_t fingerprint = 0;       // skeleton and organs (docs/fingerprint.md)
  std::uint64_t mesh_fingerprint = 0;  // 0 without meshes
};

}  // namespace panicle::bunch
