#include "models/bunch/berry/pressing/berry_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "foundation/mathematics.hpp"
#include "foundation/rotation.hpp"
#include "spatial/closest_points.hpp"
#include "spatial/sphere_overlaps.hpp"

namespace panicle::bunch {
namespace {

// A body's furthest point in a direction, from its centre. A turn t of the direction moves it by round (round · t) +
// along (along · t).
struct Furthest {
  glm::vec3 point, round, along;

  // The mean of the two radii of curvature there.
  float curvature_radius() const { return 0.5f * (glm::dot(round, round) + glm::dot(along, along)); }
};

// Finds a berry's furthest point in a direction, a unit vector in world space: in the unit space of the berry's frame M
// it is the furthest along the direction times M (Mᵀ n), found in the meridian's table.
Furthest furthest(const BerryFrame& frame, const BerryMeridian& meridian, const glm::vec3& direction) {
  const glm::vec3 m = direction * frame.axes;  // in unit space
  const float out = std::sqrt(m.x * m.x + m.z * m.z);
  const float length = std::sqrt(out * out + m.y * m.y);
  const glm::vec2 outwards = out > 0 ? glm::vec2(m.x, m.z) / out : glm::vec2(1, 0);
  const BerryMeridian::Support support = meridian.support({out, m.y});
  const glm::vec3 unit_along(m.y / length * outwards.x, -out / length, m.y / length * outwards.y);
  const glm::vec3 unit_round(-outwards.y, 0, outwards.x);
  return {frame.axes * glm::vec3(outwards.x * support.point.x, support.point.y, outwards.y * support.point.x),
          frame.axes * unit_round * std::sqrt(support.round / length),
          frame.axes * unit_along * std::sqrt(support.along / length)};
}

// The separation of two bodies in a direction from the first to the second: their furthest points along it, the vector
// between these, and its length along the direction.
struct Separation {
  glm::vec3 direction;
  Furthest a, b;
  glm::vec3 gap;
  float apart;  // negative where they overlap
};

// Two berries, convex bodies, whose separation is sought.
class BodyPair {
 public:
  BodyPair(const BerryFrame& a, const BerryFrame& b, const BerryMeridian& meridian)
      : a_(a), b_(b), meridian_(meridian), between_(b.centre - a.centre) {}

  // Measures the separation in one direction, a unit vector.
  Separation meeting_along(const glm::vec3& direction) const {
    const Furthest a = furthest(a_, meridian_, direction), b = furthest(b_, meridian_, -direction);
    const glm::vec3 gap = between_ + b.point - a.point;
    return {direction, a, b, gap, glm::dot(gap, direction)};
  }

  // Finds the largest separation over all directions by Newton's method: it is the distance of two convex bodies, or
  // their penetration depth.
  Separation largest_separation(const Separation& first) const {
    Separation best = first;
    for (int step = 0; step < 6; ++step) {
      glm::vec3 turn = best_turn(best);
      const float size = glm::length(turn);
      if (size < 2e-3f) break;
      turn *= std::min(1.0f, 0.4f / size);
      Separation next = meeting_along(glm::normalize(best.direction + turn));
      for (int half = 0; half < 2 && next.apart < best.apart; ++half) {
        turn *= 0.4f;
        next = meeting_along(glm::normalize(best.direction + turn));
      }
      if (!(next.apart > best.apart)) break;
      best = next;
    }
    return best;
  }

  // The first guess: along the shortest way between the cores, the segments of the bodies' capsules.
  glm::vec3 first_direction() const {
    const glm::vec3 core_a = core(a_), core_b = core(b_);
    const auto [s, t] =
        closest_points(between_, {core_a, 1, glm::dot(core_a, core_a)}, {core_b, 1, glm::dot(core_b, core_b)}, 1e-4f);
    const glm::vec3 way = between_ + core_b * t - core_a * s;
    const float length = glm::length(way);
    // No direction follows from crossing cores, nor from coinciding centres: see find_contacts.
    if (length > 0.05f * glm::length(a_.axes[0]) && glm::dot(way, between_) > 0) return way / length;
    return glm::normalize(between_);
  }

 private:
  // Half the core of a berry's capsule, a vector along its axis; 0 for a flat berry.
  static glm::vec3 core(const BerryFrame& frame) {
    const float length = glm::length(frame.axes[1]);
    return frame.axes[1] * std::max(0.0f, 1 - glm::length(frame.axes[0]) / length);
  }

  // The change of direction by which the separation grows most: one Newton step, with the bodies' curvature as second
  // derivative. 0 where there is none.
  static glm::vec3 best_turn(const Separation& m) {
    const glm::vec3& n = m.direction;
    const glm::vec3 right = any_perpendicular(n, 0.6f, {1, 0, 0}, {0, 1, 0});
    const glm::vec3 up = glm::cross(n, right);
    float xx = m.apart, xy = 0, yy = m.apart;
    for (const glm::vec3& along : {m.a.round, m.a.along, m.b.round, m.b.along}) {
      const float x = glm::dot(along, right), y = glm::dot(along, up);
      xx += x * x;
      xy += x * y;
      yy += y * y;
    }
    const float determinant = xx * yy - xy * xy;
    if (!(xx > 0 && determinant > 0)) return glm::vec3(0);
    const float x = glm::dot(m.gap, right), y = glm::dot(m.gap, up);
    return right * ((yy * x - xy * y) / determinant) + up * ((xx * y - xy * x) / determinant);
  }

