// The paper's procedure: every berry looks for room at its full size, and withers without room (Huang et al. 2013,
// section 4.3).
#pragma once

#include "models/bunch/bunch.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

// Fills plans, skeleton, berries, cuts and notes of `grown`. Reason none if all went well.
Diagnostic grow_paper(const BunchRequest& request, const Values& values, const Limits& limits, GrownBunch& grown);

}  // namespace panicle::bunch
