// The fingerprint of a flower: of its map and its vertices. Other plants' fingerprints of segments and organs would
// ignore the volumes beside a stem or a vein.
#pragma once

#include <cstdint>

#include "generalized_map/embedding.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Hashes each volume's label, order, parent and material, then each vertex's place (docs/fingerprint.md); glued volumes
// share vertices. `embedding` is that of the volumes' own shapes, not of a skin's.
std::uint64_t fingerprint_of(const Derived& derived, const generalized_map::Embedding& embedding);

}  // namespace panicle::flower
