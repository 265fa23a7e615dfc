#include "models/bunch/communication.hpp"

#include "foundation/random.hpp"

namespace panicle::bunch {

bool slots_for(std::size_t arity, Slots& slots) {
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

bool is_rachis(std::string_view symbol) { return symbol.substr(0, 2) == "Ar"; }

Kind kind_of(std::string_view symbol, bool pedicel) {
  if (pedicel || symbol == "Ap") return Kind::pedicel;
  if (is_rachis(symbol)) return Kind::rachis;
  if (symbol == "Ae") return Kind::end;
  return Kind::axis;
}

std::int32_t axis_of(const Internode& internode, std::span<const Internode> earlier,
                     std::span<const std::int32_t> rachis_depth, std::int32_t first_axis,
                     const lsystem::Lineage& lineage) {
  if (internode.parent < 0 || internode.kind == Kind::rachis) return -1;
  const Internode& parent = earlier[static_cast<std::size_t>(internode.parent)];
  if (parent.kind != Kind::rachis) return parent.axis;
  if (internode.kind == Kind::end && is_rachis(lineage.grandparent)) return -1;
  return first_axis + rachis_depth[static_cast<std::size_t>(internode.parent)] - 1;
}

std::uint32_t berry_id(std::uint64_t address, bool second) {
  return static_cast<std::uint32_t>((second ? hash_combine(address, 2) : address) >> 34);
}

}  // namespace panicle::bunch
