#include "models/bunch/natural/natural_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "models/bunch/fruit/berry_body.hpp"
#include "models/bunch/shape.hpp"

namespace panicle::bunch {
namespace {

constexpr float units_per_pixel = 50.0f / 29.0f;  // bunch-model: one rachis segment is 29 pixels and l_i 50 units
constexpr float standard_aim = 60;                // α_y
constexpr float most_upward = 100;                // degrees from straight down
constexpr float flowers_per_end = 3;
constexpr float least_arm = 0.4f;  // of a first-order axis, in its steps
// Flowers for each berry there is to be, at least: more to choose from than are needed, as in nature.
constexpr float flowers_per_berry = 1.1f;
constexpr float most_flowers = 10000;
constexpr float least_nodes = 12;    // of a rachis: three axes to each side, however short it is
constexpr float tip_spacing = 0.6f;  // of the rachis's nodes at its tip, over that above; `near` of L-system 4
constexpr float tip_share = 0.4f;    // of the rachis over which they draw together; `tip` of L-system 4
constexpr float base_closer = 0.7f;
constexpr float middling_size = 18;
constexpr float middling_fill = 0.6f;

// How far along `angle` from a node at `depth` the outline of a side lies.
float reach(const Envelope& envelope, std::size_t side, float depth, float angle) {
  const SinCos way = sincos_degrees(angle);
  const auto inside = [&](float t) { return envelope.half_width(side, depth + t * way.cosine) > t * way.sine; };
  constexpr int probes = 48, halvings = 14;
  const float far = envelope.length() + 300;
  float high = 0;
  for (int k = probes; k > 0 && high <= 0; --k) {
    const float t = far * static_cast<float>(k * k) / (probes * probes);
    if (inside(t)) high = far * static_cast<float>((k + 1) * (k + 1)) / (probes * probes);
    if (high > 0) {
      float low = t;
      for (int h = 0; h < halvings; ++h) {
        const float middle = (low + high) / 2;
        (inside(middle) ? low : high) = middle;
      }
      return low;
    }
  }
  return 0;
}

// The first axis of a side aims at its shoulder, however high that is; those below lean as the yaw says.
float aim_at(const Envelope& envelope, const Profile& profile, float pixel, std::size_t side, std::size_t turn,
             float depth, float left, float spacing) {
  const float far = reach(envelope, side, depth, standard_aim);
  const SinCos way = sincos_degrees(standard_aim);
  const float out = far * way.sine, low = far * way.cosine;
  const float shoulder = std::max(profile.sides[side].drop * pixel * 0.8f - depth, -0.18f * out);
  float weight = 1;
  for (std::size_t k = 0; k < turn; ++k) weight *= 0.4f;
  const float down = low + weight * (std::min(low, shoulder) - low);
  const float angle = out > 0 ? std::min(most_upward, arc_tangent(out, down) * (180 / pi)) : standard_aim;
  // The last axes hang down to the tip.
  return angle * std::clamp(0.35f + 0.65f * left / (3 * spacing), 0.35f, 1.0f);
}

// Lays the axes for the spacings in `plan`; returns how many flowers they bear, an axis counting by how much of it
// there is.
float lay_axes(NaturalPlan& plan, const Profile& profile, float pixel, float size, float elongation) {
  plan.arm.clear();
  plan.aim.clear();
  float flowers = 0;
  const float end = plan.twig + plan.stalk + 0.75f * size * std::max(1.0f, elongation);
  float left = plan.length, apart = plan.spacing;
  for (std::size_t k = 0;; ++k) {
    // The text reckons the same; a node beyond the last is there for its rounding.
    const float share = std::clamp(left / apart, 0.0f, 1.0f);
    const float depth = plan.length - left + share * apart;
    left -= apart;
    apart = plan.spacing * std::min(1.0f, tip_spacing + (1 - tip_spacing) * left / (tip_share * plan.length));
    const std::size_t side = k % 4;
    const float angle = aim_at(plan.envelope, profile, pixel, side, k / 4, depth, plan.length - depth, plan.spacing);
    plan.aim.push_back(angle);
    const bool raceme = plan.plan.sides[side].n == 0;
    const float arm = raceme ? -1 : std::max(least_arm * plan.step, reach(plan.envelope, side, depth, angle) - end);
    plan.arm.push_back(arm);
    flowers += share * (raceme ? 1 : flowers_per_end * std::max(1.0f, arm / plan.step));
    if (share <= 0) return flowers;
  }
}

}  // namespace

float fill_of(float density) {
  // Loose bunches leave three quarters of their outline to air, the densest pack as spheres at random do (0.64).
  constexpr float fills[] = {0.16f, 0.24f, 0.33f, 0.42f, 0.52f, 0.62f, 0.72f, 0.84f, 1.0f};
  const float place = std::clamp(density - 1, 0.0f, 7.999f);
  const auto below = static_cast<std::size_t>(place);
  return fills[below] + (fills[below + 1] - fills[below]) * (place - static_cast<float>(below));
}

NaturalPlan make_natural_plan(const Profile& drawn, const Values& values, float most_berries) {
  using enum Parameter;
  const float pixel = values[unit] * units_per_pixel;
  const float width = values[Parameter::size];
  Profile profile = drawn;
  for (SidePoint& side : profile.sides) side.width = std::max(side.width, width / 2 / pixel);
  const float end_reach = sincos_degrees(standard_aim).sine * (0.35f * width + values[pedicel]) + width;
  Plan counts = make_plan(drawn);
  Envelope envelope(profile, pixel, end_reach);
  NaturalPlan plan{std::move(counts), envelope, 0, 0, 0, 0, 0, 0, 0, {}, {}, 0, 0, false};
  plan.twig = 0.35f * width;
  plan.stalk = values[pedicel];
  plan.girth = values[wi] / 15 * std::clamp(0.2f * width, 1.2f, 7.0f);
  plan.fine = values[wi] / 15 * std::clamp(0.07f * width, 0.4f, 3.0f);
  plan.length = std::max(0.3f * envelope.length(), envelope.length() - plan.twig - plan.stalk - 0.9f * width);

  const float spread_share = values[spread] / 100;
  const float berry = pi / 6 * width * width * width * values[elongation] * (1 + 3 * spread_share * spread_share);
  // A raceme's berries hang outside what is drawn.
  const bool raceme =
      std::any_of(plan.plan.sides.begin(), plan.plan.sides.end(), [](const SidePlan& side) { return side.n == 0; });
  plan.room = raceme ? most_berries : std::max(12.0f, 1.2f * envelope.volume() / berry);
  const bool asked = values[Parameter::count] > 0;
  const float filling = std::max(1.0f, fill_of(values[density]) * envelope.volume() / berry);
  plan.overfull = !asked && filling > most_berries;
  plan.berries = std::min(asked ? values[Parameter::count] : filling, most_berries);
  // Nodes as near as berries of that size and density want them in a bunch of middling width, whatever the profile, so
  // that dragging moves no node; nearer by steps where that bears too few flowers for a count.
  const float fill = asked ? middling_fill : fill_of(values[density]);
  float closer = std::clamp(base_closer * std::sqrt(width / middling_size * middling_fill / fill), 0.2f, 1.4f);
  closer *= std::sqrt(std::max(1.0f, filling / most_berries));
  for (int tries = 0; tries < 16; ++tries) {
    plan.step = closer * 0.55f * width;
    plan.spacing = std::min(plan.step, plan.length / least_nodes);
    const float flowers = lay_axes(plan, profile, pixel, width, values[elongation]);
    if (!(asked || plan.overfull) || flowers >= flowers_per_berry * plan.berries || flowers > most_flowers) break;
    closer *= 0.85f;
  }
  return plan;
}

lsystem::Inputs inputs_for(const NaturalPlan& plan, const Profile& profile, const Values& values) {
  lsystem::Inputs inputs = inputs_for(Shape{plan.plan, make_fit(profile, plan.plan, 1)}, values);
  const float units = 1 / values[Parameter::unit];
  const auto give = [&](const char* name, float value) { inputs.scalars.push_back({name, value}); };
  give("length", plan.length * units);
  give("spacing", plan.spacing * units);
  give("step", plan.step * units);
  give("twig", plan.twig * units);
  give("stalk", plan.stalk * units);
  give("girth", plan.girth * units);
  give("fine", plan.fine * units);
  lsystem::Inputs::Array arms{"arm", {}}, aims{"aim", plan.aim};
  for (const float arm : plan.arm) arms.values.push_back(arm * units);
  inputs.arrays.push_back(std::move(arms));
  inputs.arrays.push_back(std::move(aims));
  return inputs;
}

}  // namespace panicle::bunch
