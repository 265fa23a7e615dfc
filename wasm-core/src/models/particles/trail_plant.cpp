#include "models/particles/trail_plant.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "models/particles/messages.generated.hpp"

namespace panicle::particles {

// A trail is the way that a particle has gone, from its start to the target.

namespace {

// The greatest energy that flows into each place.
std::vector<double> heaviest_inflow(const Trails& trails) {
  std::vector<double> heaviest(trails.size(), 0);
  for (std::size_t i = 0; i < trails.size(); ++i)
    if (trails.next[i] >= 0) {
      double& most = heaviest[static_cast<std::size_t>(trails.next[i])];
      most = std::max(most, trails.energy[i]);
    }
  return heaviest;
}

}  // namespace

// The radius of a trail through which `energy` of the energy of `all` particles flows, by the law of the girth.
float radius_of(const Girth& girth, double energy, double all) {
  const float share = all > 0 ? static_cast<float>(energy / all) : 0;
  const float part = girth.law == WidthLaw::linear        ? share
                     : girth.law == WidthLaw::square_root ? std::sqrt(share)
                                                          : power(share, girth.exponent);
  return std::max(girth.thickest * part, girth.thinnest);
}

// Adds the trails of each target as segments with the given tag, and all counts and columns on them. `frame` maps the
// trails' places into the plant. Returns the segment of each place, by target; −1 for places that lead nowhere.
std::vector<std::vector<std::int32_t>> add_trails(Plant& plant, std::span<const Trails> crowds,
                                                  std::span<const double> all, const Girth& girth, const Frame& frame,
                                                  const RunTotals& tally, std::uint32_t tag) {
  std::vector<std::vector<std::int32_t>> numbers;
  std::vector<float> energy, target_places, target_energy;
  std::vector<std::uint32_t> born;
  for (std::size_t c = 0; c < crowds.size(); ++c) {
    const Trails& trails = crowds[c];
    const std::vector<double> inflow = heaviest_inflow(trails);
    std::vector<std::int32_t>& number = numbers.emplace_back(trails.size(), -1);
    // A segment for each place that leads on, from there to the next, which has its number already.
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.next[i] < 0) continue;
      const auto next = static_cast<std::size_t>(trails.next[i]);
      number[i] = static_cast<std::int32_t>(plant.segments.size());
      // Thickness at its beginning is its own; at its end that of the heaviest which goes on from there.
      plant.segments.push_back({number[next], tag, frame(trails.places[next]), frame(trails.places[i]),
                                radius_of(girth, trails.energy[i], all[c]), radius_of(girth, inflow[i], all[c])});
      energy.push_back(static_cast<float>(trails.energy[i]));
      born.push_back(trails.born[i]);
    }
    if (trails.size() == 0) continue;
    const glm::vec3 target = frame(trails.places[0]);
    target_places.insert(target_places.end(), {target.x, target.y, target.z});
    target_energy.push_back(static_cast<float>(trails.energy[0]));
  }
  plant.counts.push_back({"particles", tally.particles});
  plant.counts.push_back({"energy", static_cast<std::uint32_t>(tally.energy + 0.5)});
  plant.counts.push_back({"merges", tally.merges});
  plant.counts.push_back({"steps", tally.steps});
  plant.counts.push_back({"segments", static_cast<std::uint32_t>(plant.segments.size())});
  plant.counts.push_back({"targets", static_cast<std::uint32_t>(target_energy.size())});
  if (tally.stragglers > 0) plant.notes.push_back(message(messages::particles::particles_led, tally.stragglers));
  plant.columns.add("segments.energy", std::move(energy));
  plant.columns.add("segments.born", std::move(born));
  plant.columns.add("targets.places", std::move(target_places), 3);
  plant.columns.add("targets.energy", std::move(target_energy));
  return numbers;
}

}  // namespace panicle::particles
