// The parameters of a request, complete and in range.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lsystem/lsystem.hpp"
#include "models/bunch/parameters.generated.hpp"
#include "models/bunch/plan.hpp"

namespace panicle::bunch {

class Values {
 public:
  // Missing and NaN values have their default; values out of range are clamped, with a note.
  Values(const std::vector<float>& requested, std::vector<std::string>& notes);

  float operator[](Parameter key) const { return values_[static_cast<std::uint32_t>(key)]; }

  // The values that replace a #define: only the given ones, so that a text's own constants stay.
  std::vector<lsystem::Inputs::Scalar> defines() const;
  // The table rows of these values.
  std::vector<const ParameterInfo*> defining() const;

  Profile profile() const;

 private:
  std::array<float, parameter_count> values_ = {};
  std::array<bool, parameter_count> given_ = {};
};

}  // namespace panicle::bunch
