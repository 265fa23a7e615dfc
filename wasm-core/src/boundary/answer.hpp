// A plant, a compiled grammar, or the reason why there is none, as the block that crosses the border (panicle.h).
#pragma once

#include <cstdint>

#include "foundation/result.hpp"
#include "plant/plant.hpp"

namespace panicle::boundary {

// Blocks from malloc; null when memory is out.
std::uint8_t* write_plant(const Plant& plant);
std::uint8_t* write_program(std::uint32_t handle);
std::uint8_t* write_failure(const Diagnostic& diagnostic);

}  // namespace panicle::boundary
