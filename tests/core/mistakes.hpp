// Mistakes that people make in a text, of whatever language: each is told at its place, in a sentence that says what to
// write.
#pragma once

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <string_view>

#include "foundation/result.hpp"

namespace panicle::tests {

struct Mistake {
  // « stands before the place that is told.
  std::string text;
  // What the sentence has in it; several between |.
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

// `trouble(text)`: what is wrong with it, as a Diagnostic.
template <class Mistakes, class Trouble>
void check_mistakes(const Mistakes& mistakes, Trouble trouble) {
  for (const Mistake& mistake : mistakes) {
    std::string text = mistake.text;
    CAPTURE(text);
    const Diagnostic place = place_in(text);
    const Diagnostic error = trouble(text);
    CAPTURE(error.message);
    CHECK(error.reason != Reason::none);
    CHECK(error.line == place.line);
    CHECK(error.column == place.column);
    std::istringstream all(mistake.advice);
    for (std::string part; std::getline(all, part, '|');) CHECK(error.message.find(part) != std::string::npos);
  }
}

}  // namespace panicle::tests
