// The measures of a tree and of a root.
#pragma once

#include <cstddef>

#include "plant/branching.hpp"
#include "plant/measures.hpp"

namespace panicle {

// The measures of branching, for which the models' tables have the same keys; the caller sets the others.
template <class Measure>
Measures<Measure> wood_measures(const Branching& branching, std::size_t count) {
  Measures<Measure> measures(count, 0);
  measures.set(Measure::spread, 0.5f * (branching.width_x + branching.width_z));
  measures.set(Measure::wood_length, branching.length);
  measures.set(Measure::wood_volume, 1000 * branching.volume);
  measures.set(Measure::tips, branching.tips);
  measures.set(Measure::forks, branching.forks);
  measures.set(Measure::order, branching.order);
  measures.set(Measure::order1, branching.of_order[0]);
  measures.set(Measure::order2, branching.of_order[1]);
  measures.set(Measure::order3, branching.of_order[2]);
  measures.set(Measure::bifurcation, branching.bifurcation);
  measures.set(Measure::fork_angle, branching.fork_angle);
  return measures;
}

}  // namespace panicle
