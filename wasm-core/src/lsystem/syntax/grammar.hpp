// The tree of a grammar's text. Every view is part of that text.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "expression/expression_tree.hpp"
#include "lsystem/lsystem.hpp"

namespace panicle::lsystem {

// The purpose of a production: the steps, decomposition within a step, or drawing.
enum class Purpose : std::uint8_t { derivation, decomposition, homomorphism };
inline constexpr std::size_t purposes = 3;

// Global settings of a text: `angle increment: 25`, `tropism: 0, -1, 0, 0.2`.
enum class GlobalSetting : std::uint8_t {
  angle_increment,
  line_length,
  line_width,
  line_width_increment,
  tropism_x,
  tropism_y,
  tropism_z,
  elasticity
};
inline constexpr std::size_t settings_count = 8;

// `name(arguments)` in the axiom or a successor.
struct ModuleTree {
  std::string_view name;
  SourceLocation place;
  std::uint32_t system = 0;  // the L-system that it belongs to: a place among Grammar::systems
  std::vector<Expression> arguments;
};

// `name(formals)` beside a predecessor. Its formals stand among the production's.
struct NeighbourTree {
  std::string_view name;
  SourceLocation place;
  std::uint32_t arity = 0;
};

// `name = expression;` in a block.
struct AssignmentTree {
  std::string_view name;
  Expression expression;
};

// `left < predecessor(formals) > right : {before} condition {after} --> successor : weight`
struct ProductionTree {
  Purpose purpose = Purpose::derivation;
  std::uint32_t system = 0;
  std::string_view predecessor;
  SourceLocation place;
  std::uint32_t arity = 0;
  std::vector<Named> formals;  // the predecessor's, then the left neighbours', then the right ones'
  std::vector<NeighbourTree> left;
  std::vector<NeighbourTree> right;  // brackets as well
  std::vector<AssignmentTree> before;
  Expression condition;  // where given
  std::vector<AssignmentTree> after;
  std::vector<ModuleTree> successor;
  Expression weight;  // where given
};

// `#define name expression`, `#define name[] expression, …`, `#input name` or `#input name[]`
struct DefinitionTree {
  Definition::Kind kind = Definition::Kind::define;
  std::string_view name;
  SourceLocation place;
  std::vector<Expression> values;  // none: to be given
};

// `#curve name (x, y) (x, y) …`
struct CurveTree {
  std::string_view name;
  SourceLocation place;
  std::vector<float> points;  // x and y of each, x ascending
};

// `#role name symbol symbol …`
struct RoleTree {
  std::string_view name;
  std::vector<Named> symbols;
};

// `ignore: symbols` or `consider: symbols`: the symbols that contexts match.
struct ContextFilterTree {
  enum class Kind : std::uint8_t { all, ignore, consider };
  Kind kind = Kind::all;
  std::vector<Named> symbols;
};

struct Grammar {
  Notation notation = Notation::huang;
  bool doubles = false;  // `#numbers double`
  std::vector<DefinitionTree> definitions;
  std::vector<CurveTree> curves;
  std::array<Expression, settings_count> settings;  // by GlobalSetting
  std::array<Expression, 2> depths;                 // of decomposition and homomorphism, where given
  std::vector<std::string_view> systems = {{}};     // names; the first is the text itself
  Expression steps;                                 // `derivation length: expression`, where given
  std::vector<RoleTree> roles;
  ContextFilterTree sight;
  std::vector<ModuleTree> axiom;
  std::vector<ProductionTree> productions;
};

}  // namespace panicle::lsystem
