// Published grammars do as published: wasm-core/grammars/grammar, as docs/models/grammar/conformance.md lists them. How
// often a symbol stands in a string is worked out from the productions by other means: in closed form, or by a
// recurrence over the ages of apices. tests/golden/oracle.tsv has the strings of another engine.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "foundation/english.hpp"
#include "lsystem/derivation/derivation.hpp"
#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::uint64_t power(std::uint64_t base, std::uint32_t exponent) {
  std::uint64_t result = 1;
  while (exponent-- > 0) result *= base;
  return result;
}

// How many apices flower in `steps` steps when each that does leaves others that do so after these many more.
std::uint64_t events(std::uint32_t steps, std::initializer_list<std::uint32_t> delays) {
  std::vector<std::uint64_t> at(steps + 1);
  std::uint64_t sum = 0;
  for (std::uint32_t step = 1; step <= steps; ++step) {
    at[step] = step == 1;
    for (const std::uint32_t delay : delays)
      if (step > delay) at[step] += at[step - delay];
    sum += at[step];
  }
  return sum;
}

// Tips of an axis that makes n nodes, each with `branches` branches of n − `younger` nodes.
std::uint64_t tips(int n, std::uint64_t branches, int younger) {
  return n <= 0 ? 1 : branches * tips(n - younger, branches, younger) + tips(n - 1, branches, younger);
}

// F(0) = 0, F(1) = 1
std::uint64_t fibonacci(std::uint32_t n) {
  std::uint64_t now = 0, next = 1;
  while (n-- > 0) std::swap(now += next, next);
  return now;
}

struct Count {
  const char* text;
  const char* symbol;
  std::function<std::uint64_t(std::uint32_t)> after;  // steps
};

// Each replaced by so many of its kind.
std::function<std::uint64_t(std::uint32_t)> times(std::uint64_t base, std::uint64_t first = 1) {
  return [=](std::uint32_t n) { return first * power(base, n); };
}

