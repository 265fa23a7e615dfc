#include "models/bunch/natural/crop.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "foundation/random.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/natural/stages.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

std::vector<float> ranks_up_to(std::size_t count) {
  std::vector<float> ranks(count);
  for (std::size_t i = 0; i < count; ++i) ranks[i] = static_cast<float>((i * 7) % count);
  return ranks;
}

std::size_t setting(const FruitSet& set) {
  return static_cast<std::size_t>(
      std::count_if(set.volumes.begin(), set.volumes.end(), [](float volume) { return volume > 0; }));
}

CropTarget target_of(float count) {
  CropTarget target;
  target.count = count;
  target.density = 5;
  target.most = 80;
  target.limit = 100;
  target.berry.size = 16;
  return target;
}

// A rachis with pedicels all round it, more than have room.
Sprout brush(std::uint32_t flowers) {
  Sprout sprout;
  const Profile profile{300, {{{60, 40}, {60, 40}, {60, 40}, {60, 40}}}};
  sprout.bounds.push_back({Envelope(profile, 0.5f, 40), 0});
  std::int32_t above = -1;
  for (std::uint32_t i = 0; i < flowers; ++i) {
    const float depth = 10 + 120 * static_cast<float>(i) / static_cast<float>(flowers);
    const glm::vec3 start{0, i == 0 ? 0 : -(depth - 120.0f / static_cast<float>(flowers)), 0}, end{0, -depth, 0};
    const auto stem_at = static_cast<std::int32_t>(sprout.internodes.size());
    sprout.internodes.push_back(stem(above, Kind::rachis, start, end));
    above = stem_at;
    glm::vec3 heading = random_direction(1, 2, i);
    heading.y *= 0.3f;
    heading = glm::normalize(heading);
    sprout.internodes.push_back(stem(stem_at, Kind::pedicel, end, end + heading * 12.0f));
    sprout.flowers.push_back(flower_on(stem_at + 1, heading, i));
  }
  return sprout;
}

Crop crop_of(const Sprout& sprout, const CropTarget& target) {
  std::vector<Bud> buds;
  for (std::size_t i = 0; i < sprout.flowers.size(); ++i)
    buds.push_back({sprout.internodes[static_cast<std::size_t>(sprout.flowers[i].parent)].end, random_unit(5, 6, i)});
  const std::vector<float> shares(buds.size(), 1);
  const Hanging hanging = hang(sprout.internodes, sprout.flowers, 0);
  return grow_crop(sprout, hanging, buds, shares, target, sizes_until(100));
}

}  // namespace

TEST_CASE("as many flowers set as requested or as fill the space, and never more than the limit") {
  const std::vector<float> ranks = ranks_up_to(200);
  CHECK(setting(set_fruit(ranks, 0, target_of(30))) == 30);
  CHECK(setting(set_fruit(ranks, 0, target_of(90))) == 80);  // more than the outline holds
  CHECK(setting(set_fruit(ranks, 50, target_of(0))) == 50);
  CHECK(!set_fruit(ranks, 50, target_of(0)).full);
  CHECK(setting(set_fruit(ranks, 150, target_of(0))) == 80);
  CHECK(set_fruit(ranks, 150, target_of(0)).full);
}

TEST_CASE("stand-ins are the next in turn, and there are none without a requested count") {
  const std::vector<float> ranks = ranks_up_to(200);
  const FruitSet set = set_fruit(ranks, 0, target_of(30));
  const std::vector<std::uint32_t> next = stand_ins(ranks, set.volumes, target_of(30));
  REQUIRE(next.size() == 10);
  for (std::size_t k = 0; k < next.size(); ++k) CHECK(ranks[next[k]] == 30 + static_cast<float>(k));
  CHECK(stand_ins(ranks, set.volumes, target_of(0)).empty());
}

TEST_CASE(
    "where some of a count find no room others stand in, one swelling for all, and who did not set is not there") {
  const Sprout sprout = brush(160);
  CropTarget target = target_of(84);
  target.limit = 160;
  target.most = 160;
  target.berry.size = 17;
  const Crop crop = crop_of(sprout, target);
  const auto lost =
      static_cast<std::size_t>(std::count(crop.swollen.lost.begin(), crop.swollen.lost.end(), RemovalReason::no_room));
  CHECK(lost > 0);                            // some berries are lost
  CHECK(crop.fruitlets.size() > 84);          // so stand-ins have set
  CHECK(crop.fruitlets.size() - lost >= 80);  // and found room
  CHECK(crop.fruitlets.size() == setting(crop.set));
  CHECK(crop.berries.size() == crop.fruitlets.size());
  CHECK(crop.swollen.centres.size() == crop.fruitlets.size());
  CHECK(crop.swollen.directions.size() == crop.fruitlets.size());
  for (std::size_t k = 0; k < crop.fruitlets.size(); ++k) {
    CHECK(crop.swollen.lost[k] != RemovalReason::not_set);
    if (k > 0) CHECK(crop.fruitlets[k].flower > crop.fruitlets[k - 1].flower);
  }
}

TEST_CASE("berries removed by hand are found by their ids") {
  CropTarget target = target_of(0);
  target.taken = {3, 9};
  std::vector<Flower> flowers;
  for (std::uint32_t i = 0; i < 12; ++i) flowers.push_back(flower_on(0, {0, -1, 0}, i));
  const std::vector<float> volumes(12, 1), shares(12, 1);
  std::vector<std::uint32_t> all(12);
  std::iota(all.begin(), all.end(), 0u);
  const std::vector<Fruitlet> fruitlets = fruitlets_of(all, 12, volumes, shares, flowers, target);
  for (const Fruitlet& one : fruitlets) {
    CHECK(one.taken == (one.flower == 3 || one.flower == 9));
    CHECK(one.half_width == doctest::Approx(8));
    CHECK(one.half_length == doctest::Approx(8));
  }
  target.berry.elongation = 1.5f;
  for (const Fruitlet& one : fruitlets_of(all, 12, volumes, shares, flowers, target)) {
    CHECK(one.half_width == doctest::Approx(8));
    CHECK(one.half_length == doctest::Approx(12));
  }
}
