#include "models/particles/refusals.hpp"

#include <cstdint>
#include <string>

namespace panicle::particles {

Diagnostic too_many_parts(const Limits& limits, std::size_t segments, std::size_t leaves) {
  const auto refused = [](std::size_t count, const char* what, std::uint32_t limit, const char* fewer) {
    return Diagnostic{Reason::limit,
                      "The plant would have " + std::to_string(count) + " " + what + ", more than " +
                          std::to_string(limit) + "; ask for fewer " + fewer + ".",
                      0, 0};
  };
  if (segments > limits.pieces) return refused(segments, "pieces of trail", limits.pieces, "particles");
  if (leaves > limits.copies) return refused(leaves, "leaves", limits.copies, "particles or leaves a tip");
  return {};
}

Diagnostic still_running(const Limits& limits) {
  return {Reason::limit,
          "After " + std::to_string(limits.moves) +
              " moves particles are still on their way; ask for fewer particles, a longer step, or a wider merge.",
          0, 0};
}

}  // namespace panicle::particles
