// Cells and neighbours. A cell of dimension i is all darts that the involutions other than αi lead to: ⟨α1, α2, α3⟩ is
// a vertex, ⟨α0, α2, α3⟩ an edge, ⟨α0, α1, α3⟩ a face, ⟨α0, α1, α2⟩ a volume (Lienhardt 1994).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generalized_map/map.hpp"

namespace panicle::generalized_map {

// A set of involutions: α0 and α2 are `with(0) | with(2)`.
using Involved = std::uint8_t;
// The set that contains involution α_i alone.
constexpr Involved with(std::uint32_t i) { return static_cast<Involved>(1u << i); }
inline constexpr Involved all_involutions = 15, in_volume = 7;

// The involutions that make the cells of dimension 0 to 3.
constexpr Involved of_cell(std::uint32_t dimension) {
  return static_cast<Involved>(all_involutions & ~with(dimension));
}

// Every orbit numbered, in the order of its first dart.
struct Orbits {
  std::vector<std::uint32_t> of_dart;
  std::uint32_t count = 0;
};

// Numbers the orbits of all darts. `orbits_of(map, of_cell(0))`: the map's vertices; `of_cell(0) & in_volume`: those of
// each volume by itself.
Orbits orbits_of(const Map& map, Involved involved);

// Finds single orbits, one after another. Marks of visited darts are numbered by query instead of being cleared.
class OrbitWalk {
 public:
  // Walks over orbits, the darts (half-edges of faces) that involutions connect.
  explicit OrbitWalk(const Map& map) : map_(map) {}

  // The darts of a dart's orbit, that dart first. Valid until the next call; the map may grow meanwhile.
  std::span<const std::uint32_t> of(std::uint32_t dart, Involved involved);

 private:
  const Map& map_;
  std::uint32_t question_ = 0;
  std::vector<std::uint32_t> seen_;  // by dart: the last question that it was an answer to
  std::vector<std::uint32_t> found_;
};

// A volume sewn to another's face.
struct Neighbour {
  Face own = base_face;
  std::uint32_t volume = none;
  Face other = base_face;
  bool operator==(const Neighbour&) const = default;
};

// All faces that a volume is sewn to, each pair of faces once, by `own`, then by number.
std::vector<Neighbour> neighbours(OrbitWalk& walk, const Map& map, std::uint32_t v);

// The same for neighbours with a label.
std::vector<Neighbour> neighbours(OrbitWalk& walk, const Map& map, std::uint32_t v, std::uint32_t label);

}  // namespace panicle::generalized_map
