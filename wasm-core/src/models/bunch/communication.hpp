// The parameters of ?E, the communication module: the interface between the grammars of bunches and the model.
#pragma once

#include <cstddef>

#include "foundation/result.hpp"

namespace panicle::bunch {

// Places of the parameters in a communication module; the first parameter is its type. Three parameters are L-system
// 2's (type, θ, l), five are L-system 3's as printed (type, θ, φ, l, w), six carry the berry's radius b as well.
struct ParameterSlots {
  std::size_t theta = 1, phi = 0, length = 0, width = 0, berry = 0;  // 0: not carried
};

inline constexpr float pedicel_type = 1;  // of ?E; 0 is any other internode

bool slots_for(std::size_t arity, ParameterSlots& slots);  // false for any other arity
Diagnostic wrong_arity();

}  // namespace panicle::bunch
