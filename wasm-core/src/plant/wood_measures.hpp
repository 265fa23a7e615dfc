// The measures of a tree and of a root.
#pragma once

#include <cstddef>
#include <vector>

#include "plant/branching.hpp"

namespace panicle {

// Measures in the order of a model's table. `Measure`: its enumeration, in which both tables have the same keys for
// branching; the caller sets the others.
template <class Measure>
class WoodMeasures {
 public:
  WoodMeasures(const Branching& branching, std::size_t count) : values_(count) {
    set(Measure::spread, 0.5f * (branching.width_x + branching.width_z));
    set(Measure::wood_length, branching.length);
    set(Measure::wood_volume, 1000 * branching.volume);
    set(Measure::tips, branching.tips);
    set(Measure::forks, branching.forks);
    set(Measure::order, branching.order);
    set(Measure::order1, branching.of_order[0]);
    set(Measure::order2, branching.of_order[1]);
    set(Measure::order3, branching.of_order[2]);
    set(Measure::bifurcation, branching.bifurcation);
    set(Measure::fork_angle, branching.fork_angle);
  }

  void set(Measure measure, double value) { values_[static_cast<std::size_t>(measure)] = static_cast<float>(value); }
  const std::vector<float>& values() const { return values_; }

 private:
  std::vector<float> values_;
};

}  // namespace panicle
