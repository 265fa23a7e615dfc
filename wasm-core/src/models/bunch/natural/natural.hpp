// The natural procedure: every pedicel starts with a flower, some set, and their berries swell against each other.
#pragma once

#include "models/bunch/bunch.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

// Fills all of `grown` but counts, fingerprints and the stems' mesh. Reason none if all went well.
Diagnostic grow_natural(const BunchRequest& request, const Values& values, const Limits& limits, GrownBunch& grown);

}  // namespace panicle::bunch
