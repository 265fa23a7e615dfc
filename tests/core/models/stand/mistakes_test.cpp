// Common mistakes in plans: each has a diagnostic at its place, with advice.
#include "mistakes.hpp"

#include "models/stand/plans.hpp"

using namespace panicle;
using namespace panicle::stand;
using namespace panicle::stand::tests;

namespace {

using panicle::tests::Mistake;

const std::string some = "plants 10, random\n";

const Mistake mistakes[] = {
    {"«", "plants 100, blue 2"},
    {"«trees 100", "ground, plants"},
    {"«3 x 4", "not with “3”"},
    {"ground 3 «4", "operator or a comma"},
    {"ground 3«", "“x” between"},
    {"ground 3 x «-4", "from 0.1 to 1000"},
    {"ground 3 x 4, «slope 3", "relief or hills"},
    {"ground 3 x 4,«", "follows the comma"},
    {"ground 3 x 4\n«ground 3 x 4", "already"},
    {"ground 3 x 4, relief «500", "from 0 to 100"},
    {"«plants, blue\na/b", "plants 100"},
    {"plants «1.5, blue", "whole number"},
    {"plants «6000, blue", "from 1 to 5000"},
    {"plants 10 «blue", "operator or a comma"},
    {"plants 10, «green", "stratified, blue, random, rows"},
    {"plants 10, rows 3«", "“x” between"},
    {"plants 10, blue «ran(3)", "write a range"},
    {"plants 10, blue «spacing", "spacing"},
    {"«plants 10, depth 0.5", "two values"},
    {"«plants 5000, blue, depth 0 to 1e-16", "0.001 apart"},
    {"«plants 10, random", "a line for each"},
    {"«plants 10, random\na/b, share 0", "add up to 0"},
    {"«a/b", "number and spacing of the plants first"},
    {some + "«trellis 2\na/b", "plants in rows"},
    {"plants, rows 2 x 1\ntrellis 2, «rail 1\na/b", "posts, wire or pair"},
    {"plants, rows 2 x 1\ntrellis 2, wire «3\na/b", "from 0 to 2"},
    {"plants, rows 2 x 1\ntrellis 2\n«trellis 2\na/b", "one layer"},
    {some + "a/b\nc/d, at «3", "at bunch"},
    {some + "a/b «share 3", "“,”"},
    {some + "a/b, «shade 3", "share, crown, scale"},
    {some + "a/b, crown 3«", "“x” between"},
    {some + "a/b, scale 2 to «1", "1 to 2"},
    {some + "«a/b, each 3", "attached to"},
    {some + "a/b:«", "name of a parameter"},
    {some + "a/b: «3", "name of a parameter"},
    {some + "a/b: steps«", "number is missing"},
    {some + "a/b: steps 5 to 7 «9", "operator or a comma"},
    {some + "a/b: steps «1/0", "from -1000000"},
};

}  // namespace

TEST_CASE("stand: mistakes have diagnostics at their place, with advice") {
  panicle::tests::check_mistakes(mistakes, [](const std::string& text) {
    const auto plan = read_plan(text);
    return plan ? Diagnostic{} : plan.error();
  });
}

TEST_CASE("stand: a plan continues after commas and colons, and evaluates its numbers") {
  const Plan plan =
      sound(read_plan("ground 2 * 30 x 40,\n  relief (1 + 2)\nplants 10,\n  rows sqrt(4) x 1\n"
                      "growth/table-1-sigma1, share 3,\n crown 5 x 9: steps 5 to 7, leaf \"oak\""));
  CHECK(plan.ground.width == 60);
  CHECK(plan.ground.relief == 3);
  CHECK(plan.layers[0].apart == 2);
  const Kind& kind = plan.layers[0].kinds[0];
  CHECK(kind.name == "growth/table-1-sigma1");
  CHECK(kind.height == 9);
  REQUIRE(kind.settings.size() == 2);
  CHECK(kind.settings[0].range.to == 7);
  CHECK(kind.settings[1].word == "oak");
}

TEST_CASE("stand: every plan of the presets can be read and placed") {
  REQUIRE(texts().size() >= 1);
  for (const std::string& text : texts()) {
    const PlacedStand all = placed(text);
    CHECK(all.notes.empty());
    CHECK(all.plants.size() >= 20);
  }
}
