#include "models/growth/reader.hpp"

#include <algorithm>
#include <utility>

#include "expression/operations.hpp"
#include "foundation/random.hpp"

namespace panicle::growth {
namespace {

using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

constexpr std::uint32_t of_volume =
    bit(Word::count) | bit(Word::id) | bit(Word::base) | bit(Word::height) | bit(Word::top) | bit(Word::gradient);
constexpr std::uint32_t of_environment = bit(Word::phototropism) | bit(Word::gravitropism) | bit(Word::neighbours);
// A rule that uses one of these is evaluated for each shoot at each step.
constexpr std::uint32_t of_shoot = bit(Word::k) | bit(Word::n) | bit(Word::gs) | bit(Word::ndv) | bit(Word::nbr) |
                                   bit(Word::nlf) | bit(Word::order) | bit(Word::length);
constexpr std::uint32_t of_factors = bit(Word::b) | bit(Word::l);
constexpr std::uint32_t any_word = of_volume | of_environment | of_shoot | of_factors;

constexpr std::string_view branch_function = "D", leaf_function = "E";

// Message about the beginnings of lines.
constexpr const char* beginnings =
    "A line begins with gs =, footprint ->, tree ->, bud(n) -> or a condition; '%' is none of these.";

std::uint32_t word_named(std::string_view name) {
  for (std::uint32_t i = 0; i + 1 < words; ++i)
    if (word_names[i] == name) return i;
  return words;
}

std::string list_of(std::uint32_t may_use) {
  std::string list;
  for (std::uint32_t i = 0; i < words; ++i)
    if ((may_use >> i & 1) != 0) list.append(list.empty() ? "" : ", ").append(word_names[i]);
  return list;
}

std::string known_functions() {
  std::string known = "D, E";
  for (const expression::Function& function : expression::functions)
    if (!expression::is_space_query(function.op)) known.append(", ").append(function.name);
  return known;
}

}  // namespace

GrowthReader::GrowthReader(std::span<const Token> tokens, Rules& rules, expression::Lowering& lowering)
    : TokenReader(tokens), rules_(rules), lowering_(lowering) {
  curves_.add(branch_function);
  curves_.add(leaf_function);
  for (const std::string_view name : word_names) formals_.push_back({name, {}});
}

bool GrowthReader::run() {
  while (at_ < tokens_.size()) {
    end_ = statement_end();
    if (!statement()) return false;
    if (at_ < end_) return wrong(here(), "'%' cannot stand here; take it out, or begin a new line.", {found()});
  }
  return true;
}

// A statement continues in the next line within brackets, and after a sign that something has to follow.
std::size_t GrowthReader::statement_end() const {
  std::size_t open = 0;
  for (std::size_t at = at_; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    if (at > at_ && token.first_on_line && open == 0) {
      const Token& before = tokens_[at - 1];
      const bool goes_on = before.kind == TokenKind::arrow || before.is(',') || before.is(':') || before.is('&') ||
                           before.is('|') || token.kind == TokenKind::arrow || token.is(':') || token.is('{') ||
                           token.is("GrowVol") || token.is("DivFunc");
      if (!goes_on) return at;
    }
    if (token.is('(') || token.is('{')) ++open;
    if ((token.is(')') || token.is('}')) && open > 0) --open;
  }
  return tokens_.size();
}

bool GrowthReader::statement() {
  arrow_ = at_;
  while (arrow_ < end_ && tokens_[arrow_].kind != TokenKind::arrow) ++arrow_;
  successors_end_ = colon_after_arrow();
  const Token& first = tokens_[at_];
  in_footprint_ = first.is("footprint");
  if (arrow_ == end_) return setting();
  if (in_footprint_) return footprint();
  if (first.is("tree")) return tree();
  if (first.is("bud")) return buds();
  const bool alone = at_ + 1 == arrow_ || next_is(at_, ':');
  if (first.kind == TokenKind::name && alone && word_named(first.text) == words)
    return fail(Reason::undefined, first.place, beginnings, {first.text});
  return conditional();
}

std::size_t GrowthReader::colon_after_arrow() const {
  std::size_t colon = end_;
  std::size_t open = 0;
  for (std::size_t at = arrow_ + 1; at < end_; ++at) {
    const Token& token = tokens_[at];
    if (token.is('(') || token.is('{')) ++open;
    if ((token.is(')') || token.is('}')) && open > 0) --open;
    if (token.is(':') && open == 0) colon = at;
  }
  return colon;
}

std::size_t GrowthReader::colon_before_arrow() const {
  std::size_t at = at_;
  while (at < arrow_ && !tokens_[at].is(':')) ++at;
  return at;
}

// `name = expression`: the number of steps, or a value for all volumes.
bool GrowthReader::setting() {
  const Token& first = tokens_[at_];
  if (first.is("gs") || first.is("gs.rand")) return steps();
  if (first.kind != TokenKind::name || !next_is(at_, '=')) return wrong(first.place, beginnings, {first.text});
  Rule rule;
  rule.place = first.place;
  return consequences(end_, rule) && place_rule(std::move(rule));
}

bool GrowthReader::steps() {
  const Token& first = tokens_[at_];
  if (rules_.steps_from.value.given)
    return wrong(first.place, "The steps have been given already; a text says gs once.");
  ++at_;
  if (first.is("gs")) return expect('=', "A = is expected here, as in gs = 8.") && number(end_, 0, rules_.steps_from);
  std::vector<Number> values;
  if (!opens(at_)) return wrong(here(), "Steps are drawn by gs.rand(7, 8).");
  if (!numbers(0, values)) return false;
  if (values.size() != 2) return wrong(first.place, "Steps are drawn from one number to another, as in gs.rand(7, 8).");
  rules_.steps_from = values[0];
  rules_.steps_to = values[1];
  return true;
}

// `bud(n) : condition -> branch : probability`: each internode of age k has n buds, from which branches grow.
bool GrowthReader::buds() {
  Rule rule;
  rule.place = here();
  Consequence buds{Consequence::Kind::buds, Word::one, {}, {}};
  ++at_;
  if (!opens(at_))
    return wrong(here(), "How many buds an internode bears stands behind bud, as in bud(k - 1) -> branch.");
  std::vector<Number> values;
  if (!numbers(bit(Word::k), values)) return false;
  if (values.size() != 1 || values[0].draws)
    return wrong(rule.place, "bud takes one number, which may depend on k alone, as in bud(k - 1) -> branch.");
  buds.number = values[0];
  if (on_sign(':') && !(++at_, condition(arrow_, rule))) return false;
  if (at_ != arrow_) return wrong(here(), "A condition stands behind a colon: bud(k - 1) : k < N - 1 -> branch.");
  ++at_;
  if (!(on_name() && (found() == "branch" || found() == "branches")))
    return wrong(here(), "A bud grows to a branch: bud(k - 1) -> branch, not '%'.", {found()});
  ++at_;
  rule.consequences.push_back(buds);
  own_rules_.buds = true;
  return weight(rule.probability) && place_rule(std::move(rule));
}

// `condition -> consequences : probability`
bool GrowthReader::conditional() {
  Rule rule;
  rule.place = here();
  const std::size_t colon = colon_before_arrow();
  if (colon < arrow_)
    return wrong(tokens_[colon].place,
                 "Before an arrow a colon stands behind bud(n) alone; take out what is before it.");
  if (!condition(arrow_, rule)) return false;
  ++at_;
  return consequences(successors_end_, rule) && weight(rule.probability) && place_rule(std::move(rule));
}

bool GrowthReader::condition(std::size_t end, Rule& rule) {
  if (at_ == end) return wrong(here(), "A condition is missing before the arrow, such as ndv < 0 -> …");
  if (!number(end, any_word, rule.condition)) return false;
  return at_ == end || wrong(here(), "An arrow is expected here, not '%'.", {found()});
}

bool GrowthReader::consequences(std::size_t end, Rule& rule) {
  do {
    if (on_sign(',') && !rule.consequences.empty()) ++at_;
    if (at_ >= end) return wrong(here(), "What happens is missing here, such as gravitropism = 0.2.");
    if (!consequence(end, rule)) return false;
  } while (at_ < end);
  return true;
}

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

bool GrowthReader::assigned(const Token& name, Consequence& consequence) {
  constexpr std::uint32_t settable =
      of_environment | bit(Word::ndv) | bit(Word::nbr) | bit(Word::nlf) | bit(Word::length);
  const std::uint32_t word = word_named(name.text);
  if (word == words || (settable >> word & 1) == 0)
    return fail(Reason::undefined, name.place, "'%' cannot be set; a rule sets %.", {name.text, list_of(settable)});
  consequence.word = static_cast<Word>(word);
  own_rules_.counts |= consequence.word == Word::ndv || consequence.word == Word::nbr;
  own_rules_.leaves |= consequence.word == Word::nlf;
  return true;
}

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
    return fail(
        name.kind == TokenKind::name ? Reason::undefined : Reason::syntax, name.place,
        "'%' cannot happen; a rule sets a value (gravitropism = 0.2) or has leaf(n), fallingLeaf(n), foliage(n) or "
        "childTrunk.",
        {name.text});
  consequence.kind = call->kind;
  ++at_;
  if (call->kind == Consequence::Kind::child_trunk) return true;
  own_rules_.leaves = true;
  std::vector<Number> values;
  if (at_ >= end || !opens(at_)) return wrong(here(), "How many stands behind it, as in %(nlf).", {name.text});
  if (!numbers(any_word, values)) return false;
  const bool lasting = call->kind == Consequence::Kind::foliage && values.size() == 2;
  if (values.size() != 1 && !lasting) return wrong(name.place, "% takes one number.", {name.text});
  consequence.number = values[0];
  if (lasting) consequence.steps = values[1];
  return true;
}

