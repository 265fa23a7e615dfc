// Interpretation functions that derivations call.
#pragma once

#include "lsystem/lsystem.hpp"

namespace panicle::lsystem {

// Interprets the string as `interpret` does, but writes each response into the parameters of its ?E and draws nothing
// in its place. Errors as for `interpret`; Reason::none without an error.
Diagnostic write_responses(const BoundProgram& bound, String& string, const Turtle& start, Listener& listener,
                           std::uint64_t seed, const Limits& limits, const Space* space);

// Interprets the string and writes the turtle's position and axes into ?P, ?H, ?L and ?U, without events to a listener.
// Errors as there.
Diagnostic locate(const BoundProgram& bound, String& string, const Turtle& start, std::uint64_t seed,
                  const Limits& limits, const Space* space);

}  // namespace panicle::lsystem
