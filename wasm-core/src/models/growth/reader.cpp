#include "models/growth/reader.hpp"

#include <algorithm>
#include <utility>

#include "expression/operations.hpp"
#include "foundation/random.hpp"
#include "models/growth/messages.generated.hpp"

namespace panicle::growth {
namespace {

using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

// Sets of words, a `bit` each: those of a volume, of the environment, of a shoot, and of factors.
constexpr std::uint32_t of_volume =
    bit(Word::count) | bit(Word::id) | bit(Word::base) | bit(Word::height) | bit(Word::top) | bit(Word::gradient);
constexpr std::uint32_t of_environment = bit(Word::phototropism) | bit(Word::gravitropism) | bit(Word::neighbours);
// A rule that uses one of these is evaluated for each shoot at each step.
constexpr std::uint32_t of_shoot = bit(Word::k) | bit(Word::n) | bit(Word::gs) | bit(Word::ndv) | bit(Word::nbr) |
                                   bit(Word::nlf) | bit(Word::order) | bit(Word::length);
constexpr std::uint32_t of_factors = bit(Word::b) | bit(Word::l);
constexpr std::uint32_t any_word = of_volume | of_environment | of_shoot | of_factors;

constexpr std::string_view branch_function = "D", leaf_function = "E";

// The number of a word; `words` if there is none of that name.
std::uint32_t word_named(std::string_view name) {
  for (std::uint32_t i = 0; i + 1 < words; ++i)
    if (word_names[i] == name) return i;
  return words;
}

// The names of a set of words, separated by commas.
std::string list_of(std::uint32_t may_use) {
  std::string list;
  for (std::uint32_t i = 0; i < words; ++i)
    if ((may_use >> i & 1) != 0) list.append(list.empty() ? "" : ", ").append(word_names[i]);
  return list;
}

// A statement continues in the next line after a sign that something has to follow.
constexpr expression::StatementSyntax syntax{"({", [](const Token& last, const Token& next) {
                                               return last.kind == TokenKind::arrow || last.is(',') || last.is(':') ||
                                                      last.is('&') || last.is('|') || next.kind == TokenKind::arrow ||
                                                      next.is(':') || next.is('{') || next.is("GrowVol") ||
                                                      next.is("DivFunc");
                                             }};

}  // namespace

// Prepares reading: the names of the divisor functions and of all words become known to expressions.
GrowthReader::GrowthReader(std::span<const Token> tokens, Rules& rules, expression::Lowering& lowering)
    : StatementReader(tokens, syntax, lowering), rules_(rules) {
  curves_.add(branch_function);
  curves_.add(leaf_function);
  for (const std::string_view name : word_names) formals_.push_back({name, {}});
}

// Reads all statements. As all readers here, returns false with the error in `trouble_`.
bool GrowthReader::run() {
  return read_statements([this] { return statement(); });
}

// Reads a statement: a declaration by its first word, a setting where it has no arrow, else a conditional rule.
bool GrowthReader::statement() {
  static constexpr expression::NamedReader<bool (GrowthReader::*)()> statements[] = {
      {"footprint", &GrowthReader::footprint}, {"tree", &GrowthReader::tree}, {"bud", &GrowthReader::buds}};
  arrow_ = find_outside("", at_, end_, [](const Token& token) { return token.kind == TokenKind::arrow; });
  successors_end_ = colon_after_arrow();
  const Token& first = tokens_[at_];
  in_footprint_ = first.is("footprint");
  if (arrow_ == end_) return setting();
  if (const auto* const known = find_named(statements)) return (this->*known->read)();
  const bool alone = at_ + 1 == arrow_ || next_is(at_, ':');
  if (first.kind == TokenKind::name && alone && word_named(first.text) == words)
    return fail(Reason::undefined, first.place, message(messages::growth::line_start, first.text));
  return conditional();
}

// The index of the last colon behind the statement's arrow, outside brackets; `end_` if there is none.
std::size_t GrowthReader::colon_after_arrow() const {
  const auto is_colon = [](const Token& token) { return token.is(':'); };
  std::size_t colon = end_;
  for (std::size_t at = arrow_; (at = find_outside("({", at + 1, end_, is_colon)) < end_;) colon = at;
  return colon;
}

// The index of the first colon before the statement's arrow; `arrow_` if there is none.
std::size_t GrowthReader::colon_before_arrow() const {
  return find_outside("", at_, arrow_, [](const Token& token) { return token.is(':'); });
}

// Reads `name = expression`: the number of steps, or a value for all volumes.
bool GrowthReader::setting() {
  const Token& first = tokens_[at_];
  if (first.is("gs") || first.is("gs.rand")) return steps();
  if (first.kind != TokenKind::name || !next_is(at_, '='))
    return wrong(first.place, message(messages::growth::line_start, first.text));
  Rule rule;
  rule.place = first.place;
  return consequences(end_, rule) && place_rule(std::move(rule));
}

// Reads the number of steps: `gs = 8`, or `gs.rand(6, 10)`, between which it is drawn.
bool GrowthReader::steps() {
  const Token& first = tokens_[at_];
  if (rules_.steps_from.value.given) return wrong(first.place, message(messages::growth::steps_twice));
  ++at_;
  if (first.is("gs")) return expect('=') && number(end_, 0, rules_.steps_from);
  std::vector<Number> values;
  if (!opens(at_)) return wrong(here(), message(messages::growth::steps_syntax));
  if (!numbers(0, values)) return false;
  if (values.size() != 2) return wrong(first.place, message(messages::growth::steps_syntax));
  rules_.steps_from = values[0];
  rules_.steps_to = values[1];
  return true;
}

// Reads `bud(n) : condition -> branch : probability`: each internode of age k has n buds, from which branches grow.
bool GrowthReader::buds() {
  Rule rule;
  rule.place = here();
  Consequence buds{Consequence::Kind::buds, Word::one, {}, {}};
  ++at_;
  if (!opens(at_)) return wrong(here(), message(messages::growth::bud_count));
  std::vector<Number> values;
  if (!numbers(bit(Word::k), values)) return false;
  if (values.size() != 1 || values[0].draws) return wrong(rule.place, message(messages::growth::bud_argument));
  buds.number = values[0];
  if (on_sign(':') && !(++at_, condition(arrow_, rule))) return false;
  if (at_ != arrow_) return wrong(here(), message(messages::growth::bud_condition));
  ++at_;
  if (!on("branch") && !on("branches")) return wrong(here(), message(messages::growth::bud_branch, found_text()));
  ++at_;
  rule.consequences.push_back(buds);
  own_rules_.buds = true;
  return weight(rule.probability) && place_rule(std::move(rule));
}

// Reads `condition -> consequences : probability`.
bool GrowthReader::conditional() {
  Rule rule;
  rule.place = here();
  const std::size_t colon = colon_before_arrow();
  if (colon < arrow_) return wrong(tokens_[colon].place, message(messages::growth::colon_before_arrow));
  if (!condition(arrow_, rule)) return false;
  ++at_;
  return consequences(successors_end_, rule) && weight(rule.probability) && place_rule(std::move(rule));
}

// Reads the condition of a rule up to the token `end`.
bool GrowthReader::condition(std::size_t end, Rule& rule) {
  if (at_ == end) return wrong(here(), message(messages::growth::condition_missing));
  if (!number(end, any_word, rule.condition)) return false;
  return at_ == end || wrong(here(), message(messages::growth::arrow_expected, found_text()));
}

// Reads the consequences of a rule up to the token `end`, separated by commas.
bool GrowthReader::consequences(std::size_t end, Rule& rule) {
  do {
    if (on_sign(',') && !rule.consequences.empty()) ++at_;
    if (at_ >= end) return wrong(here(), message(messages::growth::effect_missing));
    if (!consequence(end, rule)) return false;
  } while (at_ < end);
  return true;
}

// Reads one consequence of a rule, an assignment or a call before `end`, and adds it to the rule.
bool GrowthReader::consequence(std::size_t end, Rule& rule) {
  const Token& name = tokens_[at_];
  Consequence consequence;
  bool fine = true;
  if (name.kind == TokenKind::name && at_ + 1 < end && tokens_[at_ + 1].is('=')) {
    fine = assigned(name, consequence);
    at_ += 2;
    fine = fine && number(end, any_word, consequence.number);
  } else {
    fine = called(name, end, consequence);
  }
  if (fine) rule.consequences.push_back(consequence);
  return fine;
}

// Finds the word that an assignment sets, without reading on: it is one of the environment, or ndv, nbr, nlf or length.
bool GrowthReader::assigned(const Token& name, Consequence& consequence) {
  constexpr std::uint32_t settable =
      of_environment | bit(Word::ndv) | bit(Word::nbr) | bit(Word::nlf) | bit(Word::length);
  const std::uint32_t word = word_named(name.text);
  if (word == words || (settable >> word & 1) == 0)
    return fail(Reason::undefined, name.place, message(messages::growth::not_settable, name.text, list_of(settable)));
  consequence.word = static_cast<Word>(word);
  own_rules_.counts |= consequence.word == Word::ndv || consequence.word == Word::nbr;
  own_rules_.leaves |= consequence.word == Word::nlf;
  return true;
}

// Reads a consequence that is called: leaf(n), fallingLeaf(n), foliage(n) or foliage(n, steps), childTrunk.
bool GrowthReader::called(const Token& name, std::size_t end, Consequence& consequence) {
  struct Call {
    std::string_view name;
    Consequence::Kind kind;
  };
  static constexpr Call calls[] = {{"leaf", Consequence::Kind::leaf},
                                   {"leaves", Consequence::Kind::leaf},
                                   {"fallingLeaf", Consequence::Kind::falling_leaf},
                                   {"fallingLeaves", Consequence::Kind::falling_leaf},
                                   {"foliage", Consequence::Kind::foliage},
                                   {"childTrunk", Consequence::Kind::child_trunk}};
  const auto* const call = std::find_if(std::begin(calls), std::end(calls), [&](const Call& each) {
    return name.kind == TokenKind::name && each.name == name.text;
  });
  if (call == std::end(calls))
    return fail(name.kind == TokenKind::name ? Reason::undefined : Reason::syntax, name.place,
                message(messages::growth::effect_unknown, name.text));
  consequence.kind = call->kind;
  ++at_;
  if (call->kind == Consequence::Kind::child_trunk) return true;
  own_rules_.leaves = true;
  std::vector<Number> values;
  if (at_ >= end || !opens(at_)) return wrong(here(), message(messages::growth::count_missing, name.text));
  if (!numbers(any_word, values)) return false;
  const bool lasting = call->kind == Consequence::Kind::foliage && values.size() == 2;
  if (values.size() != 1 && !lasting) return wrong(name.place, message(messages::growth::one_number, name.text));
  consequence.number = values[0];
  if (lasting) consequence.steps = values[1];
  return true;
}

// Reads `: probability` at the end of a rule, if it is there.
bool GrowthReader::weight(Number& probability) {
  if (at_ >= end_) return true;
  if (!on_sign(':')) return wrong(here(), message(messages::growth::probability_colon, found_text()));
  ++at_;
  if (at_ >= end_) return wrong(here(), message(messages::growth::probability_missing));
  return number(end_, any_word, probability);
}

// Adds a rule to the list by which it is evaluated: once a volume if it sets the environment and uses no word of a
// shoot, else for each shoot at every step. An error if a shoot cannot set its word.
bool GrowthReader::place_rule(Rule rule) {
  std::uint32_t uses = rule.condition.uses | rule.probability.uses;
  bool draws = rule.condition.draws;
  bool environment = true, is_random = rule.probability.value.given;
  for (const Consequence& each : rule.consequences) {
    uses |= each.number.uses;
    uses |= each.steps.uses;
    draws |= each.number.draws || each.steps.draws;
    environment &= each.kind == Consequence::Kind::set && (of_environment & bit(each.word)) != 0;
    // Random values of a bud or a child trunk are independent of the shoots' common outcome.
    is_random &= each.kind == Consequence::Kind::set || each.kind == Consequence::Kind::leaf ||
                 each.kind == Consequence::Kind::falling_leaf || each.kind == Consequence::Kind::foliage ||
                 rule.consequences.size() > 1;
  }
  rule.stream = hash_combine(hash_text("growth rule"), rules_.of_shoots.size() + rules_.of_volumes.size());
  if (environment && (uses & of_shoot) == 0) {
    rules_.of_volumes.push_back(std::move(rule));
    return true;
  }
  for (const Consequence& each : rule.consequences)
    if (each.kind == Consequence::Kind::set && (each.word == Word::phototropism || each.word == Word::neighbours))
      return wrong(rule.place,
                   message(messages::growth::effect_of_volumes, word_names[static_cast<std::size_t>(each.word)]));
  rules_.repeatable &= !draws && !is_random && !rule.probability.draws && (uses & bit(Word::order)) == 0;
  rules_.of_shoots.push_back(std::move(rule));
  return true;
}

// Reads a list of numbers in parentheses. `may_use`: bits of the words that these may contain.
bool GrowthReader::numbers(std::uint32_t may_use, std::vector<Number>& values) {
  const SourceLocation opened = here();
  ++at_;
  if (on_sign(')')) return ++at_, true;
  for (;;) {
    if (!number(end_, may_use, values.emplace_back())) return false;
    if (at_ >= end_) return never_closed(opened);
    if (tokens_[at_].is(')')) return ++at_, true;
    if (!expect_comma()) return false;
    if (values.size() == 32) return fail(Reason::limit, opened, message(messages::growth::too_many_numbers));
  }
}

// Reads and compiles an expression up to `end`. `may_use`: bits of the words that it may contain.
bool GrowthReader::number(std::size_t end, std::uint32_t may_use, Number& number) {
  expression::Expression tree;
  if (!expression_before(end, tree)) {
    if (trouble_.reason != Reason::undefined) return false;
    return fail(Reason::undefined, {trouble_.line, trouble_.column},
                message(messages::growth::function_name_unknown, expression::known_functions("D, E")));
  }
  if (!rewritten(tree, may_use, number)) return false;
  // Each expression has random values of its own.
  lowering_.begin_production(
      formals_, hash_combine(hash_text(in_footprint_ ? "footprint" : "growth"), ++expressions_[in_footprint_]));
  return compile(tree, number.value);
}

// Checks the words of an expression and records their use. D(x) and E(x) become elements of lists that begin at 0; the
// values of the divisor functions are set before growth.
bool GrowthReader::rewritten(expression::Expression& tree, std::uint32_t may_use, Number& number) {
  using expression::Node;
  std::vector<Node> nodes;
  for (const Node& node : tree.nodes) {
    if (node.kind == Node::Kind::element) return wrong(node.place, message(messages::growth::no_lists));
    if (node.kind == Node::Kind::name) {
      const std::uint32_t word = word_named(node.name);
      if (word == words || (may_use >> word & 1) == 0) return unknown_word(node, may_use);
      number.uses |= 1u << word;
    }
    if (node.kind == Node::Kind::operation && node.op == expression::Op::curve) {
      const bool leaves = node.curve == 1;
      if (may_use == 0 || may_use == bit(Word::k))
        return wrong(node.place, message(messages::growth::function_too_early));
      (leaves ? rules_.uses_leaf_function : rules_.uses_branch_function) = true;
      if (needs_function_.line == 0) needs_function_ = node.place;
      nodes.push_back({Node::Kind::name, {}, 0, 0, word_names[words - 1], node.place});
      nodes.push_back({Node::Kind::operation, expression::Op::add, 2, 0, {}, node.place});
      nodes.push_back(
          {Node::Kind::element, expression::Op::element, 1, 0, leaves ? leaf_function : branch_function, node.place});
      continue;
    }
    if (node.kind == Node::Kind::operation && expression::is_space_query(node.op))
      return wrong(node.place, message(messages::growth::no_queries, node.name));
    number.draws |= node.kind == Node::Kind::operation && expression::is_random(node.op);
    nodes.push_back(node);
  }
  used_ |= number.uses;
  tree.nodes = std::move(nodes);
  return true;
}

// Fails with the message for a word that an expression cannot use; lists those that it `may_use`.
bool GrowthReader::unknown_word(const expression::Node& node, std::uint32_t may_use) {
  if (may_use == 0) return fail(Reason::undefined, node.place, message(messages::growth::word_too_early, node.name));
  return fail(Reason::undefined, node.place, message(messages::growth::word_unknown, node.name, list_of(may_use)));
}

}  // namespace panicle::growth
