// Triangles between rings of vertices. A ring of n sides has n + 1 vertices in a row, the first again at the end, where
// the texture's seam is.
#pragma once

#include <cstdint>

namespace panicle {

// Triangulates the strip between two rings, or rows that begin and end together, of any numbers of sides: always by the
// shorter diagonal. `triangle(a, b, c)` gets the corners, counter-clockwise where the outer ring lies to the right of
// the inner.
template <class Triangle>
void strip_between(std::uint32_t inner, std::uint32_t inner_sides, std::uint32_t outer, std::uint32_t outer_sides,
                   const Triangle& triangle) {
  std::uint32_t i = 0, j = 0;
  while (i < inner_sides || j < outer_sides) {
    const std::uint64_t next_inner = std::uint64_t{i + 1} * outer_sides,
                        next_outer = std::uint64_t{j + 1} * inner_sides;
    if (j == outer_sides || (i < inner_sides && next_inner <= next_outer)) {
      triangle(inner + i, inner + i + 1, outer + j);
      ++i;
    } else {
      triangle(inner + i, outer + j + 1, outer + j);
      ++j;
    }
  }
}

}  // namespace panicle
