#include "models/bunch/natural/settling/sagging.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

constexpr float grams_per_volume = 1.06e-3f;  // mass of a cubic millimetre of berry
constexpr float softness = 1e-4f;      // radians a gram, mm of lever and of length, at a radius of 1 mm, of the total
constexpr float max_bent = 0.5f;       // radians; upper bound that no branch reaches
constexpr float turned_round = -0.9f;  // cosine: an axis that would have to turn further up stays as it is
constexpr float limp = 0.75f;          // how far down a level pedicel is drawn, over its own length
constexpr float limper = 0.25f;        // more where it points up, less where it hangs already
constexpr float hung_at = 0.5f;        // size of a berry, over ripe, at which it has drawn its stem all the way down

const glm::quat straight(1, 0, 0, 0);

// How far stems have been drawn down, 0 … 1, while berries are `size` times as wide as ripe ones.
float share_of_droop(float size) { return std::min(1.0f, size / hung_at); }

// The mass of a ripe berry, grams.
float mass_of(const Swelling& berry) {
  return grams_per_volume * (4.0f / 3) * pi * berry.half_width * berry.half_width * berry.half_length;
}

// The centre of a ripe berry where the text draws it.
glm::vec3 centre_of(const Branch& branch, const Swelling& berry) {
  return branch.end + berry.heading * (berry.stalk + berry.half_length);
}

// A rotation (quaternion) by a small angle about a unit vector; the sine is the first two terms of its series.
glm::quat slight_turn(const glm::vec3& axis, float radians) {
  const float half = radians / 2, sine = half - half * half * half / 6;
  return {std::sqrt(1 - sine * sine), axis * sine};
}

// The least rotation from one direction to another; none where they are about opposite, or 0.
glm::quat least_turn(const glm::vec3& from, const glm::vec3& to) {
  const float length_product = glm::length(from) * glm::length(to);
  if (!(length_product > 1e-6f)) return straight;
  const float cosine = glm::dot(from, to) / length_product;
  return cosine < turned_round ? straight
                               : glm::normalize(glm::quat(1 + cosine, glm::cross(from, to) / length_product));
}

}  // namespace

// Computes the bends of all branches under ripe berries, and the turns that compensate for them.
Sagging::Sagging(std::span<const Branch> branches, std::span<const Swelling> berries)
    : branches_(branches),
      bends_(branches.size(), 0),
      axes_(branches.size(), glm::vec3(1, 0, 0)),
      braced_(branches.size(), straight),
      turned_(branches.size(), straight) {
  load(berries);
  brace(berries);
}

// Computes how far and about which level axis each branch bends under the berries beyond its start: moment × length /
// radius⁴, with an upper bound that is approached smoothly.
void Sagging::load(std::span<const Swelling> berries) {
  std::vector<float> masses(branches_.size(), 0);
  std::vector<glm::vec3> moments(branches_.size(), glm::vec3(0));
  for (const Swelling& berry : berries) {
    if (berry.late) continue;
    masses[berry.branch] += mass_of(berry);
    moments[berry.branch] += mass_of(berry) * centre_of(branches_[berry.branch], berry);
  }
  for (std::size_t k = branches_.size(); k-- > 0;) {
    const Branch& branch = branches_[k];
    if (branch.parent >= 0) {
      masses[static_cast<std::size_t>(branch.parent)] += masses[k];
      moments[static_cast<std::size_t>(branch.parent)] += moments[k];
    }
    const glm::vec3 lever = moments[k] - masses[k] * branch.start, axis(lever.z, 0, -lever.x);
    const float moment = glm::length(axis), radius_squared = branch.radius * branch.radius;
    if (!branch.sags || !(moment > 1e-6f) || !(radius_squared > 0)) continue;
    const float bend =
        branch.give * softness * moment * glm::length(branch.end - branch.start) / (radius_squared * radius_squared);
    bends_[k] = bend / (1 + bend / max_bent);
    axes_[k] = axis / moment;
  }
}

// Turns each axis back so that its berries hang, on average, in the direction in which the text draws them.
void Sagging::brace(std::span<const Swelling> berries) {
  const std::span<const glm::quat> bent = turned(1);
  std::vector<float> heads(branches_.size(), 0);
  for (const Swelling& berry : berries) heads[berry.branch] += berry.late ? 0.0f : 1.0f;
  // By axis, the mean place of its berries: as the text draws them, and bent.
  std::vector<glm::vec3> ends(branches_.size()), before(branches_.size(), glm::vec3(0)), after = before;
  std::vector<std::int32_t> axis_of(branches_.size(), -1);
  for (std::size_t k = 0; k < branches_.size(); ++k) {
    const Branch& branch = branches_[k];
    const auto parent = static_cast<std::size_t>(branch.parent);
    const glm::vec3 start = branch.parent < 0 ? branch.start : ends[parent];
    ends[k] = start + bent[k] * (branch.end - branch.start);
    if (!branch.sags) continue;
    const bool first = branch.parent < 0 || axis_of[parent] < 0;
    axis_of[k] = first ? static_cast<std::int32_t>(k) : axis_of[parent];
    const auto axis = static_cast<std::size_t>(axis_of[k]);
    const std::int32_t axis_parent = branches_[axis].parent;
    before[axis] += heads[k] * (branch.end - branches_[axis].start);
    after[axis] +=
        heads[k] * (ends[k] - (axis_parent < 0 ? branches_[axis].start : ends[static_cast<std::size_t>(axis_parent)]));
  }
  for (std::size_t k = 0; k < branches_.size(); ++k)
    if (axis_of[k] == static_cast<std::int32_t>(k)) braced_[k] = least_turn(after[k], before[k]);
  turned_by_ = -1;
}

// The rotation of each branch while berries are `size` times as wide as ripe ones: its own bend, its bracing and its
// parent's rotation. The bend grows with the berries' mass, the cube of their size.
std::span<const glm::quat> Sagging::turned(float size) {
  const float share = share_of_droop(size), weight = share * share * share;
  if (weight == turned_by_) return turned_;
  turned_by_ = weight;
  for (std::size_t k = 0; k < branches_.size(); ++k) {
    const Branch& branch = branches_[k];
    const glm::quat parent_turn = branch.parent < 0 ? straight : turned_[static_cast<std::size_t>(branch.parent)];
    turned_[k] = bends_[k] > 0 ? slight_turn(axes_[k], weight * bends_[k]) * braced_[k] * parent_turn : parent_turn;
  }
  return turned_;
}

// The direction in which a pedicel that grew along `heading`, a unit vector, hangs while its berry is `size` times as
// wide as ripe.
glm::vec3 drooping(const glm::vec3& heading, float size) {
  const float share = share_of_droop(size);
  const glm::vec3 direction = heading - glm::vec3(0, (limp + limper * heading.y) * share * share, 0);
  const float length = glm::length(direction);
  return length > 1e-3f ? direction / length : glm::vec3(0, -1, 0);
}

}  // namespace panicle::bunch
