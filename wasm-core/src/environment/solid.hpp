// What is inside of a closed surface: what crowns, root balls and clipped trees are bounded by.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "environment/look_budget.hpp"
#include "environment/region.hpp"
#include "environment/surface.hpp"

namespace panicle {

// Whether a point is inside is asked of the slice at its height (Rodkaew et al. 2003, section 4.1): the surface's
// cross-section with the horizontal plane, a polygon that winds about what is inside. Half-open rules make the slice of
// any closed surface closed, vertices in the plane and flat faces included; parts that overlap count as one, turned
// ones as holes. Of a surface with gaps, what lies behind a gap in the direction +X may be wrong.
//
// Time and memory are bounded for every surface. The index has at most as many entries as the budget allows: where
// large triangles would have more, its cells are larger. What a query then looks at is counted against the budget, too;
// once that is used up, the solid contains nothing, queries cost nothing, and is_exhausted() is true: whoever grows in
// it returns an error (LookBudget::error).
class Solid final : public Region {
 public:
  // `budget`: shared by the solids of one plant.
  explicit Solid(Surface surface, std::shared_ptr<LookBudget> budget = std::make_shared<LookBudget>());

  const Surface& surface() const { return surface_; }
  glm::vec3 low() const override { return low_; }
  glm::vec3 high() const override { return high_; }
  bool contains(const glm::vec3& p) const override;
  Share share_of(const glm::vec3& low, const glm::vec3& high) const override;
  bool is_exhausted() const override { return budget_->is_exhausted(); }
  // Entries of the index: one for each row of cells along x that a triangle meets.
  std::size_t members() const { return members_.size(); }
  // How far one comes from a place inside, on a way of unit length, before leaving: 0 from outside, at most `most`.
  // Surfaces within the solid, such as where parts overlap, are passed through.
  float leaving(const glm::vec3& from, const glm::vec3& way, float most) const;

 private:
  enum class Cell : std::uint8_t { unknown, outside, inside, mixed };

  // The cell of a place in the box.
  glm::ivec3 place_of(const glm::vec3& p) const {
    const glm::vec3 at = (p - low_) * per_edge_;
    return {std::min(static_cast<std::int32_t>(at.x), count_.x - 1),
            std::min(static_cast<std::int32_t>(at.y), count_.y - 1),
            std::min(static_cast<std::int32_t>(at.z), count_.z - 1)};
  }
  bool slice_contains(const glm::vec3& p) const;
  // What a triangle adds to the turns of the slice about a place.
  int turns_about(const glm::vec3& p, const std::uint32_t* corners) const;
  // Appends how far along the way the surface is met between `begin` and `end`; where two triangles meet, twice.
  void meetings(const glm::vec3& from, const glm::vec3& way, float begin, float end, std::vector<float>& at) const;
  // A triangle's side as it is seen along x: y · y + z · z − at is 0 on it and above 0 inside, and at what lies near
  // enough to it at least −near.
  struct Side {
    float y = 0, z = 0, at = 0, near = 0;
  };
  // The first and the last cell of a box.
  struct Rows {
    glm::ivec3 from, to;
  };
  // An entry of the index: a row of cells along x, and a triangle that meets it.
  struct Member {
    std::uint32_t row, triangle;
  };
  std::uint32_t row_at(int y, int z) const { return static_cast<std::uint32_t>(z * count_.y + y); }
  Rows rows_of(const std::uint32_t* corners) const;
  // Cells of the finest edge that is wanted, or larger ones, by which the index has no more entries than it may; and
  // the index.
  void choose_cells();
  // The entries of the index with the present cells, the triangles in their order; false where they are more than
  // `most`.
  bool list_members(std::size_t most, std::vector<Member>& members) const;
  void sort(const std::vector<Member>& members);
  void classify();
  // Marks the cells that a triangle comes near to. `unmarked`: how many cells of each row are not marked yet.
  void mark(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, std::vector<std::int32_t>& unmarked);
  std::size_t cell_at(const glm::ivec3& at) const {
    return static_cast<std::size_t>((at.z * count_.y + at.y) * count_.x + at.x);
  }

  Surface surface_;
  std::shared_ptr<LookBudget> budget_;
  glm::vec3 low_{0}, high_{0};
  float edge_ = 1, per_edge_ = 1;
  glm::ivec3 count_{0};
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> first_, members_;  // of each row of cells along x: the triangles that meet it
  // Of each member, with what is read past the end by four: between which heights it lies, and how far it reaches along
  // x, and a little more.
  std::vector<float> lowest_, highest_, farthest_;
};

}  // namespace panicle
