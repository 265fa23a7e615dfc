// One bunch of the specimen, derived and ready to be interpreted.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

struct Stock {
  std::shared_ptr<const lsystem::Bound> bound;
  std::shared_ptr<const lsystem::String> string;
  std::uint64_t seed = 0;
  std::int32_t first_axis = 0;
  float lean = 0;  // degrees that the whole bunch leans to the left
};

// The grammar that every bunch of a request is derived from: compiled before, or now; the built-in one of that number
// where the request has none.
Result<std::shared_ptr<const lsystem::Program>> program_for(const Request& request, int built_in, const Limits& limits);

Result<Stock> derive_stock(std::shared_ptr<const lsystem::Program> program, std::uint64_t seed,
                           const lsystem::Inputs& inputs, const Limits& limits);

// The seed of the second bunch of a specimen.
std::uint64_t second_seed(std::uint64_t seed);

// Walks the derived string from p1 on. Returns what the interpretation itself ran into.
Diagnostic interpret(const Stock& stock, const Limits& limits, lsystem::Listener& listener);

// A note for each thing that the text says and nothing heeds, and for each constant that a parameter sets, that the
// procedure's own grammar has and this text has not.
void note_remarks(const lsystem::Program& program, int built_in, const Values& values, const Limits& limits,
                  std::vector<std::string>& notes);

}  // namespace panicle::bunch
