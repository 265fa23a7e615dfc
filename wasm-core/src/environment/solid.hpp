// What is inside of a closed surface: what crowns, root balls and clipped trees are bounded by.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "environment/region.hpp"
#include "environment/surface.hpp"

namespace panicle {

// Whether a point is inside is asked of the slice at its height (Rodkaew et al. 2003, section 4.1): the surface's
// cross-section with the horizontal plane, a polygon that winds about what is inside. Half-open rules make the slice of
// any closed surface closed, vertices in the plane and flat faces included; parts that overlap count as one, turned
// ones as holes. Of a surface with gaps, what lies behind a gap in the direction +X may be wrong.
class Solid final : public Region {
 public:
  explicit Solid(Surface surface);

  const Surface& surface() const { return surface_; }
  glm::vec3 low() const override { return low_; }
  glm::vec3 high() const override { return high_; }
  bool contains(const glm::vec3& p) const override;
  Share share_of(const glm::vec3& low, const glm::vec3& high) const override;
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
  void sort();
  void classify();
  std::size_t cell_at(const glm::ivec3& at) const {
    return static_cast<std::size_t>((at.z * count_.y + at.y) * count_.x + at.x);
  }

  Surface surface_;
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