const std::vector<Count> counts = {
    {"koch-island", "F", times(8, 4)},
    {"koch-island", "-", [](std::uint32_t n) { return 3 + 3 * 4 * (power(8, n) - 1) / 7; }},
    {"koch-island-18", "F", times(18, 4)},
    {"quadratic-snowflake", "F", times(5)},
    {"islands-and-lakes", "F", times(18, 4)},
    // Each F makes 4, each f becomes 6.
    {"islands-and-lakes", "f", [](std::uint32_t n) { return 16 * (power(18, n) - power(6, n)) / 12; }},
    {"koch-curve-a", "F", times(8, 4)},
    {"koch-curve-b", "F", times(7, 4)},
    {"koch-curve-c", "F", times(7, 4)},
    {"koch-curve-d", "F", times(5, 4)},
    {"koch-curve-e", "F", times(5, 4)},
    {"koch-curve-f", "F", times(5, 4)},
    {"dragon-curve", "Fl", [](std::uint32_t n) { return n == 0 ? 1 : power(2, n - 1); }},
    {"dragon-curve", "Fr", [](std::uint32_t n) { return n == 0 ? 0 : power(2, n - 1); }},
    // Each makes two of the other and one of its own: 3ⁿ in all, and the difference changes its sign.
    {"sierpinski-gasket", "Fr", [](std::uint32_t n) { return (power(3, n) + (n % 2 ? -1 : 1)) / 2; }},
    {"sierpinski-gasket", "Fl", [](std::uint32_t n) { return (power(3, n) - (n % 2 ? -1 : 1)) / 2; }},
    // Four of its own and three of the other: 7ⁿ in all, a difference of 1.
    {"hexagonal-gosper", "Fl", [](std::uint32_t n) { return (power(7, n) + 1) / 2; }},
    {"hexagonal-gosper", "Fr", [](std::uint32_t n) { return (power(7, n) - 1) / 2; }},
    {"hilbert-curve", "F", [](std::uint32_t n) { return power(4, n) - 1; }},
    {"peano-curve", "F", [](std::uint32_t n) { return power(9, n) - 1; }},
    {"square-curve-3", "F", [](std::uint32_t n) { return power(9, n) - 1; }},
    {"square-curve-4", "F", [](std::uint32_t n) { return power(16, n) - 1; }},
    {"hilbert-cube", "F", [](std::uint32_t n) { return power(8, n) - 1; }},
    {"plant-a", "F", times(5)},
    {"plant-b", "F", times(5)},
    {"plant-c", "F", times(8)},
    {"plant-d", "X", times(3)},
    {"plant-d", "F", [](std::uint32_t n) { return 2 * (power(3, n) - power(2, n)); }},
    {"plant-e", "X", times(3)},
    {"plant-e", "F", [](std::uint32_t n) { return 2 * (power(3, n) - power(2, n)); }},
    {"plant-f", "X", times(4)},
    {"plant-f", "F", [](std::uint32_t n) { return 3 * (power(4, n) - power(2, n)) / 2; }},
    {"bush", "A", times(3)},
    // J came of the F of the step before, these of the J before and of the apices: Fₙ = Fₙ₋₁ + Fₙ₋₂ + 3ⁿ.
    {"bush", "F",
     [](std::uint32_t n) {
       std::uint64_t before = 0, now = 0;
       for (std::uint32_t i = 1; i <= n; ++i) std::swap(before += now + power(3, i), now);
       return now;
     }},
    {"flowering-plant", "plant", times(3)},
    {"algae", "a", [](std::uint32_t n) { return fibonacci(n); }},
    {"algae", "b", [](std::uint32_t n) { return n == 0 ? 1 : fibonacci(n - 1); }},
    {"signal", "b", [](std::uint32_t) { return 1u; }},
    {"signal", "a", [](std::uint32_t) { return 8u; }},
    {"signal-acropetal", "Fb", [](std::uint32_t n) { return n < 3 ? 1 + 2 * n : 7u; }},
    {"signal-basipetal", "Fb", [](std::uint32_t n) { return n + 1; }},
    {"koch-parametric", "F", times(4)},
    {"binary-tree", "F", [](std::uint32_t n) { return power(2, n) - 1; }},
    {"monopodial-tree", "F", [](std::uint32_t n) { return power(2, n) - 1; }},
    {"sympodial-tree", "F", [](std::uint32_t n) { return power(2, n) - 1; }},
    {"ternary-tree", "A", times(3)},
    {"ternary-tree", "F", [](std::uint32_t n) { return 1 + 2 * (power(3, n) - 1); }},
    {"crocus", "L", [](std::uint32_t n) { return std::min(n, 6u); }},
    {"crocus", "K", [](std::uint32_t n) { return n >= 8 ? 1u : 0u; }},
    {"shepherds-purse", "L", [](std::uint32_t n) { return std::min(n, 14u); }},
    {"shepherds-purse", "X", [](std::uint32_t n) { return n > 14 ? n - 14 : 0u; }},
    // A(7) flowers and leaves A(0) and A(4), which are 7 after 7 and 3 steps and flower in the next.
    {"rose-campion", "K", [](std::uint32_t n) { return events(n, {8, 4}); }},
    {"raceme", "K", [](std::uint32_t n) { return n > 6 ? n - 6 : 0u; }},
    {"raceme-closed", "K", [](std::uint32_t n) { return std::min(n, 13u); }},
    {"spike", "K", [](std::uint32_t n) { return n; }},
    {"umbel", "K", [](std::uint32_t n) { return std::min(n, 20u); }},
    {"capitulum", "K", [](std::uint32_t n) { return n; }},
    {"cyme", "K", [](std::uint32_t n) { return n; }},
    {"cyme-double", "K", [](std::uint32_t n) { return power(2, n) - 1; }},
    {"phyllotaxis-disc", "D", [](std::uint32_t n) { return n; }},
    {"sunflower", "C", [](std::uint32_t n) { return n; }},
    {"phyllotaxis-cylinder", "D", [](std::uint32_t n) { return n; }},
    {"cordate-leaf", "C", [](std::uint32_t n) { return 2 * n; }},
    // The C of each step has made one G in every step since.
    {"cordate-leaf", "G", [](std::uint32_t n) { return n * (n - 1); }},
    {"rose-leaf", "A", [](std::uint32_t) { return 2u; }},
    {"simple-leaf", "B", [](std::uint32_t n) { return 2 * n; }},
    // With a delay of 1 the pairs of leaflets follow Jacobsthal’s numbers, 0 1 1 3 5 11 …
    {"compound-leaf", "F",
     [](std::uint32_t n) {
       std::uint64_t sum = 0, now = 1, before = 0;
       for (std::uint32_t i = 0; i < n; ++i) {
         sum += 2 * now;
         std::swap(before = 2 * before + now, now);
       }
       return sum;
     }},
};

}  // namespace

