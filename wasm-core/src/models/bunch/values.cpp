#include "models/bunch/values.hpp"

#include "protocol/parameter_values.hpp"

namespace panicle::bunch {

// The values of all parameters: the requested ones, limited, or the defaults.
Values::Values(const std::vector<float>& requested, std::vector<std::string>& notes) {
  for (std::uint32_t i = 0; i < parameter_count; ++i) {
    given_[i] = is_given(requested, i);
    values_[i] = parameter_value(parameter_table[i], requested, i, notes);
  }
}

// The given parameters that define a constant of the text.
std::vector<const ParameterInfo*> Values::defining() const {
  std::vector<const ParameterInfo*> rows;
  for (std::uint32_t i = 0; i < parameter_count; ++i)
    if (given_[i] && !parameter_table[i].define.empty()) rows.push_back(&parameter_table[i]);
  return rows;
}

// The names and values of those constants.
std::vector<lsystem::Inputs::Scalar> Values::defines() const {
  std::vector<lsystem::Inputs::Scalar> scalars;
  for (const ParameterInfo* row : defining())
    scalars.push_back({std::string(row->define), values_[static_cast<std::size_t>(row - parameter_table.data())]});
  return scalars;
}

// The outline by the handles: its length, and a point for each of the four sides.
Profile Values::profile() const {
  using enum Parameter;
  const Values& values = *this;
  return {values[l],
          {{{values[p3w], values[p3r]},
            {values[p4w], values[p4r]},
            {values[p5w], values[p5r]},
            {values[p6w], values[p6r]}}}};
}

}  // namespace panicle::bunch
