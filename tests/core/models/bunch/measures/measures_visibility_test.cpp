// Visible berries and pedicels.
#include <doctest/doctest.h>

#include "models/bunch/measures/balls.hpp"

using namespace panicle;
using namespace panicle::bunch;
using enum Measure;

TEST_CASE("berries hide those behind them") {
  const Measured pair(balls({{0, -50, 0}, {0, -50, 30}}, 10), {});
  CHECK(pair[visible_front] == 0.5f);
  CHECK(pair[visible_side] == 1);
  CHECK(pair[visible_mean] == about(25.0 / 26, 1e-4));  // hidden from the front, the front one from behind: a half each
  GrownBunch near = balls({{0, -50, 0}, {0, -50, 30}}, 10);
  near.traits[1].width = near.traits[1].length = 0.004f;
  CHECK(Measured(near, {})[visible_front] == 1);  // the small one before the large one
}

TEST_CASE("pedicels are visible where no berry is before them") {
  GrownBunch grown = balls({{0, -50, 0}}, 10);
  grown.internodes = {{{-1, 0, {0, 0, 0}, {0, -0.03f, 0}, 0.002f, 0.002f}, Kind::rachis},
                      {{0, 0, {0, -0.03f, 0}, {0, -0.04f, 0}, 0.001f, 0.001f}, Kind::pedicel, State::grown, 0}};
  grown.berries[0].parent = 1;
  const Measured bare(grown, {});
  CHECK(bare[pedicels_seen] == about(1, 1e-5));
  CHECK(bare[pedicel_length] == about(10, 1e-4));
  CHECK(bare[peduncle_length] == about(40, 1e-4));
  for (const glm::vec3 place : {glm::vec3(0, -35, 14), glm::vec3(0, -35, -14)}) {
    grown.berries.push_back({place / 1000.0f, 0.01f, {0, -1, 0}, -1, 1});
    grown.traits.push_back({0.02f, 0.02f});
  }
  CHECK(Measured(grown, {})[pedicels_seen] == about(0.5, 1e-5));
}

TEST_CASE("the side measures use the view from the left, like the side view") {
  // A large ball at the left hides the balls behind it from there, and from no other side.
  GrownBunch grown = balls({{-60, -50, 0}, {0, -45, 0}, {0, -55, 4}, {2, -50, -4}}, 5);
  grown.berries[0].radius = 0.03f;
  grown.traits[0].width = grown.traits[0].length = 0.06f;
  CHECK(Measured(grown, {})[visible_side] == about(0.25, 1e-4));
  for (Berry& berry : grown.berries) berry.centre.x = -berry.centre.x;
  CHECK(Measured(grown, {})[visible_side] == about(1, 1e-4));
}
