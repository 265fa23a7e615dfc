#include "models/particles/venation.hpp"

#include <algorithm>

namespace panicle::particles {
namespace {

// In spacings: how far ahead one looks along a rib that it is on; how wide the cells of the field are.
constexpr float look_ahead = 2, field_cell = 0.5f;
// The petiole is on the edge, where nothing is seen: as near as this share of the way is near enough.
constexpr float before_target = 1e-3f;

}  // namespace

Venation::Venation(const Outline& outline, const Ribs& ribs, float slant, float spacing)
    : Guide(ribs.places[0]),
      outline_(&outline),
      ribs_(&ribs),
      slant_(slant),
      ahead_(look_ahead * spacing),
      waypoints_(outline, ribs.places[0], field_cell * spacing) {}

glm::vec3 Venation::aim(const glm::vec3& p) const {
  if (ribs_->places.size() > 1) {
    const Ribs::Foot foot = ribs_->nearest(p);
    const glm::vec3 below = ribs_->down(foot, std::max(slant_ * foot.distance, ahead_));
    if (sees(p, below)) return below;
    if (foot.distance > 0 && sees(p, foot.place)) return foot.place;
  }
  return waypoints_.next(p);
}

float Venation::way(const glm::vec3& p) const {
  if (ribs_->places.size() < 2) return waypoints_.way(p);
  const Ribs::Foot foot = ribs_->nearest(p);
  return std::max(waypoints_.way(p), foot.distance + ribs_->length_below(foot));
}

bool Venation::sees(const glm::vec3& a, const glm::vec3& b) const {
  return outline_->holds(a == target() ? a + before_target * (b - a) : a, b == target() ? b + before_target * (a - b) : b);
}

}  // namespace panicle::particles
