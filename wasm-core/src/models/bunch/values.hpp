// A request's parameters, complete and in range.
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

  // The values that replace a #define: those given, and no others, so that a text's own constants stand.
  std::vector<lsystem::Inputs::Scalar> defines() const;
  // Their rows of the table.
  std::vector<const ParameterInfo*> defining() const;

  Profile profile() const;

 private:
  std::array<float, parameter_count> values_ = {};
  std::array<bool, parameter_count> given_ = {};
};

}  // namespace panicle::bunch
