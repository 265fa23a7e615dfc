// Writes responses: a plant, a compiled grammar or an error as a block (panicle.h).
#pragma once

#include <cstdint>

#include "foundation/result.hpp"
#include "plant/plant.hpp"

namespace panicle {

// Blocks from malloc; null when memory is out. Segments and organs are added to the plant's columns. Where addresses
// have 32 bits, its large arrays stay where they are: the plant must outlive the block.
std::uint8_t* write_plant(Plant& plant);
std::uint8_t* write_program(std::uint32_t handle);
std::uint8_t* write_failure(const Diagnostic& diagnostic);

}  // namespace panicle
