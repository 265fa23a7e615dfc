// The inside of a closed surface: crowns, root balls and clipped trees are bounded by it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "spatial/closed_surface.hpp"
#include "spatial/query_budget.hpp"
#include "spatial/region.hpp"

namespace panicle {

// Whether a point is inside depends on the slice at its height (Rodkaew et al. 2003, section 4.1): the surface's
// cross-section with the horizontal plane, a polygon that winds around the inside. Half-open rules make the slice of
// any closed surface closed, vertices in the plane and flat faces included; parts that overlap count as one, inverted
// ones as holes. For a surface with gaps, places behind a gap in the direction +X may be wrong.
//
// Time and memory are bounded for every surface. The index has at most as many entries as the budget allows: where
// large triangles would have more, its cells are larger. The triangles that a query examines are counted against the
// budget. Once that is used up, the solid contains no place, queries take no time, and is_exhausted() is true: the
// model then returns QueryBudget::error().
class Solid final : public Region {
 public:
  // `budget`: shared by the solids of one plant.
  explicit Solid(Surface surface, std::shared_ptr<QueryBudget> budget = std::make_shared<QueryBudget>());

  const Surface& surface() const { return surface_; }
  glm::vec3 low() const override { return low_; }
  glm::vec3 high() const override { return high_; }
  bool contains(const glm::vec3& p) const override;
  Share share_of(const glm::vec3& low, const glm::vec3& high) const override;
  bool is_exhausted() const override { return budget_->is_exhausted(); }
  // Entries of the index: one for each row of cells along x that a triangle meets.
  std::size_t members() const { return members_.size(); }
  // The distance from a place inside, along a unit vector, to where the way leaves the solid: 0 from outside, at most
  // `most`. Surfaces within the solid, such as where parts overlap, are ignored.
  float exit_distance(const glm::vec3& from, const glm::vec3& way, float most) const;

 private:
  enum class Cell : std::uint8_t { unknown, outside, inside, mixed };

  // The cell of a place in the box.
  glm::ivec3 cell_of(const glm::vec3& p) const {
    const glm::vec3 at = (p - low_) * per_edge_;
    return {std::min(static_cast<std::int32_t>(at.x), count_.x - 1),
            std::min(static_cast<std::int32_t>(at.y), count_.y - 1),
            std::min(static_cast<std::int32_t>(at.z), count_.z - 1)};
  }
  bool slice_contains(const glm::vec3& p) const;
  // The contribution of a triangle to the winding number of the slice around a place.
  int winding_number(const glm::vec3& p, const std::uint32_t* corners) const;
  // Appends the distances of intersections with the surface between `begin` and `end`; twice where two triangles meet.
  void intersections(const glm::vec3& from, const glm::vec3& way, float begin, float end, std::vector<float>& at) const;
  // A side of a triangle as it is seen along x: for a point p, y · p.y + z · p.z − at is 0 on the side, positive
  // inside, and at least −near in every row that may meet the triangle.
  struct Side {
    float y = 0, z = 0, at = 0, near = 0;
  };
  // The first and the last cell of a box.
  struct CellBox {
    glm::ivec3 from, to;
  };
  // An entry of the index: a row of cells along x, and a triangle that meets it.
  struct Entry {
    std::uint32_t row, triangle;
  };
  // The index of a row of cells along x, and of a cell.
  std::uint32_t row_at(int y, int z) const { return static_cast<std::uint32_t>(z * count_.y + y); }
  // The cells of a triangle's bounding box.
  CellBox cells_around(const std::uint32_t* corners) const;
  // Chooses the edge of the cells, larger than the default where the index would have too many entries, and builds the
  // index.
  void choose_cells();
  // Lists the entries of the index with the present cells, in the order of the triangles. False: more than `most`.
  bool list_entries(std::size_t most, std::vector<Entry>& entries) const;
  void build_row_index(const std::vector<Entry>& entries);
  void classify();
  // Marks the cells that a triangle comes near to. `unmarked`: how many cells of each row are not marked yet.
  void mark(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, std::vector<std::int32_t>& unmarked);
  std::size_t cell_at(const glm::ivec3& at) const {
    return static_cast<std::size_t>((at.z * count_.y + at.y) * count_.x + at.x);
  }

  Surface surface_;
  std::shared_ptr<QueryBudget> budget_;
  glm::vec3 low_{0}, high_{0};
  float edge_ = 1, per_edge_ = 1;
  glm::ivec3 count_{0};
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> first_, members_;  // of each row of cells along x: the triangles that meet it
  // For each member, with padding for reads of four: its range of heights, and the upper end of its range along x with
  // a margin.
  std::vector<float> lowest_, highest_, farthest_;
};

}  // namespace panicle
