#include "geometry/stem_rings.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t cap_rings = 2;
constexpr float cap_degrees[cap_rings] = {35, 65};  // from the rim; the pole is at 90

// A cubic Hermite curve from node to node.
struct Curve {
  glm::vec3 from, to, out, in;

  Curve(const Node& a, const Node& b) : from(a.position), to(b.position) {
    const float length = glm::length(to - from);
    out = a.tangent * length;
    in = b.tangent * length;
  }

  glm::vec3 at(float t) const {
    const float s = 1 - t;
    return from * (s * s * (1 + 2 * t)) + to * (t * t * (1 + 2 * s)) + (out * s - in * t) * (s * t);
  }

  glm::vec3 direction(float t) const {
    const float s = 1 - t;
    const glm::vec3 slope = (to - from) * (6 * s * t) + out * (s * (s - 2 * t)) + in * (t * (t - 2 * s));
    const float length = glm::length(slope);
    return length > 0 ? slope / length : glm::normalize(to - from);
  }
};

glm::vec3 reflected(const glm::vec3& v, const glm::vec3& mirror) {
  const float square = glm::dot(mirror, mirror);
  return square > 0 ? v - mirror * (2 * glm::dot(mirror, v) / square) : v;
}

// A frame that travels along the curve: `right` is at right angles to the tangent.
struct Frame {
  glm::vec3 centre, tangent, right;
};

void square_up(Frame& frame, const glm::vec3& right) {
  frame.right = glm::normalize(right - frame.tangent * glm::dot(frame.tangent, right));
}

// A branch begins with its right in the plane of branch and bearer.
Frame first_frame(const Node& node, const Origin& origin) {
  Frame frame{node.position, node.tangent, {}};
  const glm::vec3 any = std::fabs(node.tangent.y) < 0.8f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const bool in_line = !origin.attached || std::fabs(glm::dot(node.tangent, origin.direction)) > 0.99f;
  square_up(frame, in_line ? any : origin.direction);
  return frame;
}

void carry(Frame& frame, const glm::vec3& centre, const glm::vec3& tangent) {
  const glm::vec3 step = centre - frame.centre;
  const glm::vec3 ahead = reflected(frame.tangent, step);
  const glm::vec3 right = reflected(frame.right, step);
  frame = {centre, tangent, right};
  square_up(frame, reflected(right, tangent - ahead));
}

Ring ring_of(const Frame& frame, const Section& section, const Origin& origin, std::int32_t internode) {
  Ring ring;
  ring.centre = frame.centre;
  ring.tangent = frame.tangent;
  const glm::vec3 right = frame.right + (origin.direction - frame.right) * section.lean;
  ring.right = right * (section.wide / glm::length(right));
  ring.forward = glm::cross(frame.tangent, frame.right) * section.narrow;
  ring.round = section.lean == 0 && section.wide == section.narrow;
  ring.internode = static_cast<std::uint32_t>(internode);
  return ring;
}

// How the half-axes change along a run of rings. A ring next to one that is not round is not quite round either.
void find_changes(std::span<Ring> rings) {
  bool round_before = true;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Ring& before = rings[i > 0 ? i - 1 : i];
    const Ring& after = rings[i + 1 < rings.size() ? i + 1 : i];
    const float run = glm::length(after.centre - rings[i].centre) + glm::length(rings[i].centre - before.centre);
    rings[i].right_change = (after.right - before.right) / run;
    rings[i].forward_change = (after.forward - before.forward) / run;
    const bool round = rings[i].round;
    rings[i].round = round_before && round && after.round;
    round_before = round;
  }
}

// A ring of a rounded end, `degrees` from the rim; `height` is negative at the start of the axis.
Ring cap_ring(const Ring& rim, float degrees, float height) {
  const SinCos angle = sincos_degrees(degrees);
  const float steepness = -angle.sine / (angle.cosine * height);
  Ring ring = rim;
  ring.centre += rim.tangent * (height * angle.sine);
  ring.right *= angle.cosine;
  ring.forward *= angle.cosine;
  ring.right_change = rim.right * steepness;
  ring.forward_change = rim.forward * steepness;
  return ring;
}

// Height of the rounded end, in radii of the rim.
float cap_height(End end) {
  switch (end) {
    case End::receptacle:
      return 0.35f;
    case End::withered:
      return 0.7f;
    case End::stub:
      break;
  }
  return 0.5f;
}

// One unit of v to one circumference: distance over the surface, over what the circumference is without swellings.
void lay_texture(std::span<Ring> rings, float first_radius) {
  float v = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (i > 0) {
      const float rise = glm::length(rings[i].forward) - glm::length(rings[i - 1].forward);
      const glm::vec3 run = rings[i].centre - rings[i - 1].centre;
      v += std::sqrt(rise * rise + glm::dot(run, run)) / (2 * pi * first_radius);
    }
    rings[i].v = v;
  }
}

}  // namespace

