// Reads a growth grammar's text into rules, statement by statement.
#pragma once

#include <string_view>
#include <vector>

#include "expression/statement_reader.hpp"
#include "models/growth/rules.hpp"

namespace panicle::growth {

// Whether a grammar has rules of its own for a matter; else the standard lines apply (standard.hpp).
struct OwnRules {
  bool counts = false, buds = false, leaves = false;
};

class GrowthReader : expression::StatementReader {
 public:
  GrowthReader(std::span<const expression::Token> tokens, Rules& rules, expression::Lowering& lowering);

  // False: `trouble()`.
  bool run();
  using StatementReader::trouble;
  const OwnRules& own_rules() const { return own_rules_; }
  // The words that the rules use, a `bit` each.
  std::uint32_t used() const { return used_; }
  // The first place where a rule uses D or E, which a `tree` has to define.
  const expression::SourceLocation& needs_function() const { return needs_function_; }

 private:
  bool statement();
  bool setting();
  bool steps();
  bool footprint();
  bool growth_volume();
  bool next_argument();
  bool attribute(std::string_view name, VolumeRule& rule);
  bool range_of(std::vector<Number>& values, bool drawn, std::string_view name, VolumeRule& rule,
                const expression::SourceLocation& place);
  bool positional(std::vector<Number>& values, VolumeRule& rule);
  bool tree();
  bool divisor_function(TreeRule& rule);
  bool type_of(const expression::Token& token, DivisorFunction& function);
  bool parameters_fit(const expression::Token& type, DivisorFunction& function);
  bool buds();
  bool conditional();
  bool condition(std::size_t end, Rule& rule);
  bool consequences(std::size_t end, Rule& rule);
  bool consequence(std::size_t end, Rule& rule);
  bool assigned(const expression::Token& name, Consequence& consequence);
  bool called(const expression::Token& name, std::size_t end, Consequence& consequence);
  bool weight(Number& number);
  bool place_rule(Rule rule);

  bool number(std::size_t end, std::uint32_t may_use, Number& number);
  bool rewritten(expression::Expression& tree, std::uint32_t may_use, Number& number);
  bool unknown_word(const expression::Node& node, std::uint32_t may_use);
  // Reads the arguments of a call from its ( on.
  bool numbers(std::uint32_t may_use, std::vector<Number>& values);
  // The last colon outside of all brackets after the arrow, or the end.
  std::size_t colon_after_arrow() const;
  std::size_t colon_before_arrow() const;

  Rules& rules_;
  std::vector<expression::Named> formals_;
  std::size_t arrow_ = 0;  // token of the statement's arrow
  std::size_t successors_end_ = 0;
  // Numbers of expressions outside and inside footprints, counted apart: another footprint leaves the random values of
  // other expressions unchanged.
  std::array<std::uint64_t, 2> expressions_{};
  bool in_footprint_ = false;
  std::uint32_t used_ = 0;
  OwnRules own_rules_;
  expression::SourceLocation needs_function_;
};

}  // namespace panicle::growth
