// One pixel more or less of the profile moves the bunch by little: no berry gets new random values.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

// A pedicel's address in the bunch, the same before and after a step: the path to it from the root, axis and turn by
// turn.
using Place = std::vector<std::int32_t>;

std::map<Place, glm::vec3> berries_by_place(const GrownBunch& bunch) {
  std::vector<Place> places(bunch.internodes.size());
  std::map<Place, std::int32_t> children;
  for (std::size_t i = 0; i < bunch.internodes.size(); ++i) {
    const Internode& internode = bunch.internodes[i];
    Place parent = internode.parent < 0 ? Place{} : places[static_cast<std::size_t>(internode.parent)];
    parent.push_back(static_cast<std::int32_t>(internode.kind));
    const std::int32_t ordinal = children[parent]++;
    parent.push_back(ordinal);
    places[i] = parent;
  }
  std::map<Place, glm::vec3> berries;
  for (const Berry& berry : bunch.berries) berries[places[static_cast<std::size_t>(berry.parent)]] = berry.centre;
  return berries;
}

}  // namespace

TEST_CASE(
    "one pixel of the profile moves the mean berry by less than 1 mm in the mean, and by more only where a count "
    "steps") {
  double sum = 0, worst = 0;
  int over = 0;
  const int steps = 200;
  for (int step = 0; step < steps; ++step) {
    const auto seed = static_cast<std::uint64_t>(step);
    const Table3Row& row = table3[static_cast<std::size_t>(random_integer(seed, 2, 0, 0, 8))];  // the grapes
    Profile profile = row.profile();
    profile.length += static_cast<float>(random_integer(seed, 3, 0, -20, 20));
    for (std::size_t i = 0; i < 4; ++i)
      profile.sides[i].width =
          std::max(0.0f, profile.sides[i].width + static_cast<float>(random_integer(seed, 4, i, -30, 30)));
    for (std::size_t i = 0; i < 4; ++i)
      profile.sides[i].drop =
          std::max(0.0f, profile.sides[i].drop + static_cast<float>(random_integer(seed, 7, i, -30, 30)));
    const auto before = grow(request_for(profile));
    const std::int32_t which = random_integer(seed, 5, 0, 0, 8);
    const float by = random_unit(seed, 6, 0) < 0.5f ? -1.0f : 1.0f;
    if (which == 0)
      profile.length += by;
    else if (which <= 4)
      profile.sides[static_cast<std::size_t>(which - 1)].width =
          std::max(0.0f, profile.sides[static_cast<std::size_t>(which - 1)].width + by);
    else
      profile.sides[static_cast<std::size_t>(which - 5)].drop =
          std::max(0.0f, profile.sides[static_cast<std::size_t>(which - 5)].drop + by);
    const auto after = grow(request_for(profile));
    REQUIRE(before);
    REQUIRE(after);
    const auto a = berries_by_place(before.value()), b = berries_by_place(after.value());
    double moved = 0;
    int common = 0;
    for (const auto& [place, centre] : a)
      if (const auto other = b.find(place); other != b.end()) {
        moved += glm::length(other->second - centre) * 1000.0;
        ++common;
      }
    REQUIRE(common > 0);
    const double mean = moved / common;
    sum += mean;
    worst = std::max(worst, mean);
    over += mean >= 1;
  }
  MESSAGE("mean " << sum / steps << " mm, worst step " << worst << " mm, " << over << " of 200 steps over 1 mm");
  CHECK(sum / steps < 0.2);
  CHECK(over <= steps / 25);
  CHECK(worst < 8);
}
