// The inputs of a bunch's grammar: counts, and how far its lengths stretch.
#pragma once

#include "foundation/result.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/plan.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

struct Shape {
  Plan plan;
  Fit fit;
};

Shape shape_of(const Profile& profile, float fit);

// The same for a request without segments of its own; requested segments replace the profile's, whose lengths then no
// longer apply. Errors: bad_input.
Result<Shape> shape_for(const BunchRequest& request, const Profile& profile, float fit);

// The inputs of the paper's texts: m, n, stretch and reach, and the values that replace their #defines.
lsystem::Inputs inputs_for(const Shape& shape, const Values& values);

}  // namespace panicle::bunch
