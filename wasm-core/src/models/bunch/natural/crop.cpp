#include "models/bunch/natural/crop.hpp"

#include <algorithm>
#include <utility>

#include "models/bunch/natural/berry_size.hpp"

namespace panicle::bunch {
namespace {

constexpr int most_tries = 3;         // to find room for a count
constexpr float near_enough = 0.98f;  // of a count
constexpr float over_missing = 1.5f;  // more set than were lost, for some of those will be lost too

std::size_t count_lost(const Swollen& swollen) {
  return static_cast<std::size_t>(std::count(swollen.lost.begin(), swollen.lost.end(), Why::no_room));
}

}  // namespace

FruitSet set_fruit(std::span<const Bud> buds, const Wish& wish) {
  if (wish.count > 0 || wish.overfull)
    return {choose_count(buds, wish.count > 0 ? std::min(wish.count, wish.most) : wish.most, wish.size), wish.overfull};
  std::vector<float> volumes = choose_set(buds, wish.fill, wish.size);
  const auto setting = std::count_if(volumes.begin(), volumes.end(), [](float volume) { return volume > 0; });
  if (setting <= static_cast<std::ptrdiff_t>(wish.limit)) return {std::move(volumes), false};
  return {choose_count(buds, wish.most, wish.size), true};
}

std::vector<Fruitlet> fruitlets_of(std::span<const float> volumes, std::span<const float> shares,
                                   std::span<const Flower> flowers, const Wish& wish) {
  std::vector<Fruitlet> fruitlets;
  std::vector<float> chosen_shares, chosen_volumes;
  for (std::uint32_t i = 0; i < volumes.size(); ++i) {
    if (!(volumes[i] > 0)) continue;
    chosen_shares.push_back(shares[i]);
    chosen_volumes.push_back(volumes[i]);
    fruitlets.push_back({i, 0, 0, std::binary_search(wish.taken.begin(), wish.taken.end(), flowers[i].id)});
  }
  const std::vector<float> widths = balanced_widths(chosen_shares, chosen_volumes);
  for (std::size_t k = 0; k < fruitlets.size(); ++k) {
    fruitlets[k].half_width = wish.size / 2 * widths[k];
    fruitlets[k].half_length = fruitlets[k].half_width * wish.elongation;
  }
  return fruitlets;
}

Crop grow_crop(const Sprout& sprout, const Hanging& hanging, std::span<const Bud> buds, std::span<const float> shares,
               const Wish& wish, std::span<const float> sizes) {
  Crop crop;
  crop.set = set_fruit(buds, wish);
  crop.elongation = wish.elongation;
  const float asked = std::min(wish.count, wish.most), most = std::min(wish.most, static_cast<float>(buds.size()));
  float wanted = asked;
  for (int tries = 1;; ++tries) {
    crop.fruitlets = fruitlets_of(crop.set.volumes, shares, sprout.flowers, wish);
    std::vector<Branch> branches = hanging.branches;
    crop.berries = hang_berries(crop.fruitlets, sprout.internodes, sprout.flowers, hanging, branches);
    crop.swollen = swell(branches, crop.berries, sprout.bounds, sizes);
    const auto kept = static_cast<float>(crop.fruitlets.size() - count_lost(crop.swollen));
    if (kept >= near_enough * asked || tries == most_tries || wanted >= most) return crop;
    wanted = std::min(wanted + over_missing * (asked - kept) + 1, wish.most);
    crop.set.volumes = choose_count(buds, wanted, wish.size);
  }
}

}  // namespace panicle::bunch
