#include "models/particles/extent.hpp"

#include <array>
#include <cstdint>

namespace panicle::particles {
namespace {

constexpr std::uint32_t probes = 1u << 17;
// Steps of the most even additive recurrences in two and in three dimensions: powers of the inverse roots of x³ = x + 1
// and x⁴ = x + 1 (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"), of 2³².
constexpr std::array<std::uint32_t, 3> steps_flat{3242174889, 2447445414, 0},
    steps_deep{3518319155, 2882110345, 2360945575};
constexpr float unit = 1.0f / 4294967296.0f;

}  // namespace

// Measures a region's area or volume, and the same weighted by its density, by quasi-random points in its box.
Extent extent_of(const Region& region) {
  const glm::vec3 low = region.low(), size = region.high() - low;
  const std::array<std::uint32_t, 3>& steps = region.flat() ? steps_flat : steps_deep;
  std::uint32_t inside = 0;
  double filled = 0;
  for (std::uint32_t k = 1; k <= probes; ++k) {
    const glm::vec3 p = low + size * (unit * glm::vec3(k * steps[0], k * steps[1], k * steps[2]));
    if (!region.contains(p)) continue;
    ++inside;
    filled += static_cast<double>(region.density(p));
  }
  const float box = size.x * size.y * (region.flat() ? 1 : size.z) / static_cast<float>(probes);
  return {static_cast<float>(inside) * box, static_cast<float>(filled) * box};
}

}  // namespace panicle::particles
