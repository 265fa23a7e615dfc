// The lower ends of trunks and roots at their targets: a trunk widens at the ground into its roots; a root hangs from
// the stump of its stem.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "stems/segment.hpp"
#include "stems/stem_rings.hpp"
#include "stems/tubes.hpp"

namespace panicle {

struct RootFlareOptions {
  float flare = 0;         // of a trunk: how much it widens at the ground; 0: not at all
  float stump = 0;         // of a root: how much of its stem is above ground, metres
  bool standing = true;    // a trunk; a root hangs from its stem
  std::uint64_t seed = 1;  // of its spurs
};

// Returns for each target the thickest segment that begins there; −1 for none.
std::vector<std::int32_t> trunk_bases(std::span<const Segment> segments, std::span<const glm::vec3> targets);

// Returns the pieces that replace a base segment, beginning with the one without a parent: a trunk's vertical piece, a
// root's stem.
std::vector<Segment> base_pieces(const Segment& base, const RootFlareOptions& options);

// Returns the root flare of a trunk whose axis begins with the segment `number`, in metres.
RootFlare root_flare_of(const Segment& base, std::uint32_t number, const RootFlareOptions& options);

// The part of a trunk's tube that its root flare replaces: the rings from the ground up to where it widens.
struct TrunkFoot {
  RootFlare flare;
  std::uint32_t sides = 0;  // of the tube
  std::vector<Ring> rings;
};

// Cuts a tube off where its root flare begins. A foot without rings if the tube is too short for it.
TrunkFoot take_foot(Tube& tube, const RootFlare& flare, std::uint32_t sides);

// Adds the surface of a trunk's foot: it continues the tube and widens into spurs towards the ground, goes on below
// the ground, and is closed.
void add_root_flare(StemMesh& stems, const TrunkFoot& foot, float scale);

}  // namespace panicle
