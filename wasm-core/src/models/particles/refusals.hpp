// Messages of requests with too much work: the amount, and a smaller alternative.
#pragma once

#include <cstddef>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"

namespace panicle::particles {

// The error for a plant with more segments or leaves than allowed; reason none if it has not.
Diagnostic too_many_parts(const Limits& limits, std::size_t segments, std::size_t leaves);

// The error for particles that are still on their way after the limit of moves.
Diagnostic still_running(const Limits& limits);

}  // namespace panicle::particles
