#include "models/bunch/plan.hpp"

#include <algorithm>

namespace panicle::bunch {

// The rachis is the main axis of the bunch.

namespace {

// The nearest integer; halves are rounded up. Arguments here are never negative, so truncation is the floor.
std::int32_t nearest(float x) { return static_cast<std::int32_t>(x + 0.5f); }

// The number n(s) of segments of axis `s`: the side's first axis, number `first`, is its longest; then the count falls
// linearly to one at its last axis rd.
std::int32_t segments_of_axis(const SidePlan& side, std::int32_t first, std::int32_t s) {
  if (s == first || side.n == 0) return side.n;
  const float span = static_cast<float>(std::max(1, side.rd - first));
  const float left = std::clamp(static_cast<float>(side.rd - s) / span, 0.0f, 1.0f);
  return std::max(1, nearest(static_cast<float>(side.n) * left));
}

}  // namespace

// The counts of the paper's bunch for an outline: m segments of the rachis (`m`, or as the length requires if 0), and
// the segments of its m − 1 axes, which go round the four sides.
Plan make_plan(const Profile& profile, std::int32_t m) {
  Plan plan;
  plan.m = m > 0 ? m : std::max(1, nearest(profile.length / pixels_per_rachis_segment));
  for (std::int32_t i = 0; i < 4; ++i) {
    SidePlan& side = plan.sides[i];
    side.point = profile.sides[i];
    side.n = nearest(side.point.width / pixels_per_axis_segment);
    side.rd = std::min(nearest(side.point.drop * axes_per_pixel_of_drop) + i, plan.m - 1);
  }
  plan.axes.resize(plan.m - 1);
  for (std::int32_t s = 0; s < plan.m - 1; ++s) plan.axes[s] = segments_of_axis(plan.sides[s % 4], s % 4, s);
  return plan;
}

// The profile, of that factor the size.
Profile scaled(const Profile& profile, float factor) {
  Profile smaller = profile;
  smaller.length *= factor;
  for (SidePoint& side : smaller.sides) side = {side.width * factor, side.drop * factor};
  return smaller;
}

// The factors by which segments are stretched so that whole numbers of them reach the outline; `amount`: 0 none … 1
// exactly.
Fit make_fit(const Profile& profile, const Plan& plan, float amount) {
  const auto towards = [amount](float target) { return 1 + (target - 1) * amount; };
  Fit fit;
  fit.rachis = towards(profile.length / (pixels_per_rachis_segment * static_cast<float>(plan.m)));
  for (std::size_t i = 0; i < 4; ++i) {
    const SidePlan& side = plan.sides[i];
    const float segments = side.point.width / pixels_per_axis_segment;
    // A side without segments is a raceme of single pedicels: half a pedicel long at width 0, a whole one where the
    // first segment appears.
    fit.sides[i] = towards(side.n > 0 ? segments / static_cast<float>(side.n) : 0.5f + segments);
  }
  return fit;
}

}  // namespace panicle::bunch
