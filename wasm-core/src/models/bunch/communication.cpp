#include "models/bunch/communication.hpp"

namespace panicle::bunch {

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

Diagnostic wrong_arity() {
  return {Reason::bad_input,
          "The bunch answers ?E with 3, 5 or 6 parameters: (type, theta, l), "
          "(type, theta, phi, l, w) or (type, theta, phi, l, w, b).",
          0, 0};
}

}  // namespace panicle::bunch
