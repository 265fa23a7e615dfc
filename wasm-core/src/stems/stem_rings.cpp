#include "stems/stem_rings.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/rotation.hpp"
#include "stems/collar.hpp"

namespace panicle {
namespace {

constexpr float max_bends = 4;  // most rings added for bends on thin axes with few rings
constexpr std::uint32_t collar_rows = 6, thin_collar_rows = 4;
constexpr float cap_degrees[] = {35, 65}, thin_cap_degrees[] = {50};  // from the rim; the pole is at 90

// A cubic Hermite curve from node to node, as powers of t.
struct Curve {
  glm::vec3 constant, linear, square, cube;

  // The cubic from node a to node b with their tangents (Hermite).
  Curve(const Node& a, const Node& b) {
    const glm::vec3 chord = b.position - a.position;
    const glm::vec3 out = a.tangent * b.length, in = b.tangent * b.length;
    constant = a.position;
    linear = out;
    square = chord * 3.0f - out * 2.0f - in;
    cube = out + in - chord * 2.0f;
  }
  // The point at t, 0 … 1, and the derivative there.
  glm::vec3 at(float t) const { return constant + (linear + (square + cube * t) * t) * t; }
  glm::vec3 slope(float t) const { return linear + (square * 2.0f + cube * (3 * t)) * t; }
};

// By how many quarters of the bark's picture a tube may be too thin before one vanishes, and along how many of their
// widths it does.
constexpr float most_excess = 0.6f, quarter_fade = 4;

constexpr float steep = 0.8f;  // cosine of the angle to the vertical from which directions count as vertical

// The part of `v` at right angles to the unit vector `tangent`, as a unit vector; any such if `v` has none.
glm::vec3 perpendicular_part(const glm::vec3& v, const glm::vec3& tangent) {
  const glm::vec3 part = v - tangent * glm::dot(tangent, v);
  const float square = glm::dot(part, part);
  return square > 1e-6f ? part * (1 / std::sqrt(square))
                        : glm::normalize(glm::cross(axis_across(tangent, steep), tangent));
}

// Sets a ring at right angles to the axis. `right` is a unit vector at right angles to `tangent`; the section has the
// ring's two radii.
void set_ring(Ring& ring, const glm::vec3& centre, const glm::vec3& tangent, const glm::vec3& right,
              const Section& section) {
  ring.centre = centre;
  ring.tangent = tangent;
  ring.radius = section.narrow;
  ring.right = right * section.wide;
  ring.forward = glm::cross(tangent, right) * section.narrow;
  ring.round = section.wide == section.narrow;
  ring.blend = 0;
}

// Tilts a ring near a branch's beginning towards the direction of its parent, by the section's lean.
void lean_towards(Ring& ring, const glm::vec3& parent, const Section& section) {
  const glm::vec3 right = ring.right / section.wide;
  const glm::vec3 leaning = right + (parent - right) * section.lean;
  ring.right = leaning * (section.wide / glm::length(leaning));
  ring.blend = section.blend;
  ring.round = false;
}

// Computes how the half-axes change along a run of rings. A ring next to one that is not round is not quite round
// either.
void find_changes(std::span<Ring> rings) {
  bool round_before = true;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Ring& before = rings[i > 0 ? i - 1 : i];
    const Ring& after = rings[i + 1 < rings.size() ? i + 1 : i];
    const float per_run = 1 / ((i > 0 ? rings[i].run : 0) + (&after != &rings[i] ? after.run : 0));
    const bool round = rings[i].round;
    rings[i].slope = (after.radius - before.radius) * per_run;
    rings[i].round = round_before && round && after.round;
    if (!rings[i].round) {
      rings[i].right_change = (after.right - before.right) * per_run;
      rings[i].forward_change = (after.forward - before.forward) * per_run;
    }
    round_before = round;
  }
}

// A ring of a rounded end, `degrees` from its rim. `height` is that of the end's pole above the rim, negative at the
// start of the axis.
Ring cap_ring(const Ring& rim, float degrees, float height) {
  const SinCos angle = sincos_degrees(degrees);
  const float steepness = -angle.sine / (angle.cosine * height);
  Ring ring = rim;
  ring.centre += rim.tangent * (height * angle.sine);
  ring.right *= angle.cosine;
  ring.forward *= angle.cosine;
  ring.radius *= angle.cosine;
  ring.slope = rim.radius * steepness;
  ring.right_change = rim.right * steepness;
  ring.forward_change = rim.forward * steepness;
  return ring;
}

// The distance of two rings along the surface.
float distance_between(const Ring& a, const Ring& b) {
  const glm::vec3 run = b.centre - a.centre;
  const float rise = b.radius - a.radius;
  return std::sqrt(rise * rise + glm::dot(run, run));
}

}  // namespace

