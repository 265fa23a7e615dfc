#include "models/flower/syntax/program.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "foundation/bytes.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/syntax/reader.hpp"
#include "models/flower/text.hpp"

namespace panicle::flower {
namespace {

using expression::error_at;
using expression::Token;
using expression::TokenKind;
using Tokens = std::vector<Token>;

constexpr std::string_view random_number = "math.random";

// Lua functions of the thesis that exist here without `math.`. Its angles are radians, ours degrees.
constexpr std::string_view same_in_lua[] = {"abs", "floor", "ceil", "sqrt", "exp", "log", "min", "max", "pow"};
constexpr std::string_view of_angles[] = {"sin", "cos", "tan"}, to_angles[] = {"asin", "acos", "atan"};
constexpr float degrees_a_radian = 57.2957795f, radians_a_degree = 0.0174532925f, pi = 3.14159265f;

// Rewrites calls of Lua: math.abs(x) → abs(x), math.pi → 3.14…, math.sin(x) → sin(57.3*(x)), math.atan(x) →
// (0.0175*atan(x)). RandomCallRewriter rewrites math.random; the expression reader refuses all other names.
Tokens replace_lua_calls(const Tokens& tokens) {
  static constexpr std::string_view begins = "math.";
  const auto is_one_of = [](const auto& names, std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
  };
  Tokens out;
  out.reserve(tokens.size());
  std::vector<std::size_t> closes;  // depths at which one more ) is needed
  std::size_t depth = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    const bool of_lua = token.kind == TokenKind::name && token.text.substr(0, begins.size()) == begins;
    const std::string_view name = of_lua ? token.text.substr(begins.size()) : std::string_view();
    const bool called = at + 1 < tokens.size() && tokens[at + 1].is('(');
    const auto put = [&](TokenKind kind, std::string_view text, float number = 0) {
      out.push_back({kind, token.first_on_line, token.place, text, number});
    };
    if (token.is('(')) ++depth;
    if (name == "pi") {
      put(TokenKind::number, "3.14159265", pi);
    } else if (called && is_one_of(same_in_lua, name)) {
      put(TokenKind::name, name);
    } else if (called && is_one_of(of_angles, name)) {
      put(TokenKind::name, name);
      put(TokenKind::sign, "(");
      put(TokenKind::number, "57.2957795", degrees_a_radian);
      put(TokenKind::sign, "*");
      closes.push_back(depth);
    } else if (called && is_one_of(to_angles, name)) {
      put(TokenKind::sign, "(");
      put(TokenKind::number, "0.0174532925", radians_a_degree);
      put(TokenKind::sign, "*");
      put(TokenKind::name, name);
      closes.push_back(depth);
    } else {
      out.push_back(token);
    }
    // Closes the added parenthesis behind the call's own.
    if (!token.is(')') || depth == 0) continue;
    --depth;
    if (closes.empty() || closes.back() != depth) continue;
    closes.pop_back();
    put(TokenKind::sign, ")");
  }
  return out;
}

// Rewrites the thesis's draws: math.random() as ran(1), math.random(a, b) as a + ran(b − a).
class RandomCallRewriter {
 public:
  explicit RandomCallRewriter(const Tokens& tokens) : tokens_(tokens) {}

  // Returns the rewritten tokens, or the error of a call.
  Result<Tokens> rewritten() {
    while (at_ < tokens_.size()) {
      if (!tokens_[at_].is(random_number)) {
        out_.push_back(tokens_[at_++]);
      } else if (!rewrite_call()) {
        return trouble_;
      }
    }
    return std::move(out_);
  }

 private:
  // Fails with the advice on how to write a draw.
  bool wrong() {
    trouble_ = error_at(Reason::syntax, tokens_[at_].place, message(messages::flower::random_syntax));
    return false;
  }

  // Rewrites the call of math.random at `at_`. Returns false for draws among its limits, since a limit is written
  // twice.
  bool rewrite_call() {
    const expression::SourceLocation place = tokens_[at_].place;
    const bool first = tokens_[at_].first_on_line;
    const auto put = [&](TokenKind kind, std::string_view text, float number = 0) {
      out_.push_back({kind, first, place, text, number});
    };
    const auto put_all = [&](std::size_t begin, std::size_t end) {
      put(TokenKind::sign, "(");
      out_.insert(out_.end(), tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                  tokens_.begin() + static_cast<std::ptrdiff_t>(end));
      put(TokenKind::sign, ")");
    };
    const std::size_t open = at_ + 1;
    if (open >= tokens_.size() || !tokens_[open].is('(')) return wrong();
    std::size_t close = open, comma = 0, depth = 0;
    for (; close < tokens_.size(); ++close) {
      const Token& token = tokens_[close];
      if (close > open && (token.is(random_number) || token.is("ran") || token.is("RND") || token.is("nran")))
        return wrong();
      depth += token.is('(');
      depth -= token.is(')');
      if (depth == 0) break;
      if (depth > 1 || !token.is(',')) continue;
      if (comma != 0) return wrong();
      comma = close;
    }
    if (close == tokens_.size() || (comma == 0 && close > open + 1)) return wrong();
    if (comma != 0) {
      put(TokenKind::sign, "(");
      put_all(open + 1, comma);
      put(TokenKind::sign, "+");
    }
    put(TokenKind::name, "ran");
    put(TokenKind::sign, "(");
    if (comma != 0) {
      put_all(comma + 1, close);
      put(TokenKind::sign, "-");
      put_all(open + 1, comma);
    } else {
      put(TokenKind::number, "1", 1);
    }
    put(TokenKind::sign, ")");
    if (comma != 0) put(TokenKind::sign, ")");
    at_ = close + 1;
    return true;
  }

