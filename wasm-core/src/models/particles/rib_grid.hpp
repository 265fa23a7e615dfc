// The nearest place on ribs, for many queries.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/ribs.hpp"

namespace panicle::particles {

// A grid over a box: each cell, at its first query, finds the pieces of which one must be the nearest to any place in
// it, among those of the wider cell about it.
class RibGrid {
 public:
  // `ribs` must outlive it. The box lies in the plane z = 0.
  RibGrid(const Ribs& ribs, const glm::vec3& low, const glm::vec3& high);

  // The same as `ribs.nearest(p)`, of places with z = 0.
  Ribs::Foot nearest(const glm::vec3& p) const;

  // Ribs as lines: at each place the first rib that leads there continues the line, the others begin lines of their
  // own. Returns the line of the piece from place `at`; 0 is the line that begins at place 0.
  std::uint32_t line_of(std::size_t at) const { return line_[at]; }
  // The nearest place on one line.
  Ribs::Foot nearest_on(std::uint32_t line, const glm::vec3& p) const;

 private:
  using Pieces = std::vector<std::uint32_t>;
  const Pieces& pieces_about(std::int32_t x, std::int32_t y, std::int32_t level) const;
  Pieces selected(const Pieces& from, const glm::vec3& middle, float radius) const;

  const Ribs* ribs_;
  glm::vec3 low_, cell_;
  Pieces every_;
  // Grid by grid, each twice as fine as the one before: of each cell, in ascending order; empty: no query yet.
  mutable std::vector<std::vector<Pieces>> grids_;
  std::vector<std::uint32_t> line_;  // by place
  std::vector<std::vector<std::uint32_t>> lines_;
};

}  // namespace panicle::particles