// Prepares making tubes. `crowding_` moves rings towards the nodes, by a sine.
TubeMaker::TubeMaker(const Stems& stems, const StemAxes& axes, const TubeOptions& options)
    : stems_(stems), axes_(axes), options_(options) {
  for (std::uint32_t n = 1; n <= max_steps; ++n) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      const float turn = static_cast<float>(k) / static_cast<float>(n);
      crowding_[n][k] = sincos_degrees(360 * turn).sine / (2 * pi);
    }
  }
}

// The form of an axis' end.
StemEnd TubeMaker::end_of(const StemAxis& axis) const {
  return stems_.end_of(static_cast<std::size_t>(axes_.nodes[axis.first + axis.count - 1].segment));
}

// The angles of the rings of its rounded ends.
std::span<const float> TubeMaker::cap_of(const StemAxis& axis) const {
  return is_thin(axis) ? std::span<const float>(thin_cap_degrees) : std::span<const float>(cap_degrees);
}

// The number of rings from node i − 1 of the axis to node i: more on long, bent, branching or flaring pieces, fewer on
// thin axes; `max_steps` at most.
std::uint32_t TubeMaker::rings_between(const StemAxis& axis, std::uint32_t i) const {
  const Node& a = axes_.nodes[axis.first + i - 1];
  const Node& b = axes_.nodes[axis.first + i];
  const glm::vec3 along = (b.position - a.position) / b.length;
  const bool changes_shape = (i == 1 && axis.origin.attached) || (i + 1 == axis.count && end_of(axis).flare > 0);
  const float by_length = 2 + 2 * b.length / std::max(a.radius, b.radius);
  const bool thin = is_thin(axis);
  const float bend = glm::length(a.tangent - along) + glm::length(b.tangent - along);
  const float by_bend = (thin ? 4 : 6) * bend;  // a ring about every 15° on thin axes, every 10° on others
  if (thin && options_.thin_plain) return 1 + static_cast<std::uint32_t>(std::min(3 * bend, max_bends));
  const float limit = thin ? (changes_shape ? 6.0f : 3.0f) : (changes_shape ? 10.0f : 7.0f);
  const float wanted = std::max(std::min(limit, by_length), by_bend);
  const auto steps = static_cast<std::uint32_t>(std::min(wanted, static_cast<float>(max_steps)));
  return coarse_ ? 1 + steps / 8 : steps;
}

// Whether a branch begins with a collar: if its parent continues.
bool TubeMaker::has_collar(const StemAxis& axis) const { return options_.collars && axis.origin.passing; }

const RootFlare* TubeMaker::flare_of(const StemAxis& axis) const {
  if (axis.origin.attached || axis.origin.corner) return nullptr;
  for (const RootFlare& flare : options_.flares)
    if (static_cast<std::uint32_t>(axes_.nodes[axis.first].segment) == flare.segment) return &flare;
  return nullptr;
}

std::uint32_t TubeMaker::count_rings(const StemAxis& axis) const {
  return rings_of(axis) + (has_collar(axis) ? (is_thin(axis) ? thin_collar_rows : collar_rows) : 0);
}

// The number of an axis' rings, with those of its rounded ends.
std::uint32_t TubeMaker::rings_of(const StemAxis& axis) const {
  std::uint32_t rings = 1 + static_cast<std::uint32_t>(cap_of(axis).size()) * (axis.origin.attached ? 1 : 2);
  for (std::uint32_t i = 1; i < axis.count; ++i) rings += rings_between(axis, i);
  return rings;
}

