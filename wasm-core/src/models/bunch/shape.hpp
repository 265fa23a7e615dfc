// What a bunch's grammar is given: how much of everything, and how far its lengths stretch.
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

// As above where the request asks for no segments of its own; those take the place of the profile's, whose lengths
// then no longer apply. Errors: bad_input.
Result<Shape> shape_for(const BunchRequest& request, const Profile& profile, float fit);

// The inputs of the paper's texts: m, n, stretch and reach, and what replaces their #defines.
lsystem::Inputs inputs_for(const Shape& shape, const Values& values);

}  // namespace panicle::bunch
