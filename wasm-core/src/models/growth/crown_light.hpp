// Light in the cells of a growing crown: the direction that most light comes from, at a tip.
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
  CrownLight(const Population& population, const Surroundings& surroundings);

  // Adds matter that hides light, square metres over all directions.
  void put(const glm::vec3& place, float area);
  // Computes the light anew from the matter so far.
  void update();
  // The unit vector towards most light: the mean of the open sky, bent towards where the crown is lighter.
  glm::vec3 from(const glm::vec3& place) const;
  // The share 0 … 1 of all light that reaches a place; 1 before the first update.
  float share(const glm::vec3& place) const { return light_ ? light_->at(place) : 1; }

 private:
  DensityGrid matter_;
  std::vector<LightDirection> directions_;
  glm::vec3 sky_{0, 1, 0};
  std::optional<VoxelLight> light_;  // none before the first update
};

}  // namespace panicle::growth
