// Numbers of the darts of a prism, and names of its faces.
//
// A prism of order n has 2n corners, 3n edges and n + 2 faces: the base O, the end E and the sides C1 … Cn. Of its 12 n
// darts, two to each edge of each face, the base's come first, then the end's, then the sides':
//
//   O(i, s) = 2i + s     E(i, s) = 2n + 2i + s     C_i(e, s) = 4n + 8i + 2e + s
//
// with i from 0 to n − 1, s the edge's end that the dart stands at, and e a side's edge: 0 along the base, 1 right, 2
// along the end, 3 left. Seen from outside the end and the sides run counter-clockwise and the base clockwise, so that
// corner i of the base lies below corner i of the end.
#pragma once

#include <cstdint>

namespace panicle::generalized_map {

// A face by its index in its volume. C1 is `side(1)`.
using Face = std::uint16_t;
inline constexpr Face base_face = 0;  // O
inline constexpr Face end_face = 1;   // E
// The face number of side C_i, i from 1, and back.
constexpr Face side(std::uint32_t i) { return static_cast<Face>(i + 1); }
constexpr bool is_side(Face face) { return face > end_face; }
constexpr std::uint32_t side_number(Face face) { return face - 1u; }  // of C_i, i

inline constexpr std::uint32_t least_order = 3, largest_order = 4096;

// The number of darts, half-edges of faces, of a prism whose base has `order` corners.
constexpr std::uint32_t prism_darts(std::uint32_t order) { return 12 * order; }

// The first of a face's darts, counted from the prism's first.
constexpr std::uint32_t first_of(Face face, std::uint32_t order) {
  if (face == base_face) return 0;
  if (face == end_face) return 2 * order;
  return 4 * order + 8 * (side_number(face) - 1);
}

}  // namespace panicle::generalized_map
