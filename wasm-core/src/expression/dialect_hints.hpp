// Hints for syntax of cpfg, its preprocessor and papers that this notation lacks: its meaning there, and its
// replacement here.
#pragma once

#include <string_view>

namespace panicle::expression {

// Each returns a sentence of advice; empty for unknown words.
std::string_view foreign_statement(std::string_view first_word);  // of a line
std::string_view foreign_label(std::string_view first_word);      // of a line that has a colon behind its words
std::string_view foreign_directive(std::string_view word);        // behind a #
std::string_view foreign_sign(std::string_view character);        // anywhere
std::string_view foreign_module(std::string_view token);          // in a string of modules
std::string_view foreign_function(std::string_view name);         // of an expression
std::string_view foreign_operator(std::string_view token);        // between the values of an expression

}  // namespace panicle::expression
