// The margin of a leaf: a spline through control points, cut by teeth.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "foundation/result.hpp"

namespace panicle::particles::leaf {

enum class PointKind : std::uint32_t { smooth, corner, round_tip, pointed_tip };

// Whether the kind of a margin's point is one of the tips.
inline bool tip_kind(PointKind kind) { return kind >= PointKind::round_tip; }

// Lengths in leaf lengths: the petiole joins at the origin, the tip is about (0, 1).
struct ControlPoint {
  glm::vec2 place{0};
  PointKind kind = PointKind::smooth;
};

// An ovate leaf.
std::vector<ControlPoint> default_outline();

// Reads the block `outline`: rows of x, y, kind. Empty: the default. Errors: bad_input, with the row and the fix, for
// rows that are not threes, too few or too many rows, values that are not finite or too large, and outlines without
// area. An unknown kind is a smooth point, with a note.
Result<std::vector<ControlPoint>> read_outline(std::span<const float> rows, std::vector<std::string>& notes);

// A closed polygon, counter-clockwise from the base. Its corners lie on a lattice of 2⁻²⁰, so that sums of their
// products are exact in whole numbers.
struct Margin {
  std::vector<glm::vec2> points;
  std::vector<std::size_t> controls;  // of each control point, its number among the points
  std::vector<std::size_t> tips;      // the lobe tips among the points, the leaf's own included, in their order
  std::size_t tip = 0;                // the leaf's own: the highest lobe tip; without one the highest point
  std::vector<std::size_t> teeth;     // the tips of teeth among the points, in their order
};

// The centripetal Catmull-Rom spline (Yuksel et al. 2011, "Parameterization and applications of Catmull-Rom curves")
// through the points, a cubic from each to the next. At a corner and a pointed tip it breaks: the cubic's control there
// is halfway to its other one, or a third of the way to the next point where that is sharp too. Errors: bad_input,
// which names the control points, where it crosses itself. Corners that stand out are its teeth.
Result<Margin> spline(std::span<const ControlPoint> points);

enum class ToothShape : std::uint32_t { dentate, serrate, crenate, double_serrate, crenate_serrate };

struct Teeth {
  std::uint32_t count = 0;  // on each side, from base to tip
  float depth = 0.35f;      // over their width
  ToothShape shape = ToothShape::serrate;
  float entire = 0;  // share of the margin, from the base on both sides, that has none; below 1
};

// Cuts teeth out of a margin: their points stay on it, between them it is cut in. They are distributed by length over
// the stretches between lobe tips and the sinuses between those, lean towards the tip of their stretch, and are lower
// towards tips and base, and where the blade is narrow. Teeth that would make the margin cross itself are cut less
// deep; teeth that do not fit are left out, with a note.
Margin toothed(const Margin& margin, const Teeth& teeth, std::vector<std::string>& notes);

// Pairs of edges that cross or touch, other than neighbours that meet in a corner.
struct EdgePair {
  std::size_t first = 0, second = 0;
};
std::vector<EdgePair> crossings(std::span<const glm::vec2> points);
// The first such pair; both the same if there is none.
EdgePair crossing(std::span<const glm::vec2> points);

}  // namespace panicle::particles::leaf
