#include "models/bunch/natural/settling/swelling.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/natural/settling/sagging.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

const std::vector<float> ripe = sizes_until(100);

// A roomy outline: a drum 200 mm long and as wide.
const std::vector<BunchEnvelope> roomy{
    {Envelope(Profile{400, {{{230, 40}, {230, 40}, {230, 40}, {230, 40}}}}, 0.5f, 110), 0}};

Swelling berry_at(std::uint32_t branch, const glm::vec3& heading, float half = 8) {
  Swelling berry;
  berry.branch = branch;
  berry.heading = heading;
  berry.stalk = 8;
  berry.half_width = berry.half_length = half;
  return berry;
}

}  // namespace

TEST_CASE("a berry alone hangs at its pedicel's end, which droops") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 2, 0}};
  const std::vector<Swelling> berries{berry_at(0, {1, 0, 0})};
  const Swollen one = swell(branches, berries, roomy, ripe);
  CHECK(one.lost[0] == RemovalReason{});
  const float far = glm::length(one.centres[0] - one.ends[0]);
  CHECK(far <= 16.01f);
  CHECK(far >= 0.6f * 8 + 8 - 0.01f);
  CHECK(glm::dot(one.directions[0], drooping({1, 0, 0}, 1)) > 0.99f);
  CHECK(one.directions[0].y < -0.5f);
}

TEST_CASE("a berry that dries hangs on as it did when it was full") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 2, 0}};
  const std::vector<Swelling> berries{berry_at(0, {1, 0, 0})};
  const Swollen full = swell(branches, berries, roomy, ripe), dry = swell(branches, berries, roomy, sizes_until(125));
  CHECK(glm::dot(full.directions[0], dry.directions[0]) > 0.9999f);
}

TEST_CASE("two berries side by side part, and overlap by little") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}};
  const std::vector<Swelling> berries{berry_at(0, glm::normalize(glm::vec3(1, 0, 0.5f))),
                                      berry_at(0, glm::normalize(glm::vec3(1, 0, -0.5f)))};
  const Swollen two = swell(branches, berries, roomy, ripe);
  CHECK(glm::length(two.centres[0] - two.centres[1]) > 0.8f * 16);
}

TEST_CASE("fingers part by their sides, not by their middles") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}, {{0, 0, 0}, {12, -100, 0}, -1, 1, 0}};
  std::vector<Swelling> berries{berry_at(0, {0, -1, 0}), berry_at(1, {0, -1, 0})};
  for (Swelling& berry : berries) berry.half_length = 20;
  const Swollen two = swell(branches, berries, roomy, ripe);
  const float apart = glm::length(two.centres[0] - two.centres[1]);
  CHECK(apart > 11.5f);
  CHECK(apart < 20);
}

TEST_CASE("a loaded branch gives way, a stiff one does not") {
  for (const float give : {0.0f, 0.8f}) {
    const std::vector<Branch> branches{{{0, 0, 0}, {0, -60, 0}, -1, 2, 0}, {{0, -60, 0}, {30, -60, 0}, 0, 1, give}};
    // Two berries on two branches hang at one place: one presses the other down.
    const std::vector<Branch> all{branches[0], branches[1], {{0, -60, 0}, {30, -64, 0}, 0, 1, give}};
    const std::vector<Swelling> berries{berry_at(1, {0, -1, 0}, 12), berry_at(2, {0, -1, 0}, 12)};
    const Swollen bent = swell(all, berries, roomy, ripe);
    const float moved = glm::length(bent.ends[2] - all[2].end);
    CHECK((give > 0 ? moved > 0.01f : moved == 0));
  }
}

TEST_CASE("berries stay within the outline and its tolerance") {
  const std::vector<BunchEnvelope> narrow{
      {Envelope(Profile{400, {{{40, 40}, {40, 40}, {40, 40}, {40, 40}}}}, 0.5f, 20), 0}};
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}};
  std::vector<Swelling> berries{berry_at(0, {1, 0, 0}), berry_at(0, {-1, 0, 0})};
  for (Swelling& berry : berries) berry.stalk = 30;  // which would place them 18 mm beyond it
  const Swollen held = swell(branches, berries, narrow, ripe), free = swell(branches, berries, roomy, ripe);
  for (const glm::vec3& centre : free.centres) CHECK(std::abs(centre.x) > 29);
  for (const glm::vec3& centre : held.centres) CHECK(std::abs(centre.x) < 20 + 0.5f * 8);
}

