// A symbol's kind follows from its role, not from its name.
#include "models/bunch/roles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "foundation/english.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

// The kind that a text gives `symbol`; adds its notes to `notes`.
Kind kind_in(const std::string& text, std::string_view symbol, std::vector<std::string>& notes) {
  const auto program = lsystem::compile(text, {});
  REQUIRE_MESSAGE(program, (program ? "" : program.error().message));
  const auto symbols = lsystem::symbols(*program.value());
  const auto found = std::find(symbols.begin(), symbols.end(), symbol);
  REQUIRE(found != symbols.end());
  return roles_of(*program.value(), notes).of(static_cast<std::uint32_t>(found - symbols.begin()));
}

GrownBunch grown(BunchRequest request, const std::string& grammar) {
  request.grammar = grammar;
  auto result = grow(request);
  REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
  return std::move(result.value());
}

// Of text `number`, with `from` as a whole word called `to`.
std::string renamed(int number, std::string_view from, std::string_view to) {
  const auto of_word = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  };
  std::string text(builtin_grammar(number));
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; ++at) {
    if (of_word(text[at + from.size()]) || (at > 0 && of_word(text[at - 1]))) continue;
    text.replace(at, from.size(), to);
    ++found;
  }
  REQUIRE(found > 2);
  return text;
}

// The text as it was before there were roles to declare.
std::string undeclared(int number) {
  std::string text(builtin_grammar(number));
  for (std::size_t at = 0; (at = text.find("#role", at)) != std::string::npos;)
    text.erase(at, text.find('\n', at) + 1 - at);
  return text;
}

// A request whose text finds room for everything and has no random values.
BunchRequest settled() {
  BunchRequest request = as_printed(table3[1].profile());
  set_radius(request, 2, 2);
  return request;
}

BunchRequest in_flower() {
  BunchRequest request = natural_request(table3[1].profile());
  set(request, Parameter::age, 5);
  return request;
}

std::array<std::ptrdiff_t, 4> kinds_of(const GrownBunch& bunch) {
  std::array<std::ptrdiff_t, 4> counts = {};
  for (const Internode& one : bunch.internodes) ++counts[static_cast<std::size_t>(one.kind)];
  return counts;
}

}  // namespace

TEST_CASE("a text that declares nothing has the table's roles") {
  std::vector<std::string> notes;
  const std::string text = "axiom: Ar Ar17 Ae Ae2 Ap Af\n";
  CHECK(kind_in(text, "Ar", notes) == Kind::rachis);
  CHECK(kind_in(text, "Ar17", notes) == Kind::rachis);
  CHECK(kind_in(text, "Ae", notes) == Kind::end);
  CHECK(kind_in(text, "Ae2", notes) == Kind::axis);
  CHECK(kind_in(text, "Ap", notes) == Kind::pedicel);
  CHECK(kind_in(text, "Af", notes) == Kind::axis);
  CHECK(SymbolRoles().of(lsystem::no_symbol) == Kind::axis);
  CHECK(notes.empty());
}

TEST_CASE("a text that declares roles has only those; an unknown role gets one note") {
  std::vector<std::string> notes;
  const std::string text = "#role rachis Q\n#role pedicel P\n#role tendril T U\naxiom: Q P T U Ar1\n";
  CHECK(kind_in(text, "Q", notes) == Kind::rachis);
  notes.clear();
  CHECK(kind_in(text, "P", notes) == Kind::pedicel);
  notes.clear();
  CHECK(kind_in(text, "Ar1", notes) == Kind::axis);
  notes.clear();
  CHECK(kind_in(text, "T", notes) == Kind::axis);
  REQUIRE(notes.size() == 1);
  CHECK(english(notes[0]).find("no role tendril") != std::string::npos);
  const GrownBunch bunch = grown(settled(), std::string(builtin_grammar(3)) + "#role leaf Az\nAz --> F(1)\n");
  CHECK(std::any_of(bunch.notes.begin(), bunch.notes.end(),
                    [](const std::string& note) { return english(note).find("no role leaf") != std::string::npos; }));
}

TEST_CASE("links older than roles grow the same bunch") {
  CHECK(grown(settled(), undeclared(3)).fingerprint == grown(settled(), "").fingerprint);
  for (const int number : {1, 2, 3})
    CHECK(grown(settled(), undeclared(number)).fingerprint ==
          grown(settled(), std::string(builtin_grammar(number))).fingerprint);
  CHECK(grown(in_flower(), undeclared(4)).fingerprint == grown(in_flower(), "").fingerprint);
}

TEST_CASE("a renamed symbol draws the same skeleton with other random values, for addresses are of names") {
  for (const char* name : {"Ap", "Ae", "Ar1", "Af"}) {
    CAPTURE(name);
    CHECK(grown(settled(), renamed(3, name, "Zz")).fingerprint == grown(settled(), "").fingerprint);
  }
  BunchRequest natural = in_flower();
  set(natural, Parameter::vary, 0);
  for (const char* name : {"Ap", "Ae", "Ar", "Af"}) {
    CAPTURE(name);
    CHECK(kinds_of(grown(natural, renamed(4, name, "Zz"))) == kinds_of(grown(natural, "")));
  }
  // With another role it draws another kind.
  const std::string mistaken = edited(3, "#role end Ae", "#role axis Ae");
  CHECK(kinds_of(grown(settled(), mistaken))[static_cast<std::size_t>(Kind::end)] == 0);
}
