#include "models/growth/rules.hpp"

#include <algorithm>
#include <utility>

#include "models/growth/reader.hpp"
#include "models/growth/standard.hpp"

namespace panicle::growth {
namespace {

// Reads standard lines, which have no mistakes. Returns the words that they use.
std::uint32_t add_standard(std::string_view text, Rules& rules, expression::Lowering& lowering) {
  const auto tokens = expression::tokenize(text, expression::Writing::rules);
  GrowthReader reader(tokens.value(), rules, lowering);
  reader.run();
  return reader.used();
}

// Whether the grammar defines a divisor function, or with `argument` a factor, for branches or leaves.
bool gives(const Rules& rules, DivisorFunction::Of of, bool argument) {
  for (const TreeRule& rule : rules.tree)
    for (const DivisorFunction& function : rule.functions)
      if (function.of == of && function.argument == argument) return true;
  return false;
}

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

// Adds notes on definitions that no rule uses.
void note_unused(Rules& rules, std::uint32_t used) {
  const auto note = [&](bool given, bool read, std::string_view what, std::string_view name) {
    if (!given || read) return;
    rules.notes.push_back(
        expression::sentence("The text gives %, and no rule of it reads %: it changes nothing.", {what, name}));
  };
  const bool leaves = gives(rules, DivisorFunction::Of::leaves, false);
  note(gives(rules, DivisorFunction::Of::branches, false),
       rules.uses_branch_function || (rules.uses_leaf_function && !leaves), "a divisor function for branches", "D");
  note(leaves, rules.uses_leaf_function, "a divisor function for leaves", "E");
  note(gives(rules, DivisorFunction::Of::branches, true), (used & bit(Word::b)) != 0, "exp for branches", "B");
  note(gives(rules, DivisorFunction::Of::leaves, true), (used & bit(Word::l)) != 0, "exp for leaves", "L");
}

}  // namespace

Result<Rules> read_rules(std::string_view text, const Limits& limits) {
  using expression::error_at;
  if (text.size() > limits.text_bytes)
    return error_at(Reason::limit, {}, "The text is longer than % bytes, which is the limit; make it shorter.",
                    {std::to_string(limits.text_bytes)});
  const auto tokens = expression::tokenize(text, expression::Writing::rules);
  if (!tokens) return tokens.error();
  if (tokens->empty())
    return error_at(Reason::syntax, {1, 1}, "The text is empty; begin with tree -> DivFunc(\"sigma1\"){branches}.");

  Rules rules;
  expression::Lowering lowering(rules.code);
  lowering.define_array("D");
  lowering.define_array("E");
  GrowthReader reader(tokens.value(), rules, lowering);
  if (!reader.run()) return reader.trouble();

  const OwnRules& own_rules = reader.own_rules();
  std::vector<Rule> own_shoot_rules = std::exchange(rules.of_shoots, {});
  std::uint32_t used = reader.used();
  if (!own_rules.counts) used |= add_standard(standard_counts, rules, lowering);
  if (!own_rules.buds) used |= add_standard(standard_buds, rules, lowering);
  if (!own_rules.leaves && !rules.tree.empty()) used |= add_standard(standard_leaves, rules, lowering);
  rules.of_shoots.insert(rules.of_shoots.end(), std::make_move_iterator(own_shoot_rules.begin()),
                         std::make_move_iterator(own_shoot_rules.end()));

  if (!gives(rules, DivisorFunction::Of::branches, false) && (rules.uses_branch_function || rules.uses_leaf_function))
    return error_at(Reason::undefined,
                    reader.needs_function().line > 0 ? reader.needs_function() : expression::SourceLocation{1, 1},
                    "Nothing says which divisor function D is; write tree -> DivFunc(\"sigma1\"){branches}.");
  if (const DivisorFunction* const again = given_twice(rules))
    return error_at(Reason::syntax, again->place,
                    "% has been given a DivFunc of this kind already; take one out, or give both lines a probability.",
                    {again->of == DivisorFunction::Of::leaves ? "{leaves}" : "{branches}"});
  if (rules.footprint.empty())
    rules.notes.push_back("The text has no footprint: its growth volume is GrowVol(1, 1, 4, 10, 2.5, 0).");
  note_unused(rules, used);
  return rules;
}

}  // namespace panicle::growth
