// What the grammars of bunches and the model have agreed upon: the parameters of ?E and what the names of apices tell.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

// Where a communication module keeps what it says and hears. Three parameters are L-system 2's (type, θ, l), five are
// L-system 3's as printed (type, θ, φ, l, w), six carry the berry's radius b as well.
struct Slots {
  std::size_t theta = 1, phi = 0, length = 0, width = 0, berry = 0;  // 0: not carried
};

bool slots_for(std::size_t arity, Slots& slots);  // false for any other arity
Diagnostic wrong_arity();

// The apex symbols of the paper's grammars tell what an internode is.
bool is_rachis(std::string_view symbol);
Kind kind_of(std::string_view symbol, bool pedicel);

// A first-order axis is what leaves the rachis, but for the end structure in which the rachis itself ends. It has the
// number of the rachis internode whose tip it leaves. `rachis_depth` counts, per internode, the rachis internodes down
// to it; −1 for what is of no axis.
std::int32_t axis_of(const Internode& internode, std::span<const Internode> earlier,
                     std::span<const std::int32_t> rachis_depth, std::int32_t first_axis,
                     const lsystem::Lineage& lineage);

// Of the address of the module that bears the berry, in the first bunch or the second; links hold it in six letters.
std::uint32_t berry_id(std::uint64_t address, bool second);

}  // namespace panicle::bunch
