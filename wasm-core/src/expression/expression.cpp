// Dijkstra's shunting yard: operands are output at once, operators wait on a stack until one that binds less follows.

#include "expression/expression.hpp"

#include <array>
#include <string>

#include "expression/dialect_hints.hpp"
#include "expression/messages.generated.hpp"

namespace panicle::expression {
namespace {

constexpr std::size_t deepest = 256;

enum class Logic : std::uint8_t { none, both, either };

struct Operator {
  std::string_view text;
  std::uint32_t precedence;
  Op op;
  Logic logic = Logic::none;
};

constexpr std::uint32_t precedence_of_equality = 3;
constexpr std::uint32_t precedence_of_order = 4;
constexpr std::uint32_t precedence_of_prefix = 7;
constexpr std::uint32_t precedence_of_power = 8;

// Longer spellings first.
constexpr std::array<Operator, 15> operators = {{{"&&", 2, Op::truth, Logic::both},
                                                 {"||", 1, Op::truth, Logic::either},
                                                 {"==", 3, Op::equal},
                                                 {"!=", 3, Op::not_equal},
                                                 {"<=", 4, Op::less_equal},
                                                 {">=", 4, Op::greater_equal},
                                                 {"=", 3, Op::equal},
                                                 {"<", 4, Op::less},
                                                 {">", 4, Op::greater},
                                                 {"+", 5, Op::add},
                                                 {"-", 5, Op::subtract},
                                                 {"*", 6, Op::multiply},
                                                 {"/", 6, Op::divide},
                                                 {"%", 6, Op::remainder},
                                                 {"^", 8, Op::power}}};

// An entry of the operator stack: an operator, or an open group.
struct Waiting {
  enum class Kind : std::uint8_t { operation, parenthesis, call, index };
  Kind kind = Kind::operation;
  std::uint32_t precedence = 0;
  Node node;
  std::uint32_t arguments = 1;           // of a call, counted so far
  std::uint32_t macro = Names::none;     // that is called
  std::vector<std::size_t> begins = {};  // of a macro's arguments among the expression's nodes
};

// The function of a name, or null.
const Function* function_named(std::string_view name) {
  for (const Function& function : functions)
    if (function.name == name) return &function;
  return nullptr;
}

// Parser of an expression into postfix order, by Dijkstra's shunting-yard algorithm. Methods that return a bool return
// false with the error in `error_`.
class Parser {
 public:
  Parser(std::span<const Token> tokens, std::size_t at, std::size_t end, const Names& curves, Macros& macros)
      : tokens_(tokens), at_(at), end_(end), curves_(curves), macros_(macros) {}

  std::size_t at() const { return at_; }

  // Parses tokens until the expression ends.
  Result<Expression> run() {
    expression_.place = here();
    while (at_ < end_) {
      const bool fine = wants_operand_ ? operand() : ends_here() ? (done_ = true) : next_operator();
      if (!fine) return error_;
      if (done_) break;
    }
    if (wants_operand_) {
      fail(Reason::syntax, here(), message(messages::expression::value_missing));
      return error_;
    }
    pop_operators(0);
    if (!waiting_.empty()) {
      const char* opened = waiting_.back().kind == Waiting::Kind::index ? "[" : "(";
      fail(Reason::syntax, waiting_.back().node.place, message(messages::expression::never_closed, opened));
      return error_;
    }
    return std::move(expression_);
  }

 private:
  // The place of the next token, and the token itself.
  SourceLocation here() const { return place_of(tokens_, at_, end_); }
  const Token& token() const { return tokens_[at_]; }

  bool fail(Reason reason, const SourceLocation& place, const Message& problem) {
    error_ = error_at(reason, place, problem);
    return false;
  }

  // Whether the current token ends the expression: a sign that cannot belong to it, outside of all groups.
  bool ends_here() const {
    static constexpr std::string_view ends = "),;{}";
    return groups_ == 0 && token().kind == TokenKind::sign && ends.find(token().text[0]) != std::string_view::npos;
  }

  // Whether the next token is a sign.
  bool next_is(char sign) const { return at_ + 1 < end_ && tokens_[at_ + 1].is(sign); }

  // Puts an operator or an open group on the stack; an operand must follow.
  bool push(const Waiting& waiting) {
    if (waiting_.size() >= deepest) return fail(Reason::limit, here(), message(messages::expression::nested_too_deep));
    groups_ += waiting.kind != Waiting::Kind::operation;
    waiting_.push_back(waiting);
    wants_operand_ = true;
    return true;
  }

