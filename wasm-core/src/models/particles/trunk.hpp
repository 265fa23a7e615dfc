// The guide of a tree's particles: to its trunk, and down the trunk to the ground; and of a root's, upwards in the same
// way.
#pragma once

#include <cstdint>
#include <vector>

#include "models/particles/axis.hpp"
#include "models/particles/guide.hpp"
#include "models/particles/obstacles.hpp"
#include "spatial/region.hpp"

namespace panicle::particles {

struct TrunkHabit {
  // distance that a particle aims lower, over its distance from the axis: 1 a clear leader, 2 decurrent
  float slant = 1;
  float ahead = 0;  // how far a particle on the axis looks along it
  float bole = 0;   // distance from the target within which no particle comes to the axis
  float way = -1;   // −1 where particles come down from above, 1 where they come up
  glm::vec3 bend{
      0};  // added to the direction of places `reach` away from the axis or farther, less and less towards it
  float reach = 1;
  float height = 0;  // of all that is on the axis
  float sway = 0;    // how far the axis strays from upright, over that height
};

// Each particle aims at the axis above the target, lower than itself by a given amount: a single point would fork low
// and leave no leader. Limbs cross the space between the boundaries and the inner boundary; they leave the outer one
// only on the way down, and never go beyond the height of the target: the ground.
class Trunk final : public Guide {
 public:
  // `outer` and `obstacles` must outlive it; either may be null.
  Trunk(const Axis& axis, const TrunkHabit& habit, const Region* outer = nullptr, const Obstacles* obstacles = nullptr);
  Trunk(const glm::vec3& foot, const TrunkHabit& habit, const Region* outer = nullptr,
        const Obstacles* obstacles = nullptr)
      : Trunk(Axis(foot), habit, outer, obstacles) {}

  glm::vec3 aim(const glm::vec3& p) const override;
  float way(const glm::vec3& p) const override;
  // Whether a point is outside all obstacles.
  bool open(const glm::vec3& p) const override { return obstacles_ == nullptr || !obstacles_->contains(p); }
  // Whether no obstacle is between two points.
  bool sees(const glm::vec3& a, const glm::vec3& b) const override {
    return obstacles_ == nullptr || !obstacles_->between(a, b);
  }
  bool sees_all() const override { return obstacles_ == nullptr || obstacles_->empty(); }
  bool passes(const glm::vec3& from, const glm::vec3& to) const override;
  // Whether a particle at `p` can reach the target at all.
  bool reaches(const glm::vec3& p) const;

 private:
  struct Corner {
    glm::vec3 place;
    float way;  // from there to the target
  };

  glm::vec3 to_axis(const glm::vec3& p) const;
  float straight_way(const glm::vec3& p) const;
  // Whether the way from a point to the axis and down it to the target is free.
  bool goes_straight(const glm::vec3& p) const { return sees(p, to_axis(p)) && sees(to_axis(p), target()); }
  const Corner* turning(const glm::vec3& p) const;
  void survey();

  Axis axis_;
  TrunkHabit habit_;
  const Region* outer_;
  const Obstacles* obstacles_;
  std::vector<Corner> corners_;  // of obstacles, from which a way is known
};

}  // namespace panicle::particles
