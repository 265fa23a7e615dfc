#include "models/bunch/natural/situation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/random_value.hpp"
#include "models/bunch/natural/settling/sagging.hpp"

namespace panicle::bunch {
namespace {

constexpr float open_sky = 0.3f;     // weight of the outside for flowers that face upwards as well
constexpr float golden = 0.618034f;  // of a turn: the golden ratio sets neighbours along an axis far apart
// twice the square: sets axis and depth apart together, in a raceme, as well
constexpr float golden_axis = 2 * golden * golden;
constexpr float second_order = 0.414214f - golden;  // the same for two axes that fork, if they are of the same length
constexpr float own_noise = 0.15f;

// The situation of a flower. `own` is its place in the frame of a bunch that hangs straight down.
Situation situated(const glm::vec3& own, const Envelope& envelope, const UprightTransform& upright,
                   const glm::vec3& sun) {
  const float length = envelope.length();
  const float depth = std::clamp(-own.y, 0.0f, length);
  const float x = std::max(1.0f, envelope.half_width(own.x >= 0 ? 0 : 1, depth));
  const float z = std::max(1.0f, envelope.half_width(own.z >= 0 ? 2 : 3, depth));
  const float out = std::sqrt(own.x / x * (own.x / x) + own.z / z * (own.z / z));
  const float beyond =
      std::max(0.0f, -own.y - depth) + std::max(0.0f, own.y) + std::max(0.0f, out - 1) * std::min(x, z);
  const glm::vec3 outward = upright.way_back({own.x / x, 0, own.z / z}) + glm::vec3(0, open_sky, 0);
  const float facing = glm::dot(outward, sun) / std::max(1e-3f, glm::length(outward));
  return {own, depth / std::max(1.0f, length), std::clamp(0.5f + 0.5f * facing * std::min(1.0f, out), 0.0f, 1.0f),
          beyond};
}

}  // namespace

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
    Situation one = situated(own, bound.envelope, upright, sun);
    // A raceme is as wide as its pedicels are long, not as the profile draws it.
    const std::int32_t foot = internodes[first].parent;
    const bool raceme = foot >= 0 && internodes[static_cast<std::size_t>(foot)].kind == Kind::rachis;
    one.misplaced = raceme ? 0 : one.misplaced / size;
    situations.push_back(one);
  }
  return situations;
}

glm::vec3 towards_sun(float round, float height) {
  const SinCos up = sincos_degrees(height), turn = sincos_degrees(round);
  return {up.cosine * turn.sine, up.sine, up.cosine * turn.cosine};
}

float turn_of(const Flower& flower, std::uint64_t seed) {
  const float sum = golden_axis * static_cast<float>(flower.axis + 1) + golden * static_cast<float>(flower.depth) +
                    second_order * static_cast<float>(flower.onward) + static_cast<float>(flower.place) / 3 +
                    own_noise * random_value_of(flower, seed, "set") + bunch_random_value(seed, "set", 0, flower.bunch);
  return sum - std::floor(sum);
}

}  // namespace panicle::bunch
