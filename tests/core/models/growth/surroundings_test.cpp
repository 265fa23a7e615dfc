// Surroundings of a tree: light comes from the open sky, and places beyond its room are taken.
#include "models/growth/surroundings.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "models/growth/crown_light.hpp"
#include "models/growth/form.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

constexpr float open = 1e9f;
using Numbers = std::array<float, 16>;

constexpr Numbers nothing{0, 0, 0, 0, 0, 0, 0, 0, open, open, open, open, open, open, open, open};
// A wall one metre to the east, half as high as the tree seen from there.
constexpr Numbers wall{75, 60, 0, 0, 0, 0, 0, 60, 1, 1.4f, open, open, open, open, open, 1.4f};
constexpr Numbers high_south{0, 60, 60, 60, 0, 0, 0, 0, open, open, open, open, open, open, open, open};

std::vector<glm::vec3> tips_of(std::string_view text, const Surroundings& about, std::uint64_t seed) {
  const Population population = grown(text, 8, seed);
  FormHabit habit;
  habit.seed = seed;
  const Form form = form_of(population, habit, about);
  std::vector<glm::vec3> tips;
  for (std::size_t q = 0; q < form.paths.size(); ++q)
    if (!population.shoots[q].trunk) tips.push_back(form.nodes[form.paths[q].first + form.paths[q].count]);
  return tips;
}

const std::string& sigma() {
  static const std::string text = text_named("table-1-sigma1");
  return text;
}

// The mean over some seeds.
glm::vec3 mean_tip(std::string_view text, const Numbers& numbers) {
  glm::vec3 sum(0);
  float count = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const glm::vec3& tip : tips_of(text, sound(Surroundings::of(numbers)), seed)) {
      sum += tip;
      ++count;
    }
  return sum / count;
}

}  // namespace

TEST_CASE("a tree with a wall to the east grows west, and stays within its room") {
  const glm::vec3 free = mean_tip(sigma(), nothing), walled = mean_tip(sigma(), wall);
  CHECK(walled.x < free.x - 0.25f);
  CHECK(std::abs(walled.z - free.z) < 0.15f);
  std::size_t beyond = 0, all = 0, would = 0;
  const Surroundings about = sound(Surroundings::of(wall));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const glm::vec3& tip : tips_of(sigma(), about, seed)) {
      beyond += tip.x > 1 ? 1 : 0;
      ++all;
    }
    for (const glm::vec3& tip : tips_of(sigma(), {}, seed)) would += tip.x > 1 ? 1 : 0;
  }
  CHECK(beyond < all / 20);
  CHECK(would > all / 10);
}

TEST_CASE("a horizon of 60 degrees in the south bends the crown to the north") {
  const std::string text = "phototropism = 0.5\n" + sigma();
  const glm::vec3 free = mean_tip(text, nothing), shaded = mean_tip(text, high_south);
  CHECK(shaded.z < free.z - 0.2f);
  CHECK(std::abs(shaded.x - free.x) < 0.1f);
}

TEST_CASE("neighbours that do not count take no room") {
  const std::string text = "neighbours = 0\n" + sigma();
  std::size_t beyond = 0, all = 0;
  for (const glm::vec3& tip : tips_of(text, sound(Surroundings::of(wall)), 1)) {
    beyond += tip.x > 1 ? 1 : 0;
    ++all;
  }
  CHECK(beyond > all / 10);
}

TEST_CASE("a tree without any room has the same counts") {
  Numbers none{};
  for (std::size_t i = 0; i < 8; ++i) none[i] = 90;
  const Surroundings about = sound(Surroundings::of(none));
  const auto tips = tips_of(sigma(), about, 1);
  CHECK(tips.size() == grown(sigma(), 8).branches);
  for (const glm::vec3& tip : tips) {
    CHECK(std::isfinite(glm::length(tip)));
    CHECK(std::hypot(tip.x, tip.z) < 1.5f);
  }
}

TEST_CASE("surroundings are sixteen numbers; open ones give the same tree as none") {
  CHECK_FALSE(Surroundings::of(std::array<float, 15>{}));
  Numbers broken = nothing;
  broken[3] = std::numeric_limits<float>::quiet_NaN();
  const auto refused = Surroundings::of(broken);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().reason == Reason::bad_request);
  const auto alone = tips_of(sigma(), {}, 3), clear = tips_of(sigma(), sound(Surroundings::of(nothing)), 3);
  REQUIRE(alone.size() == clear.size());
  float farthest = 0;
  for (std::size_t i = 0; i < alone.size(); ++i) farthest = std::max(farthest, glm::distance(alone[i], clear[i]));
  CHECK(farthest < 0.05f);
}

TEST_CASE("room ends at the lines between its eight directions") {
  Numbers numbers = nothing;
  for (std::size_t i = 0; i < 8; ++i) numbers[8 + i] = i % 2 == 0 ? 2.0f : 4.0f;
  const Surroundings about = sound(Surroundings::of(numbers));
  CHECK(about.contains({1.9f, 7, 0}));
  CHECK_FALSE(about.contains({2.1f, 0, 0}));
  CHECK(about.contains({-1.9f, 0, 0}));
  CHECK_FALSE(about.contains({0, 0, -2.1f}));
  for (const float x : {1.0f, -1.0f})
    for (const float z : {1.0f, -1.0f}) {
      CHECK(about.contains({2.7f * x, 0, 2.7f * z}));
      CHECK_FALSE(about.contains({2.9f * x, 0, 2.9f * z}));
    }
  CHECK(Surroundings().contains({1e8f, 0, 0}));
}

TEST_CASE("light comes from the thin side of a crown") {
  const Population population = grown(sigma(), 8);
  CrownLight light(population, {});
  CHECK(light.from({0, 5, 0}) == glm::vec3(0, 1, 0));
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 7; ++k)
      light.put({1, 1 + 0.4f * static_cast<float>(i), 0.9f * static_cast<float>(k - 3)}, 0.2f);
  light.update();
  CHECK(light.from({0, 5, 0}).x < -0.03f);
  CHECK(light.from({3, 5, 0}).x > 0.03f);
  CHECK(std::abs(light.from({0, 5, 0}).z) < 0.5f * std::abs(light.from({0, 5, 0}).x));
  CHECK(glm::length(light.from({3, 5, 0})) == doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("under a closed sky light comes from above") {
  Numbers none = nothing;
  for (std::size_t i = 0; i < 8; ++i) none[i] = 90;
  CHECK(CrownLight(grown(sigma(), 5), sound(Surroundings::of(none))).from({0, 5, 0}) == glm::vec3(0, 1, 0));
  Numbers half = none;
  half[0] = half[1] = half[7] = 0;
  CHECK(CrownLight(grown(sigma(), 5), sound(Surroundings::of(half))).from({0, 5, 0}).x > 0.5f);
}
