#include "expression/tokens.hpp"

#include <doctest/doctest.h>

#include "foundation/english.hpp"

using namespace panicle;
using namespace panicle::expression;

namespace {

// Each token as kind:text@line:column.
std::string listed(std::string_view text, Writing writing = Writing::modules) {
  const auto tokens = tokenize(text, writing);
  if (!tokens) return "error";
  std::string list;
  for (const Token& token : tokens.value()) {
    const char kind = "ndsaq"[static_cast<int>(token.kind)];
    list += std::string(list.empty() ? "" : " ") + kind + ":" + std::string(token.text) + "@" +
            std::to_string(token.place.line) + ":" + std::to_string(token.place.column);
  }
  return list;
}

Diagnostic failure(std::string_view text) {
  const auto tokens = tokenize(text);
  REQUIRE_FALSE(tokens);
  return tokens.error();
}

}  // namespace

TEST_CASE("tokenize recognises names, numbers, signs and arrows") {
  CHECK(listed("Ar1(l_i,2.5e-3) --> //F") ==
        "n:Ar1@1:1 s:(@1:4 n:l_i@1:5 s:,@1:8 d:2.5e-3@1:9 s:)@1:15 a:-->@1:17 s:/@1:21 s:/@1:22 n:F@1:23");
  CHECK(listed("1.5 .25 3. 2e 7e+2x") == "d:1.5@1:1 d:.25@1:5 d:3.@1:9 d:2@1:12 n:e@1:13 d:7e+2@1:15 n:x@1:19");
  CHECK(listed("a--b") == "n:a@1:1 s:-@1:2 s:-@1:3 n:b@1:4");
}

TEST_CASE("rules may be written with short arrows, names of parts, quotes and degrees") {
  CHECK(listed("Volumes.h<5->a →b-->c", Writing::rules) ==
        "n:Volumes.h@1:1 s:<@1:10 d:5@1:11 a:->@1:12 n:a@1:14 a:→@1:16 n:b@1:17 a:-->@1:18 n:c@1:21");
  CHECK(listed("f(\"σ 1\", 60°) . x.2", Writing::rules) ==
        "n:f@1:1 s:(@1:2 q:σ 1@1:3 s:,@1:8 d:60@1:10 s:)@1:13 s:.@1:15 n:x@1:17 d:.2@1:18");
  for (const char* text : {"\"a", "\"a\n\"", "\"\xff\"°", "°", "“a”"}) CHECK(listed(text, Writing::rules) == "error");
  CHECK(listed("A -> B.c") == "n:A@1:1 s:-@1:3 s:>@1:4 n:B@1:6 s:.@1:7 n:c@1:8");
  CHECK(listed("\"a\"") == "error");
}

TEST_CASE("comments and white space separate tokens and nothing else") {
  CHECK(listed("a/* * / F */b\n /* two\nlines */ c") == "n:a@1:1 n:b@1:13 n:c@3:10");
  CHECK(listed("\xef\xbb\xbf a\r\n\tb") == "n:a@1:2 n:b@2:2");
  CHECK(listed("") == "");
  CHECK(listed("/**/") == "");
}

TEST_CASE("columns count code points, and names may have letters of any script") {
  CHECK(listed("α δθ /* … */ x₁") == "n:α@1:1 n:δθ@1:3 n:x₁@1:14");
}

TEST_CASE("the first token of each line is marked") {
  const auto tokens = tokenize("a b\n\n  c /* \n */ d");
  REQUIRE(tokens);
  std::string firsts;
  for (const Token& token : tokens.value()) firsts += token.first_on_line ? '1' : '0';
  CHECK(firsts == "1011");
}

TEST_CASE("characters outside the notation are errors at their place") {
  CHECK(english(failure("A → B").message) == "“→” cannot be used in a grammar; write “-->” instead.");
  CHECK(failure("A → B").column == 3);
  CHECK(failure("δ\n ≤").line == 2);
  CHECK(failure("a ` b").column == 3);
  CHECK(failure("F(1e39)").column == 3);
  CHECK(failure("a \x01").column == 3);
  CHECK(failure("a /* b").column == 3);
  for (const char* broken : {"\xff", "\xc3", "a\xe2\x86", "\xc0\x80", "\xf5\x80\x80\x80"})
    CHECK(english(failure(broken).message) == "The grammar is not valid UTF-8; save it as UTF-8.");
}