TubeMaker::TubeMaker(std::span<const Internode> skeleton, const StemAxes& axes) : skeleton_(skeleton), axes_(axes) {
  for (std::uint32_t n = 1; n <= most_steps; ++n) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      const float turn = static_cast<float>(k) / static_cast<float>(n);
      crowding_[n][k] = sincos_degrees(360 * turn).sine / (2 * pi);
    }
  }
}

End TubeMaker::end_of(const StemAxis& axis) const {
  const Internode& last = skeleton_[axes_.nodes[axis.first + axis.count - 1].internode];
  if (last.kind != Kind::pedicel) return End::stub;
  return last.state == State::grown ? End::receptacle : End::withered;
}

// Steps from node i − 1 of the axis to node i.
std::uint32_t TubeMaker::steps_to(const StemAxis& axis, std::uint32_t i) const {
  const Node& a = axes_.nodes[axis.first + i - 1];
  const Node& b = axes_.nodes[axis.first + i];
  const glm::vec3 chord = b.position - a.position;
  const float length = glm::length(chord);
  const glm::vec3 along = chord / length;
  const bool shaped = (i == 1 && axis.origin.attached) || (i + 1 == axis.count && end_of(axis) == End::receptacle);
  const float by_length = 2 + 2 * length / std::max(a.radius, b.radius);
  const float by_bend = 6 * (glm::length(a.tangent - along) + glm::length(b.tangent - along));  // about every 10°
  const float wanted = std::max(std::min(shaped ? 10.0f : 7.0f, by_length), by_bend);
  const auto steps = static_cast<std::uint32_t>(std::min(wanted, static_cast<float>(most_steps)));
  return coarse_ ? 1 + steps / 8 : steps;
}

std::uint32_t TubeMaker::count_rings(const StemAxis& axis) const {
  std::uint32_t rings = 1 + cap_rings * (axis.origin.attached ? 1 : 2);
  for (std::uint32_t i = 1; i < axis.count; ++i) rings += steps_to(axis, i);
  return rings;
}

// The rings between the two ends.
void TubeMaker::sweep(const StemAxis& axis, std::vector<Ring>& rings) const {
  const std::span<const Node> nodes(&axes_.nodes[axis.first], axis.count);
  const Thickness thickness(nodes, axis.origin, end_of(axis));
  Frame frame = first_frame(nodes[0], axis.origin);
  float from_start = 0;
  const auto add = [&](std::uint32_t i, float t, std::int32_t internode) {
    Section section = thickness.at(i, t, from_start);
    section.wide = std::max(section.wide, axes_.finest);
    section.narrow = std::max(section.narrow, axes_.finest);
    rings.push_back(ring_of(frame, section, axis.origin, internode));
  };
  add(1, 0, nodes[0].internode);
  for (std::uint32_t i = 1; i < nodes.size(); ++i) {
    const Curve curve(nodes[i - 1], nodes[i]);
    const float length = glm::length(curve.to - curve.from);
    const std::uint32_t steps = steps_to(axis, i);
    const float crowded = 0.85f * std::clamp(0.25f * length / nodes[i].radius - 0.75f, 0.0f, 1.0f);
    for (std::uint32_t k = 1; k < steps; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(steps) - crowded * crowding_[steps][k];
      carry(frame, curve.at(t), curve.direction(t));
      add(i, t, nodes[i].internode);
    }
    carry(frame, curve.to, nodes[i].tangent);
    add(i, 1, nodes[i].internode);
    from_start += length;
  }
}

void TubeMaker::make(const StemAxis& axis, Tube& tube) const {
  std::vector<Ring>& rings = tube.rings;
  rings.clear();
  const std::uint32_t front = axis.origin.attached ? 0 : cap_rings;
  rings.resize(front);
  sweep(axis, rings);
  find_changes(std::span<Ring>(rings).subspan(front));

  // A branch begins within its bearer, where a flat end is enough; in the open a cut end is nearly flat too.
  const Ring first = rings[front];
  const Ring last = rings.back();
  const float back = 0.3f * glm::length(first.forward);
  const float ahead = cap_height(end_of(axis)) * glm::length(last.forward);
  for (std::uint32_t i = 0; i < front; ++i) rings[i] = cap_ring(first, cap_degrees[front - 1 - i], -back);
  for (const float degrees : cap_degrees) rings.push_back(cap_ring(last, degrees, ahead));
  tube.first_pole = first.centre - first.tangent * back;
  tube.last_pole = last.centre + last.tangent * ahead;
  lay_texture(rings, axes_.nodes[axis.first].radius);
}

}  // namespace panicle
