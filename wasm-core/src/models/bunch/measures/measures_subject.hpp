// A grown bunch as the measures see it: in millimetres, berries as bodies, with the parts of the first bunch marked.
#pragma once

#include <vector>

#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/grown.hpp"

namespace panicle::bunch {

struct Subject {
  explicit Subject(const GrownBunch& grown);

  std::vector<BerryBody> berries;   // in the bunch's order
  std::vector<float> volumes;       // mm³, one a berry, of its free form
  std::vector<float> balls;         // mm, the radius of the ball of that volume
  float mean_radius = 0;            // mean of these; 0 without berries
  std::vector<std::uint8_t> first;  // whether a berry is of the first bunch, and not of the wing
  std::vector<Segment> stems;       // one an internode
  std::vector<Segment> pedicels;    // those with a berry; as many as there are berries with a parent
};

}  // namespace panicle::bunch
