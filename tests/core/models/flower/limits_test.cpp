// Texts that ask for more than anyone may have: they end, and what is kept of them stays in proportion.
#include "flowers.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

// `v0=value;v1=value;…`, or a line of #define for each.
std::string settings(std::size_t count, const std::string& value) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += "v" + std::to_string(i) + "=" + value + ";";
  return all;
}

std::string defines(std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += "#define v" + std::to_string(i) + "=1\n";
  return all;
}

}  // namespace

// Six gigabytes, where each setting keeps every mention of the same variable in the blocks before it.
TEST_CASE("what calls depend on is kept once, however often the text says it") {
  std::string sum = "b";
  for (int i = 0; i < 12; ++i) sum = "(" + sum + "+" + sum + ")";
  std::string text = "#define A(4)\n#define b=1\n#define c=1\n#axiom: A\nA{a=" + sum + "}{}{} -> A";
  for (int i = 0; i < 50; ++i) text += "\n[&M{" + settings(300, "a") + "}]_{E}";
  text += "\n#module M\n" + defines(300) + "#define A(4)\n#axiom: A\nA{}{v7<step}{} -> A[A]_{E}";
  REQUIRE(text.size() < Limits{}.text_bytes);
  const Program program = program_of(text);
  CHECK(program.productions[0].growths.size() == 50);
  const auto rebuilds = [&](std::string_view name) {
    return std::any_of(program.variables.begin(), program.variables.end(),
                       [&](const Variable& variable) { return variable.name == name && variable.rebuilds; });
  };
  CHECK(rebuilds("b"));
  CHECK_FALSE(rebuilds("c"));
  CHECK_FALSE(rebuilds("v8"));
}
