#include "stems/stem_axes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/order.hpp"

namespace panicle {
namespace {

constexpr std::int32_t none = -1;
constexpr float cosine_of_fork = 0.6428f;         // 50°
constexpr float cosine_of_only_child = -0.1736f;  // 100°

// Whether all numbers of a segment are finite, and small enough for its length to be so too.
bool is_usable(const Segment& segment) {
  float sum = std::fabs(segment.radius) + std::fabs(segment.radius_end);
  for (int axis = 0; axis < 3; ++axis) sum += std::fabs(segment.start[axis]) + std::fabs(segment.end[axis]);
  return sum < 1e15f;
}

// The vector with length 1, or `otherwise` if it has no length.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

// Finder of the axes of stems: unbranched lines of segments, each of which is swept as one tube.
class Finder {
 public:
  explicit Finder(const Stems& stems) : stems_(stems), segments_(stems.segments) {}

  // Finds all axes and the nodes between their segments.
  StemAxes find() {
    set_finest();
    find_parents();
    find_successors();
    node_of_.assign(segments_.size(), 0);
    for (const std::int32_t first : axis_heads()) trace_axis(first);
    for (StemAxis& axis : result_.axes) {
      const std::int32_t parent = parents_[static_cast<std::size_t>(result_.nodes[axis.first].segment)];
      if (axis.origin.attached) axis.origin.node = node_of_[static_cast<std::size_t>(parent)];
    }
    return std::move(result_);
  }

 private:
  // Sets the finest useful length: floats of the largest coordinate are 2^−24 of it apart; a thousand such steps make a
  // ring that is round.
  void set_finest() {
    float extent = 0;
    usable_.resize(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      usable_[i] = is_usable(segments_[i]) ? 1 : 0;
      if (!usable_[i]) continue;
      for (int axis = 0; axis < 3; ++axis) {
        extent = std::max({extent, std::fabs(segments_[i].start[axis]), std::fabs(segments_[i].end[axis])});
      }
    }
    result_.finest = std::max(extent * 6e-5f, 1e-15f);
  }

  // The parent of a segment, if it is an earlier, usable segment whose end is this one's start; −1 otherwise.
  std::int32_t find_parent(std::size_t i) const {
    const Segment& segment = segments_[i];
    const std::int32_t parent = segment.parent;
    if (parent < 0 || static_cast<std::size_t>(parent) >= i || !usable_[i] || !usable_[parent]) return none;
    const glm::vec3 gap = segment.start - segments_[parent].end;
    const float allowed = std::max(result_.finest, 0.5f * segments_[parent].radius_end);
    return glm::dot(gap, gap) <= allowed * allowed ? parent : none;
  }

  // Finds parents, and a direction for every segment; one without length takes its parent's.
  void find_parents() {
    parents_.resize(segments_.size());
    directions_.resize(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      parents_[i] = find_parent(i);
      const glm::vec3 along = usable_[i] ? segments_[i].end - segments_[i].start : glm::vec3(0);
      const float length = glm::length(along);
      if (length > result_.finest)
        directions_[i] = along / length;
      else
        directions_[i] = parents_[i] == none ? glm::vec3(0, -1, 0) : directions_[parents_[i]];
    }
  }

  // Finds the segment that continues each segment: the best aligned child of the same group, unless it turns too
  // sharply.
  void find_successors() {
    successor_.assign(segments_.size(), none);
    std::vector<float> alignment(segments_.size(), -2);
    std::vector<std::uint32_t> children(segments_.size(), 0);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const std::int32_t parent = parents_[i];
      if (parent == none) continue;
      ++children[parent];
      if (stems_.group_of(parent) != stems_.group_of(i)) continue;
      const float aligned = glm::dot(directions_[parent], directions_[i]);
      if (aligned <= alignment[parent]) continue;
      alignment[parent] = aligned;
      successor_[parent] = static_cast<std::int32_t>(i);
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (successor_[i] == none) continue;
      const bool corner = children[i] == 1 && alignment[i] < stems_.corner;
      if (corner) {
        corners_.resize(segments_.size());
        corners_[i] = 1;
      }
      if (corner || alignment[i] < (children[i] == 1 ? cosine_of_only_child : cosine_of_fork)) successor_[i] = none;
    }
  }

