// The fast search for free room against a plain one, which computes the distance of every place to every node.
#include "models/growth/free_room.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::growth;

namespace {

constexpr int looks = 40;
constexpr float golden = 0.618034f;

glm::vec3 direction(int i) {
  const float y = 1 - (2 * static_cast<float>(i) + 1) / looks;
  const SinCos way = sincos_degrees(137.50776f * static_cast<float>(i));
  const float out = std::sqrt(1 - y * y);
  return {out * way.cosine, y, out * way.sine};
}

// As documented: no node within 0.55 r of a free place, a weight of a twentieth outside the volume, up to one and a
// half in the light. `doubt`: weight of places so near to a border that rounding decides.
FreeRoom::Found plainly(const FreeRoom::Query& query, const std::vector<glm::vec3>& nodes, const VolumeShape& volume,
                        const Surroundings& about, float& doubt) {
  FreeRoom::Found found;
  for (int i = 0; i < looks; ++i) {
    const glm::vec3 d = direction(i);
    const float noise = query.noise + golden * static_cast<float>(i + 1), deep = noise - std::floor(noise);
    const float ahead = glm::dot(d, query.forward);
    const glm::vec3 place = query.tip + (0.5f + 0.5f * deep) * query.radius * d;
    float nearest = 1e9f;
    for (const glm::vec3& node : nodes)
      if (glm::distance(node, query.tip) > 1e-4f)
        nearest = std::min(nearest, glm::distance(node, place) / query.radius);
    if (ahead < 0.3f - 1e-5f) continue;
    const bool taken = nearest < 0.55f || !about.contains(place);
    const float weight = (taken ? 1 - query.regard : 1.0f) * (volume.contains(place) ? 1.0f : 0.05f) *
                         (1 + 0.5f * std::max(0.0f, glm::dot(d, query.light)));
    const glm::vec3 offset(2e-5f * query.radius);
    if (ahead < 0.3f + 1e-5f || std::fabs(nearest - 0.55f) < 1e-5f || deep < 1e-5f || deep > 1 - 1e-5f ||
        volume.contains(place - offset) != volume.contains(place + offset) ||
        about.contains(place - offset) != about.contains(place + offset))
      doubt += 1.5f;
    found.middle += weight * d;
    found.sum += weight;
  }
  return found;
}

float between(float low, float high, std::uint64_t stream, std::uint64_t address) {
  return low + (high - low) * random_unit(7, stream, address);
}

}  // namespace

TEST_CASE("the fast search finds the same places as the plain one") {
  std::array<float, 16> walls{};
  std::fill(walls.begin() + 8, walls.end(), 2.5f);
  const Surroundings alone, walled = Surroundings::of(walls).value();
  FreeRoom room;
  int taken = 0, free = 0, doubtful = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    GrowthVolume solid;
    solid.base = between(1, 5, 1, k);
    solid.middle = between(1, 6, 2, k);
    solid.top = between(0, 4, 3, k);
    solid.height = between(2, 8, 4, k);
    solid.gradient = between(0, 0.6f, 5, k);
    const VolumeShape volume(solid);
    std::vector<glm::vec3> nodes;
    const auto count = static_cast<std::uint64_t>(between(0, 400, 6, k));
    for (std::uint64_t i = 0; i < count; ++i)
      nodes.push_back(between(0, 4, 7, hash_combine(k, i)) * random_direction(7, 8, hash_combine(k, i)) +
                      glm::vec3(0, 4, 0));
    FreeRoom::Query query;
    // The tip itself is a node.
    query.tip = nodes.empty() ? glm::vec3(0, 1, 0) : nodes[k % nodes.size()];
    query.forward = random_direction(7, 9, k);
    query.light = random_direction(7, 10, k);
    query.radius = between(0.1f, 2, 11, k);
    query.noise = random_unit(7, 12, k);
    query.regard = k % 5 == 0 ? between(0, 1, 13, k) : 1;
    const Surroundings& about = k % 2 == 0 ? alone : walled;
    float doubt = 1e-4f;
    const FreeRoom::Found plain = plainly(query, nodes, volume, about, doubt);
    room.set_nodes(nodes, between(0.05f, 1.5f, 14, k));
    const FreeRoom::Found found = room.find(query, volume, about);
    CAPTURE(k);
    CHECK(std::fabs(found.sum - plain.sum) <= doubt);
    CHECK(glm::distance(found.middle, plain.middle) <= doubt);
    (plain.sum > 5 ? free : taken) += 1;
    doubtful += doubt > 1;
  }
  CHECK(taken > 40);
  CHECK(free > 40);
  CHECK(doubtful < 40);
}

TEST_CASE("a place that is not a number is not free, and a node that is not a number takes no room") {
  const float none = std::nanf("");
  const FreeRoom::Query query{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, 1, 0.5f, 1};
  const auto free = [](const FreeRoom::Query& at, const std::vector<glm::vec3>& nodes) {
    FreeRoom room;
    room.set_nodes(nodes, 1);
    return room.find(at, VolumeShape(GrowthVolume{}), Surroundings{});
  };
  const std::vector<glm::vec3> nodes = {{0, 1, 0}, {0, 1.5f, 0}};
  const float usual = free(query, nodes).sum;
  CHECK(usual > 0);
  for (const std::vector<glm::vec3>& about : {nodes, std::vector<glm::vec3>{}}) {
    FreeRoom::Query invalid_noise = query, invalid_tip = query, invalid_radius = query;
    invalid_noise.noise = invalid_tip.tip.x = invalid_radius.radius = none;
    for (const FreeRoom::Query& each : {invalid_noise, invalid_tip, invalid_radius}) {
      const FreeRoom::Found found = free(each, about);
      CHECK(found.sum == 0);
      CHECK(found.middle == glm::vec3(0));
    }
  }
  CHECK(free(query, {nodes[0], nodes[1], {none, 1, 0}, {0, none, none}}).sum == usual);
}

TEST_CASE("contains_around implies that all places within the radius are within the room") {
  int sure = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    std::array<float, 16> numbers{};
    for (std::uint64_t i = 8; i < 16; ++i) numbers[i] = between(0.5f, 6, 20, 16 * k + i);
    const Surroundings about = Surroundings::of(numbers).value();
    const glm::vec3 at = between(0, 2, 21, k) * random_direction(7, 22, k);
    const float radius = between(0, 2, 23, k);
    if (!about.contains_around(at, radius)) continue;
    ++sure;
    for (std::uint64_t i = 0; i < 30; ++i)
      CHECK(about.contains(at + radius * random_direction(7, 24, hash_combine(k, i))));
  }
  CHECK(sure > 30);
  CHECK(Surroundings().contains_around({0, 0, 0}, 1e9f));
}
