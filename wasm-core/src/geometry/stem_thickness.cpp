#include "geometry/stem_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace panicle {
namespace {

// Shares of the radius, chosen by eye.
constexpr float between_nodes = 0.86f;
constexpr float node_swelling = 0.16f;
constexpr float foot_spread = 0.2f;
constexpr float widest_in_bearer = 0.97f;
constexpr float collar_width = 0.2f;
constexpr float foot_length = 1.1f;    // along the bearer where it goes on,
constexpr float collar_length = 0.5f;  // and where it ends
constexpr float receptacle_spread = 0.35f;
constexpr float withered_body = 0.75f, withered_tip = 0.5f;

// A hill of height 1 whose foot fades out: 1/4 at x = 1, 1/25 at 2.
float hill(float x) {
  const float y = 1 / (1 + x * x);
  return y * y;
}

// A ridge of height 1 at x = 1 that begins with 0 at 0: 0.4 at 2, 0.1 at 3.
float ridge(float x) {
  const float y = 2 * x / (1 + x * x);
  return y * y * y * y;
}

float smooth(float t) { return t * t * (3 - 2 * t); }

float length_to(std::span<const Node> nodes, std::size_t i) {
  return glm::length(nodes[i].position - nodes[i - 1].position);
}

}  // namespace

Thickness::Thickness(std::span<const Node> nodes, const Origin& origin, End end)
    : nodes_(nodes), origin_(origin), end_(end) {
  for (std::size_t i = 1; i < nodes.size(); ++i) length_ += length_to(nodes, i);
  if (!origin.attached) {
    emergence_ = 1.5f * nodes[0].radius;
    return;
  }
  const glm::vec3 across = glm::cross(nodes[1].position - nodes[0].position, origin.direction);
  const float sine = glm::length(across) / length_to(nodes, 1);
  emergence_ = std::max(origin.radius, 0.1f * nodes[0].radius) / std::max(sine, 0.5f);
}

Section Thickness::at(std::size_t i, float t, float from_start) const {
  const Node& a = nodes_[i - 1];
  const Node& b = nodes_[i];
  const float step = length_to(nodes_, i);
  const float before = t * step, after = (1 - t) * step;
  const float swelling = hill(before / (1.2f * a.radius)) + hill(after / (1.2f * b.radius));
  const float radius = (a.radius + (b.radius - a.radius) * smooth(t)) * (between_nodes + node_swelling * swelling);
  const float from_end = length_ - from_start - before;
  return collar(radius * end_factor(from_end), from_start + before, from_end);
}

float Thickness::end_factor(float from_end) const {
  const float x = from_end / nodes_.back().radius;
  switch (end_) {
    case End::receptacle:
      return 1 + receptacle_spread * hill((x - 0.35f) / 0.45f);
    case End::withered:
      return withered_body - (withered_body - withered_tip) * smooth(std::clamp(1 - x / 2, 0.0f, 1.0f));
    case End::stub:
      break;
  }
  return 1;
}

// Where the bearer goes on, a branch stands on an ellipse along the bearer's axis and rises from it like a fillet.
// Where the bearer ends, that would stick out; the branch is widest at the bearer's surface then. Across the plane of
// both there is no room beyond the bearer's own width.
Section Thickness::collar(float radius, float from_start, float from_end) const {
  const float x = from_start / emergence_;
  if (!origin_.attached) {
    radius *= 1 + foot_spread * hill(x);
    return {radius, radius, 0};
  }
  const float fade = smooth(std::min(1.0f, from_end / (1.5f * nodes_.back().radius)));
  const float lean = origin_.passing ? fade * smooth(std::max(0.0f, 1 - x / 2.4f)) : 0;
  const float length = origin_.passing ? foot_length * lean * lean : fade * collar_length * ridge(x);
  const float room = widest_in_bearer * origin_.radius + std::max(0.0f, from_start - emergence_);
  const float narrow = std::min(radius * (1 + fade * collar_width * ridge(x)), std::max(room, 0.1f * radius));
  return {std::max(narrow, radius * (1 + length)), narrow, lean};
}

}  // namespace panicle
