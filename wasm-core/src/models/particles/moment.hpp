// Trails at a moment of their growing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/particles/trails.hpp"

namespace panicle::particles {

// The trails as they stood at a moment, counted in steps, with the energy that had passed by then. Who was on the way
// from a place to the next is between them; `stride` is how far a particle comes in a step at most, which tells when it
// came to where others had been before it. Places that nothing leads on from have `next` −1: particles on their way or
// not yet gone; place 0 is the target. At the last step and later, all trails.
Trails at_moment(const Trails& trails, float moment, float stride);

// The steps of a run in which someone is seen to move. In others whoever is left waits, or goes where others have been
// before: who watches step by step would see nothing happen.
class Timeline {
 public:
  Timeline() = default;
  Timeline(std::span<const Trails> crowds, float stride);

  std::uint32_t steps() const { return static_cast<std::uint32_t>(lively_.size()); }
  // The moment at a share of the run, 0 … 1: each step takes as much of it.
  float moment(float share) const;

 private:
  std::vector<std::uint32_t> lively_;
};

}  // namespace panicle::particles
