// Positions and orientations of prisms and of their faces: all by angles and orders, never from the places of corners,
// for faces may shrink to nothing.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "generalized_map/prism.hpp"

namespace panicle::generalized_map {

// Three unit vectors at right angles, right-handed. A prism stands along z; seen against z its sides go
// counter-clockwise, and its first looks along −y.
struct Frame {
  glm::vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

// A prism's directions. Its end lies translation · height along the z that the turns have left; length goes along x and
// width along y, across the end.
struct Shape {
  float turn_x = 0, turn_y = 0, turn_z = 0;  // degrees, one after another about the axes as they then are
  float height = 1, length = 1, width = 1;
  float translation = 1;
};

// Turned about its own x, then its own y, then its own z.
Frame turned(const Frame& frame, const Shape& shape);

// Returns the frame of a volume that grows on a face of a prism with frame `frame`: on the end as the prism stands, on
// a side outwards with the prism's axis up, on the base the other way.
Frame on_face(const Frame& frame, std::uint32_t order, Face face);

// Corners of a base or an end in x and y, counter-clockwise, the edge from the first to the second at −y: of order 4
// the corners of a rectangle of length by width, of others so many on the ellipse inside it.
std::vector<glm::vec2> polygon(std::uint32_t order);  // for length and width 1

}  // namespace panicle::generalized_map
