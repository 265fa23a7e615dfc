#include "generalized_map/frame.hpp"

#include "foundation/mathematics.hpp"

namespace panicle::generalized_map {
namespace {

void turn(glm::vec3& a, glm::vec3& b, float degrees) {
  if (degrees == 0) return;
  const SinCos by = sincos_degrees(degrees);
  const glm::vec3 was = a;
  a = by.cosine * was + by.sine * b;
  b = by.cosine * b - by.sine * was;
}

}  // namespace

Frame turned(const Frame& frame, const Shape& shape) {
  Frame own = frame;
  turn(own.y, own.z, shape.turn_x);
  turn(own.z, own.x, shape.turn_y);
  turn(own.x, own.y, shape.turn_z);
  return own;
}

Frame on_face(const Frame& frame, std::uint32_t order, Face face) {
  if (face == end_face) return frame;
  if (face == base_face) return {-frame.x, frame.y, -frame.z};
  const float step = 360 / static_cast<float>(order);
  const SinCos at = sincos_degrees(-90 + static_cast<float>(side_number(face) - 1) * step);
  return {at.cosine * frame.y - at.sine * frame.x, frame.z, at.cosine * frame.x + at.sine * frame.y};
}

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
