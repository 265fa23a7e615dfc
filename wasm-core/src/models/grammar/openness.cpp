#include "models/grammar/openness.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::grammar {
namespace {

constexpr std::uint32_t cells = 32, directions = 32;

VoxelLight light_of(const std::vector<Segment>& segments, const std::vector<Screen>& screens) {
  glm::vec3 low(1e30f), high(-1e30f);
  const auto hold = [&](const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  };
  for (const Segment& segment : segments) {
    hold(segment.start);
    hold(segment.end);
  }
  for (const Screen& screen : screens) hold(screen.place);
  if (!(low.x <= high.x)) low = high = glm::vec3(0);
  const glm::vec3 size = high - low;
  const float edge = std::max({size.x, size.y, size.z, 1e-6f}) / static_cast<float>(cells);
  const glm::ivec3 count = glm::ivec3(size / edge) + 1;
  std::vector<float> matter(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                            static_cast<std::size_t>(count.z));
  const float cell = 1 / (edge * edge * edge);
  const auto put_in = [&](const glm::vec3& p, float area) {
    const glm::ivec3 at = glm::clamp(glm::ivec3((p - low) / edge), glm::ivec3(0), count - 1);
    matter[static_cast<std::size_t>((at.z * count.y + at.y) * count.x + at.x)] += area * cell;
  };
  // A rod hides a quarter of its surface.
  for (const Segment& segment : segments)
    put_in(0.5f * (segment.start + segment.end),
           0.25f * pi * (segment.radius + segment.radius_end) * glm::distance(segment.start, segment.end));
  for (const Screen& screen : screens) put_in(screen.place, screen.area);
  const auto words = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
  return {low, edge, words(count.x), words(count.y), words(count.z), matter, all_round(directions)};
}

}  // namespace

Openness::Openness(const std::vector<Segment>& segments, const std::vector<Screen>& screens)
    : light_(light_of(segments, screens)) {}

std::uint8_t Openness::at(const glm::vec3& place) const {
  return static_cast<std::uint8_t>(std::clamp(light_.at(place), 0.0f, 1.0f) * 255 + 0.5f);
}

std::vector<std::uint8_t> Openness::of(const Mesh& mesh) const {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(mesh.positions.size() / 3);
  for (std::size_t v = 0; v + 2 < mesh.positions.size(); v += 3)
    bytes.push_back(at({mesh.positions[v], mesh.positions[v + 1], mesh.positions[v + 2]}));
  return bytes;
}

}  // namespace panicle::grammar
