// Light in the cells of a crown that grows: where it comes from at a tip.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "light/density_grid.hpp"
#include "models/growth/population.hpp"
#include "models/growth/surroundings.hpp"

namespace panicle::growth {

class CrownLight {
 public:
  CrownLight(const Population& population, const Surroundings& about);

  // Something that hides light from now on, square metres over all directions.
  void put(const glm::vec3& place, float area);
  // Lets the light in anew.
  void update();
  // The unit vector from which most light comes: the middle of the open sky, drawn to where the crown is lighter.
  glm::vec3 from(const glm::vec3& place) const;

 private:
  DensityGrid matter_;
  std::vector<LightDirection> directions_;
  glm::vec3 sky_{0, 1, 0};
  std::optional<VoxelLight> light_;  // none before anything hides some
};

}  // namespace panicle::growth
