// Texts of random tokens, and valid texts with tokens changed: each gives a flower with a valid map, or a diagnostic.
// PANICLE_SEED repeats a run (fuzz_dice.hpp).
#include "flowers.hpp"
#include "fuzz_dice.hpp"
#include "generalized_map/embedding.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

const std::vector<std::string> pool = {"#define",
                                       "#axiom:",
                                       "#axiome :",
                                       "#module",
                                       "A",
                                       "B",
                                       "M",
                                       "rd",
                                       "p00",
                                       "step",
                                       "finalStep",
                                       "face",
                                       "age",
                                       "along",
                                       "beside",
                                       "H",
                                       "N",
                                       "A_C1",
                                       "A_E",
                                       "B_C3",
                                       "E",
                                       "O",
                                       "C1",
                                       "C4",
                                       "C",
                                       "{",
                                       "}",
                                       "{}",
                                       "{step<3}",
                                       "{w=2;}",
                                       "[",
                                       "]",
                                       "]_",
                                       "(",
                                       ")",
                                       "(4,0,0,0,1,1,1,1)",
                                       "(,,,,2,,,)",
                                       ",",
                                       ",",
                                       "->",
                                       "->",
                                       "-",
                                       "<",
                                       "|",
                                       ":",
                                       "&",
                                       "<math.random(0,2)>",
                                       "math.random",
                                       "=",
                                       "0",
                                       "1",
                                       "3",
                                       "4",
                                       "0.5",
                                       "1e9",
                                       "ran(1)",
                                       "@",
                                       "\n",
                                       "\n",
                                       "\n",
                                       "_",
                                       "§"};

void try_out(const std::string& text) {
  Limits limits;
  limits.darts = 20000;
  limits.work = 20000;
  limits.steps = 60;
  const auto program = read_program(text, limits);
  const auto derived = program ? derive(program.value(), steps(6), limits) : Result<Derived>(program.error());
  if (!derived) {
    CHECK(derived.error().reason != Reason::none);
    CHECK_FALSE(derived.error().message.empty());
    return;
  }
  CHECK(generalized_map::check(derived.value().map).fault == generalized_map::Fault::nothing);
  generalized_map::Embedding embedding;
  embedding.build(derived.value().map);
  embedding.place(derived.value().shapes());
  // Placing anew takes no more work than growing, where no limit ended the growth.
  const auto again = reworked(program.value(), steps(6), derived.value(), derived->whole ? limits : Limits{});
  REQUIRE(again);
  CHECK(again.value() == derived.value().values);
}

// A random integer in 0 … most. `draw` numbers the draws of one text.
std::size_t random_index(std::uint64_t run, std::uint64_t test, std::uint32_t draw, std::size_t most) {
  return static_cast<std::size_t>(
      random_integer(run + (panicle::tests::fuzz_seed() << 32), test, draw, 0, static_cast<std::int32_t>(most)));
}

}  // namespace

TEST_CASE("texts of random tokens end in a flower or a diagnostic") {
  for (std::uint64_t run = 0; run < panicle::tests::fuzz_runs(3000); ++run) {
    std::string text;
    const auto draw = [&](std::uint32_t i, std::size_t most) { return random_index(run, 1, i, most); };
    const std::size_t length = 1 + draw(0, 40);
    for (std::uint32_t i = 1; i <= length; ++i) text += pool[draw(i, pool.size() - 1)] + " ";
    CAPTURE(text);
    try_out("#define A(4,0,0,0,1,1,1,1)\n#axiom: A\n" + text);
    try_out(text);
  }
}

TEST_CASE("good texts with tokens changed end in a flower or a diagnostic") {
  std::vector<std::string> texts;
  for (const auto& file : files()) texts.push_back(content(file));
  texts.emplace_back(
      "#define V(8,0,0,0,1,1,1,1)\n#define R(4,0,0,0,1,1,1,2)\n#axiom: V\n#define k=3\nV{w=k;}{step<9}{u=w*2}-> "
      "V[V(,u,,,,,,)]_{E}[R]_{C2,C(3+step%2)}\n"
      "R : R_C1 < R_C3 -> R_C1 | R_C3\nR{}{step==4}{} -E-> R V\nV{}{step==5}{} -> R\nV -> V[&M(,2)]_{C5}\n#module "
      "M\n#define k=ran(2)\n#define Q(5,0,k,0,1,1,1,1)\n#axiom: Q(,,1)\nQ -> Q[Q]_{E}");
  for (std::uint64_t run = 0; run < panicle::tests::fuzz_runs(3000); ++run) {
    const auto draw = [&](std::uint32_t i, std::size_t most) { return random_index(run, 2, i, most); };
    std::string text = texts[draw(0, texts.size() - 1)];
    const std::size_t changes = 1 + draw(1, 3);
    for (std::uint32_t i = 0; i < changes; ++i) {
      const std::size_t at = draw(3 * i + 2, text.size() - 1), length = std::min(draw(3 * i + 3, 4), text.size() - at);
      text.replace(at, length, pool[draw(3 * i + 4, pool.size() - 1)]);
    }
    CAPTURE(text);
    try_out(text);
  }
}
