#include "models/flower/thickness.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace panicle::flower {
namespace {

// The mean radius of a tube of radius 1 with `order` sides after rounds of subdivision: across it, Catmull and Clark's
// rule is that of the cubic spline.
float radius_after_rounding(std::uint32_t order, std::uint32_t rounds) {
  std::vector<glm::vec2> ring = generalized_map::polygon(order), finer;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    finer.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::vec2 &before = ring[(i + ring.size() - 1) % ring.size()], &after = ring[(i + 1) % ring.size()];
      finer.push_back((before + 6.0f * ring[i] + after) / 8.0f);
      finer.push_back((ring[i] + after) / 2.0f);
    }
    std::swap(ring, finer);
  }
  float sum = 0;
  for (const glm::vec2& point : ring) sum += std::sqrt(glm::dot(point, point));
  return 2 * sum / static_cast<float>(ring.size());
}

}  // namespace

// By volume, whether it is part of a tube: more than half of its sides are on the boundary.
std::vector<std::uint8_t> tubes_of(const Derived& derived, const generalized_map::Boundary& boundary) {
  const generalized_map::Map& map = derived.map;
  std::vector<std::uint32_t> free_sides(map.volumes(), 0);
  for (std::uint32_t f = 0; f < boundary.surface.faces; ++f)
    free_sides[boundary.volume[f]] += generalized_map::is_side(boundary.face[f]);
  std::vector<std::uint8_t> is_tube(map.volumes());
  for (std::uint32_t v = 0; v < map.volumes(); ++v) is_tube[v] = 2 * free_sides[v] > map.volume(v).order;
  return is_tube;
}

// The shapes of all volumes, with tubes widened by as much as rounds of subdivision make them thinner.
std::vector<generalized_map::Shape> shapes_to_round(const Derived& derived, const std::vector<std::uint8_t>& is_tube,
                                                    std::uint32_t rounds) {
  std::vector<generalized_map::Shape> shapes = derived.shapes();
  if (rounds == 0) return shapes;
  std::map<std::uint32_t, float> wider;  // by order
  for (std::uint32_t v = 0; v < shapes.size(); ++v) {
    if (!is_tube[v]) continue;
    const std::uint32_t order = derived.map.volume(v).order;
    const auto [known, anew] = wider.try_emplace(order, 1.0f);
    if (anew) known->second = 1 / radius_after_rounding(order, rounds);
    shapes[v].length *= known->second;
    shapes[v].width *= known->second;
  }
  return shapes;
}

}  // namespace panicle::flower