  const Tokens& tokens_;
  std::size_t at_ = 0;
  Tokens out_;
  Diagnostic trouble_;
};

// Sorts code that depends on variables alone by the grammar of the variables: code of the text's own variables first,
// then that of each module. So the work of entering an instance does not depend on the number of modules.
void sort_once_bound(Program& program, expression::Range all) {
  std::vector<std::uint32_t> owner(program.code.registers.size(), 0);
  for (const Variable& variable : program.variables) owner[variable.to] = variable.grammar;
  std::vector<std::vector<std::uint32_t>> by_grammar(program.grammars.size());
  for (std::uint32_t at = all.begin; at < all.end; ++at) {
    const expression::Instruction& instruction = program.code.instructions[at];
    // No code uses the variables of two modules.
    const std::uint32_t grammar = std::max(owner[instruction.a], owner[instruction.b]);
    owner[instruction.out] = grammar;
    by_grammar[grammar].push_back(at);
  }
  expression::Code& code = program.code;
  std::vector<expression::Instruction> instructions;
  std::vector<expression::SourceLocation> places;
  for (std::uint32_t g = 0; g < by_grammar.size(); ++g) {
    expression::Range& range = program.grammars[g].once_bound;
    range.begin = all.begin + static_cast<std::uint32_t>(instructions.size());
    for (const std::uint32_t at : by_grammar[g]) {
      instructions.push_back(code.instructions[at]);
      places.push_back(code.places[at]);
    }
    range.end = all.begin + static_cast<std::uint32_t>(instructions.size());
  }
  for (Variable& variable : program.variables) {
    const std::vector<std::uint32_t>& indices = by_grammar[variable.grammar];
    const auto before = std::lower_bound(indices.begin(), indices.end(), all.begin + variable.needs) - indices.begin();
    variable.needs = program.grammars[variable.grammar].once_bound.begin + static_cast<std::uint32_t>(before);
  }
  std::copy(instructions.begin(), instructions.end(), code.instructions.begin() + all.begin);
  std::copy(places.begin(), places.end(), code.places.begin() + all.begin);
}

}  // namespace

// The share of light that organs of a kind transmit.
float light_through(std::string_view kind) {
  return kind == "petal" ? 0.5f : kind == "sepal" || kind == "leaf" ? 0.3f : 0;
}

// The memory that it holds, roughly.
std::uint64_t Program::bytes() const {
  std::uint64_t bytes = bytes_of(grammars) + bytes_of(labels) + bytes_of(variables) + bytes_of(productions) +
                        bytes_of(materials) + bytes_of(structure_key) + bytes_of(notes) + bytes_of(code.instructions) +
                        bytes_of(code.places) + bytes_of(code.registers) + bytes_of(code.streams);
  for (const std::string& note : notes) bytes += bytes_of(note);
  for (const Production& production : productions) {
    bytes += bytes_of(production.growths);
    for (const GrowAction& growth : production.growths) bytes += bytes_of(growth.faces) + bytes_of(growth.settings);
  }
  return bytes;
}

// Reads a flower's text: tokens, calls of Lua, then statements, and sorts the compiled code.
Result<Program> read_program(std::string_view text, const Limits& limits) {
  if (Diagnostic error = expression::check_length(text, limits); error.reason != Reason::none) return error;
  const auto cleaned = without_comments(text);
  if (!cleaned) return cleaned.error();
  const auto written = expression::tokenize(cleaned.value(), expression::Writing::rules);
  if (!written) return written.error();
  const Tokens ours = replace_lua_calls(written.value());
  const auto tokens = RandomCallRewriter(ours).rewritten();
  if (!tokens) return tokens.error();
  if (tokens->empty()) return error_at(Reason::syntax, {1, 1}, message(messages::flower::text_empty));
  Program program;
  expression::Lowering lowering(program.code);
  FlowerReader reader(tokens.value(), program, lowering);
  if (!reader.run()) return reader.trouble();
  sort_once_bound(program, lowering.finish());
  return program;
}

}  // namespace panicle::flower
