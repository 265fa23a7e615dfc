// The tree of a grammar's text. Every view is part of that text.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "lsystem/lsystem.hpp"
#include "lsystem/operations.hpp"
#include "lsystem/tokens.hpp"

namespace panicle::lsystem {

// An expression in postfix order. `&&` and `||` have a node between their operands, from which the second may be
// passed over.
struct Node {
  enum class Kind : std::uint8_t { number, name, element, operation, and_begin, and_end, or_begin, or_end };
  Kind kind = Kind::number;
  Op op = Op::add;
  std::uint32_t arguments = 0;
  float number = 0;
  std::string_view name;  // of a value, an array or a function
  Place place;
};

struct Expression {
  std::vector<Node> nodes;
  Place place;

  bool given() const { return !nodes.empty(); }
};

// `name(arguments)` in the axiom or a successor.
struct ModuleTree {
  std::string_view name;
  Place place;
  std::vector<Expression> arguments;
};

// A name and where it stands: a parameter of a predecessor, a symbol that has a role.
struct Named {
  std::string_view name;
  Place place;
};

// `name(formals)` beside a predecessor. Its formals stand among the production's.
struct NeighbourTree {
  std::string_view name;
  Place place;
  std::uint32_t arity = 0;
};

// `left < predecessor(formals) > right : condition --> successor : weight`
struct ProductionTree {
  std::string_view predecessor;
  Place place;
  std::uint32_t arity = 0;
  std::vector<Named> formals;  // the predecessor's, then the left neighbours', then the right ones'
  std::vector<NeighbourTree> left;
  std::vector<NeighbourTree> right;  // brackets as well
  Expression condition;              // where given
  std::vector<ModuleTree> successor;
  Expression weight;  // where given
};

// `#define name expression`, `#input name` or `#input name[]`
struct DefinitionTree {
  Definition::Kind kind = Definition::Kind::define;
  std::string_view name;
  Place place;
  Expression expression;
};

// `#role name symbol symbol …`
struct RoleTree {
  std::string_view name;
  std::vector<Named> symbols;
};

// `ignore: symbols` or `consider: symbols`: what contexts see.
struct SightTree {
  enum class Kind : std::uint8_t { all, ignore, consider };
  Kind kind = Kind::all;
  std::vector<Named> symbols;
};

struct Grammar {
  std::vector<DefinitionTree> definitions;
  Expression steps;  // `derivation length: expression`, where given
  std::vector<RoleTree> roles;
  SightTree sight;
  std::vector<ModuleTree> axiom;
  std::vector<ProductionTree> productions;
};

}  // namespace panicle::lsystem
