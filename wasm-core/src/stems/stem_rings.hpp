// Makes the rings of a tube along a smooth axis.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "stems/stem_axes.hpp"
#include "stems/stem_thickness.hpp"
#include "stems/tubes.hpp"

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
  float v_rate = 0;   // its change per unit of length
  float turns = 1;    // texture coordinate around at the end of the ring
  std::uint32_t segment = 0;
};

// The base of a branch (stems/collar.hpp): rows of vertices, as many a row as a ring has.
struct Collar {
  std::uint32_t rows = 0;
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> segments;

  void clear() {
    rows = 0;
    positions.clear();
    normals.clear();
    uvs.clear();
    segments.clear();
  }
};

// A closed tube: the rings, and a pole at either end, whose normals point straight back and straight ahead.
struct Tube {
  Collar collar;  // before the rings
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
  TubeMaker(const Stems& stems, const StemAxes& axes, const TubeOptions& options);

  // Whether an axis is thin enough for fewer sides.
  bool is_thin(const StemAxis& axis) const { return axes_.nodes[axis.first].radius < options_.thin; }

  // From now on uses as few rings as possible, for very many stems.
  void coarsen() { coarse_ = true; }

  // The number of rings that `make` makes, and rows of its collar.
  std::uint32_t count_rings(const StemAxis& axis) const;
  // Makes the rings of an axis with their texture coordinate v, the collar and the poles. Overwrites `tube`: its memory
  // is reused. `sides`: of the tube.
  void make(const StemAxis& axis, std::uint32_t sides, Tube& tube) const;
  // The root flare that replaces the foot of an axis; null for none.
  const RootFlare* flare_of(const StemAxis& axis) const;

 private:
  static constexpr std::uint32_t max_steps = 16;  // from node to node

  std::span<const float> cap_of(const StemAxis& axis) const;
  std::uint32_t rings_between(const StemAxis& axis, std::uint32_t i) const;
  StemEnd end_of(const StemAxis& axis) const;
  void sweep(const StemAxis& axis, Ring* rings) const;
  bool has_collar(const StemAxis& axis) const;
  std::uint32_t rings_of(const StemAxis& axis) const;
  void set_texture(const StemAxis& axis, std::span<Ring> rings, std::size_t front, std::size_t back) const;

  const Stems stems_;
  const StemAxes& axes_;
  const TubeOptions options_;
  bool coarse_ = false;
  // Steps are shorter near nodes: at fraction k / n − c sin(2π k / n) / 2π. Here is that without c, for every n.
  std::array<std::array<float, max_steps + 1>, max_steps + 1> crowding_{};
};

}  // namespace panicle
