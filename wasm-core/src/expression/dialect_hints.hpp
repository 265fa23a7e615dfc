// Hints for syntax of cpfg, its preprocessor and papers that this notation lacks: its meaning there, and its
// replacement here.
#pragma once

#include <string_view>

#include "foundation/message.hpp"

namespace panicle::expression {

// A message of advice; null without one.
using Hint = const MessageCode<0>*;

// Each returns the advice for a word; null for unknown words.
Hint foreign_statement(std::string_view first_word);  // of a line
Hint foreign_label(std::string_view first_word);      // of a line that has a colon behind its words
Hint foreign_directive(std::string_view word);        // behind a #
Hint foreign_sign(std::string_view character);        // anywhere
Hint foreign_module(std::string_view token);          // in a string of modules
Hint foreign_function(std::string_view name);         // of an expression
Hint foreign_operator(std::string_view token);        // between the values of an expression

}  // namespace panicle::expression
