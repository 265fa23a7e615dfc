// The growth space of a bud (p_c, r, l): the places ahead of a tip that nothing takes (Kim, Kim and Cho 2013, section
// 3.1). Places are looked at four at a time, and each node about the tip once for all of them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/growth/surroundings.hpp"
#include "models/growth/volume_shape.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::growth {

class FreeRoom {
 public:
  // A tip that looks about.
  struct Query {
    glm::vec3 tip, forward, light;  // the way it grows, and that to the light, of length 1
    float radius;                   // how far it looks
    float noise;                     // 0 … 1, how far each place is: no two tips look to the same
    float regard;                   // how much it counts that a place is taken, 0 … 1
  };
  // Σ w d of the places, d the way to each and w what it is worth; and Σ w.
  struct Found {
    glm::vec3 middle{0};
    float sum = 0;
  };

  // Nodes that take room from now on, and no others. `edge`: some width of cells, above 0.
  void set_nodes(std::span<const glm::vec3> nodes, float edge);

  Found find(const Query& query, const VolumeShape& volume, const Surroundings& about);

 private:
  void find_near(const Query& query);

  PointGrid grid_;
  std::vector<float> x_, y_, z_;  // of the nodes, by the grid's slots, and beyond them some that are far away
  std::vector<float> near_;       // those near a tip as seen from it: x, y, z of one after the other
  std::size_t near_count_ = 0;
};

}  // namespace panicle::growth
