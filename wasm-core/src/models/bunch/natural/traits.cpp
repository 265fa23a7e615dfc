#include "models/bunch/natural/traits.hpp"

#include "models/bunch/natural/random_value.hpp"
#include "models/bunch/units.hpp"

namespace panicle::bunch {

// Computes a berry's traits at the season's age: its stage by ripening.hpp, and the number of its seeds. The flower's
// own random values decide how early it ripens.
Traits traits_of(const RipeningInputs& berry, const Flower& flower, const Season& season, std::uint64_t seed) {
  const float random_value = random_value_of(flower, seed, "ripen");
  const Stage stage = stage_at(season.age, {berry.along, random_value, berry.exposure, season.sunlight, season.vigour});
  Traits traits;
  traits.width = 2 * berry.body.half_width * metres_per_millimetre;
  traits.length = 2 * berry.body.half_length * metres_per_millimetre;
  traits.exposure = berry.exposure;
  traits.turned = stage.turned;
  traits.opened = stage.opened;
  traits.set = berry.sets ? stage.set : 0;
  traits.shrivel = stage.shrivel;
  traits.seeds = seeds_of(random_value, random_value_of(flower, seed, "seeds"), season.seeds);
  return traits;
}

}  // namespace panicle::bunch