TEST_CASE("published grammars: counts of symbols match the theory, step by step") {
  for (const Count& count : counts) {
    INFO(count.text, " ", count.symbol);
    const std::string text = published(count.text);
    const BoundPointer bound = compiled_published(text);
    const std::uint32_t steps = lsystem::derivation_length(*bound).value();
    lsystem::Derivation derivation(*bound, 1, Limits{});
    for (std::uint32_t step = 0; step <= steps && derivation.string().modules < 20'000; ++step) {
      INFO("after ", step, " steps");
      CHECK(count_of(*bound, derivation.string(), count.symbol) == count.after(step));
      if (!derivation.step()) break;
    }
    CHECK(english(derivation.error().message) == "");
    CHECK(derivation.steps() > 1);
  }
}

TEST_CASE("published grammars: none has remarks, and all are short") {
  std::size_t bytes = 0;
  for (const std::string& name : published_names()) {
    INFO(name);
    const std::string text = published(name);
    if (text.find("#input") != std::string::npos) continue;  // needs inputs that only its model provides
    const BoundPointer bound = compiled_published(text);
    for (const lsystem::Remark& remark : lsystem::remarks(lsystem::program_of(*bound))) FAIL(lsystem::to_text(remark));
    CHECK(text.size() < 2048);
    bytes += text.size();
    const lsystem::DerivationOptions options{.start = upright};
    const Derived grown = sound(lsystem::develop(*bound, 1, {}, Limits{}, options));
    Recorder recorder;
    sound(lsystem::interpret(*bound, *grown.string, upright, recorder, 1, Limits{}));
    CHECK(recorder.lines.size() + recorder.spheres.size() > 2);
    CHECK(recorder.lines.size() < 20'000);
  }
  CHECK(published_names().size() >= 70);
  CHECK(bytes < 50'000);
}

TEST_CASE("published grammars: inflorescences have the tips that their recurrences give") {
  const auto flowers = [](const char* name, std::uint32_t steps) {
    const BoundPointer bound = compiled_published(published(name));
    return count_of(*bound, *derived(*bound, steps).string, "K");
  };
  CHECK(flowers("panicle", 14) == tips(9, 1, 3));
  CHECK(flowers("lilac", 16) == tips(9, 2, 4));
  // Ten nodes have two cymes each, of 0.12 n + 0.3, halved (0.65) in pairs down to 0.5; and the axis ends in a flower.
  std::uint64_t thyrsus = 1;
  for (int n = 1; n <= 10; ++n) {
    std::uint64_t cyme = 1;
    for (double s = 0.12 * n + 0.3; s > 0.5; s *= 0.65) cyme = 2 * cyme + 1;
    thyrsus += 2 * cyme;
  }
  CHECK(flowers("thyrsus", 14) == thyrsus);
}

TEST_CASE("published grammars: short strings, by hand") {
  const auto after_steps = [](const char* name, std::uint32_t steps) {
    const BoundPointer bound = compiled_published(published(name));
    return text_of(*bound, derived(*bound, steps));
  };
  // The book's page 4: b, a, ab, aba, abaab, abaababa.
  CHECK(after_steps("algae", 5) == "a b a a b a b a");
  // Page 5: ar, al br, bl ar ar, al al br al br, …
  CHECK(after_steps("anabaena", 3) == "al al br al br");
  CHECK(after_steps("anabaena", 4) == "bl ar bl ar ar bl ar ar");
  CHECK(after_steps("signal", 3) == "a a a b a a a a a");
  CHECK(after_steps("signal-basipetal", 2) == "Fa[+Fa]Fb[-Fa]Fb[+Fa]Fb");
  CHECK(after_steps("parametric-example", 1) == "B(1)B(4)A(1,0)");
  CHECK(after_steps("parametric-example", 2) == "B(0)B(3)A(2,1)");
  CHECK(after_steps("parametric-example", 3) == "C B(2)A(4,3)");
  CHECK(after_steps("parametric-example", 4) == "C B(1)A(8,7)");
  CHECK(after_steps("square-root-growth", 4) == "X Fa Fa Fd Fa X");
}

TEST_CASE("published grammars: a filament grows as the square root of time") {
  const BoundPointer bound = compiled_published(published("square-root-growth"));
  lsystem::Derivation derivation(*bound, 1, Limits{});
  for (std::uint32_t step = 0; step <= 100; ++step) {
    std::uint32_t root = 0;
    while ((root + 1) * (root + 1) <= step) ++root;
    CHECK(lsystem::length(derivation.string()) == 4 + root);
    derivation.step();
  }
}

TEST_CASE("published grammars: random choices have the published frequencies") {
  const BoundPointer bound = compiled_published(published("stochastic-plant"));
  std::map<std::string, int> first;
  for (std::uint64_t seed = 0; seed < 900; ++seed) ++first[text_of(*bound, derived(*bound, 1, seed))];
  CHECK(first.size() == 3);
  // 300 each, and more than four standard deviations about it.
  for (const auto& [string, times] : first) CHECK(std::abs(times - 300) < 60);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::uint64_t lines = count_of(*bound, *derived(*bound, 5, seed).string, "F");
    CHECK(lines >= power(3, 5));
    CHECK(lines <= power(5, 5));
  }
  // Borchert and Slade: 1 + p is (k + 1)²/k² from k = 3 on, so that after n steps the tips are 4 ((n + 1)/3)² on the
  // average.
  const BoundPointer tree = compiled_published(published("borchert-slade"));
  double tips_of_all = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Derived grown = derived(*tree, 11, seed);
    const std::uint64_t apices = count_of(*tree, *grown.string, "A");
    CHECK(apices >= 4);
    tips_of_all += static_cast<double>(apices);
  }
  CHECK(tips_of_all / 60 == doctest::Approx(64).epsilon(0.15));
}

