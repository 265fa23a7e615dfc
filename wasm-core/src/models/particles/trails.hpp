// What particles leave behind: a tree of places, joined by segments, that ends at its target.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace panicle::particles {

// The trails of one target, in the order of the tree: place 0 is the target, every other stands after the one it leads
// to.
struct Trails {
  std::vector<glm::vec3> places;
  std::vector<std::int32_t> next;      // the place that is nearer the target; −1 for the target
  std::vector<double> energy;          // that passes from here to the next; at the target all that arrives there
  std::vector<std::uint32_t> born;     // the step that first left a trail from here; of the target the last
  std::vector<std::int32_t> particle;  // that started here; −1 where none did

  std::size_t size() const { return places.size(); }
};

}  // namespace panicle::particles
