#include "models/bunch/communication.hpp"

#include "models/bunch/messages.generated.hpp"

namespace panicle::bunch {

// Where a query module ?E has its parameters, by their number: type, θ, length for three; type, θ, φ, length, width for
// five; the berry's radius is the sixth. Returns false for any other number.
bool slots_for(std::size_t arity, ParameterSlots& slots) {
  switch (arity) {
    case 3:
      slots = {1, 0, 2, 0, 0};
      return true;
    case 5:
      slots = {1, 2, 3, 4, 0};
      return true;
    case 6:
      slots = {1, 2, 3, 4, 5};
      return true;
    default:
      return false;
  }
}

// The error for a query with another number of parameters.
Diagnostic wrong_arity() { return bad_input(message(messages::bunch::query_arity)); }

}  // namespace panicle::bunch