TEST_CASE("a stem much longer than a berry is an obstacle all along") {
  // Upright, through the place where the berry would hang, which is near the stem's lower end, middle or upper end.
  for (const float middle : {-20.0f, -100.0f, -180.0f}) {
    CAPTURE(middle);
    const glm::vec3 through(15, middle, 1), half(0, 100, 0);
    const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 0, 0}, {through + half, through - half, -1, 2, 0}};
    const std::vector<Swelling> berries{berry_at(0, {1, 0, 0})};
    const Swollen one = swell(branches, berries, roomy, ripe);
    const glm::vec3 away = one.centres[0] - through;
    CHECK(std::hypot(away.x, away.z) > 8 + 2 - 0.1f);
    CHECK(one.ends[1] == branches[1].end);
  }
}

TEST_CASE("a berry is lost only without room or if removed by hand") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}};
  std::vector<Swelling> berries;
  for (int k = 0; k < 40; ++k) {
    const SinCos turn = sincos_degrees(static_cast<float>(k) * 137.5f);
    const float y = 1 - (static_cast<float>(k) + 0.5f) / 20;
    const float out = std::sqrt(1 - y * y);
    berries.push_back(berry_at(0, {out * turn.cosine, y, out * turn.sine}, 14));
  }
  const Swollen crowd = swell(branches, berries, roomy, ripe);
  int lost = 0;
  for (const RemovalReason why : crowd.lost) lost += why == RemovalReason::no_room;
  CHECK(lost > 0);
  CHECK(lost < 36);

  std::vector<Swelling> few{berries[0], berries[7]};
  few[1].taken = true;
  const Swollen taken = swell(branches, few, roomy, ripe);
  CHECK(taken.lost[0] == RemovalReason{});
  CHECK(taken.lost[1] == RemovalReason::by_hand);
}

TEST_CASE("swelling without berries gives an empty result") {
  CHECK(swell({}, {}, roomy, ripe).centres.empty());
  const std::vector<Branch> branches{{{0, 0, 0}, {0, 0, 0}, -1, 1, 0}};
  const std::vector<Swelling> berries{berry_at(0, {0, -1, 0})};
  CHECK(swell(branches, berries, roomy, {}).centres.size() == 1);
}

TEST_CASE("a berry and a stem part") {
  // The stem passes where the berry would hang.
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}, {{14, -130, 3}, {14, -80, 3}, -1, 2, 0}};
  const Swollen one = swell(branches, std::vector<Swelling>{berry_at(0, {1, 0, 0})}, roomy, ripe);
  const glm::vec3 way = one.centres[0] - glm::vec3(14, one.centres[0].y, 3);
  CHECK(glm::length(way) > 9.5f);
}

TEST_CASE("a pedicel bends to six tenths of its length, and no further") {
  // Stems in the form of a funnel press its berry back towards its foot.
  std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}};
  const glm::vec3 apex{30, -100, 0};
  for (const glm::vec3 rim : {glm::vec3(0, 1, 0), glm::vec3(0, -0.5f, 0.866f), glm::vec3(0, -0.5f, -0.866f)})
    branches.push_back({apex, apex + rim * 24.0f - glm::vec3(20, 0, 0), -1, 2, 0});
  std::vector<Swelling> berries{berry_at(0, {1, 0, 0})};
  berries[0].stalk = 20;
  const Swollen pressed = swell(branches, berries, roomy, ripe);
  CHECK(glm::length(pressed.centres[0] - pressed.ends[0]) > 0.6f * 20 + 8 - 0.5f);
}

