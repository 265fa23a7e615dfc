#include "models/bunch/shape.hpp"

#include <utility>

#include "models/bunch/messages.generated.hpp"

namespace panicle::bunch {
namespace {

constexpr std::int32_t max_segments = 10000;  // of one axis, requested in place of the profile's

// The shape with the counts that a request gives in place of those of the profile.
Result<Shape> requested_shape(const BunchRequest& request, const Profile& profile) {
  if (request.m < 0 || request.m > max_segments) return bad_input(message(messages::bunch::m_out_of_range));
  Shape shape{make_plan(profile, request.m), {}};
  if (request.n.empty()) return shape;
  const std::size_t axes = shape.plan.axes.size();
  if (request.n.size() != axes) return bad_input(message(messages::bunch::n_count, axes, request.n.size()));
  for (std::size_t k = 0; k < axes; ++k) {
    if (request.n[k] < 0 || request.n[k] > max_segments) return bad_input(message(messages::bunch::n_out_of_range));
    shape.plan.axes[axes - 1 - k] = request.n[k];
  }
  return shape;
}

}  // namespace

// The shape, counts and stretching factors, of a bunch that fits a profile.
Shape shape_of(const Profile& profile, float fit_amount) {
  Plan plan = make_plan(profile);
  const Fit lengths = make_fit(profile, plan, fit_amount);
  return {std::move(plan), lengths};
}

// The shape with the counts of the request, if there are any, or of the profile.
Result<Shape> shape_for(const BunchRequest& request, const Profile& profile, float fit_amount) {
  const bool has_segments = request.m != 0 || !request.n.empty();
  return has_segments ? requested_shape(request, profile) : Result<Shape>(shape_of(profile, fit_amount));
}

// Collects the inputs of the paper's grammars from a shape: m, n, and the factors `stretch` and `reach`. The paper
// counts axes from the tip, n_k = n(m − 1 − k).
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
