// Fingerprints that identify a plant, for models without an order of their own.
#pragma once

#include <cstdint>

#include "plant/plant.hpp"

namespace panicle {

// Over segments and organs (docs/fingerprint.md).
std::uint64_t fingerprint_of(const Plant& plant);
// Over all meshes.
std::uint64_t mesh_fingerprint_of(const Plant& plant);
// Sets the plant's fingerprint, and with `of_meshes` that of its meshes: the last step of growing.
void set_fingerprints(Plant& plant, bool of_meshes);

}  // namespace panicle