// `: probability`, where it is given.
bool GrowthReader::weight(Number& probability) {
  if (at_ >= end_) return true;
  if (!expect(':', "'%' cannot stand here; a probability stands behind a colon.")) return false;
  if (at_ >= end_) return wrong(here(), "A probability is missing behind the colon, such as 0.1.");
  return number(end_, any_word, probability);
}

// A rule that uses nothing of a shoot is evaluated once a volume.
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
                   "Of a single branch gravitropism and length can be set; % is a volume's: give it a rule without "
                   "k, ndv and the like.",
                   {word_names[static_cast<std::size_t>(each.word)]});
  rules_.repeatable &= !draws && !is_random && !rule.probability.draws && (uses & bit(Word::order)) == 0;
  rules_.of_shoots.push_back(std::move(rule));
  return true;
}

bool GrowthReader::numbers(std::uint32_t may_use, std::vector<Number>& values) {
  const SourceLocation opened = here();
  ++at_;
  if (on_sign(')')) return ++at_, true;
  for (;;) {
    if (!number(end_, may_use, values.emplace_back())) return false;
    if (at_ >= end_) return wrong(opened, "This ( is never closed.");
    if (tokens_[at_].is(')')) return ++at_, true;
    if (!expect(',', "A comma is expected here, not '%'.")) return false;
    if (values.size() == 32) return fail(Reason::limit, opened, "There are more than 32 numbers in these brackets.");
  }
}