TEST_CASE("published grammars: in which order flowers open") {
  // The ages of all flowers in the order of the string, which is from the base upwards.
  const auto ages = [](const char* name, std::uint32_t steps) {
    const BoundPointer bound = compiled_published(published(name));
    return parameters_of(*bound, *derived(*bound, steps).string, "K");
  };
  const auto falling = [](const std::vector<float>& of) { return std::is_sorted(of.rbegin(), of.rend()); };
  for (const char* acropetal : {"raceme", "raceme-closed", "spike", "cyme", "flowering-signal"}) {
    INFO(acropetal);
    const std::vector<float> of = ages(acropetal, 16 + 24 * (acropetal[0] == 'f'));
    CHECK(of.size() > 5);
    CHECK(falling(of));
    CHECK(of.front() > of.back());
  }
  // Mycelis: the topmost first, and then from the tip downwards.
  const std::vector<float> lettuce = ages("wall-lettuce", 64);
  CHECK(lettuce.size() > 20);
  CHECK(lettuce.back() == *std::max_element(lettuce.begin(), lettuce.end()));
  CHECK_FALSE(falling(lettuce));
}

TEST_CASE("figure 1.28: sixteen plants, no two alike") {
  const BoundPointer bound = compiled_published(published("flower-field"));
  std::set<std::string> plants;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Derived field = derived(*bound, 5, seed);
    CHECK(count_of(*bound, *field.string, "plant") == 16 * power(3, 4));
    // Between two moves along a row stands a plant.
    const std::string text = text_of(*bound, field);
    std::size_t found = 0;
    for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
      to = text.find("f(24)", from);
      found += plants.insert(text.substr(from, to - from)).second;
    }
    CHECK(found >= 16);
  }
}

