// The free form of a berry: a solid of revolution, described once in the unit space that all berries of a bunch share.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "models/bunch/berry/berry_body.hpp"

namespace panicle::bunch {

// In unit space a berry's centre is the origin, its tip scar lies at +Y, and it reaches from −1 to 1 along y and to 1
// across; scaling by half_width, half_length, half_width gives its own size. At height y the curve is
//   across² + |x|^q = 1,  x = (y − t) / (1 − t y),  q = 2 + 3 blunt,  t = taper / 3:
// an ellipse at 0, 0; a greater q makes the sides straight and leaves the ends round; t is the height of the widest
// parallel, moved there without changing the extent.
class BerryMeridian {
 public:
  explicit BerryMeridian(const BerryForm& form);

  // The gauge in a direction (unit vector) from the centre: 1 / distance of the surface there, and its gradient, which
  // is the outward normal scaled so that its product with the direction is the gauge itself.
  struct Gauge {
    float value;
    glm::vec3 gradient;
  };
  Gauge gauge(const glm::vec3& direction) const;

  // The point of the surface (across, along) whose normal is (across, along) `normal`, of any length, across ≥ 0; and
  // the surface's radii of curvature there, along the meridian and round the parallel.
  struct Support {
    glm::vec2 point;
    float along, round;
  };
  Support support(const glm::vec2& normal) const;

  float outermost() const { return outermost_; }  // distance of the surface's farthest point
  float volume() const { return volume_; }        // of the solid in unit space; 4π/3 for an ellipsoid

 private:
  glm::vec2 point_at(float parameter, glm::vec2& normal) const;
  void tabulate_supports();
  float sum_volume() const;

  float power_, shift_;
  bool ball_;
  float volume_, outermost_ = 1;
  std::array<Support, 129> supports_;
};

// Volume of the free form, in the cube of the half axes' unit: 4π/3 · half_width² · half_length where taper and blunt
// are 0; blunt 1 adds a quarter to it, taper 1 takes a little away.
float form_volume(const BerryForm& form, float half_width, float half_length);

}  // namespace panicle::bunch
