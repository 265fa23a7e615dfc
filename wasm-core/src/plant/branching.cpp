#include "plant/branching.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

// Sums up length, volume and surface of the segments as truncated cones, and finds their box and the thickest base.
void measure_size(std::span<const Segment> segments, Branching& found) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const Segment& segment : segments) {
    const double length = glm::distance(segment.start, segment.end), a = segment.radius, b = segment.radius_end;
    found.length += length;
    found.volume += static_cast<double>(pi) / 3 * length * (a * a + a * b + b * b);
    found.surface += static_cast<double>(pi) * (a + b) * std::sqrt(length * length + (a - b) * (a - b));
    low = glm::min(low, glm::min(segment.start, segment.end));
    high = glm::max(high, glm::max(segment.start, segment.end));
    if (segment.parent < 0) found.thickest = std::max(found.thickest, 2 * segment.radius);
  }
  if (segments.empty()) return;
  found.low = low.y;
  found.high = high.y;
  found.width_x = high.x - low.x;
  found.width_z = high.z - low.z;
}

// Finds the Strahler order of each segment, from the tips back to the base, and counts the branches of each order.
void measure_orders(std::span<const Segment> segments, Branching& found) {
  // For each segment: the highest order among its children, and whether two of them have it.
  std::vector<std::uint8_t> highest(segments.size(), 0), twice(segments.size(), 0), orders(segments.size(), 1);
  for (std::size_t i = segments.size(); i-- > 0;) {
    if (highest[i] > 0) orders[i] = static_cast<std::uint8_t>(highest[i] + twice[i]);
    found.order = std::max<std::uint32_t>(found.order, orders[i]);
    if (segments[i].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(segments[i].parent);
    if (orders[i] > highest[parent]) {
      highest[parent] = orders[i];
      twice[parent] = 0;
    } else if (orders[i] == highest[parent]) {
      twice[parent] = 1;
    }
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::int32_t parent = segments[i].parent;
    if (parent < 0 || orders[static_cast<std::size_t>(parent)] != orders[i]) ++found.of_order[orders[i] - 1u];
  }
  found.bifurcation = nothing;
  if (found.order < 2) return;
  const auto first = static_cast<float>(found.of_order[0]), last = static_cast<float>(found.of_order[found.order - 1]);
  found.bifurcation = power(first / last, 1 / static_cast<float>(found.order - 1));
}

// Counts tips and forks, and finds the mean angle between the two thickest segments of each fork.
void measure_forks(std::span<const Segment> segments, Branching& found) {
  struct Fork {
    std::uint32_t count = 0;
    std::int32_t first = -1, second = -1;  // the thickest two
  };
  std::vector<Fork> forks(segments.size());
  const auto radius = [&](std::int32_t i) { return segments[static_cast<std::size_t>(i)].radius; };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].parent < 0) continue;
    Fork& fork = forks[static_cast<std::size_t>(segments[i].parent)];
    const auto self = static_cast<std::int32_t>(i);
    ++fork.count;
    if (fork.first < 0 || segments[i].radius > radius(fork.first)) {
      fork.second = fork.first;
      fork.first = self;
    } else if (fork.second < 0 || segments[i].radius > radius(fork.second)) {
      fork.second = self;
    }
  }
  double sum = 0;
  const auto way = [&](std::int32_t i) {
    const Segment& segment = segments[static_cast<std::size_t>(i)];
    return segment.end - segment.start;
  };
  for (const Fork& fork : forks) {
    if (fork.count == 0) ++found.tips;
    if (fork.count < 2) continue;
    ++found.forks;
    const glm::vec3 one = way(fork.first), other = way(fork.second);
    const float lengths = glm::length(one) * glm::length(other);
    if (lengths > 0) sum += static_cast<double>(arc_cosine(glm::dot(one, other) / lengths));
  }
  found.fork_angle = found.forks > 0 ? static_cast<float>(sum / found.forks) * 180 / pi : nothing;
}

}  // namespace

// Measures sizes, Strahler orders and forks of a branched skeleton, in which parents come first.
Branching branching_of(std::span<const Segment> segments) {
  Branching found;
  measure_size(segments, found);
  measure_orders(segments, found);
  measure_forks(segments, found);
  return found;
}

}  // namespace panicle
