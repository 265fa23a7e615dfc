#include "geometry/stem_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace panicle {
namespace {

// Shares of the radius, chosen by eye.
constexpr float node_swelling = 0.10f;
constexpr float branch_spread = 1.2f;
constexpr float foot_spread = 0.25f;
constexpr float receptacle_spread = 0.5f;
constexpr float withered_loss = 0.45f;

// A hill of height 1 whose foot fades out: 1/4 at x = 1, 1/25 at 2.
float hill(float x) {
  const float y = 1 / (1 + x * x);
  return y * y;
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

float Thickness::at(std::size_t i, float t, float from_start) const {
  const Node& a = nodes_[i - 1];
  const Node& b = nodes_[i];
  const float step = length_to(nodes_, i);
  const float before = t * step, after = (1 - t) * step;
  float radius = a.radius + (b.radius - a.radius) * smooth(t);
  float swelling = 0;
  if (i > 1) swelling += hill(before / a.radius);
  if (i + 1 < nodes_.size()) swelling += hill(after / b.radius);
  radius *= (1 + node_swelling * swelling) * at_end(length_ - from_start - before);
  return at_start(radius, from_start + before);
}

float Thickness::at_end(float from_end) const {
  const float radius = nodes_.back().radius;
  switch (end_) {
    case End::receptacle:
      return 1 + receptacle_spread * hill(from_end / (0.9f * radius));
    case End::withered:
      return 1 - withered_loss * smooth(std::clamp(1 - from_end / (2.5f * radius), 0.0f, 1.0f));
    case End::stub:
      break;
  }
  return 1;
}

// Within its bearer a branch is the thinner of the two, so that its hidden end stays hidden.
float Thickness::at_start(float radius, float from_start) const {
  const float x = from_start / emergence_;
  if (!origin_.attached) return radius * (1 + foot_spread * hill(x));
  const float room = std::max(origin_.radius, 0.1f * nodes_[0].radius) * (0.8f + x);
  return std::min(radius * (1 + branch_spread * hill(x)), room);
}

}  // namespace panicle
