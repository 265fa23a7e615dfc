#include "mesh/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "foundation/rotation.hpp"
#include "mesh/normals.hpp"

namespace panicle {
namespace {

// As a share of the polygon's size: points nearer than this are one place.
constexpr float same_place = 1e-6f;
// As a share of the square of a triangle's longest edge: triangles with less area are lines.
constexpr float flat = 1e-6f;
// The most tests of corners in an ear; then ears are taken as they come, so that every polygon takes limited time.
constexpr std::uint64_t max_looks = 20'000'000, looks_a_unit = 8;

// Whether all coordinates are finite: infinity and NaN minus themselves are NaN.
bool is_finite(const glm::vec3& p) { return p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0; }

// Twice the signed area of a triangle; positive if it is counter-clockwise.
float twice_area(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Triangulator of a polygon in space by clipping ears: corners whose triangle contains no other corner.
class Clipper {
 public:
  // Prepares a polygon, seen along its mean normal: drops corners that are not finite or repeated. `most`: the greatest
  // number of looks, units of work.
  Clipper(std::span<const glm::vec3> corners, std::uint64_t most) : most_(most) {
    measure(corners);
    if (!(size_ > 0)) return;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (is_finite(corners[i])) add(corners[i], static_cast<std::uint32_t>(i));
    while (places_.size() > 1 && same_point(places_.front(), places_.back())) remove_last();
  }

  // The triangles as indices of corners; empty if all lie on a line.
  std::vector<std::uint32_t> fill() {
    if (places_.size() < 3 || !project()) return {};
    clip_ears();
    return std::move(triangles_);
  }
  std::uint64_t looks() const { return looks_; }

 private:
  // Normalises the corners to the polygon's box, so that no square overflows or vanishes.
  void measure(std::span<const glm::vec3> corners) {
    glm::vec3 low(3e38f), high(-3e38f);
    for (const glm::vec3& p : corners) {
      if (!is_finite(p)) continue;
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    if (!(low.x <= high.x)) return;
    middle_ = 0.5f * low + 0.5f * high;
    const glm::vec3 half = 0.5f * high - 0.5f * low;
    size_ = std::max({half.x, half.y, half.z});
  }

  // Whether two points coincide.
  static bool same_point(const glm::vec3& a, const glm::vec3& b) {
    return glm::dot(a - b, a - b) <= same_place * same_place;
  }

  // Adds a corner with its index, unless it coincides with the last one.
  void add(const glm::vec3& corner, std::uint32_t number) {
    const glm::vec3 place = (corner - middle_) / size_;
    if (!places_.empty() && same_point(place, places_.back())) return;
    places_.push_back(place);
    numbers_.push_back(number);
  }
  // Removes the last corner.
  void remove_last() {
    places_.pop_back();
    numbers_.pop_back();
  }

  // Projects the polygon along its normal (Newell); for a figure of eight without one, along that of the largest
  // triangle at its first corner. Returns false if all corners lie on a line.
  bool project() {
    glm::vec3 normal(0), largest(0);
    const glm::vec3& first = places_[0];
    for (std::size_t i = 1; i + 1 < places_.size(); ++i) {
      const glm::vec3 own = triangle_normal(first, places_[i], places_[i + 1]);
      normal += own;
      if (glm::dot(own, own) > glm::dot(largest, largest)) largest = own;
    }
    if (glm::dot(normal, normal) < 1e-4f * glm::dot(largest, largest)) normal = largest;
    const float length = glm::length(normal);
    if (!(length > flat * flat)) return false;
    normal /= length;
    const glm::vec3 reference = axis_across(normal, 0.7f, {1, 0, 0}, {0, 1, 0});
    const glm::vec3 right = glm::normalize(glm::cross(reference, normal)), up = glm::cross(normal, right);
    for (const glm::vec3& p : places_) flat_.emplace_back(glm::dot(p, right), glm::dot(p, up));
    return true;
  }

  // Clips ears until three corners are left, in a linked list of corners.
  void clip_ears() {
    const std::size_t count = places_.size();
    before_.resize(count);
    after_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      before_[i] = static_cast<std::uint32_t>((i + count - 1) % count);
      after_[i] = static_cast<std::uint32_t>((i + 1) % count);
    }
    std::uint32_t at = 0;
    for (std::size_t left = count; left > 2; --left) {
      at = next_ear(at, left);
      take_ear(at);
      // Skips a corner after each ear: ears all around instead of a fan.
      at = after_[after_[at]];
    }
  }

  // The next corner whose ear holds no other; where there is none, as in polygons that cross themselves, the most
  // pointed one.
  std::uint32_t next_ear(std::uint32_t from, std::size_t left) {
    std::uint32_t sharpest = from;
    float least = 3e38f;
    for (std::uint32_t at = from; left-- > 0; at = after_[at]) {
      if (++looks_ > most_) return from;
      const float turn = twice_area(flat_[before_[at]], flat_[at], flat_[after_[at]]);
      if (turn >= 0 && is_ear(at)) return at;
      if (turn >= 0 && turn < least) {
        least = turn;
        sharpest = at;
      }
    }
    return sharpest;
  }

  // Whether the triangle at a corner contains no other corner.
  bool is_ear(std::uint32_t at) {
    const glm::vec2 &a = flat_[before_[at]], &b = flat_[at], &c = flat_[after_[at]];
    for (std::uint32_t other = after_[after_[at]]; other != before_[at]; other = after_[other]) {
      ++looks_;
      const glm::vec2& p = flat_[other];
      if (p == a || p == b || p == c) continue;
      if (twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0) return false;
    }
    return true;
  }

  // Removes a corner, and adds its triangle unless it is a line; counter-clockwise.
  void take_ear(std::uint32_t at) {
    const std::uint32_t before = before_[at], after = after_[at];
    after_[before] = after;
    before_[after] = before;
    const glm::vec3 &a = places_[before], &b = places_[at], &c = places_[after];
    const glm::vec3 twice = triangle_normal(a, b, c);
    const float longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    if (!(glm::length(twice) > flat * longest)) return;
    const bool turned = twice_area(flat_[before], flat_[at], flat_[after]) < 0;
    triangles_.push_back(numbers_[before]);
    triangles_.push_back(numbers_[turned ? after : at]);
    triangles_.push_back(numbers_[turned ? at : after]);
  }

  glm::vec3 middle_{0};
  float size_ = 0;
  std::vector<glm::vec3> places_;
  std::vector<glm::vec2> flat_;
  std::vector<std::uint32_t> numbers_, before_, after_, triangles_;
  std::uint64_t looks_ = 0, most_;
};

}  // namespace

// Triangulates a polygon in space; the work counts against the budget, unless that is null.
std::vector<std::uint32_t> fill_polygon(std::span<const glm::vec3> corners, WorkBudget* budget) {
  Clipper clipper(corners, budget == nullptr ? max_looks : std::min(max_looks, looks_a_unit * budget->left()));
  std::vector<std::uint32_t> triangles = clipper.fill();
  if (budget != nullptr) budget->spend(1 + (clipper.looks() + corners.size()) / looks_a_unit);
  return triangles;
}

}  // namespace panicle
