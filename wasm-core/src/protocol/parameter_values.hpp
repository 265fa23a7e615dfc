// The parameters of a request in the order of a model's table, clamped to their ranges, with a note on each that was
// outside.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace panicle {

// `Parameter` and `table` as generated from the model's table.
template <class Parameter, const auto& table>
class Values {
 public:
  // Missing values and NaN get the default.
  Values(std::span<const float> requested, std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < table.size(); ++i) {
      const auto& info = table[i];
      values_[i] = info.standard;
      if (i >= requested.size() || requested[i] != requested[i]) continue;
      float fitting = std::clamp(requested[i], info.min, info.max);
      if (info.whole) fitting = std::floor(fitting + 0.5f);
      if (fitting != requested[i])
        notes.push_back("Parameter " + std::string(info.key) + " was brought into its range.");
      values_[i] = fitting;
    }
  }

  float operator[](Parameter parameter) const { return values_[static_cast<std::size_t>(parameter)]; }
  std::uint32_t whole(Parameter parameter) const { return static_cast<std::uint32_t>((*this)[parameter]); }
  // The chosen option, where the options are in the order of an enumeration.
  template <class Choice>
  Choice choice(Parameter parameter) const {
    return static_cast<Choice>(whole(parameter));
  }

 private:
  std::array<float, table.size()> values_{};
};

}  // namespace panicle
