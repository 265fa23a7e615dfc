#include "models/bunch/fruit/berry_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "environment/point_grid.hpp"

namespace panicle::bunch {
namespace {

bool finite(const Ball& ball) {
  return std::isfinite(double{ball.centre.x} + ball.centre.y + ball.centre.z + ball.radius);
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_pairs(std::span<const Ball> balls) {
  std::vector<glm::vec3> centres;
  float widest = 0;
  for (const Ball& ball : balls) {
    centres.push_back(ball.centre);
    if (finite(ball)) widest = std::max(widest, 2 * ball.radius);
  }
  // A few roundings of a coordinate must not make a neighbour's cell the next but one.
  const PointGrid grid(centres, 1.0001f * widest);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> partners;
  for (std::uint32_t a = 0; a < balls.size(); ++a) {
    if (!finite(balls[a])) continue;
    partners.clear();
    grid.visit(centres[a], [&](std::uint32_t b) {
      if (b <= a || !finite(balls[b])) return;
      const glm::vec3 way = centres[b] - centres[a];
      const float reach = balls[a].radius + balls[b].radius;
      if (glm::dot(way, way) <= reach * reach) partners.push_back(b);
    });
    std::sort(partners.begin(), partners.end());
    for (const std::uint32_t b : partners) pairs.emplace_back(a, b);
  }
  return pairs;
}

}  // namespace panicle::bunch
