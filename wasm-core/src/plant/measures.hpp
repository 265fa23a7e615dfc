// The measures of a plant, in the order of its model's table.
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace panicle {

// `Measure`: the enumeration that is generated from the table.
template <class Measure>
class Measures {
 public:
  // `otherwise`: the value of those that are not set; NaN: they do not apply.
  explicit Measures(std::size_t count, float otherwise = std::numeric_limits<float>::quiet_NaN())
      : values_(count, otherwise) {}

  float& operator[](Measure measure) { return values_[static_cast<std::size_t>(measure)]; }
  // Sets one measure; the others are NaN.
  void set(Measure measure, double value) { (*this)[measure] = static_cast<float>(value); }
  std::vector<float> take() { return std::move(values_); }

 private:
  std::vector<float> values_;
};

}  // namespace panicle
