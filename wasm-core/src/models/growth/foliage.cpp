#include "models/growth/foliage.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "geometry/turn.hpp"

namespace panicle::growth {
namespace {

constexpr std::uint64_t stream_turn = 0x6c656166, stream_face = stream_turn + 1, stream_size = stream_turn + 2,
                        stream_shake = stream_turn + 3, stream_lie = stream_turn + 4;
constexpr float golden_angle = 137.50776f, golden = 0.618034f;
constexpr float least_size = 0.7f;  // of the largest
constexpr float outwards = 0.45f, strewn = 0.5f, droop = 0.25f;
constexpr float drift = 0.15f;     // how far they come down from below where they hung, of that height
constexpr float above = 0.01f;     // the ground, metres
constexpr float near_tip = 0.35f;  // from where on along an internode they stand

// The rotation of a leaf whose tip points to `out` as nearly as its upper face may look to `face`.
glm::vec4 turned(const glm::vec3& out, const glm::vec3& face) {
  const glm::vec3 across = out - glm::dot(out, face) * face;
  const glm::vec3 up = glm::length(across) > 1e-3f ? glm::normalize(across) : beside(face);
  return turn_to(up, face);
}

void lie_down(Organ& leaf, std::uint64_t seed, std::uint64_t address) {
  const SinCos way = sincos_degrees(360 * random_unit(seed, stream_lie, address));
  const float far = drift * leaf.position.y * random_unit(seed, stream_lie, hash_combine(address, 1));
  leaf.position += glm::vec3(far * way.cosine, 0, far * way.sine);
  leaf.position.y = above;
  const glm::vec3 face = glm::normalize(glm::vec3(0, 1, 0) + 0.25f * random_direction(seed, stream_lie, address));
  leaf.rotation = turned({way.sine, 0, way.cosine}, face);
  leaf.tag = fallen_tag;
}

}  // namespace

Diagnostic add_leaves(Plant& plant, const Population& population, const Form& form, const Moment& moment, float time,
                      const LeafHabit& habit, const Limits& limits) {
  for (std::size_t l = 0; l < population.leaves.size(); ++l) {
    const Leaf& counted = population.leaves[l];
    const Way& way = form.ways[counted.shoot];
    const float share = come(counted.born, time);
    const bool falls = counted.falls != Leaf::never && time >= static_cast<float>(counted.falls);
    // They hang for a step, and shrivel all the while.
    const float left = falls ? 1 - std::clamp(time - static_cast<float>(counted.falls), 0.0f, 1.0f) : 1;
    if (!(share * left > 0) || way.count == 0) continue;
    const std::uint32_t node =
        std::min<std::uint32_t>(counted.born > way.from ? counted.born - way.from : 0u, way.count - 1) + 1;
    const std::int32_t bearer = moment.of_node[way.first + node];
    if (bearer < 0) continue;
    const Segment& twig = moment.segments[static_cast<std::size_t>(bearer)];
    const glm::vec3 whole = form.nodes[way.first + node] - form.nodes[way.first + node - 1];
    const float length = glm::length(whole);
    const glm::vec3 along = length > 0 ? whole / length : glm::vec3(0, 1, 0), one = beside(along),
                    other = glm::cross(along, one);
    for (std::uint32_t k = 0; k < habit.many; ++k) {
      const std::uint64_t address = hash_combine(l, k);
      const float turns = golden * static_cast<float>(l * habit.many + k);
      const float back =
          (1 - near_tip) * (turns - std::floor(turns)) * std::min(length, glm::distance(twig.start, twig.end));
      const SinCos about = sincos_degrees(golden_angle * static_cast<float>(k) +
                                          360 * random_unit(habit.seed, stream_turn, hash_combine(l, 0)));
      const glm::vec3 side = about.cosine * one + about.sine * other;
      glm::vec3 out = habit.needles ? along + 0.5f * side : 0.6f * along + side;
      if (!habit.needles) out.y -= droop;
      out = glm::normalize(out);
      const glm::vec3 face =
          glm::vec3(0, 1, 0) + outwards * along + strewn * random_direction(habit.seed, stream_face, address);
      Organ leaf;
      leaf.tag = falls ? falling_tag : leaf_tag;
      leaf.segment = bearer;
      leaf.position = twig.end - back * along;
      leaf.rotation = habit.needles ? turn_to(out, beside(out))
                                    : turned(out, glm::length(face) > 1e-3f ? glm::normalize(face) : beside(along));
      leaf.scale =
          share * left * habit.size * (least_size + (1 - least_size) * random_unit(habit.seed, stream_size, address));
      if (falls && random_unit(habit.seed, stream_shake, address) < habit.fallen) lie_down(leaf, habit.seed, address);
      plant.organs.push_back(leaf);
    }
    if (plant.organs.size() > limits.copies)
      return {Reason::limit,
              "The tree has more than " + std::to_string(limits.copies) +
                  " leaves; ask for fewer steps, or for fewer leaves for one.",
              0, 0};
  }
  return {};
}

}  // namespace panicle::growth
