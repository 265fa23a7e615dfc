// Wood that edits by hand leave bare: dead segments, and the ends of cut and broken shoots.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"
#include "models/growth/form.hpp"
#include "models/growth/moment.hpp"

namespace panicle::growth {

// For each segment 1 where it is dead: of dead shoots, and of broken ones after their last living branch. Empty where
// no segment is.
std::vector<std::uint8_t> dead_segments(const Moment& moment, const Form& form);

// The ends of cut shoots that have grown to their cut.
struct StubMeshes {
  Mesh cuts;       // saw cuts: smooth discs
  Mesh splinters;  // broken ends: rings of uneven splinters
};
StubMeshes stub_meshes(const Moment& moment, const Form& form, std::uint64_t seed);

}  // namespace panicle::growth
