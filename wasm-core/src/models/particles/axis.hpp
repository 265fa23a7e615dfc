// The line that a trunk or a main root follows: upright from its foot, or swaying about that line.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle::particles {

class Axis {
 public:
  // An upright axis.
  explicit Axis(const glm::vec3& foot) : foot_(foot) {}
  // Leans and bends by about `stray` on the way to `height` above or below the foot; the direction depends on the seed.
  Axis(const glm::vec3& foot, float height, float stray, std::uint64_t seed);

  const glm::vec3& foot() const { return foot_; }
  // The point at the height y.
  glm::vec3 at(float y) const;
  // The point at most `most` from `from` towards `to`, displaced sideways as the axis is from its own chord; `to`
  // itself where it is nearer, without displacement where the axis is straight.
  glm::vec3 step_towards(const glm::vec3& from, const glm::vec3& to, float most) const;
  // Distance from the axis at the place's height.
  float distance(const glm::vec3& p) const;

 private:
  static constexpr std::uint32_t pieces = 24;

  glm::vec3 foot_;
  float piece_ = 0;  // of the height; 0: upright
  std::array<glm::vec3, pieces + 1> offsets_{};
};

}  // namespace panicle::particles
