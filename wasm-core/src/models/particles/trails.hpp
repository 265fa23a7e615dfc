// The trails of particles: a tree of places, joined by segments, that ends at its target.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle::particles {

// The trails of one target, in the order of the tree: place 0 is the target, every other comes after the one it leads
// to.
struct Trails {
  std::vector<glm::vec3> places;
  std::vector<std::int32_t> next;      // the place that is nearer the target; −1 for the target
  std::vector<double> energy;          // energy that passes from here to the next; at the target all that arrives there
  std::vector<std::uint32_t> born;     // the step that first left a trail from here; of the target the last
  std::vector<std::int32_t> particle;  // the particle that started here; −1 for none

  std::size_t size() const { return places.size(); }
  void reserve(std::size_t count);
  // Appends a place; returns its number.
  std::int32_t add(const glm::vec3& place, std::int32_t to, double passing, std::uint32_t first_left,
                   std::int32_t started);
};

// When the particle that left a place came to the next, in steps of `stride`: no earlier than the next place was
// reached first, for others may have been there before it. Not of the target.
float arrival(const Trails& trails, std::size_t i, float stride);

// The order of all places in the tree, independent of their order in the array: 0 first, each after the one it leads
// to, those that lead to the same place next to each other and ascending. `next`: for each place but 0 the one it leads
// to.
std::vector<std::uint32_t> tree_order(std::span<const std::int32_t> next);

}  // namespace panicle::particles
