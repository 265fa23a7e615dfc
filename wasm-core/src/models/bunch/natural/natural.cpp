#include "models/bunch/natural/natural.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>

#include "models/bunch/berry/flower.hpp"
#include "models/bunch/derived_bunch.hpp"
#include "models/bunch/foliage/foliage.hpp"
#include "models/bunch/measures/measures.hpp"
#include "models/bunch/messages.generated.hpp"
#include "models/bunch/natural/berry_size.hpp"
#include "models/bunch/natural/crop.hpp"
#include "models/bunch/natural/harvest.hpp"
#include "models/bunch/natural/individual.hpp"
#include "models/bunch/natural/peduncle.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/natural/settling/exposure.hpp"
#include "models/bunch/natural/situation.hpp"
#include "models/bunch/natural/traits.hpp"
#include "models/bunch/natural/wing.hpp"
#include "models/bunch/units.hpp"

namespace panicle::bunch {

// The peduncle is the stalk of the bunch.

namespace {

using enum Parameter;

constexpr float count_met = 0.97f;  // share of a count; below it a note is added

// The requested number, density and size of berries, and their greatest number by space and limits.
CropTarget crop_target_for(const BunchRequest& request, const Values& values, const Limits& limits,
                           std::span<const NaturalPlan> plans) {
  CropTarget target;
  target.count = values[count];
  target.density = values[density];
  target.limit = limits.bodies;
  for (const NaturalPlan& plan : plans) {
    target.most += plan.room;
  }
  target.most = std::min(target.most, static_cast<float>(target.limit));
  target.berry = {values[size], values[elongation]};
  target.taken = request.thinned;
  std::sort(target.taken.begin(), target.taken.end());
  return target;
}

// Makes a bud of each flower. Its chance, of which the lowest set first, is the flower's turn over the fill that the
// random gaps of its bunch give the place.
std::vector<Bud> buds_of(std::span<const Flower> flowers, std::span<const Situation> situations, const Values& values,
                         std::uint64_t seed) {
  const auto gaps_for = [&](std::uint64_t own) { return Gaps(own, values[variability], values[size]); };
  const Gaps gaps[] = {gaps_for(seed), gaps_for(second_seed(seed))};
  std::vector<Bud> buds;
  buds.reserve(flowers.size());
  for (std::size_t i = 0; i < flowers.size(); ++i) {
    const glm::vec3& place = situations[i].place;
    const float chance = turn_of(flowers[i], seed) / gaps[flowers[i].bunch].fill_at(place);
    buds.push_back({place, chance, situations[i].misplaced, flowers[i].strength, flowers[i].bunch});
  }
  return buds;
}

// Per flower, the width of its berry over the mean one.
std::vector<float> shares_of(std::span<const Flower> flowers, std::span<const Situation> situations,
                             const Values& values, std::uint64_t seed) {
  const GrowthConditions nurture{values[spread] / 100, values[sunlight], values[vigour]};
  std::vector<float> shares;
  shares.reserve(flowers.size());
  for (std::size_t i = 0; i < flowers.size(); ++i)
    shares.push_back(width_share(flowers[i], situations[i], nurture, seed));
  return shares;
}

// Computes the traits of all berries and flowers, and how far their bodies have dried.
std::vector<Traits> ripen(Harvest& harvest, const Crop& crop, std::span<const Flower> flowers,
                          std::span<const Situation> situations, const Season& season, const glm::vec3& sunward,
                          std::uint64_t seed) {
  const std::vector<float> exposure = sun_exposure(harvest.bodies, sunward);
  std::vector<Traits> traits;
  traits.reserve(exposure.size());
  for (std::size_t k = 0; k < exposure.size(); ++k) {
    const std::uint32_t i = harvest.flowers[k];
    const RipeningInputs berry{harvest.bodies[k], situations[i].along, exposure[k], crop.set.volumes[i] > 0};
    traits.push_back(traits_of(berry, flowers[i], season, seed));
    harvest.bodies[k].shrivel = traits.back().shrivel;
  }
  return traits;
}

// The number of segments for a bunch that fills a view 700 pixels high: its outline is a third of a pixel off a round
// one at the most, n = π / √(2 · 0.38 / r) at a radius of r pixels.
std::uint32_t segments_for(std::span<const BerryBody> bodies) {
  constexpr float view = 700, per_root = 3.6f, least = 8, most = 24;
  if (bodies.empty()) return static_cast<std::uint32_t>(least);
  glm::vec3 low = bodies[0].centre, high = low;
  float radius = 0;
  for (const BerryBody& body : bodies) {
    low = glm::min(low, body.centre);
    high = glm::max(high, body.centre);
    radius += body.half_width / static_cast<float>(bodies.size());
  }
  const glm::vec3 extent = high - low + 2 * radius;
  const float pixels = view * radius / std::max({extent.x, extent.y, extent.z});
  const float even = 2 * std::floor(per_root * std::sqrt(pixels) / 2 + 0.5f);
  return static_cast<std::uint32_t>(std::clamp(even, least, most));
}

// Ovaries are a millimetre wide, and there are hundreds: as few triangles as keep them round.
constexpr std::uint32_t ovary_segments = 6;

// The mesh of all berries, pressed against each other; metres. `segments` is the requested number round a berry; 0
// chooses it by the berries' size in the picture.
BerrySurfaces surfaces_of(std::span<const BerryBody> bodies, const BerryForm& form, std::uint32_t segments,
                          bool flowering) {
  BerryOptions options;
  const std::uint32_t own = flowering ? ovary_segments : segments_for(bodies);
  options.segments = segments ? std::clamp(segments, 6u, 128u) : own;
  BerrySurfaces surfaces = press_berries(bodies, form, options);
  for (float& x : surfaces.positions) x *= metres_per_millimetre;
  return surfaces;
}

// Whether the bunch hangs from a cane, which leaves need too.
bool on_cane(const Values& values) { return values[leaves] > 0 || values[cane] != 0; }

// Adds the peduncle above the bent skeleton. Returns the internode at which the second bunch begins; -1 without one.
std::int32_t add_peduncle_above(BentSkeleton& bent, const Sprout& bunch, const Values& values, std::uint64_t seed) {
  constexpr float least_under_cane = 30;  // millimetres: berries and cane have room
  const float length = std::max(values[peduncle], on_cane(values) ? least_under_cane : 0.0f);
  const std::int32_t root = bunch.second_root < 0 ? -1 : bent.place_of[static_cast<std::size_t>(bunch.second_root)];
  const Fork fork{root, fork_height(values[size]) * metres_per_millimetre};
  const std::int32_t moved = add_peduncle(bent.internodes, length * metres_per_millimetre, seed, fork);
  for (std::int32_t& place : bent.place_of)
    if (place >= 0) place += moved;
  return root < 0 ? -1 : root + moved;
}

// A cane for a bunch to hang from, with leaves as wide as the bunch's upper part.
std::optional<Foliage> foliage_for(const BunchRequest& request, const Values& values, const Envelope& envelope,
                                   std::span<const Internode> internodes, std::vector<std::string>& notes) {
  const auto leaf_count = static_cast<std::uint32_t>(values[leaves]);
  if (!on_cane(values)) return std::nullopt;
  if (leaf_count > 0 && request.leaf.points.empty()) notes.push_back(message(messages::bunch::cane_without_leaves));
  float width = 0;
  for (std::size_t side = 0; side < 4; ++side)
    width = std::max(width, 2 * envelope.half_width(side, envelope.length() / 3));
  const glm::vec3 foot = internodes.empty() ? glm::vec3(0) : internodes[0].start;
  return grow_foliage({request.seed, leaf_count, true, values[age], foot, width * metres_per_millimetre, request.leaf});
}

// Adds the surfaces of the berries, one flower mesh where any is in bloom or the fruit is a bramble's, and the foliage.
void add_meshes(GrownBunch& grown, const BunchRequest& request, const Values& values, const Envelope& envelope,
                std::span<const BerryBody> bodies) {
  grown.surfaces = surfaces_of(bodies, grown.form, request.berry_segments, size_at(values[age]) <= size_at(0));
  const bool flowers = std::any_of(grown.traits.begin(), grown.traits.end(), [](const Traits& t) { return t.set < 1; });
  if (flowers || grown.form.fruit == Fruit::bramble) {
    grown.flower = make_flower(grown.form.fruit);
    grown.flower->unit = 0.5f * ovary_width(values[size]) * metres_per_millimetre;
  }
  grown.foliage = foliage_for(request, values, envelope, grown.internodes, grown.notes);
}

// The measures of the grown bunch inside the outlines of its one or two bunches.
std::vector<float> measures_of(const GrownBunch& grown, std::span<const BunchEnvelope> bounds) {
  std::vector<HungEnvelope> envelopes;
  for (const BunchEnvelope& bound : bounds) envelopes.push_back({bound.envelope, bound.stance});
  return measure(grown, envelopes);
}

// Adds a note if there are fewer berries than requested, or as many as allowed.
void remark_crop(const Crop& crop, const CropTarget& target, std::size_t flowers, std::vector<std::string>& notes) {
  if (crop.set.full) notes.push_back(message(messages::bunch::bunch_full, target.limit));
  const auto lost = std::count(crop.swollen.lost.begin(), crop.swollen.lost.end(), RemovalReason::no_room);
  const std::size_t found_room = crop.fruitlets.size() - static_cast<std::size_t>(lost);
  if (target.count == 0 || static_cast<float>(found_room) >= count_met * target.count || flowers == 0) return;
  const auto requested = static_cast<std::uint32_t>(target.count);
  if (static_cast<float>(flowers) < target.count)
    notes.push_back(message(messages::bunch::fewer_flowers_than_berries, flowers, requested));
  else
    notes.push_back(message(messages::bunch::fewer_berries_fit, found_room, requested));
}

// The trace's words for the reason why a flower has no berry.
const MessageCode<0>& outcome_of(RemovalReason why) {
  switch (why) {
    case RemovalReason::not_set:
      return messages::bunch::trace_not_set;
    case RemovalReason::no_room:
      return messages::bunch::trace_no_room;
    case RemovalReason::outside:
      return messages::bunch::trace_outside;
    case RemovalReason::by_hand:
      break;
  }
  return messages::bunch::trace_by_hand;
}

// Adds the outcome of each flower to the trace of its module.
void trace_outcomes(lsystem::DerivationTrace& trace, std::span<const Flower> flowers, const Crop& crop,
                    const Harvest& hung) {
  const auto add = [&](std::uint32_t module, const MessageCode<0>& outcome) {
    trace.add_response(module, "; " + message(outcome).encoded());
  };
  for (std::size_t k = 0; k < hung.berries.size(); ++k)
    if (const std::uint32_t module = hung.berries[k].module; module != no_module)
      add(module, crop.set.volumes[hung.flowers[k]] > 0 ? messages::bunch::trace_flower_sets
                                                        : messages::bunch::trace_flower_fails);
  for (const Thinned& one : hung.thinned) {
    const auto flower =
        std::find_if(flowers.begin(), flowers.end(), [&](const Flower& each) { return each.id == one.id; });
    if (flower != flowers.end() && flower->module != no_module) add(flower->module, outcome_of(one.why));
  }
}

}  // namespace

// Grows a bunch of the requested age, step by step: skeleton and flowers, the flowers that set, their swelling, the
// bent skeleton, then traits, meshes and measures.
Diagnostic grow_natural(const BunchRequest& request, const Values& values, const Limits& limits, GrownBunch& grown) {
  auto sprouted = sprout(request, values, limits, grown.notes);
  if (!sprouted) return sprouted.error();
  Sprout& bunch = sprouted.value();
  const std::span<const Flower> flowers = bunch.flowers;

  // The crop: which flowers set, and how their berries swell against each other up to the age.
  const glm::vec3 sunward = towards_sun(values[sun], values[sun_height]);
  const std::vector<Situation> situations = situate(flowers, bunch.internodes, bunch.bounds, values[size], sunward);
  const CropTarget target = crop_target_for(request, values, limits, bunch.plans);
  const Hanging hanging = hang(bunch.internodes, flowers, values[bend]);
  const Crop crop = grow_crop(bunch, hanging, buds_of(flowers, situations, values, request.seed),
                              shares_of(flowers, situations, values, request.seed), target, sizes_until(values[age]));

  // The bunch at its age: bent by the berries' weight, with its peduncle, its berries and their traits.
  const float size_now = size_at(values[age]);
  const std::vector<FlowerOutcome> outcomes = outcomes_of(crop, flowers, request.seed, values[age], size_now);
  BentSkeleton bent = bend_skeleton(bunch.internodes, flowers, hanging, outcomes, crop.swollen.ends, size_now);
  grown.second_root = add_peduncle_above(bent, bunch, values, request.seed);
  Harvest hung = harvest(crop, bunch, hanging, outcomes, bent, size_now, target.berry.size);
  const Season season{values[age], values[sunlight], values[vigour], values[seeds]};
  grown.traits = ripen(hung, crop, flowers, situations, season, sunward, request.seed);

  // The results, then meshes and measures of them.
  if (bunch.trace) {
    trace_outcomes(*bunch.trace, flowers, crop, hung);
    grown.trace = std::move(bunch.trace);
  }
  grown.swelling = crop.swollen.work;
  grown.profile = bunch.profile;
  grown.plan = make_plan(values.profile());
  if (bunch.plans.size() > 1) grown.second = make_plan(scaled(values.profile(), values[wing]));
  grown.internodes = std::move(bent.internodes);
  grown.berries = std::move(hung.berries);
  grown.thinned = std::move(hung.thinned);
  grown.form = {values[taper], values[blunt], static_cast<Fruit>(static_cast<int>(values[fruit])), values[curve],
                relief_at(values[age])};
  if (request.meshes) add_meshes(grown, request, values, bunch.bounds[0].envelope, hung.bodies);
  if (request.measures) grown.measures = measures_of(grown, bunch.bounds);
  remark_crop(crop, target, flowers.size(), grown.notes);
  return {};
}

}  // namespace panicle::bunch
