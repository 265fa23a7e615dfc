// Trails as a plant: a segment for each piece of way, its thickness by the energy that passes, and its other properties
// in columns. Shared by leaf, tree and root.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/particles/trails.hpp"
#include "plant/plant.hpp"

namespace panicle::particles {

// How thickness follows energy (section 3 of the paper leaves it open). A power of 1/2 preserves the sum of squares at
// a fork (Leonardo's rule), a power of 1/3 that of cubes (Murray's).
enum class WidthLaw : std::uint32_t { linear, square_root, power };

struct Girth {
  WidthLaw law = WidthLaw::square_root;
  float exponent = 0.5f;  // of the power law
  float thickest = 1;     // radius of all energy that ever arrives at a target
  float thinnest = 0;     // least radius
};

// The radius of a share `energy` of `all`.
float radius_of(const Girth& girth, double energy, double all);

// The transform of a place in the plane or in space into a place of the plant: metres.
struct Frame {
  glm::vec3 origin{0};
  float scale = 1;
  // The place in the plant of a point of the trails.
  glm::vec3 operator()(const glm::vec3& p) const { return origin + p * scale; }
};

// The totals of a run, for counts and notes.
struct RunTotals {
  std::uint32_t particles = 0, merges = 0;
  std::uint32_t steps = 0;       // in which a particle visibly moves (moment.hpp)
  double energy = 0;             // of all particles
  std::uint32_t stragglers = 0;  // that did not reach their target by themselves
};

// Appends the trails of all targets, one tree after the other: segments (parents first; `parent` −1 at a target or
// where a particle is on its way; `start` is the end nearer the target; tag `tag`), and columns: `segments.energy`
// (float32), `segments.born` (uint32: the step that left it), `targets.places` (float32 × 3, metres), `targets.energy`
// (float32: the arrived energy). Counts: particles, energy, merges, steps, segments, targets. `all`: the energy that
// arrives at each target in the end, by which thickness is scaled. Stragglers get a note. Returns for each place of
// each crowd the segment that begins to lead on from it, −1 for none.
std::vector<std::vector<std::int32_t>> add_trails(Plant& plant, std::span<const Trails> crowds,
                                                  std::span<const double> all, const Girth& girth, const Frame& frame,
                                                  const RunTotals& tally, std::uint32_t tag);

}  // namespace panicle::particles