  // The first segments of all axes, by group.
  std::vector<std::int32_t> axis_heads() const {
    std::vector<std::int32_t> found;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const bool carried_on = parents_[i] != none && successor_[parents_[i]] == static_cast<std::int32_t>(i);
      if (!carried_on && usable_[i]) found.push_back(static_cast<std::int32_t>(i));
    }
    std::vector<std::int32_t> groups, sorted;
    for (const std::int32_t head : found) groups.push_back(stems_.group_of(head));
    for (const std::uint32_t place : order_of(groups)) sorted.push_back(found[place]);
    return sorted;
  }

  // Adds the axis that begins with a segment and goes on with its successors; nodes too near the one before are left
  // out, and an axis of one node is none.
  void trace_axis(std::int32_t first) {
    std::vector<Node>& nodes = result_.nodes;
    const Segment& head = segments_[first];
    StemAxis axis;
    axis.group = stems_.group_of(first);
    axis.first = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({head.start, {}, head.radius, 0, first});
    for (std::int32_t i = first; i != none; i = successor_[i]) {
      const Segment& segment = segments_[i];
      const std::int32_t next = successor_[i];
      const float radius = next == none ? segment.radius_end : 0.5f * (segment.radius_end + segments_[next].radius);
      const float step = glm::length(segment.end - nodes.back().position);
      if (step > std::max(result_.finest, 0.25f * radius)) nodes.push_back({segment.end, {}, radius, step, i});
      node_of_[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(nodes.size()) - 1;
    }
    axis.count = static_cast<std::uint32_t>(nodes.size()) - axis.first;
    if (axis.count < 2) {
      nodes.resize(axis.first);
      return;
    }
    const std::int32_t parent = parents_[first];
    const bool corner = parent != none && is_corner(parent);
    axis.to_corner = is_corner(nodes.back().segment);
    axis.origin.corner = corner;
    if (parent != none && !corner)
      axis.origin = {true, successor_[parent] != none, false, directions_[parent], segments_[parent].radius_end};
    for (std::uint32_t i = 0; i < axis.count; ++i) {
      Node& node = nodes[axis.first + i];
      node.radius = std::max(node.radius, result_.finest);
    }
    set_tangents(axis);
    result_.axes.push_back(axis);
  }

  // Whether the axis after a segment begins at a sharp corner.
  bool is_corner(std::int32_t segment) const { return !corners_.empty() && corners_[segment] != 0; }

  // Sets the tangents of an axis' nodes. Between two segments the shorter one counts more (as in a Catmull–Rom curve
  // over lengths); a branch begins leaning towards its parent's direction, and the last segment ends straight.
  void set_tangents(const StemAxis& axis) {
    Node* node = &result_.nodes[axis.first];
    glm::vec3 before = (node[1].position - node[0].position) / node[1].length;
    node[0].tangent = axis.origin.attached ? unit_or(before + 0.25f * axis.origin.direction, before) : before;
    for (std::uint32_t i = 1; i + 1 < axis.count; ++i) {
      const glm::vec3 after = (node[i + 1].position - node[i].position) / node[i + 1].length;
      node[i].tangent = unit_or(before * node[i + 1].length + after * node[i].length, after);
      before = after;
    }
    node[axis.count - 1].tangent = before;
  }

  const Stems stems_;
  std::span<const Segment> segments_;
  std::vector<std::uint8_t> usable_;
  std::vector<std::int32_t> parents_;
  std::vector<glm::vec3> directions_;
  std::vector<std::int32_t> successor_;
  std::vector<std::uint32_t> node_of_;  // the node at which a segment ends
  std::vector<std::uint8_t> corners_;   // whether a line ends where the one that goes on begins at a corner
  StemAxes result_;
};

}  // namespace

// Divides a branched skeleton into axes, chains of segments that become one tube each.
StemAxes find_stem_axes(const Stems& stems) { return Finder(stems).find(); }

}  // namespace panicle
