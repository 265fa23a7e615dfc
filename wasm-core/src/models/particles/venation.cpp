#include "models/particles/venation.hpp"

#include <algorithm>

namespace panicle::particles {
namespace {

// In spacings: how far ahead one looks along a rib that it is on; how wide the cells of the field are.
constexpr float look_ahead = 2, field_cell = 0.5f;
// Of that, the least that is still worth looking at.
constexpr float least_ahead = 0.1f;
// The petiole is on the edge, where nothing is seen: as near as this share of the way is near enough.
constexpr float before_target = 1e-3f;

}  // namespace

Venation::Venation(const Outline& outline, const Ribs& ribs, float slant, float spacing)
    : Guide(ribs.places[0]),
      outline_(&outline),
      ribs_(&ribs),
      slant_(slant),
      ahead_(look_ahead * spacing),
      waypoints_(outline, ribs.strewn(field_cell * spacing), field_cell * spacing) {}

// What of the rib is seen: far below the foot, else less far; round corners by waypoints, which lead to the ribs.
glm::vec3 Venation::aim(const glm::vec3& p) const {
  const Ribs::Foot foot = ribs_->nearest(p);
  for (float below = std::max(slant_ * foot.distance, ahead_); below > least_ahead * ahead_; below *= 0.5f) {
    const glm::vec3 place = ribs_->down(foot, below);
    if (sees(p, place)) return place;
  }
  return waypoints_.next(p);
}

float Venation::way(const glm::vec3& p) const { return waypoints_.way(p) + ribs_->length_below(ribs_->nearest(p)); }

bool Venation::sees(const glm::vec3& a, const glm::vec3& b) const {
  return outline_->holds(a == target() ? a + before_target * (b - a) : a,
                         b == target() ? b + before_target * (a - b) : b);
}

}  // namespace panicle::particles
