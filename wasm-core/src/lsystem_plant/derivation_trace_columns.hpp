// The derivation trace of a plant's text, as columns of the plant (docs/language.md).
//
// A request has the word `chronicle` among its outputs, and the blocks
//   chronicle_step     uint32: 0 is the axiom, which is the default; beyond the last: the last
//   chronicle_first    uint32: index of a module in that step's string; 0 by default
//   chronicle_count    uint32: how many from there on; at most TraceRequest::most, which is the default
//   chronicle_module   uint32: a module of the last string, whose ancestors are wanted
// and the plant has, a row for each module of the window but for the first two and the last,
//   chronicle.window       uint32 x 3: the traced step, the first traced module, and how many are traced
//   chronicle.counts       uint32 each step, the axiom first: modules of its string
//   chronicle.modules      text, one a line: as strings have it
//   chronicle.parent       uint32: the module of the step before that it came from; 0xffffffff in the axiom
//   chronicle.production   uint32 x 2: line and column of the production that wrote it in this step; 0 for none
//   chronicle.fires        uint32 x 2: of the one that rewrites it next, or draws it in place of a query
//   chronicle.refusals     text, one a line: the reasons why the other productions of its symbol do not rewrite it,
//                          separated by tabs: `3:1 the condition is false with x = 3`
//   chronicle.values       text, one a line: the values that one is applied with, `n=3 t=0.5`
//   chronicle.chance       float32 x 3: where it was drawn by weight: the sum of all weights, its own, where it fell
//   chronicle.children     uint32 x 2: first and count of its children in the next step
//   chronicle.last         uint32 x 2: of its descendants in the last string
//   chronicle.answers      text, one a line: query and response as `asked 1 0 → 1 3; why`, or for ?P and the like
//   `written 0 1 0` chronicle.trail        uint32 each step: the ancestor of chronicle_module; where there is such a
//   module
#pragma once

#include <optional>
#include <string>

#include "foundation/result.hpp"
#include "lsystem/trace/derivation_trace.hpp"
#include "plant/plant.hpp"
#include "protocol/request.hpp"

namespace panicle {

// Empty where the request has no `chronicle` output. Errors: bad_request, for a window that is too long.
Result<std::optional<lsystem::TraceRequest>> read_trace_request(Request& request);

// The note on a trace that was cut short though the plant was not: texts without a derivation length are unfolded, but
// traced in steps, which cost more.
std::string cut_short(const lsystem::DerivationTrace& trace);

void add_trace_columns(Plant& plant, const lsystem::DerivationTrace& trace);

}  // namespace panicle
