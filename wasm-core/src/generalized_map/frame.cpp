#include "generalized_map/frame.hpp"

#include "foundation/mathematics.hpp"

namespace panicle::generalized_map {
namespace {

// Rotates two orthogonal axes in their plane.
void rotate_pair(glm::vec3& a, glm::vec3& b, float degrees) {
  if (degrees == 0) return;
  const SinCos by = sincos_degrees(degrees);
  const glm::vec3 was = a;
  a = by.cosine * was + by.sine * b;
  b = by.cosine * b - by.sine * was;
}

}  // namespace

// A frame after the rotations of a shape about its own axes x, y and z.
Frame turned(const Frame& frame, const Shape& shape) {
  Frame own = frame;
  rotate_pair(own.y, own.z, shape.turn_x);
  rotate_pair(own.z, own.x, shape.turn_y);
  rotate_pair(own.x, own.y, shape.turn_z);
  return own;
}

// The frame of a volume that grows on a face of a prism with `order` sides; its z axis points out of the face.
Frame on_face(const Frame& frame, std::uint32_t order, Face face) {
  if (face == end_face) return frame;
  if (face == base_face) return {-frame.x, frame.y, -frame.z};
  const float step = 360 / static_cast<float>(order);
  const SinCos at = sincos_degrees(-90 + static_cast<float>(side_number(face) - 1) * step);
  return {at.cosine * frame.y - at.sine * frame.x, frame.z, at.cosine * frame.x + at.sine * frame.y};
}

// The corners of a regular polygon of diameter 1; of the unit square for 4.
std::vector<glm::vec2> polygon(std::uint32_t order) {
  if (order == 4) return {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
  std::vector<glm::vec2> corners;
  const float step = 360 / static_cast<float>(order);
  for (std::uint32_t i = 0; i < order; ++i) {
    const SinCos at = sincos_degrees(-90 - step / 2 + static_cast<float>(i) * step);
    corners.push_back(glm::vec2(at.cosine, at.sine) * 0.5f);
  }
  return corners;
}

}  // namespace panicle::generalized_map
