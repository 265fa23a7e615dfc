#include <algorithm>
#include <cmath>
#include <map>

#include "lsystem/derivation/derivation.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

// Every V's parameter, by the label before it.
std::map<std::string, std::string> labelled(const std::string& text) {
  std::map<std::string, std::string> values;
  for (std::size_t at = text.find("V("); at != std::string::npos; at = text.find("V(", at + 1)) {
    const std::size_t comma = text.find(',', at), end = text.find(')', at);
    values[text.substr(at + 2, comma - at - 2)] = text.substr(comma + 1, end - comma - 1);
  }
  return values;
}

std::vector<float> draws(const std::string& expression, int count, std::uint64_t seed = 1) {
  const std::string text = after("#input m\naxiom: A(m)\nA(i) : i>0 --> V(i," + expression + ") A(i-1)", 4096,
                                 {{{"m", static_cast<float>(count)}}, {}}, seed);
  std::vector<float> values;
  for (const auto& [label, value] : labelled(text)) values.push_back(std::stof(value));
  return values;
}

}  // namespace

TEST_CASE("RND draws every whole number between its ends equally often") {
  std::map<float, int> counts;
  for (const float value : draws("RND(-1,3)", 3000)) ++counts[value];
  REQUIRE(counts.size() == 5);
  CHECK(counts.begin()->first == -1);
  for (const auto& [value, count] : counts) CHECK(std::abs(count - 600) < 100);
  for (const float value : draws("RND(2.5,4.5)", 50)) CHECK((value == 3 || value == 4));
  for (const float value : draws("RND(7,7)", 10)) CHECK(value == 7);
}

TEST_CASE("ran and nran have the right moments") {
  double sum = 0, squares = 0;
  for (const float value : draws("ran(10)", 3000)) {
    CHECK(value >= 0);
    CHECK(value < 10);
    sum += value;
  }
  CHECK(sum / 3000 == doctest::Approx(5).epsilon(0.03));
  sum = 0;
  for (const float value : draws("nran(4,2)", 3000)) {
    sum += value;
    squares += (value - 4) * (value - 4);
  }
  CHECK(sum / 3000 == doctest::Approx(4).epsilon(0.03));
  CHECK(std::sqrt(squares / 3000) == doctest::Approx(2).epsilon(0.05));
}

TEST_CASE("random values depend on the seed alone") {
  const auto first = draws("ran(1)", 20, 5);
  CHECK(draws("ran(1)", 20, 6) != first);
  CHECK(draws("ran(1)", 20, 5) == first);  // independent of draws in between
  CHECK(draws("ran(1)", 20, 1ull << 40) != draws("ran(1)", 20, 0));
}

TEST_CASE("random values are frozen: golden values") {
  CHECK(after("axiom: A(3)\nA(i) : i>0 --> V(ran(1), RND(1,100)) [ A(i-1) ] B\nB --> C : 1\nB --> D(nran(0,1)) : 2",
              4096, {}, 2013) ==
        "V(0.014753938,25)[V(0.9407617,29)[V(0.039176762,27)[A(0)]D(1.4304494)]D(0.17008622)]D(-1.1727351)");
}

TEST_CASE("two calls in one production draw different values") {
  const auto first = draws("ran(1)", 200), both = draws("ran(1)*0 + ran(1)", 200);
  CHECK(first != both);
  CHECK(first == draws("ran(1) + 0*ran(1)", 200));
  CHECK(first == draws("RND(0,5)*0 + ran(1)", 200));
}

TEST_CASE("adding a branch changes no other module's value") {
  const std::string short_text =
      "axiom: R(1)\n"
      "R(i) : i<6 --> [ + L(i*10) ] R(i+1)\n"
      "L(k) : nearest(k)%10<3 --> V(k, ran(1)) L(k+1)";
  const std::string with_branch =
      "axiom: G G R(1)\n"
      "R(i) : i<6 --> [ - M(i*100, ran(1)) ] [ + L(i*10) ] F(RND(1,9)) R(i+1) [ M(i*1000, 1) ]\n"
      "L(k) : nearest(k)%10<3 --> V(k, ran(1)) L(k+1)\n"
      "M(k,x) --> V(k, ran(2)) [ + V(k+1, RND(0,100)) ] G\n"
      "G --> [ F ]";
  const auto before = labelled(after(short_text, 4096)), now = labelled(after(with_branch, 4096));
  CHECK(before.size() == 15);
  CHECK(now.size() == 35);
  for (const auto& entry : before) {
    CAPTURE(entry.first);
    CHECK(now.at(entry.first) == entry.second);
  }
}

TEST_CASE("one more step of the rachis changes no value of those before") {
  const char* text = "#input m\naxiom: R(1)\nR(i) : i<=m --> [ L(i) ] R(i+1)\nL(k) --> V(k, RND(1,1000000))";
  const auto five = labelled(after(text, 4096, {{{"m", 5}}, {}})), six = labelled(after(text, 4096, {{{"m", 6}}, {}}));
  CHECK(five.size() == 5);
  CHECK(six.size() == 6);
  for (const auto& [label, value] : five) CHECK(six.at(label) == value);
}

TEST_CASE("without requested steps a random condition is drawn once") {
  const char* text = "axiom: A(0)\nA(k) : k<9 --> B(k) A(k+1)\nB(k) : ran(1)<0.5 --> C(k)\nC(k) --> C2(k)";
  const BoundPointer bound = compiled(text);
  const Derived end = sound(lsystem::unfold(*bound, 1, Limits{}));
  CHECK(end.steps < 15);  // modules that failed their draw are not drawn again
  CHECK(text_of(*bound, end).find("B(") != std::string::npos);
  CHECK(text_of(*bound, end).find("C2(") != std::string::npos);
}

