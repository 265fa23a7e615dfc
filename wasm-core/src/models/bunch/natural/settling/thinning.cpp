#include "models/bunch/natural/settling/thinning.hpp"

#include <algorithm>

namespace panicle::bunch {
namespace {

constexpr float max_pressed = 0.3f;  // share of a berry's volume, by caps beyond its contacts

// The share of a berry's volume in the cap that a neighbour cuts off at an overlap of `deep` millimetres: a ball's cap,
// π h² (3 r − h) / 3, over the volume of ball and cylindrical core.
float pressed_share_of(const SwollenSize& size, float deep) {
  const float r = size.ball, h = std::min(deep, r);
  return h * h * (3 * r - h) / (4 * r * r * r + 6 * r * r * size.core);
}

}  // namespace

// The indices of the berries that are pressed too much: those above the limit, of whose pairs each other berry is
// pressed less.
std::vector<std::uint32_t> crowded_out(std::span<const PressedPair> presses, std::span<const SwollenSize> sizes) {
  std::vector<float> pressed(sizes.size(), 0);
  for (const auto& [a, b, deep] : presses) {
    if (deep <= 0) continue;
    pressed[a] += pressed_share_of(sizes[a], deep);
    pressed[b] += pressed_share_of(sizes[b], deep);
  }
  std::vector<std::uint8_t> keeps(sizes.size(), 0);
  for (const auto& [a, b, deep] : presses) (pressed[a] > pressed[b] ? keeps[b] : keeps[a]) = 1;
  std::vector<std::uint32_t> lost;
  for (std::uint32_t i = 0; i < sizes.size(); ++i)
    if (pressed[i] > max_pressed && !keeps[i]) lost.push_back(i);
  return lost;
}

}  // namespace panicle::bunch
