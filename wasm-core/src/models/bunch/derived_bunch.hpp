// One bunch of the specimen, derived and ready to be interpreted.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/stance.hpp"

namespace panicle::bunch {

struct DerivedBunch {
  std::shared_ptr<const lsystem::BoundProgram> bound;
  std::shared_ptr<const lsystem::String> string;
  std::uint64_t seed = 0;
  std::int32_t first_axis = 0;
  Stance stance;  // of the whole bunch; in the grammar's unit
};

// The grammar that every bunch of a request is derived from: the request's program, or its text compiled now;
// `built_in` where the request has none.
Result<std::shared_ptr<const lsystem::Program>> program_for(const BunchRequest& request, std::string_view built_in,
                                                            const Limits& limits);

// `steps` as for lsystem::develop.
Result<DerivedBunch> derive_bunch(std::shared_ptr<const lsystem::BoundProgram> bound, std::uint64_t seed,
                                  std::optional<std::uint32_t> steps, const Limits& limits);

// The seed of the second bunch of a specimen.
std::uint64_t second_seed(std::uint64_t seed);

// Traces the derivation, if the request has a `chronicle`. Errors: those of lsystem::trace_derivation.
Result<std::optional<lsystem::DerivationTrace>> trace_derivation(const DerivedBunch& derived_bunch,
                                                                 const BunchRequest& request, const Limits& limits);

// Walks the derived string from p1 on, and adds answers to `chronicle`, if not null. Returns the error of the
// interpretation itself.
Diagnostic interpret(const DerivedBunch& derived_bunch, const Limits& limits, lsystem::Listener& listener,
                     lsystem::DerivationTrace* trace = nullptr);

}  // namespace panicle::bunch