  const BerryFrame& a_;
  const BerryFrame& b_;
  const BerryMeridian& meridian_;
  glm::vec3 between_;
};

// A plane at right angles to `direction`, `from_a` beyond the first centre and `from_b` before the second, whose free
// forms reach to `end_a` and `end_b`.
struct Plane {
  glm::vec3 direction;
  float from_a, from_b, end_a, end_b;
};

// The plane in which two berries press on each other; none if they are well apart, or at one place. `reach`: factor by
// which berries may bulge.
std::optional<Plane> plane_between(const BerryFrame& a, const BerryFrame& b, const BerryMeridian& meridian,
                                   float reach) {
  const glm::vec3 between = b.centre - a.centre;
  if (!(glm::dot(between, between) > 0)) return {};
  const BodyPair bodies(a, b, meridian);
  const auto well_apart = [&](const Separation& m) {
    return glm::dot(between, m.direction) > reach * glm::dot(m.a.point - m.b.point, m.direction);
  };
  Separation m = bodies.meeting_along(bodies.first_direction());
  if (well_apart(m)) return {};
  m = bodies.largest_separation(m);
  if (well_apart(m)) return {};
  float distance = glm::dot(between, m.direction);
  const float sizes = glm::dot(m.a.point - m.b.point, m.direction);
  if (distance < 0.1f * sizes) {
    m = bodies.meeting_along(glm::normalize(between));
    distance = glm::dot(between, m.direction);
    if (distance < 1e-3f * sizes) return {};
  }
  const float radius_a = m.a.curvature_radius(), radius_b = m.b.curvature_radius();
  const float share = std::clamp(radius_b / (radius_a + radius_b), 0.2f, 0.8f);
  const float end_a = glm::dot(m.a.point, m.direction), end_b = -glm::dot(m.b.point, m.direction);
  const float from_a = std::clamp(end_a + m.apart * share, 0.15f * distance, 0.85f * distance);
  return Plane{m.direction, from_a, distance - from_a, end_a, end_b};
}

}  // namespace

// The frame of a berry: centre and the three half axes, turned about its own axis by `roll` degrees.
BerryFrame frame_of(const BerryBody& body, float roll) {
  // The least turn from straight down to the body's direction: smooth except for one straight up.
  const glm::vec3& d = body.direction;
  const float lift = d.y > 0 ? (d.x * d.x + d.z * d.z) / (1 + d.y) : 1 - d.y;
  const float per_lift = lift > 1e-12f ? 1 / lift : 0;
  const glm::vec3 right(1 - d.x * d.x * per_lift, d.x, -d.x * d.z * per_lift);
  const glm::vec3 ahead(d.x * d.z * per_lift, -d.z, per_lift > 0 ? d.z * d.z * per_lift - 1 : 1);
  const SinCos turn = sincos_degrees(roll);
  const float width = body.half_width;
  return {body.centre, glm::mat3((right * turn.cosine - ahead * turn.sine) * width, d * body.half_length,
                                 (right * turn.sine + ahead * turn.cosine) * width)};
}

// Moves a plane away from its berry's centre by `distance`, and its twin, the neighbour's plane, likewise towards the
// neighbour.
void BerryContacts::move(std::size_t plane, float distance) {
  const auto shift = [](BerryPlane& p, float by) {
    const float scale = p.from / (p.from + by);
    p.slope *= scale;
    p.depth = (1 + p.depth) * scale - 1;
    p.from += by;
  };
  shift(planes[plane], distance);
  shift(planes[planes[plane].twin], -distance);
}

// Finds the contact planes of all berries that meet or nearly do. Each plane is stored twice, once for either berry, in
// unit space of that berry.
BerryContacts find_contacts(std::span<const BerryFrame> frames, const BerryMeridian& meridian, float reach) {
  // Pairs whose spheres around the enlarged forms overlap may meet.
  std::vector<Sphere> spheres;
  spheres.reserve(frames.size());
  for (const BerryFrame& frame : frames) {
    const float longest = std::max(glm::length(frame.axes[0]), glm::length(frame.axes[1]));
    spheres.push_back({frame.centre, longest * meridian.outermost() * reach});
  }
  struct Contact {
    std::uint32_t a, b;
    Plane plane;
  };
  std::vector<Contact> contacts;
  BerryContacts result;
  result.first.assign(frames.size() + 1, 0);
  std::vector<SpherePair> pairs;
  SphereOverlapQuery(spheres).pairs(pairs);
  for (const auto& [a, b] : pairs) {
    if (const auto plane = plane_between(frames[a], frames[b], meridian, reach)) {
      contacts.push_back({a, b, *plane});
      ++result.first[a + 1];
      ++result.first[b + 1];
    }
  }
  for (std::size_t i = 0; i < frames.size(); ++i) result.first[i + 1] += result.first[i];
  // Pairs are sorted by their first, then their second berry: so each berry gets its neighbours in ascending order.
  result.planes.resize(result.first.back());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (const Contact& contact : contacts) {
    const Plane& p = contact.plane;
    const std::uint32_t at_a = next[contact.a]++, at_b = next[contact.b]++;
    result.planes[at_a] = {p.direction * frames[contact.a].axes / p.from_a, p.from_a, p.end_a / p.from_a - 1, contact.b,
                           at_b};
    result.planes[at_b] = {-p.direction * frames[contact.b].axes / p.from_b, p.from_b, p.end_b / p.from_b - 1,
                           contact.a, at_a};
  }
  return result;
}

}  // namespace panicle::bunch
