// The guide of a leaf's particles: to the ribs, and down the ribs to the petiole.
#pragma once

#include <memory>
#include <vector>

#include "models/particles/guide.hpp"
#include "models/particles/outline.hpp"
#include "models/particles/rib_grid.hpp"
#include "models/particles/ribs.hpp"
#include "models/particles/waypoints.hpp"

namespace panicle::particles {

// In the printed method particles aim at the petiole, and no midrib forms. Here each aims at the nearest rib, and the
// nearer the petiole the farther off that is, so that side veins slant; on a rib a particle follows it. Places hidden
// by the edge are reached by waypoints. Ribs that are the petiole alone give the printed method, round corners.
class Venation final : public Guide {
 public:
  // `slant`: by how much of its distance from the rib a particle aims below its foot there. `spacing`: of the
  // particles. Outline and ribs must outlive it.
  Venation(const Outline& outline, const Ribs& ribs, float slant, float spacing);

  glm::vec3 aim(const glm::vec3& p) const override;
  float way(const glm::vec3& p) const override;
  bool open(const glm::vec3& p) const override { return outline_->contains(p); }
  // The distance of a point to the outline.
  float room(const glm::vec3& p) const override { return outline_->clearance(p); }
  bool sees(const glm::vec3& a, const glm::vec3& b) const override;

  // The ribs, for moving trails onto them.
  const RibGrid& ribs() const { return grid_; }

 private:
  const Outline* outline_;
  const Ribs* ribs_;
  RibGrid grid_;
  Waypoints& waypoints() const;

  float slant_, ahead_, cell_;
  mutable std::unique_ptr<Waypoints> waypoints_;  // made when the first particle is hidden from its aim
};

}  // namespace panicle::particles
