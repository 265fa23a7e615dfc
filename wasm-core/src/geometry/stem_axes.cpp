#include "geometry/stem_axes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace panicle {
namespace {

constexpr std::int32_t none = -1;
constexpr float cosine_of_fork = 0.6428f;         // 50°
constexpr float cosine_of_only_child = -0.1736f;  // 100°

// Finite, and small enough for lengths to be so too.
bool usable(const Internode& internode) {
  float sum = std::fabs(internode.radius) + std::fabs(internode.radius_end);
  for (int axis = 0; axis < 3; ++axis) sum += std::fabs(internode.start[axis]) + std::fabs(internode.end[axis]);
  return sum < 1e15f;
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

class Finder {
 public:
  explicit Finder(std::span<const Internode> skeleton) : skeleton_(skeleton) {}

  StemAxes find() {
    measure();
    relate();
    successors();
    for (const std::int32_t first : heads()) trace(first);
    return std::move(result_);
  }

 private:
  // Floats of the largest coordinate are 2^−24 of it apart; a thousand steps make a ring that is round.
  void measure() {
    float extent = 0;
    usable_.resize(skeleton_.size());
    for (std::size_t i = 0; i < skeleton_.size(); ++i) {
      usable_[i] = usable(skeleton_[i]) ? 1 : 0;
      if (!usable_[i]) continue;
      for (int axis = 0; axis < 3; ++axis) {
        extent = std::max({extent, std::fabs(skeleton_[i].start[axis]), std::fabs(skeleton_[i].end[axis])});
      }
    }
    result_.finest = std::max(extent * 6e-5f, 1e-15f);
  }

  // The parent, if it is an earlier, usable internode whose end is this one's start.
  std::int32_t find_parent(std::size_t i) const {
    const Internode& internode = skeleton_[i];
    const std::int32_t parent = internode.parent;
    if (parent < 0 || static_cast<std::size_t>(parent) >= i || !usable_[i] || !usable_[parent]) return none;
    const glm::vec3 gap = internode.start - skeleton_[parent].end;
    const float allowed = std::max(result_.finest, 0.5f * skeleton_[parent].radius_end);
    return glm::dot(gap, gap) <= allowed * allowed ? parent : none;
  }

  // Parents, and a direction for every internode; one without length takes its parent's.
  void relate() {
    parents_.resize(skeleton_.size());
    directions_.resize(skeleton_.size());
    for (std::size_t i = 0; i < skeleton_.size(); ++i) {
      parents_[i] = find_parent(i);
      const glm::vec3 along = usable_[i] ? skeleton_[i].end - skeleton_[i].start : glm::vec3(0);
      const float length = glm::length(along);
      if (length > result_.finest)
        directions_[i] = along / length;
      else
        directions_[i] = parents_[i] == none ? glm::vec3(0, -1, 0) : directions_[parents_[i]];
    }
  }

  void successors() {
    successor_.assign(skeleton_.size(), none);
    std::vector<float> alignment(skeleton_.size(), -2);
    std::vector<std::uint32_t> children(skeleton_.size(), 0);
    for (std::size_t i = 0; i < skeleton_.size(); ++i) {
      const std::int32_t parent = parents_[i];
      if (parent == none) continue;
      ++children[parent];
      if (skeleton_[parent].axis != skeleton_[i].axis) continue;
      const float aligned = glm::dot(directions_[parent], directions_[i]);
      if (aligned <= alignment[parent]) continue;
      alignment[parent] = aligned;
      successor_[parent] = static_cast<std::int32_t>(i);
    }
    for (std::size_t i = 0; i < skeleton_.size(); ++i) {
      if (alignment[i] < (children[i] == 1 ? cosine_of_only_child : cosine_of_fork)) successor_[i] = none;
    }
  }

  // The first internodes of all axes, by part.
  std::vector<std::int32_t> heads() const {
    std::vector<std::int32_t> found;
    for (std::size_t i = 0; i < skeleton_.size(); ++i) {
      const bool carried_on = parents_[i] != none && successor_[parents_[i]] == static_cast<std::int32_t>(i);
      if (!carried_on && usable_[i]) found.push_back(static_cast<std::int32_t>(i));
    }
    std::stable_sort(found.begin(), found.end(),
                     [this](std::int32_t a, std::int32_t b) { return skeleton_[a].axis < skeleton_[b].axis; });
    return found;
  }

  void trace(std::int32_t first) {
    std::vector<Node>& nodes = result_.nodes;
    const Internode& head = skeleton_[first];
    StemAxis axis;
    axis.axis = head.axis;
    axis.first = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({head.start, {}, head.radius, 0, first});
    for (std::int32_t i = first; i != none; i = successor_[i]) {
      const Internode& internode = skeleton_[i];
      const std::int32_t next = successor_[i];
      const float radius = next == none ? internode.radius_end : 0.5f * (internode.radius_end + skeleton_[next].radius);
      const float step = glm::length(internode.end - nodes.back().position);
      if (step > std::max(result_.finest, 0.25f * radius)) nodes.push_back({internode.end, {}, radius, step, i});
    }
    axis.count = static_cast<std::uint32_t>(nodes.size()) - axis.first;
    if (axis.count < 2) {
      nodes.resize(axis.first);
      return;
    }
    const std::int32_t parent = parents_[first];
    if (parent != none)
      axis.origin = {true, successor_[parent] != none, directions_[parent], skeleton_[parent].radius_end};
    for (std::uint32_t i = 0; i < axis.count; ++i) {
      Node& node = nodes[axis.first + i];
      node.radius = std::max(node.radius, result_.finest);
    }
    bend(axis);
    result_.axes.push_back(axis);
  }

  // Tangents: at a node between two internodes the shorter one counts more (as in a Catmull–Rom curve over lengths);
  // a branch sets out leaning towards its bearer's direction, and the last internode ends straight.
  void bend(const StemAxis& axis) {
    Node* node = &result_.nodes[axis.first];
    glm::vec3 before = (node[1].position - node[0].position) / node[1].step;
    node[0].tangent = axis.origin.attached ? unit_or(before + 0.25f * axis.origin.direction, before) : before;
    for (std::uint32_t i = 1; i + 1 < axis.count; ++i) {
      const glm::vec3 after = (node[i + 1].position - node[i].position) / node[i + 1].step;
      node[i].tangent = unit_or(before * node[i + 1].step + after * node[i].step, after);
      before = after;
    }
    node[axis.count - 1].tangent = before;
  }

  std::span<const Internode> skeleton_;
  std::vector<std::uint8_t> usable_;
  std::vector<std::int32_t> parents_;
  std::vector<glm::vec3> directions_;
  std::vector<std::int32_t> successor_;
  StemAxes result_;
};

}  // namespace

StemAxes find_stem_axes(std::span<const Internode> skeleton) { return Finder(skeleton).find(); }

}  // namespace panicle
