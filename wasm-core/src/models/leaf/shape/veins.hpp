// A leaf's veins in its flat chart: particles run from all over the blade to the ribs and down those to the petiole.
#pragma once

#include <string>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "models/leaf/request.hpp"
#include "models/particles/moment.hpp"
#include "models/particles/outline.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/trails.hpp"

namespace panicle::particles::leaf {

struct Veins {
  Margin margin;
  Outline outline;
  std::vector<Trails> crowds;  // one for each target, polished, once all have arrived; leaf lengths
  std::vector<double> all;     // for each: the energy of the whole leaf, by which thickness is scaled
  RunTotals tally;
  Timeline timeline;
  float spacing = 0;  // of the particles
  float stride = 0;   // of a particle
};

// Grows the veins. Errors: those of `spline`; limit, if particles exceed the limit of moves.
Result<Veins> grow_veins(const LeafRequest& leaf_request, const Limits& limits, std::vector<std::string>& notes);

}  // namespace panicle::particles::leaf
