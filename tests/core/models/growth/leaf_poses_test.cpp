// Poses of four leaves at a time equal those of each leaf alone, computed with the standard library's sine, root and
// rotation.
#include "models/growth/leaf_poses.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "foundation/lane_vectors.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"

using namespace panicle;
using namespace panicle::growth;

namespace {

glm::vec4 plainly(const Twig& twig, float about, float height, float around, bool needle) {
  const SinCos way = sincos_degrees(360 * about), stray = sincos_degrees(360 * around);
  const glm::vec3 side = way.cosine * twig.one + way.sine * twig.other;
  if (needle) {
    const glm::vec3 out = glm::normalize(twig.along + 0.5f * side);
    return turn_to(out, any_perpendicular(out));
  }
  const glm::vec3 out = glm::normalize(0.6f * twig.along + side - glm::vec3(0, 0.25f, 0));
  const float level = std::sqrt(1 - height * height);
  const glm::vec3 face = glm::normalize(glm::vec3(0, 1, 0) + 0.45f * twig.along +
                                        0.5f * glm::vec3(level * stray.cosine, level * stray.sine, height));
  return turn_to(glm::normalize(out - glm::dot(out, face) * face), face);
}

// Of the two signs of a quaternion the same one, except where the real part is 0.
float apart(const glm::vec4& a, const glm::vec4& b) { return std::min(glm::distance(a, b), glm::distance(a, -b)); }

}  // namespace

TEST_CASE("poses of four leaves at once equal those of each alone") {
  for (std::uint64_t k = 0; k < 300; ++k) {
    const glm::vec3 along = random_direction(1, 1, k), one = any_perpendicular(along);
    const Twig twig{along, one, glm::cross(along, one)};
    LeafNoise noise{};
    for (int i = 0; i < 4; ++i) {
      const std::uint64_t address = hash_combine(k, static_cast<std::uint64_t>(i));
      noise.about[i] = 6 * random_unit(1, 2, address);
      noise.height[i] = 2 * random_unit(1, 3, address) - 1;
      noise.around[i] = random_unit(1, 4, address);
    }
    const auto leaves = leaf_poses(twig, noise, 0.5f), needles = needle_poses(twig, noise);
    for (int i = 0; i < 4; ++i) {
      CAPTURE(k);
      CAPTURE(i);
      const auto at = static_cast<std::size_t>(i);
      CHECK(apart(leaves[at], plainly(twig, noise.about[i], noise.height[i], noise.around[i], false)) < 2e-4f);
      CHECK(apart(needles[at], plainly(twig, noise.about[i], noise.height[i], noise.around[i], true)) < 2e-4f);
      CHECK(glm::length(leaves[at]) == doctest::Approx(1).epsilon(1e-6));
    }
  }
}

TEST_CASE("a leaf without a defined direction still has a unit rotation") {
  // Where `out` and `face` are parallel, or `face` is 0: the twig points straight down and the noise is opposite.
  for (const float height : {-1.0f, 0.0f, 1.0f})
    for (const glm::vec3& along : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1, 0, 0)}) {
      const glm::vec3 one = any_perpendicular(along);
      LeafNoise noise{};
      noise.about = Four{0, 0.25f, 0.5f, 0.75f};
      noise.height = all_of(height);
      noise.around = noise.about;
      for (const glm::vec4& pose : leaf_poses({along, one, glm::cross(along, one)}, noise, 0.5f))
        CHECK(glm::length(pose) == doctest::Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("sines and cosines of four turns equal the exact ones") {
  for (int i = -4000; i < 4000; ++i) {
    const float turns = 0.0025f * static_cast<float>(i) + 0.0007f;
    const FourSinCos four = sincos_turns(Four{turns, -turns, 0.25f, 1.5f});
    const double angle = 2 * 3.14159265358979323846 * static_cast<double>(turns);
    CHECK(std::fabs(static_cast<double>(four.sine[0]) - std::sin(angle)) < 3e-7);
    CHECK(std::fabs(static_cast<double>(four.cosine[0]) - std::cos(angle)) < 3e-7);
    CHECK(four.sine[1] == -four.sine[0]);
    CHECK(four.sine[2] == 1);
    CHECK(four.cosine[3] == -1);
  }
}
