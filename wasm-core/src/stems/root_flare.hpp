// The lower ends of trunks and roots at their targets: a trunk is level with the ground and widens into its roots; a
// root hangs from the stump of its stem.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "stems/segment.hpp"
#include "stems/tubes.hpp"

namespace panicle {

struct RootFlareOptions {
  float flare = 0;         // of a trunk: how much wider it stands on the ground than it is
  float stump = 0;         // of a root: how much of its stem is above ground, metres
  bool standing = true;    // a trunk; a root hangs from its stem
  std::uint64_t seed = 1;  // by which its ridges stand
};

// Returns for each target the thickest segment that begins there; −1 for none.
std::vector<std::int32_t> trunk_bases(std::span<const Segment> segments, std::span<const glm::vec3> targets);

// Returns the pieces that replace a base segment, beginning with the one without a parent: a trunk's vertical piece, a
// root's stem.
std::vector<Segment> base_pieces(const Segment& base, const RootFlareOptions& options);

// The centre line of a trunk: the segments of its axis, from its base on.
struct TrunkLine {
  std::span<const Segment> segments;
  std::span<const std::int32_t> axes;
  std::size_t base = 0;

  // The centre at a height above its base, interpolated between segments.
  glm::vec3 at(float height) const;
};

// Cuts the trunk's tube off level with the ground, and adds a flared surface around it that widens towards the ground
// in ridges.
void add_root_flare(StemMesh& stems, const StemPart& tube, const TrunkLine& trunk, const RootFlareOptions& options);

}  // namespace panicle
