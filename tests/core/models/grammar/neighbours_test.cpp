// Responses to ?E in grammars.
#include "models/grammar/neighbours.hpp"

#include "models/grammar/growing.hpp"

namespace panicle::grammar {
namespace {

std::string grown_string(const std::string& of) {
  const Plant plant = grow({.text = of, .outputs = "string"});
  const std::vector<char> text = column_in<char>(plant.columns, "string");
  return std::string(text.begin(), text.end());
}

TEST_CASE("?E counts the ends of lines near it, except its own") {
  CHECK(grown_string(
            "derivation length: 1\naxiom: ?E(1.5,9) F F ?E(1.5,9) F F F ?E(1.5,9) A\n?E(r,n) : n>99 --> B\nA --> A") ==
        "?E(1.5,1)F F?E(1.5,2)F F F?E(1.5,1)A");
}

TEST_CASE("a response may be rewritten in the next step, with or without a derivation length") {
  // A tip goes on while fewer than three ends are near it.
  const std::string tip =
      "axiom: A ?E(2.5,0)\nA > ?E(r,n) : n<2 --> F A\nA > ?E(r,n) : n>=2 --> C\n?E(r,n) : n>=2 --> D";
  CHECK(grown_string(tip) == "F F F C D");
  CHECK(grown_string("derivation length: 2\n" + tip) == "F F A?E(2.5,0)");
  CHECK(grown_string("axiom: ?E(1,5,5)\n?E(r,n,l) : l>0.99 --> F A\nA --> B") == "F B");
}

TEST_CASE("?E responds with less light below many lines than above them") {
  const std::string answered = grown_string(
      "derivation length: 1\naxiom: ?E(1,0,0) f(4) [ +(90) F F F ] [ -(90) F F F ] [ &(90) F F F ] f(4) ?E(1,0,0) A\nA "
      "--> B");
  const auto light = [&](std::size_t from) {
    return std::stof(answered.substr(answered.find(',', answered.find(',', answered.find("?E", from)) + 1) + 1));
  };
  const float below = light(0), above = light(2);
  CHECK(below < above);
  CHECK(below > 0);
  CHECK(above <= 1);
}

}  // namespace
}  // namespace panicle::grammar
