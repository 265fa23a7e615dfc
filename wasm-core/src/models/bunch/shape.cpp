#include "models/bunch/shape.hpp"

#include <string>
#include <utility>

namespace panicle::bunch {
namespace {

constexpr std::int32_t most_segments = 10000;  // of one axis, requested in place of the profile's

Result<Shape> requested_shape(const BunchRequest& request, const Profile& profile) {
  if (request.m < 0 || request.m > most_segments)
    return Diagnostic{Reason::bad_input, "m must be from 1 to 10000.", 0, 0};
  Shape shape{make_plan(profile, request.m), {}};
  if (request.n.empty()) return shape;
  const std::size_t axes = shape.plan.axes.size();
  if (request.n.size() != axes)
    return Diagnostic{Reason::bad_input,
                      "n needs m − 1 = " + std::to_string(axes) + " values, n1 first; it has " +
                          std::to_string(request.n.size()) + ".",
                      0, 0};
  for (std::size_t k = 0; k < axes; ++k) {
    if (request.n[k] < 0 || request.n[k] > most_segments)
      return Diagnostic{Reason::bad_input, "Every n must be from 0 to 10000.", 0, 0};
    shape.plan.axes[axes - 1 - k] = request.n[k];
  }
  return shape;
}

}  // namespace

Shape shape_of(const Profile& profile, float fit_amount) {
  Plan plan = make_plan(profile);
  const Fit lengths = make_fit(profile, plan, fit_amount);
  return {std::move(plan), lengths};
}

Result<Shape> shape_for(const BunchRequest& request, const Profile& profile, float fit_amount) {
  const bool has_segments = request.m != 0 || !request.n.empty();
  return has_segments ? requested_shape(request, profile) : Result<Shape>(shape_of(profile, fit_amount));
}

// The paper counts axes from the tip, n_k = n(m − 1 − k).
lsystem::Inputs inputs_for(const Shape& shape, const Values& values) {
  lsystem::Inputs inputs{values.defines(), {}};
  inputs.scalars.push_back({"m", static_cast<float>(shape.plan.m)});
  inputs.scalars.push_back({"stretch", shape.fit.rachis});
  lsystem::Inputs::Array segments{"n", {}}, reach{"reach", {}};
  for (std::size_t k = shape.plan.axes.size(); k-- > 0;) {
    segments.values.push_back(static_cast<float>(shape.plan.axes[k]));
    reach.values.push_back(shape.fit.sides[k % 4] / shape.fit.rachis);
  }
  inputs.arrays = {std::move(segments), std::move(reach)};
  return inputs;
}

}  // namespace panicle::bunch
