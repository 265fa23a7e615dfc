// The targets of particles, and the obstacles in their way.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace panicle::particles {

class Guide {
 public:
  explicit Guide(const glm::vec3& target) : target_(target) {}
  virtual ~Guide() = default;
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;

  // Where trails end.
  const glm::vec3& target() const { return target_; }
  // The point that a particle at `p` aims at, on its way to the target or the target itself.
  virtual glm::vec3 aim(const glm::vec3& p) const = 0;
  // The estimated length of the way from `p` to the target; never less than the straight line.
  virtual float way(const glm::vec3& p) const { return glm::distance(p, target_); }
  // Whether a particle may be there.
  virtual bool open(const glm::vec3&) const { return true; }
  // Whether a step may be taken. A particle that is outside already may stay there.
  virtual bool passes(const glm::vec3& from, const glm::vec3& to) const { return open(to) || !open(from); }
  // A radius around the place without obstacles; 0 if unknown.
  virtual float room(const glm::vec3&) const { return 0; }
  // Whether there are no obstacles: all places are open and see each other.
  virtual bool sees_all() const { return false; }
  // Whether no obstacle is between two places.
  virtual bool sees(const glm::vec3&, const glm::vec3&) const { return true; }

 private:
  glm::vec3 target_;
};

// The guide straight to the target.
class Straight final : public Guide {
 public:
  using Guide::Guide;
  glm::vec3 aim(const glm::vec3&) const override { return target(); }
};

}  // namespace panicle::particles
