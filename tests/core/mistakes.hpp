// Common mistakes in a text of any language: each error has the right place and advice.
#pragma once

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <string_view>

#include "foundation/english.hpp"
#include "foundation/result.hpp"

namespace panicle::tests {

struct Mistake {
  // « marks the expected place of the error.
  std::string text;
  // Parts that the message must contain, separated by |.
  std::string advice;
};

// Where « stands, and the text without it.
inline Diagnostic place_in(std::string& text) {
  constexpr std::string_view mark = "«";
  const std::size_t at = text.find(mark);
  REQUIRE(at != std::string::npos);
  Diagnostic place{Reason::none, "", 1, 1};
  for (std::size_t i = 0; i < at; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) ++place.column;
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    }
  }
  text.erase(at, mark.size());
  return place;
}

// Checks the errors of all mistakes. `trouble(text)` returns the error of a text as a Diagnostic.
template <class Mistakes, class Trouble>
void check_mistakes(const Mistakes& mistakes, Trouble trouble) {
  for (const Mistake& mistake : mistakes) {
    std::string text = mistake.text;
    CAPTURE(text);
    const Diagnostic place = place_in(text);
    const Diagnostic error = trouble(text);
    const std::string sentence = english(error.message);
    CAPTURE(sentence);
    CHECK(error.reason != Reason::none);
    CHECK(error.line == place.line);
    CHECK(error.column == place.column);
    std::istringstream all(mistake.advice);
    for (std::string part; std::getline(all, part, '|');) CHECK(sentence.find(part) != std::string::npos);
  }
}

}  // namespace panicle::tests
