#include "models/bunch/natural/crop.hpp"

#include <algorithm>
#include <utility>

#include "foundation/order.hpp"
#include "models/bunch/natural/berry_size.hpp"

namespace panicle::bunch {
namespace {

constexpr float max_stand_ins = 0.3f;  // of a count

// The elements of `values` at the indices `places`, in that order.
template <class Value>
std::vector<Value> elements_at(const std::vector<Value>& values, std::span<const std::size_t> places) {
  std::vector<Value> some;
  some.reserve(places.size());
  for (const std::size_t place : places) some.push_back(values[place]);
  return some;
}

// Removes the stand-ins that were not needed, and brings the rest into the flowers' order.
void remove_unused_stand_ins(Crop& crop) {
  std::vector<std::size_t> remaining;
  std::vector<std::int32_t> flowers;
  for (std::size_t k = 0; k < crop.fruitlets.size(); ++k) {
    if (crop.swollen.lost[k] == RemovalReason::not_set) {
      crop.set.volumes[crop.fruitlets[k].flower] = 0;
    } else {
      remaining.push_back(k);
      flowers.push_back(static_cast<std::int32_t>(crop.fruitlets[k].flower));
    }
  }
  std::vector<std::size_t> places;
  for (const std::uint32_t place : order_of(flowers)) places.push_back(remaining[place]);
  crop.fruitlets = elements_at(crop.fruitlets, places);
  crop.berries = elements_at(crop.berries, places);
  crop.swollen.centres = elements_at(crop.swollen.centres, places);
  crop.swollen.directions = elements_at(crop.swollen.directions, places);
  crop.swollen.lost = elements_at(crop.swollen.lost, places);
}

}  // namespace

// Chooses the flowers that set, those of the lowest ranks: `target.count` of them if a number is requested, otherwise
// those below the rank `fill`. Too many for the limit are reduced, and the result's `full` is true.
FruitSet set_fruit(std::span<const float> ranks, float fill, const CropTarget& target) {
  const std::vector<float> own(ranks.begin(), ranks.end());
  if (target.count > 0) return {choose_count(own, std::min(target.count, target.most)), false};
  std::vector<float> volumes = choose_set(own, fill);
  const auto setting = std::count_if(volumes.begin(), volumes.end(), [](float volume) { return volume > 0; });
  if (setting <= static_cast<std::ptrdiff_t>(target.limit)) return {std::move(volumes), false};
  return {choose_count(own, target.most), true};
}

// The flowers that do not set, but may replace berries that find no room, in the order of their ranks: up to 30 % of a
// requested count. Empty if no count is requested.
std::vector<std::uint32_t> stand_ins(std::span<const float> ranks, std::span<const float> volumes,
                                     const CropTarget& target) {
  std::vector<std::uint32_t> in_turn;
  if (!(target.count > 0)) return in_turn;
  const auto most = static_cast<std::size_t>(
      std::max(0.0f, std::min(max_stand_ins * target.count + 1, static_cast<float>(target.limit) - target.count)));
  for (const std::uint32_t i : setting_order(ranks))
    if (!(volumes[i] > 0) && in_turn.size() < most) in_turn.push_back(i);
  return in_turn;
}

// One fruitlet, a berry's target size, for each flower of `setting`. The mean width of the first `regular` ones is that
// of the target.
std::vector<Fruitlet> fruitlets_of(std::span<const std::uint32_t> setting, std::size_t regular,
                                   std::span<const float> volumes, std::span<const float> shares,
                                   std::span<const Flower> flowers, const CropTarget& target) {
  std::vector<Fruitlet> fruitlets;
  std::vector<float> own_shares, own_volumes;
  for (const std::uint32_t i : setting) {
    own_shares.push_back(shares[i]);
    own_volumes.push_back(volumes[i]);
    fruitlets.push_back({i, 0, 0, std::binary_search(target.taken.begin(), target.taken.end(), flowers[i].id)});
  }
  const std::vector<float> widths = balanced_widths(own_shares, own_volumes, regular);
  for (std::size_t k = 0; k < fruitlets.size(); ++k) {
    fruitlets[k].half_width = target.berry.size / 2 * widths[k];
    fruitlets[k].half_length = fruitlets[k].half_width * target.berry.elongation;
  }
  return fruitlets;
}

// Chooses the flowers that set, by number or by density, adds stand-ins for berries that may find no room, and lets all
// of them swell against each other. Stand-ins that were not needed are removed.
Crop grow_crop(const Sprout& sprout, const Hanging& hanging, std::span<const Bud> buds, std::span<const float> shares,
               const CropTarget& target, std::span<const float> sizes) {
  Crop crop;
  crop.elongation = target.berry.elongation;
  const std::vector<float> ranks = ranks_of(buds, target.berry.size);
  const float fill = target.count > 0 ? 0 : fill_for(buds, ranks, target.density, target.berry);
  crop.set = set_fruit(ranks, fill, target);
  std::vector<float>& volumes = crop.set.volumes;
  std::vector<std::uint32_t> setting;
  for (std::uint32_t i = 0; i < volumes.size(); ++i)
    if (volumes[i] > 0) setting.push_back(i);
  const std::size_t regular = setting.size();
  for (const std::uint32_t i : stand_ins(ranks, volumes, target)) {
    setting.push_back(i);
    volumes[i] = 1;
  }
  crop.fruitlets = fruitlets_of(setting, regular, volumes, shares, sprout.flowers, target);
  std::vector<Branch> branches = hanging.branches;
  crop.berries = hang_berries(crop.fruitlets, sprout.internodes, sprout.flowers, hanging, branches);
  for (std::size_t k = regular; k < crop.berries.size(); ++k) crop.berries[k].late = true;
  const auto wanted = static_cast<std::size_t>(std::min(target.count, target.most));
  crop.swollen = swell(branches, crop.berries, sprout.bounds, sizes, regular < setting.size() ? wanted : 0);
  remove_unused_stand_ins(crop);
  return crop;
}

}  // namespace panicle::bunch
