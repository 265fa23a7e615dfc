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

Waypoints& Venation::waypoints() const {
  if (!waypoints_) waypoints_ = std::make_unique<Waypoints>(*outline_, ribs_->sampled(cell_), cell_);
  return *waypoints_;
}

// The visible point of the rib: far below the nearest place, else less far; round corners by waypoints, which lead to
// the ribs.
glm::vec3 Venation::aim(const glm::vec3& p) const {
  const Ribs::Foot foot = grid_.nearest(p);
  for (float below = std::max(slant_ * foot.distance, ahead_); below > least_ahead * ahead_; below *= 0.5f) {
    const glm::vec3 place = ribs_->down(foot, below);
    if (sees(p, place)) return place;
    if (foot.at == 0) break;  // there is no rib below
  }
  return waypoints().next(p);
}

float Venation::way(const glm::vec3& p) const {
  const Ribs::Foot foot = grid_.nearest(p);
  return (sees(p, foot.place) ? foot.distance : waypoints().way(p)) + ribs_->length_below(foot);
}

bool Venation::sees(const glm::vec3& a, const glm::vec3& b) const {
  return outline_->holds(a == target() ? a + before_target * (b - a) : a,
                         b == target() ? b + before_target * (a - b) : b);
}

}  // namespace panicle::particles
