#include "models/stand/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::stand {
namespace {

// Distance of neighbours that count, in heights of the tallest crown: beyond, a crown rises no higher than 18° and is
// far from all branches.
constexpr float far = 3, farthest = 40;

// A neighbour is skipped only where it is lower than the horizon by more than the rounding of tangents.
constexpr float slack = 0.999f;
constexpr float first_ring = 0.2f;  // as a share of the reach

// A plant's crown: its foot, its radius and its height, all in metres.
struct Crown {
  glm::vec3 at{0};
  float radius = 0, height = 0;
};

// The share of a direction that a neighbour's crown covers. `off` is the angle between the direction and the neighbour,
// `half` the half angle under which the crown is seen, both in degrees: 1 within `half`, and linearly less to 0 at 45°
// beyond, so that a crown between two of the eight directions counts in both.
float covered_share(float off, float half) { return std::clamp(1 - (off - half) / 45, 0.0f, 1.0f); }

}  // namespace

// Computes the surroundings of each plant in eight directions: first the height of the horizon in degrees, then the
// room up to the neighbours' crowns in metres over the plant's scale. Only plants on the ground count as neighbours.
std::vector<float> surroundings_of(const Plan& plan, const std::vector<Placement>& plants) {
  std::vector<const Kind*> kinds;
  for (const Layer& layer : plan.layers)
    for (const Kind& kind : layer.kinds) kinds.push_back(&kind);
  std::vector<float> all(surrounding * plants.size(), 0);
  std::vector<Crown> crowns;
  std::vector<glm::vec3> feet;
  float tallest = 0;
  for (const Placement& plant : plants) {
    const Kind& kind = *kinds[plant.kind];
    crowns.push_back({plant.at, 0.5f * kind.width * plant.scale, kind.height * plant.scale});
    if (plant.parent >= 0) continue;
    feet.emplace_back(plant.at.x, 0, plant.at.z);
    tallest = std::max(tallest, crowns.back().height);
  }
  // Attached plants come after all others and are not neighbours.
  const float reach = std::min(far * tallest, farthest);
  const PointGrid grid(feet, std::max(reach, 0.01f));
  for (std::size_t i = 0; i < plants.size(); ++i) {
    float* const horizon = &all[surrounding * i];
    float* const room = horizon + azimuths;
    std::fill(room, room + azimuths, no_neighbour);
    const Crown& self = crowns[i];
    if (plants[i].parent >= 0) continue;
    float lowest = 0, widest = no_neighbour;
    float from = 0, to = first_ring * reach;
    // Raises the horizon and reduces the room by the crown j, if it is between `from` and `to` metres away.
    const auto add_neighbour = [&](std::uint32_t j) {
      const Crown& other = crowns[j];
      const glm::vec2 way(other.at.x - self.at.x, other.at.z - self.at.z);
      const float distance = glm::length(way);
      if (j == i || distance <= from || distance > to || distance < 1e-4f) return;
      const float ends = distance * self.radius / (self.radius + other.radius);
      // Seen from half the plant's own height, to the near side of the other's top.
      const float above = other.at.y + other.height - self.at.y - 0.5f * self.height;
      const float near = std::max(distance - 0.5f * other.radius, 0.1f);
      const bool within = ends / plants[i].scale < widest;
      if (!within && above <= lowest * near) return;
      const float high = above > 0 ? arc_tangent(above, near) * 180 / pi : 0;
      const float azimuth = arc_tangent(way.y, way.x) * 180 / pi - plants[i].turn;
      const float half = arc_sine(std::min(other.radius / distance, 1.0f)) * 180 / pi;
      for (std::uint32_t k = 0; k < azimuths; ++k) {
        float from_axis = azimuth - 45 * static_cast<float>(k);
        from_axis = std::abs(from_axis - 360 * std::floor(from_axis / 360 + 0.5f));
        horizon[k] = std::max(horizon[k], high * covered_share(from_axis, half));
        if (from_axis < 80) room[k] = std::min(room[k], ends / sincos_degrees(from_axis).cosine / plants[i].scale);
      }
      const SinCos least = sincos_degrees(*std::min_element(horizon, room));
      lowest = least.cosine > 0 ? slack * least.sine / least.cosine : 0;
      widest = *std::max_element(room, room + azimuths);
    };
    // The nearest first: they leave little that others change.
    grid.visit(feet[i], add_neighbour);
    from = to, to = reach;
    grid.visit(feet[i], add_neighbour);
    for (std::uint32_t k = 0; k < azimuths; ++k) {
      horizon[k] = std::floor(horizon[k] + 0.5f);
      room[k] = std::max(std::floor(100 * room[k] + 0.5f) / 100, least_room);
    }
  }
  return all;
}

// Returns the sky at points of the ground, a byte each. A crown hides most of the sky below it, and linearly less up to
// its height beside it.
std::vector<std::uint8_t> sky_below(const Plan& plan, const std::vector<Placement>& plants,
                                    const std::vector<float>& points) {
  std::vector<const Kind*> kinds;
  for (const Layer& layer : plan.layers)
    for (const Kind& kind : layer.kinds) kinds.push_back(&kind);
  std::vector<glm::vec3> feet;
  float widest = 0.01f;
  for (const Placement& plant : plants) {
    if (plant.parent >= 0) continue;
    const Kind& kind = *kinds[plant.kind];
    feet.emplace_back(plant.at.x, 0, plant.at.z);
    widest = std::max(widest, plant.scale * (0.5f * kind.width + 0.5f * kind.height));
  }
  const PointGrid grid(feet, widest);
  std::vector<std::uint8_t> sky;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const glm::vec3 at(points[i], 0, points[i + 2]);
    float open = 1;
    grid.visit(at, [&](std::uint32_t j) {
      const Kind& kind = *kinds[plants[j].kind];
      const float radius = 0.5f * kind.width * plants[j].scale, height = kind.height * plants[j].scale;
      const float beside = (glm::distance(feet[j], at) - 0.5f * radius) / (0.5f * (radius + height));
      open *= 1 - 0.55f * std::clamp(1 - beside, 0.0f, 1.0f);
    });
    sky.push_back(static_cast<std::uint8_t>(255 * std::max(open, 0.12f)));
  }
  return sky;
}

}  // namespace panicle::stand
