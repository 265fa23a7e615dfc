// The particles of one target on their way there (Rodkaew et al. 2003, section 2): each is drawn to its nearest
// neighbour and to the target, those that meet become one, and their trails are recorded. Crowds of several targets do
// not interact, else twigs would bridge the crowns of a twin tree.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "models/particles/guide.hpp"
#include "models/particles/neighbours.hpp"
#include "models/particles/rules.hpp"
#include "models/particles/trail_grid.hpp"
#include "models/particles/trails.hpp"

namespace panicle::particles {

// Details that the paper leaves open:
// - All directions are computed from the places before the step. Coincident particles do not draw each other. Where
//   both pulls cancel, a particle waits: the one in front for the one behind.
// - A step that would leave the shape is taken towards the aim alone, and no farther than the aim where it still would.
// - A particle within a step of the target arrives; its last segment ends exactly there.
// - Pairs closer than `merge` meet, the nearest first, each particle once a step. The heavier goes on (of equal ones
//   the one with the lower index) from the mean of both places by energy, or from its own where that mean is outside.
// - With `join`, a particle ends in an older trail that lies ahead and is not its own; its energy runs on there.
// - After four times the steps that the longest of a hundred ways takes, particles ignore their neighbours: bends can
//   hold two in an endless circle. Particles that have not arrived after as many steps again are moved to the target,
//   from aim to aim.
class ParticleSystem {
 public:
  // `guide` must outlive the system. `rules.merge` is raised to the least that ends.
  ParticleSystem(std::span<const glm::vec3> starts, double energy, const Guide& guide, const Rules& rules);

  // Moves all particles once. Returns false, without any change, once all have arrived.
  bool step();
  // Steps until all have arrived, or until the sum of all moves reaches `most`: then returns false, with particles
  // still on their way.
  bool run(std::uint64_t most = ~std::uint64_t{0}) {
    while (moves_ + places_.size() <= most)
      if (!step()) return true;
    return false;
  }

  std::uint32_t steps() const { return steps_; }
  std::uint64_t moves() const { return moves_; }  // of all particles, in all steps
  std::uint32_t merges() const { return merges_; }
  std::uint32_t joins() const { return joins_; }
  std::uint32_t stragglers() const { return stragglers_; }  // that had to be moved to the target
  double arrived() const { return arrived_; }               // energy, at the target
  // The places and energies of the particles on their way.
  std::span<const glm::vec3> places() const { return places_; }
  std::span<const double> energies() const { return energies_; }

  // The trails once all have arrived.
  Trails trails() const;

 private:
  struct Node {
    glm::vec3 place;
    std::int32_t next = -1;
    std::uint32_t particle = 0;  // that left it
    std::uint32_t born = 0;      // the step in which it was left for the next
  };

  void choose_strides();
  void move();
  void merge_pairs();
  void join();
  void remove_gone();
  void link(std::uint32_t slot, std::int32_t to);
  void move_to(std::uint32_t slot, const glm::vec3& to);
  void arrive(std::uint32_t slot);
  void walk_to_target(std::uint32_t slot);
  std::uint32_t union_root(std::uint32_t particle);

  const Guide* guide_;
  Rules rules_;
  double energy_;  // of each at the start
  std::uint32_t started_;
  std::uint32_t step_budget_;  // steps until particles ignore their neighbours
  std::uint32_t steps_ = 0, merges_ = 0, joins_ = 0, stragglers_ = 0;
  std::uint64_t moves_ = 0;
  double arrived_ = 0;

  // By slot, the particles on their way, in ascending order of their numbers.
  std::vector<glm::vec3> places_;
  std::vector<double> energies_;
  std::vector<std::uint32_t> particles_;  // their numbers
  std::vector<std::int32_t> nodes_at_;    // the last node of each one's trail
  std::vector<std::uint8_t> gone_;        // arrived, or merged into another
  std::vector<std::uint8_t> met_;         // in this step
  std::vector<glm::vec3> strides_;        // of this step
  std::vector<glm::vec3> aims_;           // of where they are, where that is known: after `join`

  std::vector<Node> nodes_;  // 0 is the target, 1 + i where particle i started
  // by particle: the particle that it has merged into; its own number while on its way or at the target
  std::vector<std::uint32_t> merged_into_;
  std::vector<std::uint32_t> slots_;  // by particle; `at_target` after arrival

  Neighbours neighbours_;
  std::vector<Pair> pairs_;
  TrailGrid grid_;  // of all nodes, where particles join
};

}  // namespace panicle::particles
