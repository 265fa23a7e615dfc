// Makes the rings of a tube along a smooth axis.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "stems/stem_axes.hpp"
#include "stems/stem_thickness.hpp"

namespace panicle {

// The edge of a cross-section: centre + right cos a + forward sin a. Changes are per unit of length along the tangent.
struct Ring {
  glm::vec3 centre{0}, tangent{0};
  glm::vec3 right{0}, forward{0};                // half-axes; right × forward points ahead
  float radius = 0;                              // length of `forward`
  float slope = 0;                               // change of `radius`
  glm::vec3 right_change{0}, forward_change{0};  // of the half-axes; only where not round
  float blend = 0;                               // share of the parent's normals; only where not round
  bool round = true;  // both half-axes of that radius and slope, at right angles to the tangent
  float run = 0;      // distance from the ring before
  float v = 0;        // texture coordinate along the axis
  std::uint32_t segment = 0;
};

// A closed tube: the rings, and a pole at either end, whose normals point straight back and straight ahead.
struct Tube {
  std::vector<Ring> rings;
  glm::vec3 parent_point{0}, parent_direction{0};  // the line that blended normals point away from
  float parent_radius = 1;
  glm::vec3 first_pole{0}, last_pole{0};
};

// Makes the tubes of stems along their axes; both must outlive it.
//
// The centre line is a cubic Hermite curve through the nodes; rings are denser near nodes and where it bends, and turn
// as little as possible from one to the next. Thickness determines their widths; where a branch comes out of its
// parent, rings lean towards the parent's axis and take on its normals, so that the two look grown together.
class TubeMaker {
 public:
  // Axes that begin thinner than `thin` get about half the rings; with `few_rings_on_thin` one a node and more in
  // bends.
  TubeMaker(const Stems& stems, const StemAxes& axes, float thin = 0, bool few_rings_on_thin = false);

  // Whether an axis is thin enough for fewer sides.
  bool is_thin(const StemAxis& axis) const { return axes_.nodes[axis.first].radius < thin_; }

  // From now on uses as few rings as possible, for very many stems.
  void coarsen() { coarse_ = true; }

  // The number of rings that `make` makes.
  std::uint32_t count_rings(const StemAxis& axis) const;
  // Makes the rings of an axis with their texture coordinate v, and the poles. Overwrites `tube`: its memory is reused.
  void make(const StemAxis& axis, Tube& tube) const;

 private:
  static constexpr std::uint32_t max_steps = 16;  // from node to node

  std::span<const float> cap_of(const StemAxis& axis) const;
  std::uint32_t rings_between(const StemAxis& axis, std::uint32_t i) const;
  StemEnd end_of(const StemAxis& axis) const;
  void sweep(const StemAxis& axis, Ring* rings) const;

  const Stems stems_;
  const StemAxes& axes_;
  const float thin_;
  const bool few_rings_on_thin_;
  bool coarse_ = false;
  // Steps are shorter near nodes: at fraction k / n − c sin(2π k / n) / 2π. Here is that without c, for every n.
  std::array<std::array<float, max_steps + 1>, max_steps + 1> crowding_{};
};

}  // namespace panicle
