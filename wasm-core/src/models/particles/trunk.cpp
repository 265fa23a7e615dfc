#include "models/particles/trunk.hpp"

#include <algorithm>
#include <limits>

namespace panicle::particles {
namespace {

constexpr float unknown = std::numeric_limits<float>::max();
constexpr float on_axis = 0.1f;  // of the looking distance: nearer than this, a particle is on the axis
// A particle that looked far ahead would cut the bends of an axis that sways, and run beside it.
constexpr float nearer = 0.25f;
// A longer one could reverse a way.
constexpr float longest_bend = 0.9f;

}  // namespace

// Prepares the guide of particles to a trunk's axis and down it. `outer` may be null: no boundary; `obstacles` may be
// null: none.
Trunk::Trunk(const Axis& axis, const TrunkHabit& habit, const Region* outer, const Obstacles* obstacles)
    : Guide(axis.foot()),
      axis_(axis),
      habit_(habit),
      outer_(outer),
      obstacles_(obstacles && !obstacles->empty() ? obstacles : nullptr) {
  const float bend = glm::length(habit.bend);
  if (bend > longest_bend) habit_.bend *= longest_bend / bend;
  if (obstacles_) survey();
}

// The point of the axis that a particle at p heads for: farther on along the axis by the slant times its distance, at
// least by `ahead`, but before the bole begins; the foot if that would be passed.
glm::vec3 Trunk::to_axis(const glm::vec3& p) const {
  const glm::vec3 foot = target();
  const float from_axis = axis_.distance(p);
  const float left = (p.y - foot.y) * -habit_.way;
  float drop = glm::max(habit_.slant * from_axis, habit_.ahead);
  if (from_axis > on_axis * habit_.ahead && left > habit_.bole) drop = glm::min(drop, left - habit_.bole);
  return !(left > drop) ? foot : axis_.at(p.y + habit_.way * drop);
}

// The length of the way from p to the axis and along it to the target, without obstacles.
float Trunk::straight_way(const glm::vec3& p) const {
  const glm::vec3 near = to_axis(p);
  return glm::distance(p, near) + glm::distance(near, target());
}

// The place that a particle at p goes to next: a step on the way to the axis, bent by the habit where it is far from
// its aim and the bent way is free; or the corner of an obstacle that hides the axis.
glm::vec3 Trunk::aim(const glm::vec3& p) const {
  const glm::vec3 straight = to_axis(p);
  if (!sees(p, straight)) {
    const Corner* corner = turning(p);
    return corner ? corner->place : straight;
  }
  const float near = nearer * habit_.ahead;
  const glm::vec3 to = straight - p;
  const float length = glm::length(to);
  if (habit_.bend == glm::vec3(0) || !(length > habit_.ahead)) return axis_.step_towards(p, straight, near);
  const glm::vec3 way = to / length + glm::min(axis_.distance(p) / habit_.reach, 1.0f) * habit_.bend;
  const glm::vec3 bent = p + way * (habit_.ahead / glm::length(way));
  return axis_.step_towards(p, passes(p, bent) ? bent : straight, near);
}

// The length of the way from p to the target, around obstacles.
float Trunk::way(const glm::vec3& p) const {
  if (sees(p, to_axis(p))) return straight_way(p);
  const Corner* corner = turning(p);
  return corner ? glm::distance(p, corner->place) + corner->way : straight_way(p);
}

// Whether a particle may move between two points: not beyond the target, not through obstacles, and not out of the
// boundary against its direction.
bool Trunk::passes(const glm::vec3& from, const glm::vec3& to) const {
  const float along = (to.y - from.y) * habit_.way;
  if (along > 0 && (to.y - target().y) * habit_.way > 0) return false;
  return sees(from, to) && (outer_ == nullptr || along >= 0 || outer_->contains(to));
}

// Whether a particle at a point finds a way to the target, straight or round an obstacle.
bool Trunk::reaches(const glm::vec3& p) const { return open(p) && (goes_straight(p) || turning(p) != nullptr); }

// The corner that p sees with the shortest way to the target through it, or null.
const Trunk::Corner* Trunk::turning(const glm::vec3& p) const {
  const Corner* best = nullptr;
  float shortest = unknown;
  for (const Corner& corner : corners_) {
    const float way = glm::distance(p, corner.place) + corner.way;
    if (way >= shortest || glm::distance(p, corner.place) < 1e-3f * habit_.ahead || !sees(p, corner.place)) continue;
    shortest = way;
    best = &corner;
  }
  return best;
}

// Computes the shortest ways from all corners of obstacles: Dijkstra (1959) over corners that see each other, from
// those that go straight to the target or the axis.
void Trunk::survey() {
  std::vector<Corner> all;
  for (const glm::vec3& place : obstacles_->corners())
    all.push_back({place, goes_straight(place) ? straight_way(place) : unknown});
  while (!all.empty()) {
    const auto next =
        std::min_element(all.begin(), all.end(), [](const Corner& a, const Corner& b) { return a.way < b.way; });
    if (next->way == unknown) break;
    const Corner found = *next;
    all.erase(next);
    corners_.push_back(found);
    for (Corner& other : all) {
      const float way = found.way + glm::distance(found.place, other.place);
      if (way < other.way && sees(found.place, other.place)) other.way = way;
    }
  }
}

}  // namespace panicle::particles
