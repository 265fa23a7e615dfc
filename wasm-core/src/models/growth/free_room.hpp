// The growth space of a bud (p_c, r, l): the free places ahead of a tip (Kim, Kim and Cho 2013, section 3.1). Four
// places are evaluated at a time, and the nodes near the tip are collected once for all of them.
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
  // A tip and its search.
  struct Query {
    glm::vec3 tip, forward, light;  // unit vectors of its growth and towards the light
    float radius;                   // radius of the search
    float noise;                    // 0 … 1, varies the depth of places: no two tips search the same places
    float regard;                   // how much a taken place counts against itself, 0 … 1
  };
  // Σ w d over the places, with direction d and weight w of each; and Σ w.
  struct Found {
    glm::vec3 middle{0};
    float sum = 0;
  };

  // Replaces the nodes that take room. `edge`: width of the grid's cells, above 0.
  void set_nodes(std::span<const glm::vec3> nodes, float edge);

  Found find(const Query& query, const VolumeShape& volume, const Surroundings& about);

 private:
  void find_near(const Query& query);

  PointGrid grid_;
  std::vector<float> x_, y_, z_;  // coordinates of the nodes in the order of the grid, padded with far ones
  std::vector<float> near_;       // nodes near a tip relative to it: x, y, z of one after the other
  std::size_t near_count_ = 0;
};

}  // namespace panicle::growth
