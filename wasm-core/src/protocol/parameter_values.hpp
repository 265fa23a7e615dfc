// The parameters of a request in the order of a model's table, clamped to their ranges, with a note on each that was
// outside.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "protocol/parameter_info.hpp"

namespace panicle {

// Whether row `i` of the table has a value in the request: missing values and NaN have none.
inline bool is_given(std::span<const float> requested, std::size_t i) {
  return i < requested.size() && requested[i] == requested[i];
}

// The requested value of row `i` in its range, with a note where it was outside; the default where there is none.
float parameter_value(const ParameterInfo& info, std::span<const float> requested, std::size_t i,
                      std::vector<std::string>& notes);

// `Parameter` and `table` as generated from the model's table.
template <class Parameter, const auto& table>
class Values {
 public:
  // Reads all parameters; notes are added for those out of range.
  Values(std::span<const float> requested, std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < table.size(); ++i) values_[i] = parameter_value(table[i], requested, i, notes);
  }

  float operator[](Parameter parameter) const { return values_[static_cast<std::size_t>(parameter)]; }
  // The value of a whole-number parameter.
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
