#include "models/bunch/foliage/leaf_outline.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/random.hpp"
#include "models/bunch/foliage/leaf.hpp"

namespace panicle::bunch {
namespace {

float between(std::uint64_t seed, std::uint64_t address, float low, float high) {
  return low + (high - low) * random_unit(seed, hash_text("leaf outline"), address);
}

// Proportions after the medium class of OIV 602–606 to 601 (docs/foliage.md): lobes 0.78 and 0.56, bays 0.52 and 0.44
// of the midrib.

// From a bay between two lobes (0) to a lobe's tip (1): a narrow bay, full flanks, a tip that still tapers.
float flank(float x) { return x * (1.4f - 0.4f * x); }

constexpr std::uint32_t middle_tooth = leaf_sectors / 2 * leaf_teeth;  // at the tip

// From the left: outer sector, lower, upper; upper, lower, outer to the right.
std::uint32_t from_midrib(std::uint32_t sector) { return sector < 3 ? 2 - sector : sector - 3; }

}  // namespace

LeafOutline::LeafOutline(std::uint64_t seed) : seed_(seed) {
  const float depth = between(seed, 0, 0, 1);  // from shallow lobes to deep ones, alike on both sides
  for (std::uint32_t k = 0; k < 2; ++k) {
    const std::uint64_t own = 10 * (k + 1);
    Side& side = sides_[k];
    side.upper = between(seed, 1, 0.76f, 0.86f) + between(seed, own, -0.02f, 0.02f);
    side.lower = between(seed, 2, 0.54f, 0.63f) + between(seed, own + 1, -0.02f, 0.02f);
    side.upper_sinus = side.upper * (0.86f - 0.24f * depth + between(seed, own + 2, -0.025f, 0.025f));
    side.lower_sinus = side.lower * (0.92f - 0.18f * depth + between(seed, own + 3, -0.025f, 0.025f));
    side.sinus_angle = between(seed, 3, 160, 170) + between(seed, own + 4, -2, 2);
    side.auricle = between(seed, 4, 0.20f, 0.25f);
  }
}

float LeafOutline::angle(std::uint32_t sector, float share) const {
  const Side& side = sides_[sector < 3 ? 0 : 1];
  const float ends[] = {0, leaf_upper_vein, leaf_lower_vein, side.sinus_angle};
  const std::uint32_t from = from_midrib(sector);
  const float outwards = sector < 3 ? 1 - share : share;
  const float degrees = ends[from] + (ends[from + 1] - ends[from]) * outwards;
  return sector < 3 ? -degrees : degrees;
}

float LeafOutline::radius(std::uint32_t sector, float share) const {
  const Side& side = sides_[sector < 3 ? 0 : 1];
  const std::uint32_t from = from_midrib(sector);
  const float outwards = sector < 3 ? 1 - share : share;
  if (from == 2) return side.lower + (side.auricle - side.lower) * outwards * (1.3f - 0.3f * outwards);
  const float inner = from == 0 ? 1 : side.upper;
  const float outer = from == 0 ? side.upper : side.lower;
  const float bay = from == 0 ? side.upper_sinus : side.lower_sinus;
  // The bay lies nearer to the shorter lobe.
  const float middle = 0.54f;
  return outwards < middle ? bay + (inner - bay) * flank(1 - outwards / middle)
                           : bay + (outer - bay) * flank((outwards - middle) / (1 - middle));
}

float LeafOutline::jut(std::uint32_t sector, float tooth) const {
  const std::uint32_t nearest = static_cast<std::uint32_t>(tooth + 0.5f);
  const std::uint32_t along = sector * leaf_teeth + nearest;  // a vein's tooth belongs to both its sectors
  const std::uint32_t from_midrib_tip = along > middle_tooth ? along - middle_tooth : middle_tooth - along;
  float height = (along % 2 == 0 ? 0.062f : 0.040f) * between(seed_, 100 + along, 0.75f, 1.25f);
  if (nearest % leaf_teeth == 0) height = from_midrib_tip == 0 ? 0.105f : 0.085f;
  // Towards the petiole sinus the margin is entire, and where the blade is short teeth are small.
  const float entire = 1 - static_cast<float>(from_midrib_tip) / static_cast<float>(middle_tooth);
  const float size = std::min(1.0f, 4 * entire) * (0.35f + 0.65f * radius(sector, tooth / leaf_teeth));
  const float off = 2 * std::fabs(tooth - static_cast<float>(nearest));  // 0 at the tip, 1 in the notch
  return size * (height * (1 - off) * (1 + 0.55f * off) - 0.018f * off);
}

}  // namespace panicle::bunch
