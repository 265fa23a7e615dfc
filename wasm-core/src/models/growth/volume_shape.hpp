// The solid of a growth volume: a quadric of revolution through its three widths about an axis that may lean, which is
// the paper's frustum where the middle width is the mean of the others.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "foundation/mathematics.hpp"
#include "models/growth/population.hpp"

namespace panicle::growth {

class VolumeShape {
 public:
  // Prepares the solid of revolution of a growth volume: its place, axis, height and half widths.
  explicit VolumeShape(const GrowthVolume& volume)
      : at_(volume.at),
        height_(volume.height),
        base_(0.25f * volume.base * volume.base),
        middle_(volume.middle * volume.middle),
        top_(0.25f * volume.top * volume.top) {
    const float s = sine(volume.gradient);
    axis_ = {s * cosine(volume.towards), cosine(volume.gradient), s * sine(volume.towards)};
  }

  const glm::vec3& axis() const { return axis_; }  // of length 1, up
  // Height of a place along the axis: 0 the base, 1 the top.
  float up(const glm::vec3& p) const { return glm::dot(p - at_, axis_) / height_; }
  // Half the width at a height of 0 … 1.
  float radius(float up) const { return std::sqrt(std::max(0.0f, square(up))); }

  // Whether the solid contains a place, or a mask for four places in lanes.
  template <class Number>
  auto contains(const Number& x, const Number& y, const Number& z) const {
    const Number from_x = x - at_.x, from_y = y - at_.y, from_z = z - at_.z;
    const Number along = from_x * axis_.x + from_y * axis_.y + from_z * axis_.z;
    const Number out_x = from_x - along * axis_.x, out_y = from_y - along * axis_.y, out_z = from_z - along * axis_.z;
    return (along >= 0.0f) & (along <= height_) &
           (out_x * out_x + out_y * out_y + out_z * out_z <= square(along / height_));
  }
  // The same for one place.
  bool contains(const glm::vec3& p) const { return contains(p.x, p.y, p.z); }

 private:
  // Half the width, squared, at a share `up` of the height: the parabola through the squares at base, middle and top
  // (Lagrange); below 0 where there is none.
  template <class Number>
  Number square(const Number& up) const {
    return base_ * (1.0f - up) * (1.0f - 2.0f * up) + middle_ * up * (1.0f - up) + top_ * up * (2.0f * up - 1.0f);
  }

  glm::vec3 at_, axis_;
  float height_, base_, middle_, top_;
};

}  // namespace panicle::growth
