#include "models/bunch/natural/settling/thinning.hpp"

#include <doctest/doctest.h>

using namespace panicle;
using namespace panicle::bunch;

namespace {

const SwollenSize ball{8, 8, 8, 0, 8}, finger{8, 16, 8, 8, 8};

}  // namespace

TEST_CASE(
    "who gives up more than a berry can is lost, and only the most "
    "pressed of a neighbourhood") {
  const std::vector<SwollenSize> sizes(4, ball);
  CHECK(crowded_out(std::vector<PressedPair>{{0, 1, 2}, {1, 2, 2}}, sizes).empty());
  // Caps half a radius high take 16 % of a ball's volume: one such contact is allowed, two are not.
  const std::vector<PressedPair> row{{0, 1, 4}, {1, 2, 4}, {2, 3, -1}};
  CHECK(crowded_out(row, sizes) == std::vector<std::uint32_t>{1});
  CHECK(crowded_out(std::vector<PressedPair>{{0, 1, 4}}, sizes).empty());
  CHECK(crowded_out({}, sizes).empty());
}

TEST_CASE("a cap is a smaller share of a longer berry") {
  const std::vector<PressedPair> row{{0, 1, 4}, {1, 2, 4}};
  CHECK(crowded_out(row, std::vector<SwollenSize>(3, finger)).empty());
}
