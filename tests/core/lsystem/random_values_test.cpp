#include <algorithm>
#include <cmath>
#include <map>

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

TEST_CASE("ran and nran have the moments they should have") {
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

TEST_CASE("values depend on the seed, and on nothing else") {
  CHECK(draws("ran(1)", 20, 5) == draws("ran(1)", 20, 5));
  CHECK(draws("ran(1)", 20, 5) != draws("ran(1)", 20, 6));
  CHECK(draws("ran(1)", 20, 1ull << 40) != draws("ran(1)", 20, 0));
}

TEST_CASE("values are those that links were made with") {
  CHECK(after("axiom: A(3)\nA(i) : i>0 --> V(ran(1), RND(1,100)) [ A(i-1) ] B\nB --> C : 1\nB --> D(nran(0,1)) : 2",
              4096, {}, 2013) ==
        "V(0.014753938,25)[V(0.9407617,29)[V(0.039176762,27)[A(0)]D(1.4304494)]D(0.17008622)]D(-1.1727351)");
}

TEST_CASE("two calls in one production draw apart") {
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

TEST_CASE("a module keeps its value however many steps it waits") {
  const char* text = "axiom: A(0)\nA(k) : k<9 --> B(k) A(k+1)\nB(k) : ran(1)<0.5 --> C(k)\nC(k) --> C2(k)";
  const BoundPointer bound = compiled(text);
  const Derived end = derived(*bound, 4096);
  CHECK(end.steps < 15);  // what was not drawn at first is not drawn again
  CHECK(text_of(*bound, end).find("B(") != std::string::npos);
  CHECK(text_of(*bound, end).find("C2(") != std::string::npos);
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
