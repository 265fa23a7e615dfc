// The two sides of a leaf's margin, from base to tip.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/leaf/shape/margin.hpp"

namespace panicle::particles::leaf {

// Points of a side by the share of its length, 0 at the base and 1 at the tip. The margin must outlive it.
class Sides {
 public:
  // Measures the margin, a closed polygon that begins at the base, up to the tip and back.
  explicit Sides(const Margin& margin) : points_(margin.points), lengths_{0} {
    for (std::size_t i = 0; i < points_.size(); ++i)
      lengths_.push_back(lengths_[i] + glm::distance(points_[i], points_[(i + 1) % points_.size()]));
    tip_ = lengths_[margin.tip];
  }
  // The point at a share, 0 … 1, of the way from the base to the tip along the right or left margin.
  glm::vec3 right(float share) const { return place(share * tip_); }
  glm::vec3 left(float share) const { return place(lengths_.back() - share * (lengths_.back() - tip_)); }

 private:
  // The point at a length along the margin.
  glm::vec3 place(float length) const {
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    const std::size_t i = std::min(static_cast<std::size_t>(after - lengths_.begin()) - 1, points_.size() - 1);
    const float whole = lengths_[i + 1] - lengths_[i];
    const glm::vec2 to = points_[(i + 1) % points_.size()];
    const glm::vec2 p = points_[i] + (whole > 0 ? (length - lengths_[i]) / whole : 0) * (to - points_[i]);
    return {p.x, p.y, 0};
  }

  std::span<const glm::vec2> points_;
  std::vector<float> lengths_;
  float tip_ = 0;
};

}  // namespace panicle::particles::leaf
