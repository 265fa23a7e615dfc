#include "models/particles/axis.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint64_t stream_sway = 0x5ba7;
// Turns of the bend over the height, and its amplitude over the lean's.
constexpr float turns = 1.4f, bends = 0.6f;

}  // namespace

// Builds an axis that rises from `foot`: sampled horizontal offsets, the sum of a lean and of a sine wave, each in a
// random direction. `stray` is the offset at the top; 0 gives a straight axis.
Axis::Axis(const glm::vec3& foot, float height, float stray, std::uint64_t seed) : foot_(foot) {
  if (!(stray > 0) || !(height > 0)) return;
  piece_ = height / pieces;
  // a random angle, degrees
  const auto chance = [seed](std::uint64_t address) { return 360 * random_unit(seed, stream_sway, address); };
  // a horizontal unit vector
  const auto way = [](float degrees) {
    const auto [sine, cosine] = sincos_degrees(degrees);
    return glm::vec3(cosine, 0, sine);
  };
  const glm::vec3 lean = stray * way(chance(0)), bend = bends * stray * way(chance(1));
  const float phase = chance(2), first = sincos_degrees(phase).sine;
  for (std::uint32_t i = 0; i <= pieces; ++i) {
    const float share = static_cast<float>(i) / pieces;
    offsets_[i] = share * lean + (sincos_degrees(phase + 360 * turns * share).sine - first) * bend;
  }
}

// The point of the axis at height y, interpolated between the samples.
glm::vec3 Axis::at(float y) const {
  if (!(piece_ > 0)) return {foot_.x, y, foot_.z};
  const float along = std::min(std::fabs(y - foot_.y) / piece_, static_cast<float>(pieces));
  const auto below = std::min(static_cast<std::uint32_t>(along), pieces - 1);
  const glm::vec3 offset =
      offsets_[below] + (along - static_cast<float>(below)) * (offsets_[below + 1] - offsets_[below]);
  return {foot_.x + offset.x, y, foot_.z + offset.z};
}

// A point up to `most` from `from` on the way to `to`, which follows the bends of the axis in between.
glm::vec3 Axis::step_towards(const glm::vec3& from, const glm::vec3& to, float most) const {
  const float length = glm::distance(from, to);
  if (!(piece_ > 0) || !(length > most)) return to;
  const float share = most / length;
  const glm::vec3 straight = from + share * (to - from), chord = at(from.y) + share * (at(to.y) - at(from.y));
  return straight + at(straight.y) - chord;
}

// The horizontal distance of a point to the axis.
float Axis::distance(const glm::vec3& p) const { return glm::distance(p, at(p.y)); }

}  // namespace panicle::particles
