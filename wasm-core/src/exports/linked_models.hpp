// The models that a module is linked with.
#pragma once

#include <span>

#include "protocol/model.hpp"

namespace panicle {

// Defined by the linked models: one in each .wasm, all of them natively.
std::span<const Model* const> linked_models();

}  // namespace panicle
