#include "lsystem/syntax/production_reader.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "expression/code.hpp"
#include "expression/messages.generated.hpp"
#include "lsystem/messages.generated.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::size_t max_neighbours = 64;
constexpr std::size_t max_assignments = 64;

}  // namespace

// Reads a production, `left < predecessor > right : condition --> successor : weight`. As all readers here, returns
// false with the error in `trouble_`.
bool ProductionReader::production(Purpose purpose) {
  ProductionTree production;
  production.purpose = purpose;
  production.system = system_;
  if (is_label()) return wrong(here(), message(messages::lsystem::label_not_supported, found()));
  if (!predecessor(production) || !condition(production)) return false;
  at_ = arrow_ + 1;
  const std::size_t end = end_of_line(arrow_);
  for (std::size_t i = at_; i < end; ++i)
    if (tokens_[i].kind == TokenKind::arrow) return wrong(tokens_[i].place, message(messages::lsystem::second_arrow));
  const bool empty = on_sign('*');  // cpfg's way to write an empty successor
  at_ += empty;
  if (!empty && !modules(production.successor)) return false;
  if (on_sign(':')) {
    ++at_;
    if (!expression_to(end_, production.weight)) return false;
  }
  if (at_ < end_) return wrong(here(), message(messages::lsystem::after_star, found_text()));
  grammar_.productions.push_back(std::move(production));
  return true;
}

// Whether the production begins with a label, `p1 :`. It does when another colon follows, or when the name occurs
// nowhere else and the text behind its colon is no expression.
bool ProductionReader::is_label() {
  if (!on_name() || at_ + 2 >= arrow_ || !tokens_[at_ + 1].is(':')) return false;
  for (std::size_t i = at_ + 2; i < arrow_; ++i)
    if (tokens_[i].is(':')) return true;
  const Token& next = tokens_[at_ + 2];
  static constexpr std::string_view never_begin_expressions = "&^/\\|[]%?";
  if (times_named(found()) > 1) return false;
  if (next.kind == TokenKind::name) return times_named(next.text) > 1 && !is_value(next.text);
  if (next.is('*')) return at_ + 3 < arrow_;
  return next.kind == TokenKind::sign && never_begin_expressions.find(next.text[0]) != std::string_view::npos;
}

// Whether a name is a constant's or calls a function.
bool ProductionReader::is_value(std::string_view name) {
  index_words();
  for (const Function& function : functions)
    if (name == function.name) return true;
  return declared_.find(name) != Names::none;
}

// How often a name of the text occurs in it.
std::uint32_t ProductionReader::times_named(std::string_view name) {
  index_words();
  return times_[words_.find(name)];
}

// Counts all words of the text, and lists the names that directives define; on first use.
void ProductionReader::index_words() {
  if (!times_.empty()) return;
  times_.assign(tokens_.size(), 0);
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    ++times_[words_.add(tokens_[i].text)];
    if (tokens_[i].is('#') && i + 2 < tokens_.size()) declared_.add(tokens_[i + 2].text);
  }
}

// Reads `left < predecessor > right`, up to the colon of a condition.
bool ProductionReader::predecessor(ProductionTree& production) {
  std::size_t end = at_;
  while (end < arrow_ && !tokens_[end].is(':')) ++end;
  const std::size_t after = std::exchange(end_, arrow_);
  std::vector<Named> beside;
  if (std::any_of(tokens_.begin() + at_, tokens_.begin() + end, [](const Token& token) { return token.is('<'); })) {
    if (!neighbours(end, '<', production.left, beside)) return false;
    if (!on_sign('<')) return wrong(here(), message(messages::lsystem::context_order));
    ++at_;
  }
  production.place = here();
  if (!symbol(production.predecessor) || !formals(production.formals)) return false;
  production.arity = static_cast<std::uint32_t>(production.formals.size());
  if (on_sign('<')) return wrong(here(), message(messages::lsystem::second_left_context));
  if (on_sign('>')) {
    ++at_;
    if (!neighbours(end, '>', production.right, beside)) return false;
  }
  production.formals.insert(production.formals.end(), beside.begin(), beside.end());
  if (at_ < end_ && !on_sign(':')) {
    if (on_name() || is_turtles(found()))
      return wrong(here(), message(messages::lsystem::one_predecessor, found_text()));
    return wrong(here(), message(messages::lsystem::condition_syntax, found_text()));
  }
  end_ = after;
  return are_valid(production.formals);
}

