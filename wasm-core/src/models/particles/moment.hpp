// Trails at a moment of their growing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/particles/trails.hpp"

namespace panicle::particles {

// The trails as they were at a moment, counted in steps, with the energy that had passed by then. Particles on the way
// from a place to the next are between them; `stride` is how far a particle comes in a step at most, from which follows
// when it came to places where others had been before it. Places without a next have `next` −1: particles on their way
// or not yet started; place 0 is the target. At the last step and later, all trails.
Trails at_moment(const Trails& trails, float moment, float stride);

// The steps of a run in which a particle visibly moves. In other steps the remaining particles wait, or go where others
// have been before: a viewer going step by step would see no change.
class Timeline {
 public:
  Timeline() = default;
  Timeline(std::span<const Trails> crowds, float stride);

  std::uint32_t steps() const { return static_cast<std::uint32_t>(lively_.size()); }
  // The moment at a share of the run, 0 … 1: each visible step takes the same share.
  float moment(float share) const;

 private:
  std::vector<std::uint32_t> lively_;
};

}  // namespace panicle::particles
