#include "models/bunch/fruit/berry_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace panicle::bunch {
namespace {

bool finite(const Ball& ball) {
  return std::isfinite(double{ball.centre.x} + ball.centre.y + ball.centre.z + ball.radius);
}

// Cells at least as wide as the largest ball, so that what touches lies in neighbouring ones; wider where the balls are
// so scattered that most cells would be empty.
class Grid {
 public:
  explicit Grid(std::span<const Ball> balls) {
    glm::vec3 high(0);
    float widest = 0;
    bool any = false;
    for (const Ball& ball : balls) {
      if (!finite(ball)) continue;
      low_ = any ? glm::min(low_, ball.centre) : ball.centre;
      high = any ? glm::max(high, ball.centre) : ball.centre;
      widest = std::max(widest, 2 * ball.radius);
      any = true;
    }
    const glm::vec3 extent = high - low_;
    const float longest = std::max({extent.x, extent.y, extent.z});
    // A few roundings of a coordinate must not make a neighbour's cell the next but one.
    float edge = std::max(widest * 1.0001f, longest * 1e-3f);
    if (!(edge > 0)) edge = 1;
    const auto cells_of = [&](float length) { return static_cast<std::uint32_t>(length / edge) + 1; };
    const std::uint64_t most = 8 * balls.size() + 64;
    while (std::uint64_t{cells_of(extent.x)} * cells_of(extent.y) * cells_of(extent.z) > most) edge *= 1.5f;
    per_edge_ = 1 / edge;
    count_ = {cells_of(extent.x) + 1, cells_of(extent.y) + 1, cells_of(extent.z) + 1};
    enter(balls);
  }

  // Calls `each` for every ball in the cells about a centre.
  template <class Each>
  void around(const glm::vec3& centre, const Each& each) const {
    const glm::uvec3 cell = cell_of(centre);
    const std::uint32_t from_x = cell.x > 0 ? cell.x - 1 : 0, to_x = std::min(cell.x + 1, count_.x - 1);
    for (std::uint32_t z = cell.z > 0 ? cell.z - 1 : 0; z <= std::min(cell.z + 1, count_.z - 1); ++z) {
      for (std::uint32_t y = cell.y > 0 ? cell.y - 1 : 0; y <= std::min(cell.y + 1, count_.y - 1); ++y) {
        const std::size_t row = (std::size_t{z} * count_.y + y) * count_.x;
        for (std::uint32_t at = first_[row + from_x]; at < first_[row + to_x + 1]; ++at) each(members_[at]);
      }
    }
  }

 private:
  glm::uvec3 cell_of(const glm::vec3& p) const { return glm::uvec3((p - low_) * per_edge_); }

  // Counting sort: the members of a cell stand together, in ascending order.
  void enter(std::span<const Ball> balls) {
    const auto index_of = [this](const glm::vec3& p) {
      const glm::uvec3 cell = cell_of(p);
      return (std::size_t{cell.z} * count_.y + cell.y) * count_.x + cell.x;
    };
    first_.assign(std::size_t{count_.x} * count_.y * count_.z + 1, 0);
    for (const Ball& ball : balls) {
      if (finite(ball)) ++first_[index_of(ball.centre) + 1];
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    members_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
      if (finite(balls[i])) members_[next[index_of(balls[i].centre)]++] = i;
    }
  }

  glm::vec3 low_{0};
  float per_edge_ = 1;
  glm::uvec3 count_{1};
  std::vector<std::uint32_t> first_, members_;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_pairs(std::span<const Ball> balls) {
  const Grid grid(balls);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> partners;
  for (std::uint32_t a = 0; a < balls.size(); ++a) {
    if (!finite(balls[a])) continue;
    partners.clear();
    grid.around(balls[a].centre, [&](std::uint32_t b) {
      const glm::vec3 way = balls[b].centre - balls[a].centre;
      const float reach = balls[a].radius + balls[b].radius;
      if (b > a && glm::dot(way, way) <= reach * reach) partners.push_back(b);
    });
    std::sort(partners.begin(), partners.end());
    for (const std::uint32_t b : partners) pairs.emplace_back(a, b);
  }
  return pairs;
}

}  // namespace panicle::bunch
