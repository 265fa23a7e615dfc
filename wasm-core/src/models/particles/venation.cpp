#include "models/particles/venation.hpp"

#include <algorithm>

namespace panicle::particles {
namespace {

// In spacings: the looking distance along a rib, and the width of the field's cells.
constexpr float look_ahead = 2, field_cell = 0.5f;
// Least share of the looking distance.
constexpr float least_ahead = 0.1f;
// The petiole is on the edge, from which nothing is visible: the aim stops this share of the way before it.
constexpr float before_target = 1e-3f;

}  // namespace

Venation::Venation(const Outline& outline, const Ribs& ribs, float slant, float spacing)
    : Guide(ribs.places[0]),
      outline_(&outline),
      ribs_(&ribs),
      grid_(ribs, outline.low(), outline.high()),
      slant_(slant),
      ahead_(look_ahead * spacing),
      cell_(field_cell * spacing) {}

// The shortest ways to the ribs around corners of the outline; computed when first needed.
Waypoints& Venation::waypoints() const {
  if (!waypoints_) waypoints_ = std::make_unique<Waypoints>(*outline_, ribs_->sampled(cell_), cell_);
  return *waypoints_;
}

// The point that a particle at p heads for: a visible point of the ribs, far below the nearest one if possible, else
// less far; where none is visible, the next waypoint on the way to the ribs.
glm::vec3 Venation::aim(const glm::vec3& p) const {
  const Ribs::Foot foot = grid_.nearest(p);
  for (float below = std::max(slant_ * foot.distance, ahead_); below > least_ahead * ahead_; below *= 0.5f) {
    const glm::vec3 place = ribs_->down(foot, below);
    if (sees(p, place)) return place;
    if (foot.at == 0) break;  // there is no rib below
  }
  return waypoints().next(p);
}

// The length of the way from p to the nearest rib and down along it to the petiole.
float Venation::way(const glm::vec3& p) const {
  const Ribs::Foot foot = grid_.nearest(p);
  return (sees(p, foot.place) ? foot.distance : waypoints().way(p)) + ribs_->length_below(foot);
}

// Whether the segment from a to b stays in the leaf; its end at the petiole, which lies on the edge, is not tested.
bool Venation::sees(const glm::vec3& a, const glm::vec3& b) const {
  return outline_->holds(a == target() ? a + before_target * (b - a) : a,
                         b == target() ? b + before_target * (a - b) : b);
}

}  // namespace panicle::particles
