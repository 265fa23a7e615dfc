#include "models/bunch/stock.hpp"

#include <utility>

#include "foundation/random.hpp"
#include "models/bunch/builtin_grammars.hpp"

namespace panicle::bunch {

Result<std::shared_ptr<const lsystem::Program>> program_for(const Request& request, int built_in,
                                                            const Limits& limits) {
  if (request.program) return request.program;
  const std::string_view text = request.grammar.empty() ? builtin_grammar(built_in) : request.grammar;
  return lsystem::compile(text, limits, lsystem::Lineages::always);
}

Result<Stock> derive_stock(std::shared_ptr<const lsystem::Program> program, std::uint64_t seed,
                           const lsystem::Inputs& inputs, const Limits& limits) {
  auto bound = lsystem::bind(std::move(program), inputs, limits);
  if (!bound) return bound.error();
  auto derived = lsystem::develop(*bound.value(), seed, {}, limits);
  if (!derived) return derived.error();
  return Stock{std::move(bound.value()), std::move(derived->string), seed};
}

std::uint64_t second_seed(std::uint64_t seed) { return hash_combine(seed, hash_text("second bunch")); }

Diagnostic interpret(const Stock& stock, const Limits& limits, lsystem::Listener& listener) {
  lsystem::Turtle turtle;
  lsystem::turn(turtle, -stock.lean);
  const auto drawn = lsystem::interpret(*stock.bound, *stock.string, turtle, listener, stock.seed, limits);
  return drawn ? Diagnostic{} : drawn.error();
}

void note_remarks(const lsystem::Program& program, int built_in, const Values& values, const Limits& limits,
                  std::vector<std::string>& notes) {
  std::vector<lsystem::Inputs::Scalar> unknown = values.defines();
  std::erase_if(unknown, [&](const auto& scalar) { return lsystem::declares(program, scalar.name); });
  if (!unknown.empty())
    if (const auto own = lsystem::compile(builtin_grammar(built_in), limits))
      std::erase_if(unknown, [&](const auto& scalar) { return !lsystem::declares(*own.value(), scalar.name); });
  for (const lsystem::Remark& remark : lsystem::remarks(program, unknown)) {
    const std::string place = remark.line ? "Line " + std::to_string(remark.line) + ": " : std::string();
    notes.push_back(place + remark.message);
  }
}

}  // namespace panicle::bunch
