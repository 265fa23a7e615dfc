#include "stems/stem_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/easing.hpp"

namespace panicle {
namespace {

// Shares of the radius, chosen by eye.
constexpr float between_nodes = 0.86f;
constexpr float node_swelling = 0.16f;
constexpr float foot_spread = 0.2f;
constexpr float widest_in_parent = 0.88f;
constexpr float collar_width = 0.2f;
constexpr float max_blend = 0.9f;
// Lengthening of a branch's foot along its parent, where the parent continues and where it ends.
constexpr float foot_length = 1.1f;    // along the parent where it goes on,
constexpr float collar_length = 0.5f;  // and where it ends

// A hill of height 1 at x = 0 that ends at x = ±1.5.
float wide_hill(float x) { return hill(x, 1 / 2.25f); }

// A ridge of height 1 at x = 1, from 0 at 0 to 0 at the collar's end.
constexpr float collar_end = 2.4f;
// A ridge of height 1 at x = 1, from 0 at x = 0 to 0 at the collar's end.
float ridge(float x) { return smooth(x < 1 ? x : (collar_end - x) / (collar_end - 1)); }

}  // namespace

// Finds how far from its start the branch comes out of its parent's surface: the farther, the narrower the angle
// between both.
Thickness::Thickness(std::span<const Node> nodes, const Origin& origin, const StemEnd& end, const ThicknessForm& form)
    : nodes_(nodes), origin_(origin), end_(end), form_(form) {
  for (const Node& node : nodes) length_ += node.length;
  emergence_ = 1.5f * nodes[0].radius;
  if (origin.attached) {
    const glm::vec3 across = glm::cross(nodes[1].position - nodes[0].position, origin.direction);
    const float sine = glm::length(across) / nodes[1].length;
    emergence_ = std::max(origin.radius, 0.1f * nodes[0].radius) / std::max(sine, 0.5f);
  }
  per_emergence_ = 1 / emergence_;
  per_end_radius_ = 1 / nodes.back().radius;
}

// Moves on to the segment before node i.
void Thickness::enter(std::size_t i) {
  constexpr float extent = 1.2f;  // of a node, in radii
  const Node& a = nodes_[i - 1];
  const Node& b = nodes_[i];
  from_start_ += step_;
  step_ = b.length;
  radius_ = a.radius;
  gain_ = b.radius - a.radius;
  if (form_.tapering) {
    taper_ = step_ * taper_at(i - 1);
    next_taper_ = step_ * taper_at(i);
  }
  per_swelling_ = step_ / (extent * a.radius);
  per_next_swelling_ = step_ / (extent * b.radius);
}

// The radius' slope at a node: the harmonic mean of the slopes on both sides, 0 where their signs differ, so that the
// radius is monotone.
float Thickness::taper_at(std::size_t node) const {
  const auto between = [&](std::size_t i) { return (nodes_[i].radius - nodes_[i - 1].radius) / nodes_[i].length; };
  if (node == 0) return between(1);
  if (node + 1 == nodes_.size()) return between(node);
  const float before = between(node), after = between(node + 1);
  return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

// The cross-section at the share t of the current segment: the radius is a cubic between both nodes (Hermite with the
// tapers as slopes), with swellings at the nodes.
Section Thickness::at(float t) const {
  float radius = radius_ + gain_ * smooth(t);
  if (form_.tapering) radius += t * (1 - t) * ((1 - t) * taper_ - t * next_taper_);
  if (form_.jointed) {
    const float swelling = wide_hill(t * per_swelling_) + wide_hill((1 - t) * per_next_swelling_);
    radius *= between_nodes + node_swelling * swelling;
  }
  const float from_start = from_start_ + t * step_;
  const float from_end = length_ - from_start;
  return collar(radius * end_factor(from_end), from_start, from_end);
}

// The factor of the radius near the axis' end, by the distance from it: a narrower tip and a flare.
float Thickness::end_factor(float from_end) const {
  const float x = from_end * per_end_radius_;
  float factor = end_.body;
  if (end_.tip != end_.body) factor -= (end_.body - end_.tip) * smooth(std::clamp(1 - x / 2, 0.0f, 1.0f));
  if (end_.flare != 0) factor += end_.flare * wide_hill((x - 0.35f) / 0.45f);
  return factor;
}

// The cross-section near the parent. Where the parent continues, a branch begins with an ellipse along the parent's
// axis and rises from it like a fillet. Where the parent ends, that would protrude: the branch is widest at the
// parent's surface then. Across the plane of both it is never wider than the parent.
Section Thickness::collar(float radius, float from_start, float from_end) const {
  const float x = from_start * per_emergence_;
  if (form_.foot == Foot::plain) return {radius, radius, 0, 0};
  if (form_.foot == Foot::inside) {
    const float room = widest_in_parent * origin_.radius + std::max(0.0f, from_start - emergence_);
    const float narrow = std::min(radius, std::max(room, 0.1f * radius));
    return {narrow, narrow, 0, 0};
  }
  if (!origin_.attached && !origin_.corner) radius *= 1 + foot_spread * wide_hill(x);
  if (!origin_.attached || x >= collar_end) return {radius, radius, 0, 0};
  const float fade = smooth(std::min(1.0f, from_end * per_end_radius_ * (1 / 1.5f)));
  const float lean = origin_.passing ? fade * smooth(std::max(0.0f, 1 - x / collar_end)) : 0;
  const float length = origin_.passing ? foot_length * lean * lean : fade * collar_length * ridge(x);
  const float room = widest_in_parent * origin_.radius + std::max(0.0f, from_start - emergence_);
  const float narrow = std::min(radius * (1 + fade * collar_width * ridge(x)), std::max(room, 0.1f * radius));
  const float blend = origin_.passing ? max_blend * fade * smooth(std::clamp(2 - x, 0.0f, 1.0f)) : 0;
  return {std::max(narrow, radius * (1 + length)), narrow, lean, blend};
}

}  // namespace panicle
