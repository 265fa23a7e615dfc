#include "models/particles/dressing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "geometry/tubes.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint32_t sides = 12, thin_sides = 5;
// Axes thinner than this share of the thickest are thin.
constexpr float thin = 0.12f;
constexpr float traveller = 1.6f;  // times its trail's radius
constexpr std::uint32_t sky_cells = 32, sky_directions = 32;

std::uint8_t byte_of(float share) { return static_cast<std::uint8_t>(std::clamp(share, 0.0f, 1.0f) * 255 + 0.5f); }

}  // namespace

std::vector<std::int32_t> axes_of(std::span<const Trails> crowds, std::span<const std::vector<std::int32_t>> numbers,
                                  std::size_t segments) {
  std::vector<std::int32_t> axes(segments, 0);
  std::int32_t count = 0;
  for (std::size_t c = 0; c < crowds.size(); ++c) {
    const Trails& trails = crowds[c];
    std::vector<std::int32_t> heaviest(trails.size(), -1);
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.next[i] < 0) continue;
      std::int32_t& best = heaviest[static_cast<std::size_t>(trails.next[i])];
      if (best < 0 || trails.energy[i] > trails.energy[static_cast<std::size_t>(best)]) best = static_cast<std::int32_t>(i);
    }
    for (std::size_t i = 0; i < trails.size(); ++i) {
      const std::int32_t segment = numbers[c][i];
      if (segment < 0) continue;
      const auto next = static_cast<std::size_t>(trails.next[i]);
      const bool goes_on = numbers[c][next] >= 0 && heaviest[next] == static_cast<std::int32_t>(i);
      axes[static_cast<std::size_t>(segment)] = goes_on ? axes[static_cast<std::size_t>(numbers[c][next])] : count++;
    }
  }
  return axes;
}

void add_travellers(Plant& plant, const Trails& trails, std::uint32_t step, double all, const Girth& girth,
                    float least_radius, std::uint32_t tag) {
  // What has come to each place by then.
  std::vector<double> here(trails.size(), 0);
  std::vector<double> own = trails.energy;
  for (std::size_t i = 1; i < trails.size(); ++i) own[static_cast<std::size_t>(trails.next[i])] -= trails.energy[i];
  for (std::size_t i = trails.size(); i-- > 1;) {
    if (trails.particle[i] >= 0) here[i] += own[i];
    if (trails.born[i] <= step) here[static_cast<std::size_t>(trails.next[i])] += here[i];
  }
  for (std::size_t i = 1; i < trails.size(); ++i) {
    if (trails.born[i] <= step || !(here[i] > 0)) continue;
    Organ ball;
    ball.tag = tag;
    ball.position = trails.places[i];
    ball.scale = std::max(traveller * radius_of(girth, here[i], all), least_radius);
    plant.organs.push_back(ball);
  }
}

void add_stems(Plant& plant, std::span<const std::int32_t> axes, std::string_view material, const VoxelLight* sky) {
  float thickest = 0;
  for (const Segment& segment : plant.segments) thickest = std::max(thickest, segment.radius);
  const TubeOptions options{.sides = sides, .thin = thin * thickest, .thin_sides = thin_sides};
  StemMesh stems = sweep_stems({plant.segments, axes}, options, 1.0f);
  Columns columns;
  if (sky) {
    std::vector<std::uint8_t> bytes;
    const std::vector<float>& at = stems.mesh.positions;
    bytes.reserve(at.size() / 3);
    for (std::size_t v = 0; v + 2 < at.size(); v += 3) bytes.push_back(byte_of(sky->at({at[v], at[v + 1], at[v + 2]})));
    columns.add("sky", std::move(bytes));
  }
  columns.add("segment", std::move(stems.segment));
  plant.meshes.push_back({"stems", std::string(material), std::move(stems.mesh), {}, std::move(columns)});
}

VoxelLight openness(const Plant& plant, std::uint32_t leaf_tag, float leaf_area) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  const auto hold = [&](const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  };
  for (const Organ& organ : plant.organs) hold(organ.position);
  for (const Segment& segment : plant.segments) hold(segment.end);
  if (!(low.x <= high.x)) low = high = glm::vec3(0);
  const glm::vec3 size = high - low;
  const float edge = std::max({size.x, size.y, size.z, 1e-3f}) / static_cast<float>(sky_cells);
  const glm::ivec3 count = glm::ivec3(size / edge) + 1;
  std::vector<float> matter(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                            static_cast<std::size_t>(count.z));
  // What a surface hides, taken over all sides, is half of a leaf's area and a quarter of a rod's surface.
  const float cell = 1 / (edge * edge * edge);
  const auto put_in = [&](const glm::vec3& p, float area) {
    const glm::ivec3 at = glm::clamp(glm::ivec3((p - low) / edge), glm::ivec3(0), count - 1);
    matter[static_cast<std::size_t>((at.z * count.y + at.y) * count.x + at.x)] += area * cell;
  };
  for (const Organ& organ : plant.organs)
    if (organ.tag == leaf_tag) put_in(organ.position, 0.5f * leaf_area * organ.scale * organ.scale);
  for (const Segment& segment : plant.segments)
    put_in(0.5f * (segment.start + segment.end),
           0.25f * pi * (segment.radius + segment.radius_end) * glm::distance(segment.start, segment.end));
  const auto words = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
  return {low, edge, words(count.x), words(count.y), words(count.z), matter, all_round(sky_directions)};
}

std::vector<std::uint8_t> sky_of_organs(const Plant& plant, const VoxelLight& sky) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(plant.organs.size());
  for (const Organ& organ : plant.organs) bytes.push_back(byte_of(sky.at(organ.position)));
  return bytes;
}

}  // namespace panicle::particles
