// The inputs of a bunch's grammar: counts, and how far its lengths stretch.
#pragma once

#include "foundation/result.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/plan.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

// The plan of a bunch, and how far its lengths stretch to meet the profile.
struct Shape {
  Plan plan;
  Fit fit;
};

// The plan of a profile. `fit_amount`: how far lengths stretch to meet the profile, 0 … 1 (make_fit).
Shape shape_of(const Profile& profile, float fit_amount);

// The same for a request without segments of its own; requested segments replace the profile's, whose lengths then no
// longer apply. Errors: bad_input.
Result<Shape> shape_for(const BunchRequest& request, const Profile& profile, float fit_amount);

// The inputs of the paper's texts: m, n, stretch and reach, and the values that replace their #defines.
lsystem::Inputs inputs_for(const Shape& shape, const Values& values);

}  // namespace panicle::bunch
