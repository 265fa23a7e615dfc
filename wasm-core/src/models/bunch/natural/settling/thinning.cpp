#include "models/bunch/natural/settling/thinning.hpp"

#include <algorithm>

namespace panicle::bunch {
namespace {

constexpr float most_pressed = 0.3f;  // share of a berry's volume, by caps beyond its contacts

// The volume of a cap of a berry, as a share of the berry's; the ball's cap is the measure.
float cap_share(const SwollenSize& size, float deep) {
  const float r = size.ball, h = std::min(deep, r);
  return h * h * (3 * r - h) / (4 * r * r * r + 6 * r * r * size.core);
}

}  // namespace

std::vector<std::uint32_t> crowded_out(std::span<const PressedPair> presses, std::span<const SwollenSize> sizes) {
  std::vector<float> pressed(sizes.size(), 0);
  for (const auto& [a, b, deep] : presses) {
    if (deep <= 0) continue;
    pressed[a] += cap_share(sizes[a], deep);
    pressed[b] += cap_share(sizes[b], deep);
  }
  std::vector<std::uint8_t> keeps(sizes.size(), 0);
  for (const auto& [a, b, deep] : presses) (pressed[a] > pressed[b] ? keeps[b] : keeps[a]) = 1;
  std::vector<std::uint32_t> lost;
  for (std::uint32_t i = 0; i < sizes.size(); ++i)
    if (pressed[i] > most_pressed && !keeps[i]) lost.push_back(i);
  return lost;
}

}  // namespace panicle::bunch
