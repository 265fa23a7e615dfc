// The meadow of figure 24: a ground of volumes, glued like a petal, whose seeds are modules.
#include <map>
#include <set>

#include "flowers.hpp"
#include "foundation/english.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;
namespace gm = panicle::generalized_map;

namespace {

const std::vector<std::string> kinds = {"CLOVER", "BUTTERCUP", "DAISY", "CORNFLOWER", "POPPY"};

Flower meadow(const std::vector<Given::Value>& values, std::uint64_t seed = 1, const Limits& limits = {}) {
  Given given;
  given.seed = seed;
  given.values = values;
  return grown(text_named("meadow"), given, limits);
}

// How many of each module there are.
std::map<std::string, std::size_t> modules_of(const Flower& flower) {
  std::map<std::string, std::size_t> found;
  for (const Instance& instance : flower.derived.instances) ++found[flower.program.grammars[instance.grammar].name];
  return found;
}

std::size_t flowers_of(const Flower& flower) {
  auto found = modules_of(flower);
  std::size_t all = 0;
  for (const std::string& kind : kinds) all += found[kind];
  return all;
}

}  // namespace

TEST_CASE("a meadow's ground is one surface, and each of its volumes has a seed of one kind") {
  const Flower flower = meadow({{"across", 12}});
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
  CHECK_FALSE(flower.noted("never became adjacent"));
  const gm::Map& map = flower.derived.map;
  // Of the rows' volumes all but those at the margin are glued to both neighbours.
  std::size_t ground = 0, inner = 0;
  for (std::uint32_t v = 0; v < map.volumes(); ++v) {
    const Record& record = flower.derived.records[flower.derived.record_of[v]];
    if (record.instance != 0) continue;
    ++ground;
    if (record.rank.beside > 0) inner += !map.is_free(v, gm::side(1)) && !map.is_free(v, gm::side(3));
  }
  CHECK(ground > 90);
  CHECK(inner > 0.6 * static_cast<double>(ground));
  auto found = modules_of(flower);
  CHECK(found["SOW"] == ground);
  CHECK(found["GRASS"] + flowers_of(flower) == ground);
}

TEST_CASE("all kinds grow in a meadow, in drifts, and other ones of another seed") {
  const Flower flower = meadow({});
  const auto found = modules_of(flower);
  for (const Grammar& grammar : flower.program.grammars) {
    CAPTURE(grammar.name);
    CHECK(found.contains(grammar.name));
  }
  const Flower other = meadow({}, 2);
  CHECK(modules_of(other) != found);
  for (const std::string& kind : kinds) CHECK(modules_of(other).contains(kind));
}

TEST_CASE("figures of the text set a meadow's number of flowers and its size") {
  std::size_t before = 0;
  for (const float share : {0.0f, 0.5f, 1.0f, 2.0f}) {
    const std::size_t now = flowers_of(meadow({{"across", 16}, {"flowers", share}}));
    CHECK((share == 0 ? now == 0 : now > before));
    before = now;
  }
  const std::size_t small = meadow({{"across", 8}}).derived.map.volumes(),
                    large = meadow({{"across", 16}}).derived.map.volumes();
  CHECK(large > 3 * small);
  CHECK(large < 6 * small);
}

TEST_CASE("a meadow that is too large is cut short, with a note") {
  Limits limits;
  limits.darts = 200'000;
  const Flower flower = meadow({}, 1, limits);
  CHECK_FALSE(flower.derived.whole);
  CHECK(english(flower.derived.notes.front()).find("Growth ended in step") != std::string::npos);
  CHECK(flower.derived.map.darts() > 190'000);
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
}
