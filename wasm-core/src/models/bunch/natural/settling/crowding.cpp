#include "models/bunch/natural/settling/crowding.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/natural_plan.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::bunch {
namespace {

constexpr float near = 2;  // reach, in berry widths
// The kernel (1 − r²/h²)² holds 32 π h³ / 105, a berry π / 6.
constexpr float filled_by_one = (1.0f / 6) / (32.0f / 105 * near * near * near);
constexpr float middling = 0.365f;  // share of space about berries of a middling bunch
// The crowding of bunches of densities 1 … 9, of round berries.
constexpr float crowdings[] = {0.036f, 0.061f, 0.096f, 0.139f, 0.192f, 0.262f, 0.358f, 0.525f, 1.1f};
constexpr float pushed_in = 2;     // factor by which a width outside the outline crowds a berry more
constexpr float longer_by = 0.6f;  // power of the elongation: long berries lie side by side
// The search uses Newton's method on logarithms: there crowding rises with the fill almost evenly.
constexpr int tries = 3;
constexpr float most_step = 0.7f;
constexpr float usual_steepness = 1.4f, least_steepness = 0.7f, most_steepness = 3;

struct FillSample {
  float fill = 0;
  float crowding = 0;
};

struct Berry {
  float volume;
  std::uint32_t bunch;
  float pushed;  // how far it will be pushed inside
  float crowd;
};

}  // namespace

float crowding(std::span<const Bud> buds, std::span<const float> volumes, const BerrySize& berry) {
  std::vector<Berry> berries;
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < buds.size(); ++i) {
    if (!(volumes[i] > 0)) continue;
    const glm::vec3& place = buds[i].place;
    places.emplace_back(place.x, place.y / berry.elongation, place.z);
    berries.push_back({volumes[i], buds[i].bunch, 1 + pushed_in * buds[i].misplaced, 0});
  }
  const float reach = near * berry.size, square = reach * reach;
  const PointGrid grid(places, reach / 2);
  const std::span<const std::uint32_t> ids = grid.ids();
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    const glm::vec3 place = places[i];
    grid.within(place - reach, place + reach, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; ++slot) {
        const std::uint32_t j = ids[slot];
        if (j <= i || berries[j].bunch != berries[i].bunch) continue;
        const glm::vec3 between = places[j] - place;
        const float within = 1 - (between.x * between.x + between.y * between.y + between.z * between.z) / square;
        if (!(within > 0)) continue;
        berries[i].crowd += within * within * berries[j].volume;
        berries[j].crowd += within * within * berries[i].volume;
      }
    });
  }
  float all = 0, open = 0;
  for (const Berry& each : berries) {
    all += each.volume;
    open += each.volume / (1 + each.pushed * each.crowd * filled_by_one / middling);
  }
  return open > 0 ? middling * (all / open - 1) : 0;
}

float crowding_at(float density, float elongation) {
  const float place = std::clamp(density - 1, 0.0f, 7.999f);
  const auto below = static_cast<std::size_t>(place);
  const float round =
      crowdings[below] + (crowdings[below + 1] - crowdings[below]) * (place - static_cast<float>(below));
  return round * power(elongation, longer_by);
}

float fill_for(std::span<const Bud> buds, std::span<const float> ranks, float density, const BerrySize& berry) {
  const auto attempt = [&](float fill) {
    const std::vector<float> volumes = choose_set({ranks.begin(), ranks.end()}, exponential(fill));
    return FillSample{fill, logarithm(std::max(crowding(buds, volumes, berry), 1e-6f))};
  };
  const float wanted = logarithm(crowding_at(density, berry.elongation));
  FillSample last = attempt(logarithm(fill_of(density)));
  float steepness = usual_steepness;
  for (int k = 0; k < tries; ++k) {
    const float step = std::clamp((wanted - last.crowding) / steepness, -most_step, most_step);
    const FillSample next = attempt(last.fill + step);
    // Weight of the chord: near 1 where the two points are far enough apart for a slope.
    const float reliability = step * step / (step * step + 1e-4f);
    const float chord = std::abs(step) > 0 ? (next.crowding - last.crowding) / step : 0;
    steepness = std::clamp(usual_steepness + reliability * (chord - usual_steepness), least_steepness, most_steepness);
    last = next;
  }
  return exponential(last.fill + std::clamp((wanted - last.crowding) / steepness, -most_step, most_step));
}

}  // namespace panicle::bunch
