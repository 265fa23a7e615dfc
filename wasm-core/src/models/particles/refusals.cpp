#include "models/particles/refusals.hpp"

#include "models/particles/messages.generated.hpp"

namespace panicle::particles {

// The error for more segments or leaves than allowed; none within the limits.
Diagnostic too_many_parts(const Limits& limits, std::size_t segments, std::size_t leaves) {
  if (segments > limits.pieces)
    return {Reason::limit, message(messages::particles::too_many_pieces, segments, limits.pieces)};
  if (leaves > limits.copies)
    return {Reason::limit, message(messages::particles::too_many_leaves, leaves, limits.copies)};
  return {};
}

// The error for particles that have not arrived after the greatest number of steps.
Diagnostic still_running(const Limits& limits) {
  return {Reason::limit, message(messages::particles::still_moving, limits.moves)};
}

}  // namespace panicle::particles
