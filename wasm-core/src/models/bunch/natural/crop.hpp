// The crop: the flowers that set, the target sizes of their berries, and the result of swelling.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/natural/hanging.hpp"
#include "models/bunch/natural/settling/crowding.hpp"
#include "models/bunch/natural/settling/fruit_set.hpp"
#include "models/bunch/natural/sprout.hpp"

namespace panicle::bunch {

// The number and the size of the berries to grow.
struct CropTarget {
  float count = 0;          // requested number; 0 leaves it to the density
  float density = 0;        // requested density, OIV note 1 … 9
  float most = 0;           // upper bound by space
  std::uint32_t limit = 0;  // upper bound, independent of the space
  BerrySize berry;
  std::vector<std::uint32_t> taken;  // ids of berries removed by hand, in ascending order
};

struct FruitSet {
  std::vector<float> volumes;  // per flower: volume of its berry over a full one; 0 where it does not set
  bool full = false;           // whether the number reached the upper bound instead of the density
};

// `fill` is the share of space that berries of the density take.
FruitSet set_fruit(std::span<const float> ranks, float fill, const CropTarget& target);

// Flowers that set if berries of a count find no room, in their order: as many as could be needed.
std::vector<std::uint32_t> stand_ins(std::span<const float> ranks, std::span<const float> volumes,
                                     const CropTarget& target);

// Makes the berries of `setting`, flowers whose `volumes` are above 0; the mean width of the first `regular` ones is
// the target's. `shares` are the flowers' width_share.
std::vector<Fruitlet> fruitlets_of(std::span<const std::uint32_t> setting, std::size_t regular,
                                   std::span<const float> volumes, std::span<const float> shares,
                                   std::span<const Flower> flowers, const CropTarget& target);

struct Crop {
  FruitSet set;
  std::vector<Fruitlet> fruitlets;  // in the flowers' order
  std::vector<Swelling> berries;    // one a fruitlet
  Swollen swollen;
  float elongation = 1;

  // At a size over the ripe one; millimetres.
  float half_width(std::size_t berry, float size) const { return fruitlets[berry].half_width * size; }
  float half_length(std::size_t berry, float size) const { return half_width(berry, size) * elongation; }
  bool is_lost(std::size_t berry) const { return swollen.lost[berry] != RemovalReason{}; }
};

// `sizes` are those through which berries swell (ripening.hpp).
Crop grow_crop(const Sprout& sprout, const Hanging& hanging, std::span<const Bud> buds, std::span<const float> shares,
               const CropTarget& target, std::span<const float> sizes);

}  // namespace panicle::bunch
