#include "models/bunch/natural/harvest.hpp"

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/berry_size.hpp"
#include "models/bunch/natural/random_value.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/units.hpp"

namespace panicle::bunch {
namespace {

constexpr float seat_depth = 0.96f;  // of a berry's half length, from its centre to where the pedicel ends

// Adds the berry or ovary of the flower with index `flower`. `place`: the internode it sits on; `body`: its shape,
// millimetres. Its ball is the sphere of the same volume.
void add_berry(Harvest& harvest, std::uint32_t flower, const Flower& of, std::int32_t place, const BerryBody& body) {
  const float ball = body.half_width * cube_root(body.half_length / body.half_width);
  harvest.berries.push_back(
      {body.centre * metres_per_millimetre, ball * metres_per_millimetre, body.direction, place, of.id, of.module});
  harvest.bodies.push_back(body);
  harvest.flowers.push_back(flower);
}

}  // namespace

// The state of each flower at `age` (0 … 125 percent of ripeness): berry, stub of a lost berry, flower that has not
// fallen yet, or fallen. `size`: width of berries now over ripe ones.
std::vector<FlowerOutcome> outcomes_of(const Crop& crop, std::span<const Flower> flowers, std::uint64_t seed, float age,
                                       float size) {
  std::vector<FlowerOutcome> outcomes(flowers.size());
  for (std::size_t i = 0; i < flowers.size(); ++i)
    if (!(crop.set.volumes[i] > 0) && age < age_of_fall(random_value_of(flowers[i], seed, "fall")))
      outcomes[i].state = FlowerState::flower;
  const Swollen& swollen = crop.swollen;
  for (std::size_t k = 0; k < crop.fruitlets.size(); ++k) {
    FlowerOutcome& outcome = outcomes[crop.fruitlets[k].flower];
    outcome.state = crop.is_lost(k) ? FlowerState::stub : FlowerState::berry;
    outcome.seat = swollen.centres[k] - swollen.directions[k] * (seat_depth * crop.half_length(k, size));
  }
  return outcomes;
}

// Collects the berries that found room and the flowers at their places on the bent skeleton, and lists the lost ones.
Harvest harvest(const Crop& crop, const Sprout& sprout, const Hanging& hanging, std::span<const FlowerOutcome> outcomes,
                const BentSkeleton& bent, float size, float ripe_width) {
  Harvest harvest;
  const Swollen& swollen = crop.swollen;
  const auto place_of = [&](const Flower& flower) { return bent.place_of[static_cast<std::size_t>(flower.parent)]; };
  for (std::size_t k = 0; k < crop.fruitlets.size(); ++k) {
    const Fruitlet& fruitlet = crop.fruitlets[k];
    const Flower& flower = sprout.flowers[fruitlet.flower];
    if (crop.is_lost(k))
      harvest.thinned.push_back(
          {flower.id, swollen.lost[k], swollen.ends[crop.berries[k].branch] * metres_per_millimetre});
    else
      add_berry(harvest, fruitlet.flower, flower, place_of(flower),
                {swollen.centres[k], swollen.directions[k], crop.half_width(k, size), crop.half_length(k, size), 0,
                 flower.id});
  }
  const float half = ovary_width(ripe_width) / 2;
  for (std::uint32_t i = 0; i < outcomes.size(); ++i) {
    const Flower& flower = sprout.flowers[i];
    if (outcomes[i].state == FlowerState::flower) {
      const std::int32_t place = place_of(flower);
      const glm::vec3 end = bent.internodes[static_cast<std::size_t>(place)].end / metres_per_millimetre;
      add_berry(harvest, i, flower, place, {end + flower.heading * half, flower.heading, half, half, 0, flower.id});
    } else if (outcomes[i].state == FlowerState::fallen) {
      const std::int32_t from = hanging.stalk_from[static_cast<std::size_t>(flower.parent)];
      const Internode& first = sprout.internodes[static_cast<std::size_t>(from < 0 ? flower.parent : from)];
      harvest.thinned.push_back(
          {flower.id, RemovalReason::not_set, (from < 0 ? first.end : first.start) * metres_per_millimetre});
    }
  }
  return harvest;
}

}  // namespace panicle::bunch
