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

// The rachis is the main axis of the bunch; a pedicel is the stalk of one flower or berry.

namespace {

constexpr float max_upward = 100;          // degrees from straight down
constexpr std::size_t max_nodes = 4096;    // of a rachis: limits texts, for each node takes a step to derive
constexpr float least_arm = 0.4f;          // length of a first-order axis, in spacings of its nodes
constexpr float flowers_per_berry = 1.2f;  // at least: more flowers than berries, as in nature
constexpr float max_flowers = 10000;
constexpr float least_nodes = 16;                  // of a rachis, however short it is
constexpr float usual_spacing = 0.55f;             // of the nodes of a first-order axis, in berry widths
constexpr float second_over_first_spacing = 1.5f;  // spacing on second-order axes, over that on first-order axes
constexpr float base_spacing_factor = 0.7f;        // of the usual spacing, for berries of middling size and density
constexpr float middling_size = 18;                // millimetres
constexpr float middling_fill = 0.6f;              // share of the outline's volume
constexpr float least_spacing_factor = 0.2f, max_spacing_factor = 1.4f;
constexpr float spacing_shrinks_by = 0.85f;  // factor at each try, where more flowers are needed
constexpr int max_tries = 16;

// Lengths in berry widths.
constexpr float twig_length = 0.35f;
constexpr float berry_beyond = 0.75f;  // of a berry, inside the outline where an axis ends
constexpr float berry_below = 0.9f;    // likewise below the rachis
constexpr float rachis_over_berry = 0.2f, pedicel_over_berry = 0.07f;  // widths
constexpr float standard_width = 15;                                   // w_i of the table

// Shape of the axes' aims.
constexpr float shoulder_height = 0.8f;  // of a side's drop: where its first axis points
constexpr float max_above = 0.4f;        // height above its node of the aim, over the distance to it
constexpr float shoulder_fades = 0.4f;   // from one axis of a side to the next
constexpr float towards_handles = 7;     // degrees by which axes midway between handles are turned towards their planes
constexpr float hanging = 0.35f;         // of its angle left to an axis at the tip
constexpr float hanging_nodes = 3;       // from the tip on which axes hang

constexpr float drawn_in = 1.5f;      // a second-order axis, by how far the berry at its end would be outside
constexpr float least_length = 0.3f;  // of the rachis, over the outline's
// upper bound of the number of berries, over those that the outline's volume holds
constexpr float room_over_volume = 1.2f;
constexpr float least_room = 12;

// How far the twig and berry that hang from the end of an axis extend: outward from the rachis and downward,
// millimetres.
struct Hung {
  float out = 0, down = 0;
};

// The distance, millimetres, from a node of the rachis at `depth` to the outline, along a ray `angle` degrees from
// straight down at the azimuth `round`. With `hung`: how far an axis may go for the parts that hang from its end to be
// inside.
// Probes from far to near find the outermost stretch inside, and halving its end.
float distance_to_outline(const Envelope& envelope, const Azimuth& round, float depth, float angle,
                          const Hung& hung = {}) {
  const SinCos direction = sincos_degrees(angle);
  const auto inside = [&](float t) {
    return envelope.radius(round, depth + hung.down + t * direction.cosine) > hung.out + t * direction.sine;
  };
  constexpr int probes = 48, halvings = 14;
  const float longest = envelope.length() + 300;
  float high = 0;
  for (int k = probes; k > 0 && high <= 0; --k) {
    const float t = longest * static_cast<float>(k * k) / (probes * probes);
    if (inside(t)) high = longest * static_cast<float>((k + 1) * (k + 1)) / (probes * probes);
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

// The angle of the axis at a node to the rachis, degrees. `turn` counts full rounds of axes from the top; `depth` is
// the node's depth and `left` the rachis below it, millimetres; `hung`: the length that hangs from an axis.
// The first axes aim at the height of the shoulders, and higher by half of `hung`; those below lean by the yaw.
float aim_at(const Envelope& envelope, float shoulder_depth, float yaw, const Azimuth& round, std::size_t turn,
             float depth, float left, float spacing, float hung) {
  const float distance = distance_to_outline(envelope, round, depth, yaw);
  const SinCos direction = sincos_degrees(yaw);
  const float out = distance * direction.sine, low = distance * direction.cosine;
  const float shoulder = std::max(shoulder_depth - depth - 0.5f * hung, -max_above * out);
  float weight = 1;
  for (std::size_t k = 0; k < turn; ++k) weight *= shoulder_fades;
  const float down = low + weight * (std::min(low, shoulder) - low);
  const float angle = out > 0 ? std::min(max_upward, arc_tangent(out, down) * (180 / pi)) : yaw;
  // The last axes hang down to the tip.
  return angle * std::clamp(hanging + (1 - hanging) * left / (hanging_nodes * spacing), hanging, 1.0f);
}

// The azimuth of an axis whose azimuth would be `degrees` if all sides were alike: nearer to wide sides, and to the
// planes of the handles, so that the bunch reaches them.
float way_round(const Profile& profile, float degrees) {
  const Azimuth even = azimuth_of(degrees);
  const SinCos direction = sincos_degrees(degrees);
  const float across = std::sqrt(profile.sides[even.across].width), along = std::sqrt(profile.sides[even.along].width);
  const float round = arc_tangent(along * direction.sine, across * direction.cosine) * (180 / pi);
  return round - towards_handles * sincos_degrees(4 * round).sine;
}

// The parts beyond the end of an axis, `end` millimetres of it straight on: a twig, and a pedicel with most of its
// berry, which hang.
Hung hung_from(const NaturalPlan& plan, float angle, float end) {
  const SinCos direction = sincos_degrees(angle);
  const glm::vec3 hangs = drooping({direction.sine, -direction.cosine, 0}, 1);
  const float pedicel_and_berry = end - plan.twig;
  return {plan.twig * direction.sine + pedicel_and_berry * hangs.x,
          plan.twig * direction.cosine - pedicel_and_berry * hangs.y};
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
  const float along = plan.first_order_spacing * static_cast<float>(j + 1);
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
  float ends = std::max(1.0f, axis.length / plan.first_order_spacing);
  for (std::size_t j = 0;; ++j) {
    const float left = axis.length - plan.first_order_spacing * static_cast<float>(j + 1);
    const float most = text.lateral * left - plan.second_order_spacing;
    // stop there: more nodes have too many flowers
    const bool grows = static_cast<float>(plan.beyond.size()) < max_flowers;
    const float beyond = most > 0 && grows ? room_at(plan, axis, j, most, end, text.yaw) : 0;
    plan.beyond.push_back(beyond);
    ends += beyond / plan.second_order_spacing;
    if (left <= -plan.first_order_spacing) return ends;
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
  float left = plan.length, spacing = plan.spacing;
  for (std::size_t k = 0;; ++k) {
    // The text computes the same; a node beyond the last is there for its rounding.
    const float share = std::clamp(left / spacing, 0.0f, 1.0f);
    const float depth = plan.length - left + share * spacing;
    left -= spacing;
    spacing = plan.spacing *
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
    const float arm =
        raceme ? -1
               : std::max(least_arm * plan.first_order_spacing,
                          distance_to_outline(plan.envelope, round, depth, angle, hung_from(plan, angle, end)));
    plan.arm.push_back(arm);
    plan.node.push_back(static_cast<float>(plan.beyond.size() + 1));
    const float ends = place_nodes(plan, {round, way, depth, angle, arm}, end, text);
    flowers += share * (raceme ? 1 : text.flowers_per_end * ends);
    if (share <= 0 || !(spacing > 0) || k + 1 == max_nodes) return flowers;
  }
}

// An array of max_nodes values that goes on with its last four, those of the last turn about the rachis.
lsystem::Inputs::Array array_for_all_nodes(const char* name, std::vector<float> values) {
  values.reserve(max_nodes);
  while (values.size() < max_nodes) values.push_back(values.size() < 4 ? values.back() : values[values.size() - 4]);
  return {name, std::move(values)};
}

// Whether the number of berries is requested, instead of a density.
bool is_count_requested(const Values& values) { return values[Parameter::count] > 0; }

// Sets the lengths and widths of the bunch's parts.
void set_sizes(NaturalPlan& plan, const Values& values) {
  using enum Parameter;
  const float width = values[Parameter::size], length = plan.envelope.length();
  plan.twig = twig_length * width;
  plan.pedicel_length = values[pedicel];
  plan.rachis_width = values[wi] / standard_width * std::clamp(rachis_over_berry * width, 1.2f, 7.0f);
  plan.pedicel_width = values[wi] / standard_width * std::clamp(pedicel_over_berry * width, 0.4f, 3.0f);
  plan.length = std::max(least_length * length, length - plan.twig - plan.pedicel_length - berry_below * width);
}

// Sets how many berries the bunch is to have, and how many it has room for. Returns the number that fills the outline
// to the requested density, even if it is above `max_berries`.
// The mean cube of widths whose deviation is s of their mean is 1 + 3 s² times the cube of the mean.
float set_berry_counts(NaturalPlan& plan, const Values& values, float max_berries) {
  using enum Parameter;
  const float width = values[Parameter::size], spread_share = values[spread] / 100;
  const float berry = pi / 6 * width * width * width * values[elongation] * (1 + 3 * spread_share * spread_share);
  plan.berry = berry;
  // A raceme's berries hang outside the lines of the profile.
  const bool raceme =
      std::any_of(plan.plan.sides.begin(), plan.plan.sides.end(), [](const SidePlan& side) { return side.n == 0; });
  plan.room = raceme ? max_berries : std::max(least_room, room_over_volume * plan.envelope.volume() / berry);
  const float filling = std::max(1.0f, fill_of(values[density]) * plan.envelope.volume() / berry);
  plan.overfull = !is_count_requested(values) && filling > max_berries;
  plan.berries = std::min(is_count_requested(values) ? values[Parameter::count] : filling, max_berries);
  return filling;
}

// The factor of the usual spacing of nodes with which they are placed first: for berries of that size and density in a
// bunch of middling width, independent of the profile, so that dragging moves no node.
float first_spacing_factor(const Values& values, float filling, float max_berries, float wider) {
  const float fill = is_count_requested(values) ? middling_fill : fill_of(values[Parameter::density]);
  const float factor =
      std::clamp(base_spacing_factor * std::sqrt(values[Parameter::size] / middling_size * middling_fill / fill),
                 least_spacing_factor, max_spacing_factor);
  return factor * (std::sqrt(std::max(1.0f, filling / max_berries)) * wider);
}

}  // namespace

// The share of the outline that berries of a density, 1 … 9, take before any is lost: between the values of a table.
// The densest bunches keep two thirds of it, as spheres packed at random do.
float fill_of(float density) {
  constexpr float fills[] = {0.13f, 0.19f, 0.25f, 0.31f, 0.38f, 0.48f, 0.62f, 0.84f, 1.0f};
  const float place = std::clamp(density - 1, 0.0f, 7.999f);
  const auto below = static_cast<std::size_t>(place);
  return fills[below] + (fills[below + 1] - fills[below]) * (place - static_cast<float>(below));
}

// Reads the constants of the grammar's text by name, with those of L-system 4 where it has none. The other values are
// as in `before`.
TextConstants constants_of(const lsystem::BoundProgram& text, const TextConstants& before) {
  const TextConstants standard;
  TextConstants found = before;
  found.tip_spacing = lsystem::constant(text, "near", standard.tip_spacing);
  found.tip_share = lsystem::constant(text, "tip", standard.tip_share);
  found.lateral = lsystem::constant(text, "lateral", standard.lateral);
  found.turn = std::fmod(lsystem::constant(text, "turn", standard.turn), 360.0f);
  found.yaw = std::min(std::abs(lsystem::constant(text, "alpha_y", standard.yaw)), max_upward);
  return found;
}

// Plans a bunch inside the outline: sizes of its parts, number of berries, then the nodes with their axes, set closer
// until there are enough flowers.
NaturalPlan make_natural_plan(const Profile& drawn, const Values& values, float max_berries, const TextConstants& text,
                              float start) {
  using enum Parameter;
  const float pixel = values[unit] * units_per_pixel;
  const float width = values[Parameter::size];
  Profile profile = drawn;
  for (SidePoint& side : profile.sides) side.width = std::max(side.width, width / 2 / pixel);
  const float end_reach = sincos_degrees(text.yaw).sine * (twig_length * width + values[pedicel]) + width;
  Plan counts = make_plan(drawn);
  NaturalPlan plan{std::move(counts), Envelope(profile, pixel, end_reach)};
  set_sizes(plan, values);
  const float filling = set_berry_counts(plan, values, max_berries);

  // Where the first spacing gives too few flowers for the berries that are wanted, it shrinks step by step.
  const bool needs_flowers = is_count_requested(values) || plan.overfull;
  float spacing_factor = first_spacing_factor(values, filling, max_berries, text.wider);
  const float end = plan.twig + plan.pedicel_length + berry_beyond * width * std::max(1.0f, values[elongation]);
  for (int tries = 0; tries < max_tries; ++tries) {
    plan.first_order_spacing = spacing_factor * usual_spacing * width;
    plan.second_order_spacing = second_over_first_spacing * plan.first_order_spacing;
    plan.spacing = std::min(plan.first_order_spacing, plan.length / least_nodes);
    const float flowers = place_axes(plan, profile, pixel, end, text, start);
    if (!needs_flowers || flowers >= flowers_per_berry * plan.berries || flowers > max_flowers) break;
    spacing_factor *= spacing_shrinks_by;
  }
  return plan;
}

// The values of the plan under the names by which the text of the L-system uses them, in the paper's unit.
lsystem::Inputs inputs_for(const NaturalPlan& plan, const Profile& profile, const Values& values) {
  lsystem::Inputs inputs = inputs_for(Shape{plan.plan, make_fit(profile, plan.plan, 1)}, values);
  const float units = 1 / values[Parameter::unit];
  const auto add_scalar = [&](const char* name, float value) { inputs.scalars.push_back({name, value}); };
  add_scalar("length", plan.length * units);
  add_scalar("spacing", plan.spacing * units);
  add_scalar("step", plan.first_order_spacing * units);
  add_scalar("stride", plan.second_order_spacing * units);
  add_scalar("twig", plan.twig * units);
  add_scalar("stalk", plan.pedicel_length * units);
  add_scalar("girth", plan.rachis_width * units);
  add_scalar("fine", plan.pedicel_width * units);
  std::vector<float> arms;
  for (const float arm : plan.arm) arms.push_back(arm * units);
  inputs.arrays.push_back(array_for_all_nodes("arm", std::move(arms)));
  inputs.arrays.push_back(array_for_all_nodes("way", plan.way));
  inputs.arrays.push_back(array_for_all_nodes("aim", plan.aim));
  inputs.arrays.push_back(array_for_all_nodes("node", plan.node));
  std::vector<float> beyonds;
  for (const float far : plan.beyond) beyonds.push_back(far * units);
  beyonds.resize(beyonds.size() + max_nodes, 0);
  inputs.arrays.push_back({"beyond", std::move(beyonds)});
  return inputs;
}

}  // namespace panicle::bunch