TEST_CASE("with steps a random condition is drawn in each: delays are geometrically distributed") {
  constexpr double modules = 4000, chance = 0.3;
  const BoundPointer bound = compiled("axiom: A(4000)\nA(i) : i>0 --> W A(i-1)\nW --> D\nD : ran(1)<0.3 --> E");
  const BoundPointer weighted = compiled("axiom: A(4000)\nA(i) : i>0 --> W A(i-1)\nW --> D\nD --> E : ran(1)<0.3");
  for (const BoundPointer& grammar : {bound, weighted}) {
    // All D wait at once: as many W are written in as many steps, each tried once in the steps that follow.
    const auto with = [&](std::uint32_t steps, char symbol) {
      const std::string text = text_of(*grammar, derived(*grammar, steps));
      return static_cast<double>(std::count(text.begin(), text.end(), symbol));
    };
    // In the long run each D waits 1 / 0.3 steps, so that this many stand in the string while new ones come.
    const double waiting = (1 - chance) / chance;
    CHECK(std::abs(with(2000, 'D') - 1 - waiting) < 4 * std::sqrt(waiting / chance) + 1);
    double left = with(4002, 'D');
    CHECK(left < 20);
    CHECK(with(4060, 'D') == 0);
    CHECK(with(4060, 'E') == modules);
  }
}

TEST_CASE("a random condition is drawn in each step with its probability") {
  std::string text = "derivation length: 0\naxiom: ";
  constexpr double modules = 3000, chance = 0.3;
  for (int i = 0; i < 3000; ++i) text += "A ";
  const BoundPointer bound = compiled(text + "\nA : ran(1)<0.3 --> B");
  double waiting = modules;
  for (std::uint32_t step = 1; step <= 8; ++step) {
    const std::string now = text_of(*bound, derived(*bound, step));
    const double left = static_cast<double>(std::count(now.begin(), now.end(), 'A'));
    CAPTURE(step);
    CHECK(std::abs(left - waiting * (1 - chance)) < 4 * std::sqrt(waiting * chance * (1 - chance)));
    CHECK(std::count(now.begin(), now.end(), 'B') == modules - left);
    waiting = left;
  }
}

TEST_CASE("a derivation waits only for modules that a random condition may still rewrite") {
  const auto steps_at_rest = [](std::string_view text) {
    const BoundPointer bound = compiled(text);
    lsystem::Derivation derivation(*bound, 1, Limits{});
    while (derivation.steps() < 100 && !derivation.at_rest()) derivation.step();
    return derivation.steps();
  };
  CHECK(steps_at_rest("axiom: A\nA(x) : ran(1)<0.3 --> B\nA : 0 --> C") == 1);
  CHECK(steps_at_rest("axiom: A(1)\nA(x) : ran(1)<0 --> B\nA : 0 --> C") == 100);
}

TEST_CASE("a successor after a delay equals one without a delay") {
  const char* axiom = "axiom: R(40)\nR(i) : i>0 --> A(i) R(i-1)\n";
  const std::string late =
      std::string(axiom) + "A(k) : ran(1)<0.3 --> V(k,ran(1)) [B(k)]\nB(k) --> V(k+100,RND(1,1000))";
  const std::string soon = std::string(axiom) + "A(k) : ran(1)<2 --> V(k,ran(1)) [B(k)]\nB(k) --> V(k+100,RND(1,1000))";
  const auto delayed = labelled(after(late, 300)), at_once = labelled(after(soon, 300));
  CHECK(at_once.size() == 80);
  CHECK(delayed == at_once);
  CHECK(after(late, 300) == after(soon, 300));
  CHECK(after(late, 42) != after(soon, 42));
}

TEST_CASE("a choice by weights alone is the same with steps and without") {
  const BoundPointer bound = compiled("axiom: R(50)\nR(i) : i>0 --> A R(i-1)\nA --> B : 1\nA --> C(ran(1)) : 2");
  CHECK(text_of(*bound, derived(*bound, 60)) == text_of(*bound, sound(lsystem::unfold(*bound, 1, Limits{}))));
}

TEST_CASE("stochastic productions are chosen as often as their weights say") {
  const char* text =
      "axiom: A(4000)\nA(i) : i>0 --> B A(i-1)\n"
      "B --> X : 1\nB --> Y : 2\nB --> Z : 5";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::string string = after(text, 4096, {}, seed);
    const auto times = [&](char c) { return static_cast<double>(std::count(string.begin(), string.end(), c)); };
    CHECK(times('X') == doctest::Approx(500).epsilon(0.12));
    CHECK(times('Y') == doctest::Approx(1000).epsilon(0.1));
    CHECK(times('Z') == doctest::Approx(2500).epsilon(0.05));
    CHECK(times('X') + times('Y') + times('Z') == 4000);
  }
  CHECK(after(text, 4096, {}, 1) != after(text, 4096, {}, 2));
}

TEST_CASE("only weighted productions that match compete, and one without a weight waits its turn") {
  CHECK(after("axiom: A(1)\nA(x) : x>1 --> B : 9\nA(x) --> C : 1", 1) == "C");
  CHECK(after("axiom: A(1)\nA(x) --> B : 0\nA(x) --> C : x\nA(x) --> D", 1) == "C");
  CHECK(after("axiom: A(1)\nA(x) --> D\nA(x) --> C : 1", 1) == "D");
  CHECK(after("axiom: A(1)\nA(x) --> B : 0\nA(x) --> D\nA(x) --> C : 0", 1) == "D");
  CHECK(after("axiom: A(1)\nA(x) --> B : 0", 1) == "A(1)");
}
