// The order in which a mesh's vertices can be removed (Garland and Heckbert 1997, "Surface simplification using quadric
// error metrics"). Each collapses into a neighbour, and none is moved: so every mesh with the same triangles can be
// simplified by the same list, wherever its vertices are.
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

// Triangles of which `thinning_of` compares all collapses, which takes some 10 µs a triangle as wasm.
inline constexpr std::uint32_t max_compared = 100'000;

// Until nothing can go without turning something over. Deterministic: of equal costs the lower number goes first.
// Of a patch with more triangles than `most`, all vertices within a cell of a grid become one instead, for
// increasingly large cells (Rossignac and Borrel 1993, "Multi-resolution 3D approximations for rendering complex
// scenes"): in O(n log n), and triangles may turn over. Fixed vertices stay. `looks`: how many collapses were compared
// is added to it.
std::vector<Collapse> thinning_of(const Patch& patch, std::uint32_t most = max_compared,
                                  std::uint64_t* looks = nullptr);

}  // namespace panicle
