#include "models/tree/leaves.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/bits.hpp"
#include "foundation/easing.hpp"
#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"

namespace panicle::particles::tree {
namespace {

constexpr std::uint64_t stream_tilt = 0x6c656166, stream_turn = stream_tilt + 1, stream_size = stream_tilt + 2,
                        stream_fall = stream_tilt + 3;
constexpr float outwards = 0.45f;   // how much leaves turn to the direction of their twig, from where light comes, too
constexpr float tilt = 0.5f;        // greatest random tilt of leaves
constexpr float droop = 0.25f;      // of their tips
constexpr float least_size = 0.7f;  // of the largest
constexpr float internode = 0.4f;   // from leaf to leaf along the shoot, in leaf lengths
constexpr float rising = 0.6f;      // share of the unfolding time after which the highest leaves begin

// A random address of a place: independent of its order among the others.
std::uint64_t address_of(const glm::vec3& p) {
  const auto word = [](float value) { return std::uint64_t{bit_cast<std::uint32_t>(value)}; };
  return hash_combine(word(p.x) << 32 | word(p.y), word(p.z));
}

}  // namespace

// Adds the leaves of the twigs at which particles started. `numbers`: the segment of each trail point, −1 for none;
// `tag`: the organs' tag.
void add_leaves(Plant& plant, const Trails& trails, std::span<const std::int32_t> numbers, const LeafHabit& habit,
                std::uint32_t tag) {
  const bool pair = habit.count == 2;  // two are opposite each other at the tip
  // Buds open from below upwards: by height among all tips.
  float low = std::numeric_limits<float>::max(), high = -low;
  for (std::size_t i = 0; i < trails.size(); ++i)
    if (trails.particle[i] >= 0) {
      low = std::min(low, trails.places[i].y);
      high = std::max(high, trails.places[i].y);
    }
  for (std::size_t i = 0; i < trails.size(); ++i) {
    if (trails.particle[i] < 0 || numbers[i] < 0) continue;
    const float begins = high > low ? rising * (trails.places[i].y - low) / (high - low) : 0;
    const float share = smooth_step(begins, begins + 1 - rising, habit.unfolded);
    if (!(share > 0)) continue;
    const Segment& twig = plant.segments[static_cast<std::size_t>(numbers[i])];
    const glm::vec3 along = twig.end - twig.start;
    const float length = glm::length(along);
    const glm::vec3 way = length > 0 ? along / length : glm::vec3(0, 1, 0), side = any_perpendicular(way),
                    across = glm::cross(way, side);
    const std::uint64_t place = address_of(trails.places[i]);
    const float turn = 360 * random_unit(habit.seed, stream_turn, place);
    for (std::uint32_t k = 0; k < habit.count; ++k) {
      const std::uint32_t node = pair ? 0 : k;
      const std::uint64_t address = hash_combine(place, k);
      // Leaves that fell are left out. The others are placed around the twig: by the golden angle, pairs opposite each
      // other.
      if (!(random_unit(habit.seed, stream_fall, address) < habit.attached)) continue;
      const float roll = turn + (pair ? 180.0f : golden_angle) * static_cast<float>(k);
      const auto [sine, cosine] = sincos_degrees(roll);
      glm::vec3 out = 0.6f * way + cosine * side + sine * across;
      glm::vec3 face = habit.light + outwards * way + tilt * random_direction(habit.seed, stream_tilt, address);
      face = glm::length(face) > 1e-3f ? glm::normalize(face) : habit.light;
      if (habit.needles)
        out = way + 0.5f * (cosine * side + sine * across);
      else
        out.y -= droop;
      // The tip points outwards as nearly as the upper face may look to the light; needles keep their direction.
      glm::vec3 up = habit.needles ? out : out - glm::dot(out, face) * face;
      up = glm::length(up) > 1e-3f ? glm::normalize(up) : any_perpendicular(face);
      const glm::vec3 front = face - glm::dot(face, up) * up;
      Organ leaf;
      leaf.tag = tag;
      leaf.segment = numbers[i];
      leaf.position = twig.end - std::min(length, internode * habit.size * static_cast<float>(node)) * way;
      leaf.rotation = turn_to(up, glm::length(front) > 1e-3f ? glm::normalize(front) : any_perpendicular(up));
      leaf.scale = share * habit.size * (least_size + (1 - least_size) * random_unit(habit.seed, stream_size, address));
      plant.organs.push_back(leaf);
    }
  }
}

}  // namespace panicle::particles::tree
