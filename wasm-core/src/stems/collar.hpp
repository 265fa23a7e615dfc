// Branch collars: the base of a branch as a surface that leaves its parent's surface along a fillet, so that both look
// grown together.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "stems/stem_axes.hpp"
#include "stems/stem_rings.hpp"

namespace panicle {

// The surface of a parent around a fork: tapering pieces of its axis.
class ParentSurface {
 public:
  // The pieces around the node `fork` of `axes`, some radii up and down its axis.
  ParentSurface(const StemAxes& axes, std::uint32_t fork);

  // A point's distance from the surface, negative within it; and the unit vector that leads away from the axis.
  struct Distance {
    float value = 0;
    glm::vec3 away{0};
  };
  Distance from(const glm::vec3& point) const;

  float radius() const { return radius_; }
  const glm::vec3& direction() const { return direction_; }

 private:
  struct Piece {
    glm::vec3 start{0}, along{0};
    float per_square = 0;  // 1 / length² of `along`
    float radius = 0, gain = 0;
  };
  static constexpr std::uint32_t most_pieces = 8;

  Piece pieces_[most_pieces];
  std::uint32_t count_ = 0;
  float radius_ = 0;
  glm::vec3 direction_{0};
};

// Replaces the rings of a tube that lie within its parent by the rows of a collar (Tube::collar). Each side's row
// points follow a parabola that touches the parent's surface where it begins and the branch where it ends. Does nothing
// where a side never leaves the parent. `body`: the index of the first ring that belongs to the rounded end.
void add_collar(Tube& tube, const ParentSurface& parent, std::uint32_t parent_segment, std::uint32_t sides,
                std::uint32_t rows, std::size_t body);

}  // namespace panicle
