// What tells two flowers apart: their maps and where these stand, lobes and all. The segments and organs by which other
// plants are told leave out what stands beside a stem or a vein.
#pragma once

#include <cstdint>

#include "generalized_map/embedding.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

// Over each volume's label, order, parent and material, then each vertex's place (docs/fingerprint.md): what is glued
// shares vertices. The embedding is that of the volumes' own shapes, not of a skin's.
std::uint64_t fingerprint_of(const Derived& derived, const generalized_map::Embedding& embedding);

}  // namespace panicle::flower
