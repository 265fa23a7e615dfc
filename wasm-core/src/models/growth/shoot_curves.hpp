// Curved shoots: the centre line of a shoot as a smooth curve through its nodes, which sags by its own weight, rises at
// its tip, and wanders between its nodes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/growth/form.hpp"
#include "models/growth/population.hpp"

namespace panicle::growth {

struct CurveHabit {
  std::uint32_t pieces = 0;  // straight pieces of the longest internodes; 0: internodes are straight
  float gnarl = 0;           // sideways wander between two nodes, as a share of their distance
  float sag = 0;             // by how much a level shoot points down at its base, and
  float rise = 0;            // up at its tip: tangents of angles
  float tip = 0.6f;          // thickness at the tip over that after the last fork
  std::uint64_t seed = 1;
};

// The curve of one shoot. Places are relative to its base, so that a shoot follows its parent.
class ShootCurve {
 public:
  // Prepares the curve of the shoot with index `q`.
  void set(const Population& population, const Form& form, const CurveHabit& habit, std::uint32_t q);

  // The vector from the start of an internode to the place at a share 0 … 1 of it. The curve and its direction are
  // continuous over the nodes.
  glm::vec3 at(std::uint32_t internode, float share) const;
  // The number of straight pieces that stand for an internode: fewer for short ones and for high orders.
  std::uint32_t pieces(std::uint32_t internode) const;

 private:
  struct Internode {
    glm::vec3 whole{0};                          // from its start to its end
    glm::vec3 start_tangent{0}, end_tangent{0};  // as long as the internode
    glm::vec3 wander{0}, sway{0};                // sideways: greatest in the middle; to both sides by turns
  };
  std::vector<Internode> internodes_;
  std::uint32_t pieces_ = 1;
  float full_length_ = 1;  // of an internode with all pieces, metres
};

}  // namespace panicle::growth
