#include "protocol/parameter_values.hpp"

#include <algorithm>
#include <cmath>

#include "protocol/messages.generated.hpp"

namespace panicle {

// The value of parameter `i`: the requested one, moved into its range and rounded if it must be whole, with a note if
// that changes it; otherwise the default.
float parameter_value(const ParameterInfo& info, std::span<const float> requested, std::size_t i,
                      std::vector<std::string>& notes) {
  if (!is_given(requested, i)) return info.standard;
  float fitting = std::clamp(requested[i], info.min, info.max);
  if (fitting > 0 && fitting < info.gap_below) fitting = info.gap_below;
  if (info.whole) fitting = std::floor(fitting + 0.5f);
  if (fitting != requested[i]) notes.push_back(message(messages::protocol::parameter_clamped, info.key));
  return fitting;
}

}  // namespace panicle
