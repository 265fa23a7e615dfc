#include "spatial/sphere_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/lanes.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t lanes = 4;
// A few roundings of a coordinate must not make a neighbour's cell the next but one.
constexpr float margin = 1.0001f;

// Four lanes with the same value.
Four four(float v) { return Four{v, v, v, v}; }

// Clamps four values to 0 … 1.
Four within_unit(const Four& v) {
  const Four above = v > 0.0f ? v : four(0);
  return above < 1.0f ? above : four(1);
}

}  // namespace

// Sorts spheres into a grid; those without a valid radius are in no cell.
void SphereOverlapQuery::build(std::span<const Sphere> spheres) {
  constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
  largest_ = 0;
  centres_.clear();
  radii_.clear();
  for (const Sphere& sphere : spheres) {
    const bool there = sphere.radius >= 0 && std::isfinite(sphere.radius);
    centres_.push_back(there ? sphere.centre : glm::vec3(nowhere));
    radii_.push_back(sphere.radius);
    if (there) largest_ = std::max(largest_, sphere.radius);
  }
  grid_.build(centres_, 2 * margin * largest_);
  const std::span<const std::uint32_t> ids = grid_.ids();
  for (auto* values : {&x_, &y_, &z_, &radius_}) values->resize(ids.size() + lanes - 1);
  for (std::size_t slot = 0; slot < ids.size(); ++slot) {
    const Sphere& sphere = spheres[ids[slot]];
    x_[slot] = sphere.centre.x;
    y_[slot] = sphere.centre.y;
    z_[slot] = sphere.centre.z;
    radius_[slot] = sphere.radius;
  }
}

// Finds the spheres from index `least` on that touch a capsule, the points within `radius` of the segment from `start`
// along `way`; sets `found_` in ascending order.
void SphereOverlapQuery::find_touching(const glm::vec3& start, const glm::vec3& way, float radius,
                                       std::uint32_t least) {
  found_.clear();
  const glm::vec3 end = start + way, room(margin * (radius + largest_));
  const float square = glm::dot(way, way);
  if (!std::isfinite(square)) return;
  const glm::vec3 per_square = square > 0 ? way / square : glm::vec3(0);
  const std::uint32_t* ids = grid_.ids().data();
  grid_.within(glm::min(start, end) - room, glm::max(start, end) + room, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t slot = first; slot < last; slot += lanes) {
      Four x = load(&x_[slot]) - start.x, y = load(&y_[slot]) - start.y, z = load(&z_[slot]) - start.z;
      if (square > 0) {
        const Four t = within_unit(x * per_square.x + y * per_square.y + z * per_square.z);
        x -= t * way.x;
        y -= t * way.y;
        z -= t * way.z;
      }
      const Four reach = load(&radius_[slot]) + radius;
      const auto near = x * x + y * y + z * z <= reach * reach;  // not where anything is not a number
      if (all(~near)) continue;
      const std::uint32_t count = std::min(last - slot, lanes);
      for (std::uint32_t lane = 0; lane < count; ++lane)
        if (near[lane] && ids[slot + lane] >= least) found_.push_back(ids[slot + lane]);
    }
  });
  std::sort(found_.begin(), found_.end());
}

// Appends pairs of spheres that touch, until there are `most`.
void SphereOverlapQuery::pairs(std::vector<SpherePair>& found, std::size_t most) {
  for (std::uint32_t a = 0; a < centres_.size() && found.size() < most; ++a) {
    find_touching(centres_[a], glm::vec3(0), radii_[a], a + 1);
    for (const std::uint32_t b : found_) {
      if (found.size() < most) found.push_back({a, b});
    }
  }
}

// The spheres that touch a stem of that radius; valid until the next query.
std::span<const std::uint32_t> SphereOverlapQuery::along(const glm::vec3& start, const glm::vec3& end, float radius) {
  find_touching(start, end - start, radius, 0);
  return found_;
}

}  // namespace panicle