// Reads the modules of a context: the left one up to its `<`, the right one up to `end`. A lone `*` is none.
bool ProductionReader::neighbours(std::size_t end, char side, std::vector<NeighbourTree>& neighbours,
                                  std::vector<Named>& beside) {
  if (on_sign('*')) return ++at_, true;
  const SourceLocation began = here();
  std::vector<SourceLocation> open;
  while (at_ < end && !on_sign('<') && !on_sign('>')) {
    NeighbourTree neighbour{{}, here(), 0};
    const std::size_t before = beside.size();
    if (!symbol(neighbour.name) || !formals(beside)) return false;
    neighbour.arity = static_cast<std::uint32_t>(beside.size() - before);
    const bool opens = neighbour.name == "[", closes = neighbour.name == "]";
    if (side == '<' && (opens || closes))
      return wrong(neighbour.place, message(messages::lsystem::left_context_brackets));
    if (opens) open.push_back(neighbour.place);
    if (closes && open.empty()) return wrong(neighbour.place, message(messages::expression::never_opened, "]"));
    if (closes) open.pop_back();
    neighbours.push_back(neighbour);
    if (neighbours.size() > max_neighbours)
      return fail(Reason::limit, neighbour.place, message(messages::lsystem::context_too_long));
  }
  if (!open.empty()) return wrong(open.back(), message(messages::expression::never_closed, "["));
  if (neighbours.empty())
    return wrong(began, message(messages::lsystem::context_empty, std::string_view(side == '<' ? "<" : ">")));
  return true;
}

// Checks the number of formal parameters, and that their names differ.
bool ProductionReader::are_valid(const std::vector<Named>& formals) {
  if (formals.size() > max_parameters)
    return fail(Reason::limit, formals[max_parameters].place, message(messages::lsystem::too_many_formals));
  for (std::size_t i = 1; i < formals.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (formals[k].name == formals[i].name)
        return wrong(formals[i].place, message(messages::lsystem::parameter_twice, formals[i].name));
  return true;
}

// Reads `{block} condition {block}`, each of which may be left out.
bool ProductionReader::condition(ProductionTree& production) {
  if (at_ == arrow_) return true;
  ++at_;
  const std::size_t after = std::exchange(end_, arrow_);
  if (on_sign('{') && !block(production.before)) return false;
  const bool always = on_sign('*') && (at_ + 1 == arrow_ || next_is(at_, '{'));
  at_ += always;
  if (at_ < arrow_ && !on_sign('{') && !expression_before(arrow_, production.condition)) return false;
  if (on_sign('{') && !block(production.after)) return false;
  if (at_ < arrow_) return wrong(here(), message(messages::expression::unexpected, found_text()));
  end_ = after;
  return true;
}

// Reads `{name = expression; …}`.
bool ProductionReader::block(std::vector<AssignmentTree>& assignments) {
  const SourceLocation opened = here();
  ++at_;
  while (!on_sign('}')) {
    if (at_ >= end_) return wrong(opened, message(messages::lsystem::block_never_closed, "{"));
    if (on_sign(';')) {
      ++at_;
      continue;
    }
    if (!on_name()) return wrong(here(), message(messages::lsystem::block_syntax, "{y = 2*x; z = y+1}", found_text()));
    AssignmentTree assignment{tokens_[at_].text, {}};
    ++at_;
    if (!expect('=')) return false;
    if (!expression_before(end_, assignment.expression)) return false;
    if (at_ < end_ && !on_sign(';') && !on_sign('}'))
      return wrong(here(), message(messages::lsystem::block_end_expected, found_text()));
    assignments.push_back(std::move(assignment));
    if (assignments.size() > max_assignments)
      return fail(Reason::limit, here(), message(messages::lsystem::block_too_long));
  }
  ++at_;
  return true;
}

}  // namespace panicle::lsystem
