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
constexpr float max_step = 0.7f;
constexpr float usual_steepness = 1.4f, least_steepness = 0.7f, max_steepness = 3;

// A tried fill (the limit of the ranks that set) and the crowding that results, both as logarithms.
struct FillSample {
  float fill = 0;
  float crowding = 0;
};

// A berry that sets. Its `crowd` is the volume of its neighbours, weighted by a kernel of their distances.
struct Berry {
  float volume;
  std::uint32_t bunch;
  float pushed;  // how far it will be pushed inside
  float crowd;
};

}  // namespace

// The share of space that other berries fill about a berry, as a harmonic mean over all berries by volume. Lengths are
// divided by the elongation first, so that berries are round.
// The kernel of two berries at distance r is (1 − r²/h²)², for the reach h; each pair is added to both berries.
float crowding(std::span<const Bud> buds, std::span<const float> volumes, const BerrySize& berry) {
  std::vector<Berry> berries;
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < buds.size(); ++i) {
    if (!(volumes[i] > 0)) continue;
    const glm::vec3& place = buds[i].place;
    places.emplace_back(place.x, place.y / berry.elongation, place.z);
    berries.push_back({volumes[i], buds[i].bunch, 1 + pushed_in * buds[i].misplaced, 0});
  }
  const float reach = near * berry.size, reach_squared = reach * reach;
  const PointGrid grid(places, reach / 2);
  const std::span<const std::uint32_t> ids = grid.ids();
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    const glm::vec3 place = places[i];
    grid.within(place - reach, place + reach, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; ++slot) {
        const std::uint32_t j = ids[slot];
        if (j <= i || berries[j].bunch != berries[i].bunch) continue;
        const glm::vec3 between = places[j] - place;
        const float weight_root =
            1 - (between.x * between.x + between.y * between.y + between.z * between.z) / reach_squared;
        if (!(weight_root > 0)) continue;
        berries[i].crowd += weight_root * weight_root * berries[j].volume;
        berries[j].crowd += weight_root * weight_root * berries[i].volume;
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

// The crowding of bunches of a density, 1 … 9: between the values of a table, more for long berries.
float crowding_at(float density, float elongation) {
  const float place = std::clamp(density - 1, 0.0f, 7.999f);
  const auto below = static_cast<std::size_t>(place);
  const float round =
      crowdings[below] + (crowdings[below + 1] - crowdings[below]) * (place - static_cast<float>(below));
  return round * power(elongation, longer_by);
}

// Finds the fill with which flowers of these ranks are as crowded as the density requires: a few steps of the secant
// method on logarithms, whose slope is limited, so that the result is smooth.
float fill_for(std::span<const Bud> buds, std::span<const float> ranks, float density, const BerrySize& berry) {
  const auto attempt = [&](float fill) {
    const std::vector<float> volumes = choose_set({ranks.begin(), ranks.end()}, exponential(fill));
    return FillSample{fill, logarithm(std::max(crowding(buds, volumes, berry), 1e-6f))};
  };
  const float wanted = logarithm(crowding_at(density, berry.elongation));
  FillSample last = attempt(logarithm(fill_of(density)));
  float steepness = usual_steepness;
  for (int k = 0; k < tries; ++k) {
    const float step = std::clamp((wanted - last.crowding) / steepness, -max_step, max_step);
    const FillSample next = attempt(last.fill + step);
    // Weight of the chord: near 1 where the two points are far enough apart for a slope.
    const float reliability = step * step / (step * step + 1e-4f);
    const float chord = std::abs(step) > 0 ? (next.crowding - last.crowding) / step : 0;
    steepness = std::clamp(usual_steepness + reliability * (chord - usual_steepness), least_steepness, max_steepness);
    last = next;
  }
  return exponential(last.fill + std::clamp((wanted - last.crowding) / steepness, -max_step, max_step));
}

}  // namespace panicle::bunch