TEST_CASE("berries lost while swelling do not come back when the others dry") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}};
  for (const float half : {9.0f, 9.5f}) {
    std::vector<Swelling> berries;
    for (int k = 0; k < 24; ++k) {
      const SinCos turn = sincos_degrees(static_cast<float>(k) * 137.5f);
      const float y = 1 - (static_cast<float>(k) + 0.5f) / 12;
      const float out = std::sqrt(1 - y * y);
      berries.push_back(berry_at(0, {out * turn.cosine, y, out * turn.sine}, half));
    }
    const auto lost = [&](float age) {
      int count = 0;
      for (const RemovalReason why : swell(branches, berries, roomy, sizes_until(age)).lost)
        count += why == RemovalReason::no_room;
      return count;
    };
    CHECK(lost(100) > 0);
    CHECK(lost(125) == lost(100));
  }
}

TEST_CASE("late berries join where others found no room, in their order, and only as many as requested") {
  const std::vector<Branch> branches{{{0, 0, 0}, {0, -100, 0}, -1, 1, 0}, {{0, 0, 0}, {60, -60, 0}, -1, 1, 0}};
  std::vector<Swelling> berries;
  for (int k = 0; k < 24; ++k) {
    const SinCos turn = sincos_degrees(static_cast<float>(k) * 137.5f);
    const float y = 1 - (static_cast<float>(k) + 0.5f) / 12;
    const float out = std::sqrt(1 - y * y);
    berries.push_back(berry_at(k < 20 ? 0 : 1, {out * turn.cosine, y, out * turn.sine}, k < 20 ? 14.0f : 8.0f));
    berries.back().late = k >= 20;
  }
  const auto there = [](const Swollen& some) {
    return std::count(some.lost.begin(), some.lost.end(), RemovalReason{});
  };
  const Swollen alone = swell(branches, berries, roomy, ripe);
  for (std::size_t k = 20; k < 24; ++k) CHECK(alone.lost[k] == RemovalReason::not_set);
  const auto held = static_cast<std::size_t>(there(alone));
  REQUIRE(held < 20);
  const Swollen enough = swell(branches, berries, roomy, ripe, held);
  for (std::size_t k = 20; k < 24; ++k) CHECK(enough.lost[k] == RemovalReason::not_set);
  const Swollen more = swell(branches, berries, roomy, ripe, held + 1);
  CHECK(more.lost[20] == RemovalReason{});
  CHECK(there(more) > there(alone));
  for (std::size_t k = 20; k < 24; ++k)
    if (more.lost[k] == RemovalReason{}) CHECK(glm::length(more.centres[k] - more.ends[1]) < 16.1f);
}

TEST_CASE("pedicels are little over half as long in flower, and grow until berries are six tenths of their size") {
  CHECK(stalk_at(0) == doctest::Approx(0.55));
  CHECK(stalk_at(0.3f) == doctest::Approx(0.775));
  CHECK(stalk_at(0.6f) == doctest::Approx(1));
  CHECK(stalk_at(1) == doctest::Approx(1));
}

TEST_CASE("a branch stays where berries have pushed it: farther for a larger `give`") {
  std::vector<float> moved;
  for (const float give : {0.0f, 0.4f, 0.8f}) {
    const std::vector<Branch> branches{{{0, 0, 0}, {0, -60, 0}, -1, 2, 0},
                                       {{0, -60, 0}, {30, -60, 0}, 0, 1, give},
                                       {{26, -60, 1}, {26, -100, 1}, -1, 2, 0}};
    // Its berry hangs at a stiff stem.
    Swelling berry = berry_at(1, glm::normalize(glm::vec3(-0.2f, -1, 0)), 12);
    const Swollen bent = swell(branches, std::vector<Swelling>{berry}, roomy, ripe);
    moved.push_back(glm::length(bent.ends[1] - branches[1].end));
  }
  CHECK(moved[0] == 0);
  CHECK(moved[1] > 0);
  CHECK(moved[2] > 3 * moved[1]);
}

TEST_CASE("a pedicel does not turn round, though the outline would have its berry behind it") {
  const std::vector<BunchEnvelope> narrow{
      {Envelope(Profile{400, {{{40, 40}, {40, 40}, {40, 40}, {40, 40}}}}, 0.5f, 20), 0}};
  // It grows outwards, from well outside.
  const std::vector<Branch> branches{{{0, 0, 0}, {34, -100, 0}, -1, 1, 0}};
  const Swollen held = swell(branches, std::vector<Swelling>{berry_at(0, {1, 0, 0})}, narrow, ripe);
  CHECK(held.directions[0].x > -0.8f);
}
