#include "models/bunch/natural/settling/sagging.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

constexpr float grams_per_volume = 1.06e-3f;  // mass of a cubic millimetre of berry
constexpr float softness = 1e-4f;      // radians a gram, mm of lever and of length, at a radius of 1 mm, of the total
constexpr float most_bent = 0.5f;      // radians; upper bound that no branch reaches
constexpr float turned_round = -0.9f;  // cosine: an axis that would have to turn further up stays as it is
constexpr float limp = 0.75f;          // how far down a level pedicel is drawn, over its own length
constexpr float limper = 0.25f;        // more where it points up, less where it hangs already
constexpr float hung_at = 0.5f;        // size of a berry, over ripe, at which it has drawn its stem all the way down

const glm::quat straight(1, 0, 0, 0);

float drawn_down(float size) { return std::min(1.0f, size / hung_at); }

float grams(const Swelling& berry) {
  return grams_per_volume * (4.0f / 3) * pi * berry.half_width * berry.half_width * berry.half_length;
}

glm::vec3 hangs_at(const Branch& branch, const Swelling& berry) {
  return branch.end + berry.heading * (berry.stalk + berry.half_length);
}

// A rotation by a small angle about a unit vector.
glm::quat slight_turn(const glm::vec3& axis, float radians) {
  const float half = radians / 2, sine = half - half * half * half / 6;
  return {std::sqrt(1 - sine * sine), axis * sine};
}

// The least rotation from one direction to another; none where they are about opposite, or 0.
glm::quat least_turn(const glm::vec3& from, const glm::vec3& to) {
  const float far = glm::length(from) * glm::length(to);
  if (!(far > 1e-6f)) return straight;
  const float cosine = glm::dot(from, to) / far;
  return cosine < turned_round ? straight : glm::normalize(glm::quat(1 + cosine, glm::cross(from, to) / far));
}

}  // namespace

Sagging::Sagging(std::span<const Branch> branches, std::span<const Swelling> berries)
    : branches_(branches),
      bends_(branches.size(), 0),
      axes_(branches.size(), glm::vec3(1, 0, 0)),
      braced_(branches.size(), straight),
      turned_(branches.size(), straight) {
  load(berries);
  brace(berries);
}

void Sagging::load(std::span<const Swelling> berries) {
  std::vector<float> masses(branches_.size(), 0);
  std::vector<glm::vec3> moments(branches_.size(), glm::vec3(0));
  for (const Swelling& berry : berries) {
    if (berry.late) continue;
    masses[berry.branch] += grams(berry);
    moments[berry.branch] += grams(berry) * hangs_at(branches_[berry.branch], berry);
  }
  for (std::size_t k = branches_.size(); k-- > 0;) {
    const Branch& branch = branches_[k];
    if (branch.parent >= 0) {
      masses[static_cast<std::size_t>(branch.parent)] += masses[k];
      moments[static_cast<std::size_t>(branch.parent)] += moments[k];
    }
    const glm::vec3 lever = moments[k] - masses[k] * branch.start, axis(lever.z, 0, -lever.x);
    const float much = glm::length(axis), square = branch.radius * branch.radius;
    if (!branch.sags || !(much > 1e-6f) || !(square > 0)) continue;
    const float bend = branch.give * softness * much * glm::length(branch.end - branch.start) / (square * square);
    bends_[k] = bend / (1 + bend / most_bent);
    axes_[k] = axis / much;
  }
}

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

std::span<const glm::quat> Sagging::turned(float size) {
  const float much = drawn_down(size), weight = much * much * much;
  if (weight == turned_by_) return turned_;
  turned_by_ = weight;
  for (std::size_t k = 0; k < branches_.size(); ++k) {
    const Branch& branch = branches_[k];
    const glm::quat parent_turn = branch.parent < 0 ? straight : turned_[static_cast<std::size_t>(branch.parent)];
    turned_[k] = bends_[k] > 0 ? slight_turn(axes_[k], weight * bends_[k]) * braced_[k] * parent_turn : parent_turn;
  }
  return turned_;
}

glm::vec3 drooping(const glm::vec3& heading, float size) {
  const float much = drawn_down(size);
  const glm::vec3 way = heading - glm::vec3(0, (limp + limper * heading.y) * much * much, 0);
  const float far = glm::length(way);
  return far > 1e-3f ? way / far : glm::vec3(0, -1, 0);
}

}  // namespace panicle::bunch
