#include "models/bunch/values.hpp"

#include <algorithm>
#include <cmath>

namespace panicle::bunch {
namespace {

float admitted(float value, const ParameterInfo& info, std::vector<std::string>& notes) {
  float fitting = std::clamp(value, info.min, info.max);
  if (fitting > 0 && fitting < info.gap_below) fitting = info.gap_below;
  if (info.whole) fitting = std::floor(fitting + 0.5f);
  if (fitting != value) notes.push_back("Parameter " + std::string(info.key) + " was brought into its range.");
  return fitting;
}

}  // namespace

Values::Values(const std::vector<float>& requested, std::vector<std::string>& notes) {
  for (std::uint32_t i = 0; i < parameter_count; ++i) {
    const ParameterInfo& info = parameter_table[i];
    given_[i] = i < requested.size() && requested[i] == requested[i];
    values_[i] = given_[i] ? admitted(requested[i], info, notes) : info.standard;
  }
}

std::vector<const ParameterInfo*> Values::defining() const {
  std::vector<const ParameterInfo*> rows;
  for (std::uint32_t i = 0; i < parameter_count; ++i)
    if (given_[i] && !parameter_table[i].define.empty()) rows.push_back(&parameter_table[i]);
  return rows;
}

std::vector<lsystem::Inputs::Scalar> Values::defines() const {
  std::vector<lsystem::Inputs::Scalar> scalars;
  for (const ParameterInfo* row : defining())
    scalars.push_back({std::string(row->define), values_[static_cast<std::size_t>(row - parameter_table.data())]});
  return scalars;
}

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
