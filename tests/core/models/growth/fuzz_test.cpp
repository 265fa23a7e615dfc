// Texts of random tokens, and valid texts with tokens changed: each gives a tree or a diagnostic. PANICLE_SEED repeats
// a run (fuzz_dice.hpp).
#include <array>
#include <cmath>

#include "fuzz_dice.hpp"
#include "models/growth/foliage.hpp"
#include "models/growth/levels.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

const std::vector<std::string> pool = {"footprint",
                                       "tree",
                                       "bud",
                                       "branch",
                                       "leaf",
                                       "fallingLeaf",
                                       "childTrunk",
                                       "gs",
                                       "gs.rand",
                                       "k",
                                       "N",
                                       "ndv",
                                       "nbr",
                                       "nlf",
                                       "B",
                                       "L",
                                       "D",
                                       "E",
                                       "order",
                                       "length",
                                       "gravitropism",
                                       "phototropism",
                                       "neighbours",
                                       "GrowVol",
                                       "GrowVol.h",
                                       "GrowVol.id",
                                       "DivFunc",
                                       "\"sigma1\"",
                                       "\"sigma1b\"",
                                       "\"hat\"",
                                       "\"star2\"",
                                       "\"exp\"",
                                       "\"",
                                       "{branches}",
                                       "{leaves}",
                                       "{",
                                       "}",
                                       "(",
                                       "(",
                                       ")",
                                       ")",
                                       ",",
                                       ",",
                                       ":",
                                       "->",
                                       "->",
                                       "→",
                                       "-",
                                       "+",
                                       "*",
                                       "/",
                                       "^",
                                       "=",
                                       "==",
                                       "<",
                                       ">",
                                       "&&",
                                       "||",
                                       "0",
                                       "1",
                                       "2",
                                       "3",
                                       "8",
                                       "0.1",
                                       "1e9",
                                       "1e-9",
                                       "60°",
                                       "°",
                                       ".",
                                       "cnt.rand",
                                       "size.rand",
                                       "size",
                                       "h",
                                       "at",
                                       "RND",
                                       "ran",
                                       "abs",
                                       "min",
                                       "\n",
                                       "\n",
                                       "\n",
                                       "/*",
                                       "*/",
                                       "σ",
                                       "\xff",
                                       "[",
                                       "]",
                                       "#"};

Limits small_limits() {
  Limits limits;
  limits.work = 20'000;
  limits.segments = 500;
  limits.copies = 2000;
  limits.pieces = 2000;
  return limits;
}

// Whether it is a tree; a diagnostic has a message, and a place in the text or none.
bool grows(const std::string& text) {
  const Diagnostic diagnostic = trouble(text, 7, small_limits());
  if (diagnostic.reason == Reason::none) return true;
  CHECK_FALSE(diagnostic.message.empty());
  CHECK((diagnostic.line == 0) == (diagnostic.column == 0));
  return false;
}

// The form and the levels of a tree have finite numbers, also with unusual volumes and rules.
void is_sound(const std::string& text, std::uint64_t seed) {
  const Population population = grown(text, 5, seed);
  if (population.shoots.size() > small_limits().segments) return;
  std::array<float, 16> about{};
  for (std::size_t i = 0; i < about.size(); ++i) about[i] = (i < 8 ? 90 : 6) * random_unit(seed, 1, i);
  const Form form = form_of(population, {}, sound(Surroundings::of(about)));
  const Moment moment = sound(moment_of(population, form, 5, {}, Limits{}));
  Plant plant;
  CHECK(add_leaves(plant, population, form, moment, 5, {}, Limits{}).reason == Reason::none);
  for (const PlantMesh& level : levels_of(moment, plant.organs, 0.5f, 0.3f).meshes) {
    for (const float number : level.mesh.positions) REQUIRE(std::isfinite(number));
    for (const float number : level.mesh.normals) REQUIRE(std::isfinite(number));
    for (const std::uint32_t index : level.mesh.indices) REQUIRE(3 * std::size_t{index} < level.mesh.positions.size());
  }
}

}  // namespace

TEST_CASE("growth grammars of random tokens end in a tree or a diagnostic") {
  for (std::uint64_t text = 0; text < panicle::tests::fuzz_runs(3000); ++text) {
    CAPTURE(text);
    panicle::tests::Dice dice(13, text);
    std::string written;
    for (std::size_t token = dice.below(60); token > 0; --token) written += pool[dice.below(pool.size())] + " ";
    grows(written);
  }
}

TEST_CASE("growth grammars with tokens changed end in a tree or a diagnostic") {
  std::vector<std::string> good;
  for (const auto& path : files()) good.push_back(content(path));
  std::size_t sound_texts = 0;
  for (std::uint64_t text = 0; text < panicle::tests::fuzz_runs(1500); ++text) {
    CAPTURE(text);
    panicle::tests::Dice dice(13, 100'000 + text);
    std::string written = good[dice.below(good.size())];
    for (std::size_t change = 1 + dice.below(4); change > 0; --change) {
      const std::size_t at = dice.below(written.size());
      const std::size_t way = dice.below(3);
      if (way == 0) {
        written.insert(at, " " + pool[dice.below(pool.size())] + " ");
      } else {
        written.erase(at, 1 + dice.below(8));
        if (way == 2) written.insert(at, pool[dice.below(pool.size())]);
      }
    }
    const bool grew = grows(written);
    if (grew && text % 8 == 0) is_sound(written, text);
    sound_texts += grew;
  }
  CHECK(sound_texts > 0);
}
