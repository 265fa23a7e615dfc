// In which order a mesh can do without its vertices (Garland and Heckbert 1997, "Surface simplification using quadric
// error metrics"). Each is drawn into a neighbour, and none is moved: so whatever has the same triangles can be thinned
// by the same list, wherever its vertices are.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace panicle {

struct Patch {
  std::vector<glm::vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> is_fixed;  // by vertex: 1 of those that stay
  std::uint32_t counted = 0;           // so many of the triangles count; those behind them only close it
};

struct Collapse {
  std::uint32_t vertex = 0, into = 0;
  float error = 0;              // how far the surface is off by then, in the patch's unit; never less than before
  std::uint32_t triangles = 0;  // that are left of those that count
};

// Until nothing can go without turning something over. Without luck: of what is equal the lower number goes first.
std::vector<Collapse> thinning_of(const Patch& patch);

}  // namespace panicle
