// The outline that the handles define, for a fitted bunch to fill. Per side from p1 by a quarter ellipse to (w, r),
// straight to the sideways reach of one end structure at the height of axis rd, constant from there to the tip, rounded
// there.
#pragma once

#include <array>
#include <cstdint>

#include "models/bunch/plan.hpp"

namespace panicle::bunch {

// An azimuth round the bunch's axis: the two sides that it lies between, and its parts along each.
struct Azimuth {
  std::size_t across = 0, along = 2;  // sides of the x axis and of the z axis
  float cosine = 1, sine = 0;         // parts along each, none below 0

  // The side whose direction is nearer.
  std::size_t nearest() const { return cosine >= sine ? across : along; }
  // The mean of a value of the two sides, weighted by the squares of cosine and sine.
  template <class Of>
  float between(Of of) const {
    return of(across) * cosine * cosine + of(along) * sine * sine;
  }
};

// The azimuth of a roll: `degrees` as a hanging turtle rolls by `/`: from p3 over the back to p4.
Azimuth azimuth_of(float degrees);

class Envelope {
 public:
  // rd is taken before rounding, so that the outline moves with every pixel. Results are in millimetres. `pixel`:
  // millimetres to a pixel of the profile; `end_reach`: sideways reach of one end structure.
  Envelope(const Profile& profile, float pixel, float end_reach);

  float length() const { return length_; }
  // Half-width of side i (p3 +x, p4 −x, p5 +z, p6 −z) at a depth below p1; 0 outside 0 … length.
  float half_width(std::size_t i, float depth) const;
  // Distance of the outline from the axis at an azimuth; 0 outside 0 … length.
  float radius(const Azimuth& round, float depth) const;
  // Area of a horizontal section, and volume. Between two neighbouring sides the outline is a quarter ellipse at every
  // depth.
  float section(float depth) const;
  float volume() const;
  // The area of the silhouette from the front (sides 0, 1) or from the side (2, 3).
  float area(std::size_t first_side) const;

 private:
  struct Side {
    float width = 0, shoulder = 0, waist = 0, narrow = 0, rounding = 0;
  };
  float length_ = 0;
  std::array<Side, 4> sides_ = {};
};

}  // namespace panicle::bunch
