// A polygon and points inside it as triangles: the constrained Delaunay triangulation, by insertion and flips (Lawson
// 1977; edges of the polygon by Sloan 1993, "A fast algorithm for generating constrained Delaunay triangulations").
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace panicle {

// The number of lattice steps per unit. Points are taken to lie on the lattice: with it all decisions are exact.
inline constexpr float triangulation_lattice = 1048576;  // 2²⁰

// About half a second natively; a hundred times the steps of the finest blades.
inline constexpr std::uint64_t max_triangulation_steps = 20'000'000;

// Triangles, counter-clockwise, three indices each, that fill the polygon of the first `ring` points exactly; the
// others are corners too where they lie inside it. Those that lie outside or on its edges, or where another is, are
// left out. `points`: within ±8, on the lattice or rounded to it. The polygon runs counter-clockwise and neither
// crosses nor touches itself; of one that does nothing comes back, nor of one that takes more than so many steps:
// flips, and triangles that are passed on the way to a point.
std::vector<std::uint32_t> triangulate(std::span<const glm::vec2> points, std::size_t ring,
                                       std::uint64_t max_steps = max_triangulation_steps);

}  // namespace panicle
