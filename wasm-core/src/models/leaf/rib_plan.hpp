// Builds a leaf's ribs by a plan.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/leaf/shape/margin.hpp"
#include "models/particles/outline.hpp"
#include "models/particles/ribs.hpp"

namespace panicle::particles::leaf {

enum class RibKind : std::uint32_t { none, pinnate, palmate, parallel };

// Where side veins end: just before the margin, in the tips of teeth (craspedodromous), or below the next one, to which
// they bend up along the margin (brochidodromous).
enum class Course : std::uint32_t { margin, teeth, arch };

struct RibPlan {
  RibKind kind = RibKind::pinnate;
  std::uint32_t secondaries = 8;  // on each side of a midrib; arcs on each side of a parallel leaf
  float angle = 50;               // degrees, from the vein that a secondary leaves
  float spacing = 0.8f;           // at the tip, over that at the base
  float offset = 0.4f;            // of one side against the other, in spacings
  float arch = 0.4f;              // curvature of a secondary towards the tip, 0 … 1
  Course course = Course::margin;
};

// One tree of ribs for each target: none and pinnate have one, palmate one for each lobe tip, parallel one for each
// arc. All end where the petiole joins, `base`. In a lobed pinnate leaf one secondary runs to each lobe tip. Ribs that
// cannot be placed get a note in `notes`.
std::vector<Ribs> build_ribs(const RibPlan& plan, const Margin& margin, const Outline& outline, const glm::vec3& base,
                             std::vector<std::string>& notes);

}  // namespace panicle::particles::leaf
