// The size and form of a bunch and of its berries, by the OIV's descriptors.
#pragma once

#include "models/bunch/grown.hpp"
#include "models/bunch/measures/measures_subject.hpp"

namespace panicle::bunch {

// The form of a bunch with at least one berry, in mm. Length and width are those of all berries, the rest is of the
// first bunch.
struct BunchForm {
  float length = 0;
  float width = 0;
  float shape = 0;  // OIV 208: 1 cylindrical, 2 conical, 3 funnel-shaped
  float wings = 0;  // 0 … 4
};

BunchForm bunch_form(const Subject& subject);

// From the root to where it first branches, mm; 0 without a stem.
float length_of_peduncle(const GrownBunch& grown);

// Means over all berries, mm; meaningless without any.
struct BerryMeans {
  float diameter = 0;  // of the balls of their volumes
  float spread = 0;    // standard deviation of these over their mean
  float width = 0, length = 0;
  float pedicel = 0;  // NaN where no berry has one
};

BerryMeans berry_means(const Subject& subject);

// OIV 223: 1 obloid, 2 globose, 3 broad ellipsoid, 4 narrow ellipsoid, 5 cylindrical, 6 obtuse ovoid, 7 ovoid,
// 8 obovoid, 9 horn-shaped, 10 finger-shaped.
float berry_shape_note(const BerryForm& form, float length_over_width);

// OIV 222: 1 not uniform, 2 uniform.
float uniformity_note(float spread);

}  // namespace panicle::bunch
