// The tree of an expression's text. Every view is part of that text.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "expression/operations.hpp"
#include "expression/tokens.hpp"

namespace panicle::expression {

// An expression in postfix order. `&&` and `||` have a node between their operands, from which the second may be
// skipped.
struct Node {
  enum class Kind : std::uint8_t { number, name, element, operation, and_begin, and_end, or_begin, or_end };
  Kind kind = Kind::number;
  Op op = Op::add;
  std::uint32_t arguments = 0;
  float number = 0;
  std::string_view name;  // of a value, an array or a function
  SourceLocation place;
  std::uint32_t curve = 0;  // that Op::curve reads
  double precise = 0;       // the number in double precision
};

struct Expression {
  std::vector<Node> nodes;
  SourceLocation place;

  bool given() const { return !nodes.empty(); }
};

// A name and its place in the text: a parameter of a predecessor, a symbol that has a role.
struct Named {
  std::string_view name;
  SourceLocation place;
};

}  // namespace panicle::expression
