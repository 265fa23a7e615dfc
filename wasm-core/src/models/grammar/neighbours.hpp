// Responses to ?E between steps: how crowded a place is, and how light (after Měch and Prusinkiewicz 1996;
// docs/models/grammar/grammar.md).
//
// ?E(r, n, l): n is the number of lines that end within r of the turtle, in the grammar's unit, except lines that end
// at the turtle; l is the share of an overcast sky's light that arrives, 0 … 1, where each line's end fills a cell of
// edge r so that a path of length r through it leaves e^−½.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "light/voxel_light.hpp"
#include "lsystem/lsystem.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::grammar {

class Neighbours : public lsystem::Listener {
 public:
  // Queries take work of `budget`, which must outlive this listener.
  explicit Neighbours(WorkBudget& budget) : budget_(budget) {}

  bool observes_first() const override { return true; }
  void observation_begins() override;
  void responses_begin() override;
  void line(std::int32_t, const lsystem::Turtle&, const lsystem::Turtle& after, const lsystem::Lineage&) override;
  void sphere(const lsystem::Turtle&, float, const lsystem::Lineage&) override {}
  void query(const lsystem::Turtle& turtle, std::span<float> parameters, const lsystem::Lineage&) override;
  void cut(const lsystem::Turtle&) override {}

 private:
  // The ends in cells of one edge, and the light between them once it has been queried.
  struct Cells {
    float edge;
    PointGrid grid;
    std::unique_ptr<VoxelLight> light;
  };
  Cells& cells(float edge);
  std::unique_ptr<VoxelLight> light(float edge) const;

  WorkBudget& budget_;
  std::vector<glm::vec3> ends_;
  bool answering_ = false;
  std::vector<Cells> cells_;  // by the radii queried in this step
};

}  // namespace panicle::grammar
