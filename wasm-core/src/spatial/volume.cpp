#include "spatial/volume.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace panicle {
namespace {

constexpr float least = 1e-6f;     // half of a size, where none is given
constexpr float rounding = 1e-5f;  // of the size and of the distance from the origin
constexpr double forever = std::numeric_limits<double>::infinity();

// The least t ≥ 0 where a·t² + 2·b·t + c is 0, for c ≤ 0; infinity if there is none. That is where a ray from inside
// leaves the region of negative values.
double exit_root(double a, double b, double c) {
  c = std::min(c, 0.0);
  const double square = b * b - a * c;
  if (square < 0) return forever;
  if (b > 0) return -c / (b + std::sqrt(square));
  return a > 0 ? (std::sqrt(square) - b) / a : forever;
}

// The distance from the coordinate `at` along `way` to the wall at −1 or 1.
double wall_distance(double at, double way) {
  if (way > 0) return std::max((1 - at) / way, 0.0);
  return way < 0 ? std::max((-1 - at) / way, 0.0) : forever;
}

// The rotation of length 1; none for a quaternion of length 0.
glm::quat normalised(const glm::quat& q) {
  const float square = glm::dot(q, q);
  return square > 0 ? q * (1 / std::sqrt(square)) : glm::quat(1, 0, 0, 0);
}

}  // namespace

Volume::Volume(Kind kind, const glm::vec3& centre, const glm::vec3& size, const glm::quat& rotation,
               const Surface& mesh, std::shared_ptr<QueryBudget> budget)
    : kind_(kind),
      centre_(centre),
      half_(glm::max(0.5f * (kind == Kind::sphere ? glm::vec3(size.x) : size), least)),
      to_local_rotation_(glm::conjugate(normalised(rotation))),
      margin_(rounding * (std::max({half_.x, half_.y, half_.z}) + glm::length(centre))) {
  if (kind == Kind::mesh) solid_ = std::make_shared<const Solid>(stretched(mesh, -half_, half_), std::move(budget));
}

// Whether a point is in the volume.
bool Volume::contains(const glm::vec3& p) const { return contains_local(to_local(p - centre_)); }

// Whether a point in the volume's own frame is in the volume.
bool Volume::contains_local(const glm::vec3& p) const {
  const glm::vec3 u = p / half_;
  switch (kind_) {
    case Kind::box:
      return std::fabs(u.x) <= 1 && std::fabs(u.y) <= 1 && std::fabs(u.z) <= 1;
    case Kind::sphere:
    case Kind::ellipsoid:
      return glm::dot(u, u) <= 1;
    case Kind::cylinder:
      return std::fabs(u.y) <= 1 && u.x * u.x + u.z * u.z <= 1;
    case Kind::cone: {
      const float radius = 0.5f * (1 - u.y);
      return std::fabs(u.y) <= 1 && u.x * u.x + u.z * u.z <= radius * radius;
    }
    case Kind::mesh:
      break;
  }
  return solid_->contains(p);
}

// The distance from a point inside to the surface, `most` at most; point and unit vector in the volume's own frame. All
// but meshes are solved exactly, in units in which the volume reaches from −1 to 1 on each axis.
float Volume::exit_distance(const glm::vec3& p, const glm::vec3& way, float most) const {
  if (kind_ == Kind::mesh) return solid_->exit_distance(p, way, most);
  const glm::dvec3 u = glm::dvec3(p) / glm::dvec3(half_), w = glm::dvec3(way) / glm::dvec3(half_);
  double end = most;
  switch (kind_) {
    case Kind::box:
      end = std::min({end, wall_distance(u.x, w.x), wall_distance(u.y, w.y), wall_distance(u.z, w.z)});
      break;
    case Kind::sphere:
    case Kind::ellipsoid:
      end = std::min(end, exit_root(glm::dot(w, w), glm::dot(u, w), glm::dot(u, u) - 1));
      break;
    case Kind::cylinder:
      end = std::min({end, wall_distance(u.y, w.y),
                      exit_root(w.x * w.x + w.z * w.z, u.x * w.x + u.z * w.z, u.x * u.x + u.z * u.z - 1)});
      break;
    case Kind::cone: {
      const double radius = 0.5 * (1 - u.y), slope = -0.5 * w.y;
      end = std::min({end, wall_distance(u.y, w.y),
                      exit_root(w.x * w.x + w.z * w.z - slope * slope, u.x * w.x + u.z * w.z - radius * slope,
                                u.x * u.x + u.z * u.z - radius * radius)});
      break;
    }
    case Kind::mesh:
      break;
  }
  return static_cast<float>(end);
}

// The distance from a point along a unit vector that certainly stays in the volume, `most` at most; 0 from outside.
float Volume::reach(const glm::vec3& from, const glm::vec3& way, float most) const {
  const glm::vec3 p = to_local(from - centre_), w = to_local(way);
  if (!contains_local(p) || !(most > 0)) return 0;
  const float margin = margin_ + rounding * glm::length(p);
  const float end = exit_distance(p, w, most + margin);
  float far = end < most + margin ? std::min(end - margin, most) : most;
  // Along a wall, or in a cleft of a mesh, a larger margin is needed.
  for (float back = margin; far > 0 && !contains(from + far * way); back *= 2) far -= back;
  return std::max(far, 0.0f);
}

}  // namespace panicle