  // Reads a number, a name, the beginning of a group or a prefix operator.
  bool operand() {
    const Token& first = token();
    if (first.kind == TokenKind::number) {
      put({Node::Kind::number, Op::add, 0, first.number, {}, first.place, 0, first.precise});
    } else if (first.kind == TokenKind::name) {
      if (next_is('(')) return begin_call();
      if (next_is('[')) {
        at_ += 2;
        return push({Waiting::Kind::index, 0, {Node::Kind::element, Op::element, 1, 0, first.text, first.place}});
      }
      put({Node::Kind::name, Op::add, 0, 0, first.text, first.place});
    } else if (first.is('(')) {
      ++at_;
      return push({Waiting::Kind::parenthesis, 0, {Node::Kind::number, Op::add, 0, 0, {}, first.place}});
    } else if (first.is('-') || first.is('+') || first.is('!')) {
      return prefix();
    } else {
      const bool turned = (first.is('>') || first.is('<')) && at_ > 0 && tokens_[at_ - 1].is('=');
      return fail(Reason::syntax, first.place,
                  turned ? message(messages::expression::comparison_reversed)
                         : message(messages::expression::value_expected, first.text));
    }
    ++at_;
    wants_operand_ = false;
    return true;
  }

  // Reads a sign before an operand.
  bool prefix() {
    const Token& sign = token();
    ++at_;
    if (sign.is('+')) return true;
    const Op op = sign.is('-') ? Op::negate : Op::invert;
    return push({Waiting::Kind::operation, precedence_of_prefix, {Node::Kind::operation, op, 1, 0, {}, sign.place}});
  }

  // Begins a call of a function or curve.
  bool begin_call() {
    const Token& name = token();
    const Function* function = function_named(name.text);
    const std::uint32_t curve = curves_.find(name.text), macro = macros_.names.find(name.text);
    if (macro != Names::none) return begin_macro(name, macro);
    if (function == nullptr && curve == Names::none) {
      if (const Hint hint = foreign_function(name.text)) return fail(Reason::undefined, name.place, message(*hint));
      std::string known;
      for (const Function& f : functions) known.append(known.empty() ? "" : ", ").append(f.name);
      return fail(Reason::undefined, name.place, message(messages::expression::unknown_function, name.text, known));
    }
    at_ += 2;
    Node node{Node::Kind::operation, Op::curve, 1, 0, name.text, name.place, curve};
    if (function != nullptr)
      node = {Node::Kind::operation, function->op, function->arguments, 0, function->name, name.place};
    return push({Waiting::Kind::call, 0, node});
  }

  // Begins a call of a macro.
  bool begin_macro(const Token& name, std::uint32_t macro) {
    at_ += 2;
    const auto arguments = static_cast<std::uint32_t>(macros_.all[macro].formals.size());
    Waiting call{Waiting::Kind::call, 0, {Node::Kind::operation, Op::add, arguments, 0, name.text, name.place}};
    call.macro = macro;
    call.begins.push_back(expression_.nodes.size());
    return push(call);
  }

  // Replaces a call of a macro, whose arguments are the last nodes of the expression, by the macro's body.
  bool expand_macro(const Waiting& call) {
    const Macro& macro = macros_.all[call.macro];
    std::vector<Node>& nodes = expression_.nodes;
    const std::vector<Node> given(nodes.begin() + static_cast<std::ptrdiff_t>(call.begins[0]), nodes.end());
    nodes.resize(call.begins[0]);
    for (const Node& node : macro.body.nodes) {
      std::size_t formal = macro.formals.size();
      if (node.kind == Node::Kind::name)
        for (formal = 0; formal < macro.formals.size() && macro.formals[formal].name != node.name;) ++formal;
      if (formal == macro.formals.size()) {
        put(node);
        ++macros_.nodes;
      } else {
        const std::size_t begin = call.begins[formal] - call.begins[0];
        const std::size_t end =
            formal + 1 < call.begins.size() ? call.begins[formal + 1] - call.begins[0] : given.size();
        nodes.insert(nodes.end(), given.begin() + static_cast<std::ptrdiff_t>(begin),
                     given.begin() + static_cast<std::ptrdiff_t>(end));
        macros_.nodes += end - begin;
      }
      if (macros_.nodes > Macros::max_nodes)
        return fail(Reason::limit, call.node.place, message(messages::expression::macros_too_long));
    }
    return true;
  }

  // Reads a binary operator, a comma or the end of a group.
  bool next_operator() {
    const Token& sign = token();
    if (sign.is(')') || sign.is(']')) return close_group(sign);
    if (sign.is(',')) return next_argument(sign);
    for (const Operator& op : operators)
      if (spelled_here(op.text)) return binary(op);
    return no_operator(sign);
  }

