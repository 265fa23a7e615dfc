#include "foundation/message.hpp"

#include <doctest/doctest.h>

#include <string>

#include "expression/messages.generated.hpp"
#include "foundation/english.hpp"

namespace panicle {
namespace {

TEST_CASE("a message is a code and its arguments") {
  const std::string made = message(messages::expression::at_line, 3, "no axiom");
  CHECK(made ==
        "\x02"
        "expression.at_line\x1f"
        "3\x1fno axiom\x03");
}

TEST_CASE("control characters of an argument become spaces, so that they end neither the argument nor the line") {
  const std::string made = message(messages::expression::at_line, 1,
                                   "a\x1f"
                                   "b\nc\x02"
                                   "d");
  CHECK(made ==
        "\x02"
        "expression.at_line\x1f"
        "1\x1f"
        "a b c d\x03");
}

TEST_CASE("a message inside a message becomes a sentence inside its sentence") {
  const Message inner = message(messages::expression::at_line, 7, "unknown name");
  CHECK(english(message(messages::expression::at_line, 2, inner).encoded()) == "Line 2: Line 7: unknown name");
}

TEST_CASE("text without messages stays as it is") { CHECK(english("plain {text} # here") == "plain {text} # here"); }

TEST_CASE("a message that is cut off or has an unknown code ends in its code") {
  CHECK(english("\x02growth.no_such_code\x1f"
                "1") == "growth.no_such_code");
}

}  // namespace
}  // namespace panicle
