// An outline in the plane z = 0: tests for inside, and the distance of its edge.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "spatial/region.hpp"

namespace panicle::particles {

// A closed polygon, in either sense. One that crosses itself contains the points with a winding number other than 0.
class Outline final : public Region {
 public:
  explicit Outline(std::vector<glm::vec2> points);

  std::span<const glm::vec2> points() const { return {points_.data(), count()}; }
  glm::vec3 low() const override { return low_; }
  glm::vec3 high() const override { return high_; }
  bool contains(const glm::vec3& p) const override;
  // Whether the straight way between two places inside stays inside.
  bool holds(const glm::vec3& a, const glm::vec3& b) const;
  // Distance of the edge from a place, inside or outside.
  float distance(const glm::vec3& p) const;
  float area() const;  // of a polygon that does not cross itself
  // An estimate of the distance in constant time: from the edge nearest to the middle of a cell. Places outside the box
  // use the cell nearest to them.
  float about_distance(const glm::vec3& p) const;
  // Whether no edge is nearer than that.
  bool keeps_off(const glm::vec3& p, float reach) const;
  // A lower bound of the distance: the certain distance of a cell. 0 outside the outline's box.
  float clearance(const glm::vec3& p) const;

 private:
  std::size_t count() const { return points_.size() - 1; }
  bool crosses(const glm::vec2& a, const glm::vec2& b) const;
  float distance_to_edge(const glm::vec3& p, std::uint32_t edge) const;
  void measure();
  void list_edges();
  void make_certain();
  void find_sides();
  std::int32_t column_of(float x) const;
  std::int32_t line_of(float y) const;
  template <class See>
  void cells_between(const glm::vec2& a, const glm::vec2& b, const See& visit) const;
  int winding(float x, float y) const;
  std::size_t row_of(float y) const;

  std::vector<glm::vec2> points_;  // and the first again
  glm::vec3 low_{0}, high_{0};
  float row_height_ = 1;
  std::vector<std::uint32_t> first_, members_;  // of each row of the box: the edges that meet it
  float cell_ = 1, per_cell_ = 1;
  std::int32_t across_ = 0, up_ = 0;
  std::vector<float> clearance_;                    // of each cell of the box
  std::vector<std::uint32_t> nearest_;              // of each: the edge nearest to its middle
  std::vector<std::uint8_t> inside_;                // of each that has clearance: whether it is inside
  std::vector<std::uint32_t> first_in_, edges_in_;  // of each: the edges that meet it
};

}  // namespace panicle::particles