TEST_CASE("L-system 1.1: heterocysts stand at a distance from each other") {
  const BoundPointer bound = compiled_published(published("anabaena-heterocysts"));
  const Derived filament = derived(*bound, 200);
  std::vector<std::size_t> between = {0};
  modules_of(*filament.string, [&](std::uint32_t symbol, std::span<const float> parameters) {
    if (name_of(*bound, symbol) != "F") return;
    if (parameters[1] == 0)
      between.push_back(0);
    else
      ++between.back();
  });
  // The ends are heterocysts.
  REQUIRE(between.size() > 5);
  CHECK(between.front() == 0);
  CHECK(between.back() == 0);
  for (std::size_t i = 1; i + 1 < between.size(); ++i) CHECK(between[i] >= 8);
}

TEST_CASE("synthetic topiary: branches that leave the box die, and buds below wake") {
  struct Box {
    const char* text;
    float side, low, high;
  };
  for (const auto& [name, side, low, high] : {Box{"pruned-branch", 5.5F, 0, 12}, Box{"pruned-tree", 6, 0, 12}}) {
    INFO(name);
    const BoundPointer bound = compiled_published(published(name));
    const lsystem::DerivationOptions options{.start = upright};
    const Derived grown = sound(lsystem::develop(*bound, 3, {}, Limits{}, options));
    Recorder recorder;
    sound(lsystem::interpret(*bound, *grown.string, upright, recorder, 3, Limits{}));
    CHECK(recorder.lines.size() > 30);
    std::size_t outside = 0;
    for (const Recorder::Line& line : recorder.lines) {
      const glm::vec3 at = line.before.position;
      outside += std::max(std::abs(at.x), std::abs(at.z)) >= side || at.y < low - 1e-4F || at.y >= high;
    }
    // A line may go out, and is taken away in the next step; none goes on from there.
    CHECK(outside == 0);
    CHECK(count_of(*bound, *grown.string, "[") > 3);
  }
}

TEST_CASE("published grammars: strings are those of another engine") {
  std::istringstream lines(file_text(panicle::tests::repository_folder() + "/tests/golden/oracle.tsv"));
  std::string name;
  BoundPointer bound;
  std::unique_ptr<lsystem::Derivation> derivation;
  std::size_t texts = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string now;
    std::uint32_t step = 0, hash = 0;
    std::uint64_t modules = 0;
    double sum = 0;
    fields >> now >> step >> modules >> hash >> sum;
    if (now != name) {
      name = now;
      derivation.reset();
      bound =
          compiled_published(file_text(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar/" + name));
      derivation = std::make_unique<lsystem::Derivation>(*bound, 1, Limits{});
      ++texts;
    } else {
      derivation->step();
    }
    INFO(name, ", step ", step);
    CHECK(derivation->steps() == step);
    CHECK(lsystem::length(derivation->string()) == modules);
    CHECK(symbols_hash(*bound, derivation->string()) == hash);
    CHECK(parameters_sum(derivation->string()) == doctest::Approx(sum).epsilon(1e-4));
  }
  CHECK(texts > 40);
}
