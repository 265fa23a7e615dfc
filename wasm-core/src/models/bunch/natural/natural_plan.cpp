#include "models/bunch/natural/natural_plan.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "models/bunch/natural/settling/sagging.hpp"
#include "models/bunch/shape.hpp"
#include "models/bunch/units.hpp"

namespace panicle::bunch {
namespace {

constexpr float most_upward = 100;         // degrees from straight down
constexpr std::size_t most_nodes = 4096;   // of a rachis: limits texts, for each node takes a step to derive
constexpr float least_arm = 0.4f;          // of a first-order axis, in its steps
constexpr float flowers_per_berry = 1.2f;  // at least: more flowers than berries, as in nature
constexpr float most_flowers = 10000;
constexpr float least_nodes = 16;         // of a rachis, however short it is
constexpr float step_of_axis = 0.55f;     // between its nodes, in berry widths, where berries are middling
constexpr float stride_over_step = 1.5f;  // of second-order axes
constexpr float base_closer = 0.7f;       // times that
constexpr float middling_size = 18;
constexpr float middling_fill = 0.6f;
constexpr float least_closer = 0.2f, most_closer = 1.4f;
constexpr float closer_by = 0.85f;  // a try, where a count needs more flowers
constexpr int most_tries = 16;

// Lengths in berry widths.
constexpr float twig_length = 0.35f;
constexpr float berry_beyond = 0.75f;  // of a berry, inside the outline where an axis ends
constexpr float berry_below = 0.9f;    // likewise below the rachis
constexpr float rachis_width = 0.2f, pedicel_width = 0.07f;
constexpr float standard_width = 15;  // w_i of the table

// Shape of the axes' aims.
constexpr float shoulder_height = 0.8f;  // of a side's drop: where its first axis points
constexpr float most_above = 0.4f;       // height above its node of the aim, over the distance to it
constexpr float shoulder_fades = 0.4f;   // from one axis of a side to the next
constexpr float towards_handles = 7;     // degrees by which axes midway between handles are turned towards their planes
constexpr float hanging = 0.35f;         // of its angle left to an axis at the tip
constexpr float hanging_nodes = 3;       // from the tip on which axes hang

constexpr float drawn_in = 1.5f;      // a second-order axis, by how far the berry at its end would be outside
constexpr float least_length = 0.3f;  // of the rachis, over the outline's
// upper bound of the number of berries, over those that the outline's volume holds
constexpr float room_over_volume = 1.2f;
constexpr float least_room = 12;

// The extent of the twig and berry that hang from the end of an axis.
struct Hung {
  float out = 0, down = 0;
};

// Distance along `angle` from a node at `depth` to the outline, that way round; or, of an axis, how far it may go for
// the parts that hang from its end to be inside.
float reach(const Envelope& envelope, const Azimuth& round, float depth, float angle, const Hung& hung = {}) {
  const SinCos way = sincos_degrees(angle);
  const auto inside = [&](float t) {
    return envelope.radius(round, depth + hung.down + t * way.cosine) > hung.out + t * way.sine;
  };
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

// The first axes aim at the height of the shoulders, and higher by half of the length that hangs from them; those below
// lean by the yaw.
float aim_at(const Envelope& envelope, float shoulder_depth, float yaw, const Azimuth& round, std::size_t turn,
             float depth, float left, float spacing, float hung) {
  const float far = reach(envelope, round, depth, yaw);
  const SinCos way = sincos_degrees(yaw);
  const float out = far * way.sine, low = far * way.cosine;
  const float shoulder = std::max(shoulder_depth - depth - 0.5f * hung, -most_above * out);
  float weight = 1;
  for (std::size_t k = 0; k < turn; ++k) weight *= shoulder_fades;
  const float down = low + weight * (std::min(low, shoulder) - low);
  const float angle = out > 0 ? std::min(most_upward, arc_tangent(out, down) * (180 / pi)) : yaw;
  // The last axes hang down to the tip.
  return angle * std::clamp(hanging + (1 - hanging) * left / (hanging_nodes * spacing), hanging, 1.0f);
}

// The azimuth of an axis whose azimuth would be `degrees` if all sides were alike: nearer to wide sides, and to the
// planes of the handles, so that the bunch reaches them.
float way_round(const Profile& profile, float degrees) {
  const Azimuth even = azimuth_of(degrees);
  const SinCos way = sincos_degrees(degrees);
  const float across = std::sqrt(profile.sides[even.across].width), along = std::sqrt(profile.sides[even.along].width);
  const float round = arc_tangent(along * way.sine, across * way.cosine) * (180 / pi);
  return round - towards_handles * sincos_degrees(4 * round).sine;
}

// The parts beyond the end of an axis, `end` millimetres of it straight on: a twig, and a pedicel with most of its
// berry, which hang.
Hung hung_from(const NaturalPlan& plan, float angle, float end) {
  const SinCos way = sincos_degrees(angle);
  const glm::vec3 hangs = drooping({way.sine, -way.cosine, 0}, 1);
  const float rest = end - plan.twig;
  return {plan.twig * way.sine + rest * hangs.x, plan.twig * way.cosine - rest * hangs.y};
}

// A first-order axis, at the rachis; degrees and millimetres.
struct Axis {
  Azimuth round;
  float way = 0, depth = 0, angle = 0, length = 0;
};

// How far beyond its twig, `most` at most, the j-th end structure of an axis may go on for the parts that hang from its
// end to be inside the outline: less by a multiple of the excess, because the place where a line leaves the outline
// moves far with a pixel. Each end structure is rolled a quarter further than the one before, as in the text.
float room_at(const NaturalPlan& plan, const Axis& axis, std::size_t j, float most, float end, float yaw) {
  const float along = plan.step * static_cast<float>(j + 1);
  const SinCos aim = sincos_degrees(axis.angle), way = sincos_degrees(axis.way), off = sincos_degrees(yaw);
  // Directions of end structures: out from the rachis, round it as it is rolled, and down.
  constexpr SinCos quarters[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
  const SinCos turn = quarters[j % 4];
  if (turn.cosine < 0) return 0;  // the axes below take that room
  const glm::vec3 out(way.cosine, 0, -way.sine), round(-way.sine, 0, -way.cosine), down(0, -1, 0);
  const glm::vec3 ahead = aim.sine * out + aim.cosine * down, lifted = aim.cosine * out - aim.sine * down;
  const glm::vec3 heading = off.cosine * ahead + off.sine * (turn.cosine * lifted + turn.sine * round);
  const glm::vec3 foot = axis.depth * down + along * ahead;
  const glm::vec3 at = foot + (2 * plan.twig + most) * heading + (end - plan.twig) * drooping(heading, 1);
  const float far = std::sqrt(at.x * at.x + at.z * at.z), share = far > 0 ? 1 / far : 0;
  const Azimuth towards{at.x >= 0 ? 0u : 1u, at.z >= 0 ? 2u : 3u, std::abs(at.x) * share, std::abs(at.z) * share};
  return std::clamp(most + drawn_in * (plan.envelope.radius(towards, -at.y) - far), 0.0f, most);
}

// Finds how far second-order axes may go at an axis's nodes; returns the number of end structures on the axis, with
// theirs. A node beyond the last allows for the text's rounding.
float place_nodes(NaturalPlan& plan, const Axis& axis, float end, const TextConstants& text) {
  float ends = std::max(1.0f, axis.length / plan.step);
  for (std::size_t j = 0;; ++j) {
    const float left = axis.length - plan.step * static_cast<float>(j + 1);
    const float most = text.lateral * left - plan.stride;
    // stop there: more nodes have too many flowers
    const bool grows = static_cast<float>(plan.beyond.size()) < most_flowers;
    const float beyond = most > 0 && grows ? room_at(plan, axis, j, most, end, text.yaw) : 0;
    plan.beyond.push_back(beyond);
    ends += beyond / plan.stride;
    if (left <= -plan.step) return ends;
  }
}

// Places the axes for the spacings in `plan`; returns their number of flowers, an axis counting by the share of it that
// exists.
float place_axes(NaturalPlan& plan, const Profile& profile, float pixel, float end, const TextConstants& text,
                 float start) {
  plan.arm.clear();
  plan.aim.clear();
  plan.way.clear();
  plan.node.clear();
  plan.beyond.clear();
  float flowers = 0;
  float left = plan.length, apart = plan.spacing;
  for (std::size_t k = 0;; ++k) {
    // The text computes the same; a node beyond the last is there for its rounding.
    const float share = std::clamp(left / apart, 0.0f, 1.0f);
    const float depth = plan.length - left + share * apart;
    left -= apart;
    apart = plan.spacing *
            std::min(1.0f, text.tip_spacing + (1 - text.tip_spacing) * left / (text.tip_share * plan.length));
    const float way = way_round(profile, start + text.turn * static_cast<float>(k));
    plan.way.push_back(way);
    const Azimuth round = azimuth_of(way);
    const float drop = round.between([&](std::size_t side) { return profile.sides[side].drop; });
    const float shoulder = drop * pixel * shoulder_height;
    const float angle =
        aim_at(plan.envelope, shoulder, text.yaw, round, k / 4, depth, plan.length - depth, plan.spacing, end);
    plan.aim.push_back(angle);
    const bool raceme = plan.plan.sides[round.nearest()].n == 0;
    const float arm = raceme ? -1
                             : std::max(least_arm * plan.step,
                                        reach(plan.envelope, round, depth, angle, hung_from(plan, angle, end)));
    plan.arm.push_back(arm);
    plan.node.push_back(static_cast<float>(plan.beyond.size() + 1));
    const float ends = place_nodes(plan, {round, way, depth, angle, arm}, end, text);
    flowers += share * (raceme ? 1 : text.flowers_per_end * ends);
    if (share <= 0 || !(apart > 0) || k + 1 == most_nodes) return flowers;
  }
}

// An array that repeats its last turn about the rachis.
lsystem::Inputs::Array prolonged(const char* name, std::vector<float> values) {
  values.reserve(most_nodes);
  while (values.size() < most_nodes) values.push_back(values.size() < 4 ? values.back() : values[values.size() - 4]);
  return {name, std::move(values)};
}

}  // namespace

float fill_of(float density) {
  // The share of the outline that berries take before any is lost: the densest bunches keep two thirds of it, as
  // spheres packed at random do.
  constexpr float fills[] = {0.13f, 0.19f, 0.25f, 0.31f, 0.38f, 0.48f, 0.62f, 0.84f, 1.0f};
  const float place = std::clamp(density - 1, 0.0f, 7.999f);
  const auto below = static_cast<std::size_t>(place);
  return fills[below] + (fills[below + 1] - fills[below]) * (place - static_cast<float>(below));
}

TextConstants constants_of(const lsystem::BoundProgram& text, const TextConstants& before) {
  const TextConstants standard;
  TextConstants found = before;
  found.tip_spacing = lsystem::constant(text, "near", standard.tip_spacing);
  found.tip_share = lsystem::constant(text, "tip", standard.tip_share);
  found.lateral = lsystem::constant(text, "lateral", standard.lateral);
  found.turn = std::fmod(lsystem::constant(text, "turn", standard.turn), 360.0f);
  found.yaw = std::min(std::abs(lsystem::constant(text, "alpha_y", standard.yaw)), most_upward);
  return found;
}

NaturalPlan make_natural_plan(const Profile& drawn, const Values& values, float most_berries, const TextConstants& text,
                              float start) {
  using enum Parameter;
  const float pixel = values[unit] * units_per_pixel;
  const float width = values[Parameter::size];
  Profile profile = drawn;
  for (SidePoint& side : profile.sides) side.width = std::max(side.width, width / 2 / pixel);
  const float end_reach = sincos_degrees(text.yaw).sine * (twig_length * width + values[pedicel]) + width;
  Plan counts = make_plan(drawn);
  Envelope envelope(profile, pixel, end_reach);
  NaturalPlan plan{std::move(counts), envelope, 0, 0, 0, 0, 0, 0, 0, 0, {}, {}, {}, {}, {}, 0, 0, 0, false};
  plan.twig = twig_length * width;
  plan.stalk = values[pedicel];
  plan.girth = values[wi] / standard_width * std::clamp(rachis_width * width, 1.2f, 7.0f);
  plan.fine = values[wi] / standard_width * std::clamp(pedicel_width * width, 0.4f, 3.0f);
  plan.length =
      std::max(least_length * envelope.length(), envelope.length() - plan.twig - plan.stalk - berry_below * width);

  const float spread_share = values[spread] / 100;
  const float berry = pi / 6 * width * width * width * values[elongation] * (1 + 3 * spread_share * spread_share);
  plan.berry = berry;
  // A raceme's berries hang outside the lines of the profile.
  const bool raceme =
      std::any_of(plan.plan.sides.begin(), plan.plan.sides.end(), [](const SidePlan& side) { return side.n == 0; });
  plan.room = raceme ? most_berries : std::max(least_room, room_over_volume * envelope.volume() / berry);
  const bool is_count_requested = values[Parameter::count] > 0;
  const float filling = std::max(1.0f, fill_of(values[density]) * envelope.volume() / berry);
  plan.overfull = !is_count_requested && filling > most_berries;
  plan.berries = std::min(is_count_requested ? values[Parameter::count] : filling, most_berries);
  // Nodes are spaced for berries of that size and density in a bunch of middling width, independent of the profile, so
  // that dragging moves no node; spacing shrinks in steps where it gives too few flowers for a count.
  const float fill = is_count_requested ? middling_fill : fill_of(values[density]);
  float closer =
      std::clamp(base_closer * std::sqrt(width / middling_size * middling_fill / fill), least_closer, most_closer);
  closer *= std::sqrt(std::max(1.0f, filling / most_berries)) * text.wider;
  const float end = plan.twig + plan.stalk + berry_beyond * width * std::max(1.0f, values[elongation]);
  for (int tries = 0; tries < most_tries; ++tries) {
    plan.step = closer * step_of_axis * width;
    plan.stride = stride_over_step * plan.step;
    plan.spacing = std::min(plan.step, plan.length / least_nodes);
    const float flowers = place_axes(plan, profile, pixel, end, text, start);
    if (!(is_count_requested || plan.overfull) || flowers >= flowers_per_berry * plan.berries || flowers > most_flowers)
      break;
    closer *= closer_by;
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
  give("stride", plan.stride * units);
  give("twig", plan.twig * units);
  give("stalk", plan.stalk * units);
  give("girth", plan.girth * units);
  give("fine", plan.fine * units);
  std::vector<float> arms;
  for (const float arm : plan.arm) arms.push_back(arm * units);
  inputs.arrays.push_back(prolonged("arm", std::move(arms)));
  inputs.arrays.push_back(prolonged("way", plan.way));
  inputs.arrays.push_back(prolonged("aim", plan.aim));
  inputs.arrays.push_back(prolonged("node", plan.node));
  std::vector<float> beyonds;
  for (const float far : plan.beyond) beyonds.push_back(far * units);
  beyonds.resize(beyonds.size() + most_nodes, 0);
  inputs.arrays.push_back({"beyond", std::move(beyonds)});
  return inputs;
}

}  // namespace panicle::bunch
