// Points in cells, for asking who is near.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::bunch {

// A dense grid over the points' box, laid out anew each time: counting sort, no hashing, the same order everywhere.
class Neighbours {
 public:
  Neighbours(std::span<const glm::vec3> points, float edge) {
    glm::vec3 high{0};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::vec3& p = points[i];
      low_ = i == 0 ? p : glm::vec3(std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z));
      high = i == 0 ? p : glm::vec3(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
    }
    // Few points far apart need no finer cells than there are points.
    constexpr float most_cells = 1 << 18;
    const glm::vec3 size = high - low_;
    edge_ = std::max(edge, 1e-3f);
    const auto cells = [&] { return (size.x / edge_ + 1) * (size.y / edge_ + 1) * (size.z / edge_ + 1); };
    while (cells() > most_cells) edge_ *= 1.5f;
    for (int axis = 0; axis < 3; ++axis) count_[axis] = static_cast<std::int32_t>(size[axis] / edge_) + 1;

    first_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    for (const glm::vec3& p : points) ++first_[index_of(p) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    ids_.resize(points.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < points.size(); ++i) ids_[next[index_of(points[i])]++] = i;
  }

  // Calls `see(index)` for every point in the cells about `p`: all within an edge's length, and others.
  template <class See>
  void visit(const glm::vec3& p, See&& see) const {
    std::int32_t from[3], to[3];
    for (int axis = 0; axis < 3; ++axis) {
      const float at = (p[axis] - low_[axis]) / edge_;
      const std::int32_t cell =
          at > -2 ? at < static_cast<float>(count_[axis]) + 2 ? floor_of(at) : count_[axis] + 1 : -2;
      from[axis] = std::max(cell - 1, 0);
      to[axis] = std::min(cell + 1, count_[axis] - 1);
    }
    for (std::int32_t z = from[2]; z <= to[2]; ++z)
      for (std::int32_t y = from[1]; y <= to[1]; ++y) {
        const std::int32_t row = (z * count_[1] + y) * count_[0];
        if (from[0] > to[0]) continue;
        const std::uint32_t end = first_[static_cast<std::size_t>(row + to[0] + 1)];
        for (std::uint32_t k = first_[static_cast<std::size_t>(row + from[0])]; k < end; ++k) see(ids_[k]);
      }
  }

 private:
  static std::int32_t floor_of(float x) {
    const auto whole = static_cast<std::int32_t>(x);
    return static_cast<float>(whole) > x ? whole - 1 : whole;
  }

  std::size_t index_of(const glm::vec3& p) const {
    std::int32_t cell[3];
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = std::clamp(static_cast<std::int32_t>((p[axis] - low_[axis]) / edge_), 0, count_[axis] - 1);
    return static_cast<std::size_t>((cell[2] * count_[1] + cell[1]) * count_[0] + cell[0]);
  }

  glm::vec3 low_{0};
  float edge_ = 1;
  std::int32_t count_[3] = {1, 1, 1};
  std::vector<std::uint32_t> first_;  // of each cell's ids, and the end
  std::vector<std::uint32_t> ids_;
};

}  // namespace panicle::bunch
