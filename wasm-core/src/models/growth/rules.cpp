#include "models/growth/rules.hpp"

#include <algorithm>
#include <utility>

#include "models/growth/messages.generated.hpp"
#include "models/growth/reader.hpp"
#include "models/growth/standard.hpp"

namespace panicle::growth {
namespace {

constexpr std::string_view tree_example = "tree -> DivFunc(\"sigma1\"){branches}";

// Reads standard lines, which have no mistakes. Returns the words that they use, a `bit` each.
std::uint32_t add_standard(std::string_view text, Rules& rules, expression::Lowering& lowering) {
  const auto tokens = expression::tokenize(text, expression::Writing::rules);
  GrowthReader reader(tokens.value(), rules, lowering);
  reader.run();
  return reader.used();
}

// Whether a `tree` line defines a function of this kind (`DivisorFunction::argument`) for branches or leaves.
bool defines(const Rules& rules, DivisorFunction::Of of, bool argument) {
  for (const TreeRule& rule : rules.tree)
    for (const DivisorFunction& function : rule.functions)
      if (function.of == of && function.argument == argument) return true;
  return false;
}

// Whether the grammar defines the divisor function D (branches) or E (leaves).
bool defines_divisor(const Rules& rules, DivisorFunction::Of of) { return defines(rules, of, false); }

// Whether the grammar defines the factor B (branches) or L (leaves), by `exp`.
bool defines_factor(const Rules& rules, DivisorFunction::Of of) { return defines(rules, of, true); }

// A function that is defined twice, other than as alternatives with probabilities; null where none is.
const DivisorFunction* given_twice(const Rules& rules) {
  for (std::size_t i = 0; i < rules.tree.size(); ++i) {
    for (const DivisorFunction& function : rules.tree[i].functions) {
      for (std::size_t j = 0; j <= i; ++j) {
        if (j != i && rules.tree[i].weight.value.given && rules.tree[j].weight.value.given) continue;
        for (const DivisorFunction& earlier : rules.tree[j].functions) {
          if (&earlier == &function) break;
          if (earlier.of == function.of && earlier.argument == function.argument) return &function;
        }
      }
    }
  }
  return nullptr;
}

// Adds notes on definitions that no rule uses. `used`: the words in all rules, a `bit` each.
void note_unused(Rules& rules, std::uint32_t used) {
  using enum DivisorFunction::Of;
  const auto note = [&](bool is_defined, bool is_used, const MessageCode<0>& unused) {
    if (is_defined && !is_used) rules.notes.push_back(message(unused));
  };
  // Without a divisor function for leaves, that for branches serves both.
  const bool has_leaf_divisor = defines_divisor(rules, leaves);
  note(defines_divisor(rules, branches), rules.uses_branch_function || (rules.uses_leaf_function && !has_leaf_divisor),
       messages::growth::unused_branch_function);
  note(has_leaf_divisor, rules.uses_leaf_function, messages::growth::unused_leaf_function);
  note(defines_factor(rules, branches), (used & bit(Word::b)) != 0, messages::growth::unused_branch_factor);
  note(defines_factor(rules, leaves), (used & bit(Word::l)) != 0, messages::growth::unused_leaf_factor);
}

}  // namespace

// Reads a growth grammar, adds the standard rules for all that it does not define, and checks that its functions are
// defined once.
Result<Rules> read_rules(std::string_view text, const Limits& limits) {
  using expression::error_at;
  if (Diagnostic error = expression::check_length(text, limits); error.reason != Reason::none) return error;
  const auto tokens = expression::tokenize(text, expression::Writing::rules);
  if (!tokens) return tokens.error();
  if (tokens->empty()) return error_at(Reason::syntax, {1, 1}, message(messages::growth::text_empty, tree_example));

  Rules rules;
  expression::Lowering lowering(rules.code);
  lowering.define_array("D");
  lowering.define_array("E");
  GrowthReader reader(tokens.value(), rules, lowering);
  if (!reader.run()) return reader.trouble();

  // Standard rules come before the text's own, which may change their results.
  const OwnRules& own_rules = reader.own_rules();
  std::vector<Rule> own_shoot_rules = std::exchange(rules.of_shoots, {});
  std::uint32_t used = reader.used();
  if (!own_rules.counts) used |= add_standard(standard_counts, rules, lowering);
  if (!own_rules.buds) used |= add_standard(standard_buds, rules, lowering);
  if (!own_rules.leaves && !rules.tree.empty()) used |= add_standard(standard_leaves, rules, lowering);
  rules.of_shoots.insert(rules.of_shoots.end(), std::make_move_iterator(own_shoot_rules.begin()),
                         std::make_move_iterator(own_shoot_rules.end()));

  // Checks that the functions that rules use are defined, and none twice.
  if (!defines_divisor(rules, DivisorFunction::Of::branches) &&
      (rules.uses_branch_function || rules.uses_leaf_function))
    return error_at(Reason::undefined,
                    reader.needs_function().line > 0 ? reader.needs_function() : expression::SourceLocation{1, 1},
                    message(messages::growth::no_branch_function, tree_example));
  if (const DivisorFunction* const duplicate = given_twice(rules))
    return error_at(Reason::syntax, duplicate->place,
                    message(messages::growth::function_twice,
                            duplicate->of == DivisorFunction::Of::leaves ? "{leaves}" : "{branches}"));
  if (rules.footprint.empty()) rules.notes.push_back(message(messages::growth::no_footprint));
  note_unused(rules, used);
  return rules;
}

}  // namespace panicle::growth
