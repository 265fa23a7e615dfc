// Natural bunches within their outline.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/natural/drawn_profile.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

TEST_CASE("berries keep to the outline: coverage and spill over the grape shapes and drawn profiles") {
  double coverage = 0, spill = 0, least = 1, most = 0;
  int count = 0;
  for (int k = 0; k < 29; ++k) {
    const Profile profile =
        k < 9 ? table3[static_cast<std::size_t>(k)].profile() : drawn_profile(static_cast<std::uint64_t>(k));
    BunchRequest request = natural_request(profile);
    request.measures = true;
    const GrownBunch bunch = grown(request);
    const double covered = bunch.measures[static_cast<std::size_t>(Measure::coverage)];
    const double spilt = bunch.measures[static_cast<std::size_t>(Measure::spill)];
    coverage += covered;
    spill += spilt;
    least = std::min(least, covered);
    most = std::max(most, spilt);
    ++count;
  }
  MESSAGE("coverage mean " << coverage / count << ", least " << least << "; spill mean " << spill / count << ", most "
                           << most);
  CHECK(coverage / count >= 0.92);
  CHECK(least >= 0.85);
  CHECK(spill / count <= 0.03);
  CHECK(most <= 0.06);
}

TEST_CASE(
    "one pixel of the profile moves the mean berry by a tenth of a millimetre, by over 0.5 mm once in a hundred "
    "times") {
  double sum = 0, worst = 0;
  int far = 0;
  const int steps = 200;
  for (int step = 0; step < steps; ++step) {
    const auto seed = static_cast<std::uint64_t>(step);
    Profile profile = table3[static_cast<std::size_t>(random_integer(seed, 2, 0, 0, 8))].profile();
    profile.length += static_cast<float>(random_integer(seed, 3, 0, -20, 20));
    for (std::size_t i = 0; i < 4; ++i) {
      SidePoint& side = profile.sides[i];
      side.width = std::max(0.0f, side.width + static_cast<float>(random_integer(seed, 4, i, -30, 30)));
      side.drop = std::max(0.0f, side.drop + static_cast<float>(random_integer(seed, 7, i, -30, 30)));
    }
    const GrownBunch before = grown(natural_request(profile));
    const std::int32_t which = random_integer(seed, 5, 0, 0, 8);
    const float by = random_unit(seed, 6, 0) < 0.5f ? -1.0f : 1.0f;
    float& moved = which == 0   ? profile.length
                   : which <= 4 ? profile.sides[static_cast<std::size_t>(which - 1)].width
                                : profile.sides[static_cast<std::size_t>(which - 5)].drop;
    moved = std::max(0.0f, moved + by);
    const GrownBunch after = grown(natural_request(profile));
    std::map<std::uint32_t, glm::vec3> places;
    for (const Berry& berry : before.berries) places[berry.id] = berry.centre;
    double way = 0;
    int common = 0;
    for (const Berry& berry : after.berries)
      if (const auto at = places.find(berry.id); at != places.end()) {
        way += glm::length(at->second - berry.centre) * 1000.0;
        ++common;
      }
    REQUIRE(common > 0);
    sum += way / common;
    worst = std::max(worst, way / common);
    far += way / common > 0.5;
  }
  MESSAGE("mean of " << steps << " steps " << sum / steps << " mm, worst " << worst << " mm, " << far
                     << " over 0.5 mm");
  CHECK(sum / steps < 0.13);
  CHECK(far <= steps / 100);
  CHECK(worst < 1);
}