// Sets the rings between the two ends of an axis. A branch begins with its right in the plane of branch and parent.
void TubeMaker::sweep(const StemAxis& axis, Ring* rings) const {
  const std::span<const Node> nodes(&axes_.nodes[axis.first], axis.count);
  const Foot foot = has_collar(axis) ? Foot::inside : flare_of(axis) ? Foot::plain : Foot::spread;
  Thickness thickness(nodes, axis.origin, end_of(axis), {stems_.jointed, stems_.tapering, foot});
  glm::vec3 centre = nodes[0].position;
  glm::vec3 right = axis.origin.attached ? axis.origin.direction : axis_across(nodes[0].tangent, steep);
  // Adds the ring at the fraction `t` of a segment, turned as little as possible from the ring before.
  const auto add = [&](const glm::vec3& next, const glm::vec3& tangent, float t, std::int32_t segment) {
    Section section = thickness.at(t);
    section.wide = std::max(section.wide, axes_.finest);
    section.narrow = std::max(section.narrow, axes_.finest);
    right = perpendicular_part(right, tangent);
    Ring& ring = *rings++;
    set_ring(ring, next, tangent, right, section);
    if (section.lean > 0) lean_towards(ring, axis.origin.direction, section);
    ring.run = glm::length(next - centre);
    ring.segment = static_cast<std::uint32_t>(segment);
    centre = next;
  };
  thickness.enter(1);
  add(nodes[0].position, nodes[0].tangent, 0, nodes[0].segment);
  for (std::uint32_t i = 1; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    const Curve curve(nodes[i - 1], node);
    if (i > 1) thickness.enter(i);
    const std::uint32_t steps = rings_between(axis, i);
    // The longer a piece is in radii, the nearer its rings are to the nodes.
    const float crowded = 0.85f * std::clamp(0.25f * node.length / node.radius - 0.75f, 0.0f, 1.0f);
    const float per_steps = 1 / static_cast<float>(steps);
    for (std::uint32_t k = 1; k < steps; ++k) {
      const float t = static_cast<float>(k) * per_steps - crowded * crowding_[steps][k];
      const glm::vec3 slope = curve.slope(t);
      const float speed = glm::length(slope);
      const glm::vec3 tangent = speed > 0 ? slope * (1 / speed) : node.tangent;
      add(curve.at(t), tangent, t, node.segment);
    }
    add(node.position, node.tangent, 1, node.segment);
  }
}

// Sets v along a tube: one unit to one circumference, without swellings, or by the scale of the bark, with the turns
// around. `front` and `back`: the first ring of the body, and the first one behind it.
void TubeMaker::set_texture(const StemAxis& axis, std::span<Ring> rings, std::size_t front, std::size_t back) const {
  const float radius = axes_.nodes[axis.first].radius;
  const float per_circumference = 1 / (2 * pi * radius);
  const auto [width, height] = options_.bark;
  const float quarter = 0.25f * width;
  float held = 1, quarters = 1;  // those that are aimed at, and those so far
  if (width > 0) held = quarters = std::max(1.0f, std::round(2 * pi * radius / quarter));
  rings[0].v = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const bool body = i > front && i < back;
    const float distance = i == 0 ? 0 : body ? rings[i].run : distance_between(rings[i - 1], rings[i]);
    if (width > 0) {
      // Rounded ends keep the scale of their rim.
      const float around = 2 * pi * rings[std::clamp(i, front, back - 1)].radius;
      if (around < (held - most_excess) * quarter) held = std::max(1.0f, std::round(around / quarter));
      quarters = std::max(held, quarters - distance * quarters / (quarter_fade * around));
      rings[i].turns = 0.25f * quarters;
      rings[i].v_rate = rings[i].turns * width / (around * height);
      if (i > 0) rings[i].v = rings[i - 1].v + 0.5f * distance * (rings[i - 1].v_rate + rings[i].v_rate);
    } else {
      rings[i].turns = 1;
      rings[i].v_rate = per_circumference;
      if (i > 0) rings[i].v = rings[i - 1].v + distance * per_circumference;
    }
  }
}

// Makes the tube of an axis: rings, rounded ends, texture coordinates and collar.
void TubeMaker::make(const StemAxis& axis, std::uint32_t sides, Tube& tube) const {
  tube.collar.clear();
  std::vector<Ring>& rings = tube.rings;
  rings.resize(rings_of(axis));
  tube.parent_point = axes_.nodes[axis.first].position;
  tube.parent_direction = axis.origin.direction;
  tube.parent_radius = std::max(axis.origin.radius, axes_.finest);
  const std::span<const float> cap = cap_of(axis);
  const std::size_t front = axis.origin.attached ? 0 : cap.size();
  const std::size_t back = rings.size() - cap.size();
  sweep(axis, &rings[front]);
  find_changes({&rings[front], back - front});

  // A branch begins within its parent, where a flat end is enough; in the open a cut end is nearly flat too.
  const Ring& first = rings[front];
  const Ring& last = rings[back - 1];
  const float first_height = (axis.origin.corner ? 1 : 0.3f) * first.radius;
  const float last_height = (axis.to_corner ? 1 : end_of(axis).height) * last.radius;
  for (std::size_t i = 0; i < front; ++i) rings[i] = cap_ring(first, cap[front - 1 - i], -first_height);
  for (std::size_t i = 0; i < cap.size(); ++i) rings[back + i] = cap_ring(last, cap[i], last_height);
  tube.first_pole = first.centre - first.tangent * first_height;
  tube.last_pole = last.centre + last.tangent * last_height;

  set_texture(axis, rings, front, back);
  if (!has_collar(axis)) return;
  const std::uint32_t fork = axis.origin.node;
  add_collar(tube, ParentSurface(axes_, fork), static_cast<std::uint32_t>(axes_.nodes[fork].segment), sides,
             is_thin(axis) ? thin_collar_rows : collar_rows, back);
}

}  // namespace panicle
