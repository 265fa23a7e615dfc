// Measures of a leaf, in its flat chart.
#pragma once

#include <span>
#include <vector>

#include "models/leaf/shape/margin.hpp"
#include "models/particles/outline.hpp"
#include "models/particles/trail_plant.hpp"
#include "models/particles/trails.hpp"
#include "models/particles/vein_orders.hpp"

namespace panicle::particles::leaf {

// The measured leaf: trails in leaf lengths, and the energy of each crowd by which thickness is scaled.
struct Measured {
  const Margin& margin;
  const Outline& outline;
  std::span<const Trails> crowds;
  std::span<const Vein> veins;
  std::span<const double> all;
  const Girth& girth;  // metres
  float length;        // metres to a leaf length
};

// In the order of the table (measures.generated.hpp); NaN where one does not apply.
std::vector<float> measures_of(const Measured& leaf);

}  // namespace panicle::particles::leaf
