#include "models/bunch/natural/situation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"
#include "models/bunch/natural/random_value.hpp"
#include "models/bunch/natural/settling/sagging.hpp"

namespace panicle::bunch {
namespace {

constexpr float open_sky = 0.3f;  // weight of the outside for flowers that face upwards as well
// Turns of the golden ratio set neighbours along an axis far apart.
// twice the square: sets axis and depth apart together, in a raceme, as well
constexpr float golden_axis = 2 * golden_ratio * golden_ratio;
constexpr float second_order =
    0.414214f - golden_ratio;  // the same for two axes that fork, if they are of the same length
constexpr float own_noise = 0.15f;

// Returns the situation of a flower whose bunch has that outline. `own` is its place, millimetres, in the frame of a
// bunch that hangs straight down; `sun` is a unit vector. The result's `misplaced` is in millimetres, not yet in berry
// widths.
Situation situation_of(const glm::vec3& own, const Envelope& envelope, const UprightTransform& upright,
                       const glm::vec3& sun) {
  const float length = envelope.length();
  const float depth = std::clamp(-own.y, 0.0f, length);
  const float half_x = std::max(1.0f, envelope.half_width(own.x >= 0 ? 0 : 1, depth));
  const float half_z = std::max(1.0f, envelope.half_width(own.z >= 0 ? 2 : 3, depth));
  // Distance from the bunch's axis as a share of the outline's: 1 on the outline.
  const float radius = std::sqrt(own.x / half_x * (own.x / half_x) + own.z / half_z * (own.z / half_z));
  const float outside_millimetres =
      std::max(0.0f, -own.y - depth) + std::max(0.0f, own.y) + std::max(0.0f, radius - 1) * std::min(half_x, half_z);
  const glm::vec3 outward = upright.way_back({own.x / half_x, 0, own.z / half_z}) + glm::vec3(0, open_sky, 0);
  const float facing = glm::dot(outward, sun) / std::max(1e-3f, glm::length(outward));
  const float lit = std::clamp(0.5f + 0.5f * facing * std::min(1.0f, radius), 0.0f, 1.0f);
  return {own, depth / std::max(1.0f, length), lit, outside_millimetres};
}

}  // namespace

// The situation of each flower: the place of its berry in its upright bunch, how far along the bunch, how much light,
// and how far outside the outline. `size`: a berry's width, millimetres.
std::vector<Situation> situate(std::span<const Flower> flowers, std::span<const Internode> internodes,
                               std::span<const BunchEnvelope> bounds, float size, const glm::vec3& sun) {
  std::vector<Situation> situations;
  situations.reserve(flowers.size());
  for (const Flower& flower : flowers) {
    const Internode& parent = internodes[static_cast<std::size_t>(flower.parent)];
    const std::size_t first = beginning_of(internodes, static_cast<std::size_t>(flower.parent));
    const float stalk = glm::length(parent.end - internodes[first].start);
    const BunchEnvelope& bound = bounds[flower.bunch];
    const UprightTransform upright(bound.stance);
    const glm::vec3 way = drooping(upright.way(flower.heading), 1);
    const glm::vec3 own = upright.place(internodes[first].start) + way * (stalk + 0.5f * size);
    Situation situation = situation_of(own, bound.envelope, upright, sun);
    // A raceme is as wide as its pedicels are long, not as the profile draws it: no flower of it is misplaced.
    const std::int32_t foot = internodes[first].parent;
    const bool raceme = foot >= 0 && internodes[static_cast<std::size_t>(foot)].kind == Kind::rachis;
    situation.misplaced = raceme ? 0 : situation.misplaced / size;
    situations.push_back(situation);
  }
  return situations;
}

// The unit vector towards a sun at `round` degrees from the front (z) to the right (x) and `height` degrees above the
// horizon.
glm::vec3 towards_sun(float round, float height) {
  const SinCos up = sincos_degrees(height), turn = sincos_degrees(round);
  return {up.cosine * turn.sine, up.sine, up.cosine * turn.cosine};
}

// A flower's turn to set, 0 … 1; low ones set first. A sum of its indices (axis, depth, …), each times an irrational
// number, modulo 1, spreads the turns of neighbours evenly; a little noise is added.
float turn_of(const Flower& flower, std::uint64_t seed) {
  const float sum = golden_axis * static_cast<float>(flower.axis + 1) +
                    golden_ratio * static_cast<float>(flower.depth) + second_order * static_cast<float>(flower.onward) +
                    static_cast<float>(flower.place) / 3 + own_noise * random_value_of(flower, seed, "set") +
                    bunch_random_value(seed, "set", 0, flower.bunch);
  return sum - std::floor(sum);
}

}  // namespace panicle::bunch
