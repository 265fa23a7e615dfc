#include "models/growth/surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "models/growth/messages.generated.hpp"

namespace panicle::growth {
namespace {

constexpr float least_room = 1e-3f, max_room = 1e6f;
constexpr float surely = 0.999f;  // margin for rounding
constexpr float diagonal = 0.70710678f;
// The x and z of unit vectors in the eight directions.
constexpr std::array<float, Surroundings::sides> east{1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal},
    south{0, diagonal, 1, diagonal, 0, -diagonal, -1, -diagonal};  // +X, and +Z

// The octant (eighth of a turn, from +X to +Z, 0 … 7) that a horizontal direction is in.
std::size_t octant_of(float x, float z) {
  const bool steep = std::fabs(z) > std::fabs(x);
  if (z >= 0) return x >= 0 ? (steep ? 1 : 0) : (steep ? 2 : 3);
  return x < 0 ? (steep ? 5 : 4) : (steep ? 6 : 7);
}

}  // namespace

// Reads surroundings from sixteen numbers: the height of the horizon in eight directions (degrees), then the room in
// the same directions (metres), which are the corners of a polygon.
Result<Surroundings> Surroundings::of(std::span<const float> numbers) {
  if (numbers.size() != 2 * sides ||
      !std::all_of(numbers.begin(), numbers.end(), [](float each) { return std::isfinite(each); }))
    return bad_request(message(messages::growth::surroundings_not_sixteen));
  Surroundings about;
  about.is_open_ = false;
  for (std::size_t i = 0; i < sides; ++i) {
    about.horizon_[i] = std::clamp(numbers[i], 0.0f, 90.0f);
    about.room_[i] = std::clamp(numbers[sides + i], least_room, max_room);
  }
  // The distance to the line between two ends, at right angles.
  about.least_ = max_room;
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t next = (i + 1) % sides;
    const float x = about.room_[i] * east[i], z = about.room_[i] * south[i];
    const float way_x = about.room_[next] * east[next] - x, way_z = about.room_[next] * south[next] - z;
    const float near = (x * way_z - z * way_x) / std::sqrt(way_x * way_x + way_z * way_z);
    about.least_ = std::min(about.least_, surely * near);
  }
  return about;
}

// Whether all of a disc about a point is certainly inside the polygon of free room.
bool Surroundings::contains_around(const glm::vec3& p, float radius) const {
  return is_open_ || std::sqrt(p.x * p.x + p.z * p.z) + radius < least_;
}

// Whether a point is inside the polygon of free room: on the inner side of the edge in its octant.
bool Surroundings::contains(const glm::vec3& p) const {
  if (is_open_) return true;
  const std::size_t i = octant_of(p.x, p.z), next = (i + 1) % sides;
  const float x = room_[i] * east[i], z = room_[i] * south[i];
  const float way_x = room_[next] * east[next] - x, way_z = room_[next] * south[next] - z;
  return way_x * (p.z - z) - way_z * (p.x - x) >= 0;
}

// The directions of light, with a share of 0 for those below the horizon, which is interpolated between the eight.
std::vector<LightDirection> Surroundings::dimmed(std::vector<LightDirection> directions) const {
  if (is_open_) return directions;
  for (LightDirection& direction : directions) {
    const glm::vec3& way = direction.towards;
    float turns = arc_tangent(way.z, way.x) * (static_cast<float>(sides) / (2 * pi));
    if (turns < 0) turns += static_cast<float>(sides);
    const auto i = std::min(static_cast<std::size_t>(turns), sides - 1);
    const float share = turns - static_cast<float>(i);
    const float height = (1 - share) * horizon_[i] + share * horizon_[(i + 1) % sides];
    if (way.y < sine(height * pi / 180)) direction.share = 0;
  }
  return directions;
}

}  // namespace panicle::growth
