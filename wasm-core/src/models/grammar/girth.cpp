#include "models/grammar/girth.hpp"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "foundation/mathematics.hpp"
#include "models/grammar/sketch.hpp"

namespace panicle::grammar {
namespace {

// Whether the text has given the line no width: its radius is the tiny mark `no_width`.
bool has_no_width(const Segment& segment) { return segment.radius > 0 && segment.radius < 1e6f * no_width; }

// Width of a line whose width is set to 0, as a share of the thinnest line without a width.
constexpr float hairline = 0.1f;

// The number of tips above each segment; 1 for a tip.
std::vector<std::uint32_t> tips_of(std::span<const Segment> segments) {
  std::vector<std::uint32_t> tips(segments.size(), 0);
  for (std::size_t i = segments.size(); i-- > 0;) {
    if (tips[i] == 0) tips[i] = 1;
    if (segments[i].parent >= 0) tips[segments[i].parent] += tips[i];
  }
  return tips;
}

// The length that widths are a share of: the mean length of lines; for plants of very many lines a share of the plant's
// extent, so that its lines are visible.
float measure_of(std::span<const Segment> segments, double length) {
  constexpr float lines_across = 16, most = 3.75f;
  glm::vec3 low = segments[0].start, high = low;
  for (const Segment& segment : segments) {
    low = glm::min(low, glm::min(segment.start, segment.end));
    high = glm::max(high, glm::max(segment.start, segment.end));
  }
  const glm::vec3 size = high - low;
  const float mean = static_cast<float>(length / static_cast<double>(segments.size()));
  return std::clamp(std::max({size.x, size.y, size.z}) / lines_across, mean, most * mean);
}

}  // namespace

// Sets the radii of lines without a width: the thinnest at the tips, then growing as a power of the number of tips that
// a line carries (Murray, da Vinci). Given widths are multiplied by a factor.
void thicken(std::span<Segment> segments, const Girth& girth) {
  double length = 0;
  bool any = false;
  for (Segment& segment : segments) {
    length += glm::distance(segment.start, segment.end);
    const bool open = has_no_width(segment) || segment.radius == 0;
    any = any || open;
    if (open) continue;
    segment.radius *= girth.width_factor;
    segment.radius_end *= girth.width_factor;
  }
  if (!any) return;
  const float thinnest = 0.5f * girth.tip * measure_of(segments, length);
  const std::vector<std::uint32_t> tips = tips_of(segments);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Segment& segment = segments[i];
    if (segment.radius == 0) segment.radius = segment.radius_end = hairline * thinnest;
    if (!has_no_width(segment)) continue;
    segment.radius = segment.radius_end =
        tips[i] == 1 ? thinnest : thinnest * power(static_cast<float>(tips[i]), girth.thickening);
  }
}

}  // namespace panicle::grammar