bool GrowthReader::number(std::size_t end, std::uint32_t may_use, Number& number) {
  expression::Expression tree;
  if (!expression_before(end, tree)) {
    if (trouble_.reason != Reason::undefined) return false;
    return fail(Reason::undefined, {trouble_.line, trouble_.column}, "There is no such function; there are %.",
                {known_functions()});
  }
  if (!rewritten(tree, may_use, number)) return false;
  // Each expression has random values of its own.
  lowering_.begin_production(
      formals_, hash_combine(hash_text(in_footprint_ ? "footprint" : "growth"), ++expressions_[in_footprint_]));
  const std::uint32_t begin = lowering_.here();
  const auto source = lowering_.lower(tree);
  if (!source) {
    trouble_ = source.error();
    return false;
  }
  number.value = {true, {begin, lowering_.here()}, source.value(), tree.place};
  return true;
}

// D(x) and E(x) become elements of lists that begin at 0; the values of the divisor functions are set before growth.
bool GrowthReader::rewritten(expression::Expression& tree, std::uint32_t may_use, Number& number) {
  using expression::Node;
  std::vector<Node> nodes;
  for (const Node& node : tree.nodes) {
    if (node.kind == Node::Kind::element)
      return wrong(node.place, "There are no lists in a growth grammar; what stands in brackets has round ones: D(k).");
    if (node.kind == Node::Kind::name) {
      const std::uint32_t word = word_named(node.name);
      if (word == words || (may_use >> word & 1) == 0) return unknown_word(node, may_use);
      number.uses |= 1u << word;
    }
    if (node.kind == Node::Kind::operation && node.op == expression::Op::curve) {
      const bool leaves = node.curve == 1;
      if (may_use == 0 || may_use == bit(Word::k))
        return wrong(node.place, "D and E are known while the tree grows, not here; write a number.");
      (leaves ? rules_.uses_leaf_function : rules_.uses_branch_function) = true;
      if (needs_function_.line == 0) needs_function_ = node.place;
      nodes.push_back({Node::Kind::name, {}, 0, 0, word_names[words - 1], node.place});
      nodes.push_back({Node::Kind::operation, expression::Op::add, 2, 0, {}, node.place});
      nodes.push_back(
          {Node::Kind::element, expression::Op::element, 1, 0, leaves ? leaf_function : branch_function, node.place});
      continue;
    }
    if (node.kind == Node::Kind::operation && expression::is_space_query(node.op))
      return wrong(node.place, "% asks about a place of the plant, which a growth grammar does not know; take it out.",
                   {node.name});
    number.draws |= node.kind == Node::Kind::operation && expression::is_random(node.op);
    nodes.push_back(node);
  }
  used_ |= number.uses;
  tree.nodes = std::move(nodes);
  return true;
}

bool GrowthReader::unknown_word(const expression::Node& node, std::uint32_t may_use) {
  if (may_use == 0)
    return fail(Reason::undefined, node.place, "'%' is not known before anything grows; write a number here.",
                {node.name});
  return fail(Reason::undefined, node.place, "There is no '%' here; there are %.", {node.name, list_of(may_use)});
}

}  // namespace panicle::growth
