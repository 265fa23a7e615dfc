// Messages of requests with too much work: the amount, and a smaller alternative.
#pragma once

#include <cstddef>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"

namespace panicle::particles {

// Of a plant that has more pieces of trail or more leaves than there may be; reason none if it has not.
Diagnostic beyond(const Limits& limits, std::size_t segments, std::size_t leaves);

// Of particles that are still on their way after all the moves that they may make.
Diagnostic still_running(const Limits& limits);

}  // namespace panicle::particles