  // Fails with a message on a token that is not an operator.
  bool no_operator(const Token& token) {
    if (const Hint hint = foreign_operator(token.text)) return fail(Reason::syntax, token.place, message(*hint));
    if (token.kind == TokenKind::name || token.kind == TokenKind::number)
      return fail(Reason::syntax, token.place, message(messages::expression::operator_missing, token.text));
    return fail(Reason::syntax, token.place, message(messages::expression::not_in_expression, token.text));
  }

  // Whether the tokens from here on spell an operator.
  bool spelled_here(std::string_view text) const {
    if (!token().is(text[0])) return false;
    return text.size() == 1 || (next_is(text[1]) && touching(token(), tokens_[at_ + 1]));
  }

  // Reads a binary operator: outputs those before it that bind at least as strongly, and puts it on the stack. && and
  // || are marked at both ends, for their jumps.
  bool binary(const Operator& op) {
    const SourceLocation place = token().place;
    if (!pop_operators(op.precedence + (op.precedence == precedence_of_power), op.precedence)) return false;
    at_ += op.text.size();
    Node node{Node::Kind::operation, op.op, 2, 0, {}, place};
    if (op.logic != Logic::none) {
      const bool both = op.logic == Logic::both;
      node.kind = both ? Node::Kind::and_begin : Node::Kind::or_begin;
      put(node);
      node.kind = both ? Node::Kind::and_end : Node::Kind::or_end;
    }
    return push({Waiting::Kind::operation, op.precedence, node});
  }

  // Outputs the operators on top of the stack that bind at least as strongly as `precedence`. A chain such as 1 < x < 3
  // is an error, because it would compare the truth of 1 < x with 3.
  bool pop_operators(std::uint32_t precedence, std::uint32_t following = 0) {
    while (!waiting_.empty() && waiting_.back().kind == Waiting::Kind::operation &&
           waiting_.back().precedence >= precedence) {
      const Waiting& top = waiting_.back();
      const bool compares = top.precedence == precedence_of_equality || top.precedence == precedence_of_order;
      if (compares && top.precedence == following)
        return fail(Reason::syntax, here(), message(messages::expression::comparison_chain));
      put(top.node);
      waiting_.pop_back();
    }
    return true;
  }

  // Closes a parenthesis, call or index, and outputs it.
  bool close_group(const Token& sign) {
    pop_operators(0);
    const bool bracket = sign.is(']');
    if (waiting_.empty() || (waiting_.back().kind == Waiting::Kind::index) != bracket)
      return fail(Reason::syntax, sign.place, message(messages::expression::never_opened, sign.text));
    const Waiting group = waiting_.back();
    waiting_.pop_back();
    --groups_;
    ++at_;
    wants_operand_ = false;
    if (group.kind == Waiting::Kind::call && group.arguments != group.node.arguments)
      return fail(
          Reason::syntax, group.node.place,
          message(messages::expression::argument_count, group.node.name, group.node.arguments, group.arguments));
    if (group.macro != Names::none) return expand_macro(group);
    if (group.kind != Waiting::Kind::parenthesis) put(group.node);
    return true;
  }

  // Begins the next argument of a call.
  bool next_argument(const Token& comma) {
    pop_operators(0);
    if (waiting_.empty() || waiting_.back().kind != Waiting::Kind::call)
      return fail(Reason::syntax, comma.place, message(messages::expression::comma_outside_call));
    ++waiting_.back().arguments;
    if (waiting_.back().macro != Names::none) waiting_.back().begins.push_back(expression_.nodes.size());
    ++at_;
    wants_operand_ = true;
    return true;
  }

  void put(const Node& node) { expression_.nodes.push_back(node); }

  std::span<const Token> tokens_;
  std::size_t at_;
  std::size_t end_;
  const Names& curves_;
  Macros& macros_;
  bool wants_operand_ = true;
  bool done_ = false;
  std::size_t groups_ = 0;
  std::vector<Waiting> waiting_;
  Expression expression_;
  Diagnostic error_;
};

}  // namespace

// The place of a token; behind the last one if there is none.
SourceLocation place_of(std::span<const Token> tokens, std::size_t at, std::size_t end) {
  if (at < end) return tokens[at].place;
  if (at == 0) return {1, 1};
  const Token& last = tokens[at - 1];
  std::uint32_t width = 0;
  for (const char byte : last.text) width += (static_cast<unsigned char>(byte) & 0xc0) != 0x80;
  return {last.place.line, last.place.column + width};
}

Result<Expression> parse_expression(std::span<const Token> tokens, std::size_t& at, std::size_t end,
                                    const Names& curves, Macros& macros) {
  Parser parser(tokens, at, end, curves, macros);
  Result<Expression> expression = parser.run();
  at = parser.at();
  return expression;
}

}  // namespace panicle::expression
