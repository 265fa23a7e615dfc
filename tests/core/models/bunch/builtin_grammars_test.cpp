#include "models/bunch/builtin_grammars.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>

using panicle::bunch::builtin_grammar;

TEST_CASE("the built-in grammars are the repository's files to the byte") {
  for (int number = 1; number <= 4; ++number) {
    std::ifstream file(std::string(PANICLE_GRAMMARS "/bunch/grape-bunch-") + std::to_string(number) + ".lsys",
                       std::ios::binary);
    REQUIRE(file);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    CHECK(!text.empty());
    CHECK(builtin_grammar(number) == text);
  }
  CHECK(builtin_grammar(0).empty());
  CHECK(builtin_grammar(5).empty());
}
