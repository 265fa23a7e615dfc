#include "models/bunch/stock.hpp"

#include <algorithm>
#include <utility>

#include "foundation/random.hpp"

namespace panicle::bunch {

Result<Stock> derive_stock(std::string_view grammar, std::uint64_t seed, const lsystem::Inputs& inputs,
                           const Limits& limits) {
  auto program = lsystem::compile(grammar, inputs, limits, lsystem::Lineages::always);
  if (!program) return program.error();
  auto derived = lsystem::unfold(*program.value(), seed, limits);
  if (!derived) return derived.error();
  return Stock{std::move(program.value()), std::move(derived->string), seed};
}

std::uint64_t second_seed(std::uint64_t seed) { return hash_combine(seed, hash_text("second bunch")); }

Diagnostic interpret(const Stock& stock, const Limits& limits, lsystem::Listener& listener) {
  lsystem::Turtle turtle;
  lsystem::turn(turtle, -stock.lean);
  const auto drawn = lsystem::interpret(*stock.program, *stock.string, turtle, listener, stock.seed, limits);
  return drawn ? Diagnostic{} : drawn.error();
}

void remark_unknown(const lsystem::Program& program, const std::vector<lsystem::Inputs::Scalar>& defines,
                    std::vector<std::string>& notes) {
  const std::span<const lsystem::Definition> known = lsystem::definitions(program);
  for (const lsystem::Inputs::Scalar& given : defines) {
    const bool found = std::any_of(known.begin(), known.end(), [&](const auto& one) { return one.name == given.name; });
    if (!found) notes.push_back("The grammar has no #define " + given.name + ", so its parameter changes nothing.");
  }
}

}  // namespace panicle::bunch
