// A row of a model's table of parameters (parameters.generated.hpp).
#pragma once

#include <string_view>

namespace panicle {

struct ParameterInfo {
  std::string_view key;
  std::string_view define;  // the grammar's #define it replaces; empty for none
  std::string_view where;   // the option that must be chosen for it to take effect; empty: always
  float min, max;
  float gap_below;  // values strictly between 0 and this are raised to it; 0 for none
  float standard;
  bool whole;
};

}  // namespace panicle
