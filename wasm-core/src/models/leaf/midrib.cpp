#include "models/leaf/midrib.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "models/particles/waypoints.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float detour_cell = 0.04f;  // of the waypoints that a bent main vein follows

}  // namespace

// The first place that is at least `length` along the midrib from the base.
std::size_t Midrib::at(float length) const {
  const auto after = std::lower_bound(lengths.begin(), lengths.end(), length);
  return std::min<std::size_t>(static_cast<std::size_t>(after - lengths.begin()), places.size() - 1);
}

// The direction of the midrib at place i: a unit vector towards the tip.
glm::vec2 Midrib::heading(std::size_t i) const {
  const glm::vec3 way = places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0];
  const float size = glm::length(way);
  return size > 0 ? flat(way) / size : glm::vec2(0, 1);
}

// Adds a place that leads to the place `next` of the ribs; returns its index.
std::int32_t add(Ribs& ribs, std::int32_t next, const glm::vec3& place) {
  ribs.places.push_back(place);
  ribs.next.push_back(next);
  return static_cast<std::int32_t>(ribs.places.size()) - 1;
}

// Adds a midrib with these places, the first of which is the base, to the ribs.
Midrib build_midrib(Ribs& ribs, std::vector<glm::vec3> places) {
  Midrib midrib{std::move(places), {0}, {0}};
  for (std::size_t i = 1; i < midrib.places.size(); ++i) {
    midrib.numbers.push_back(add(ribs, midrib.numbers.back(), midrib.places[i]));
    midrib.lengths.push_back(midrib.lengths.back() + glm::distance(midrib.places[i - 1], midrib.places[i]));
  }
  return midrib;
}

// Rounds the corners of a line: in each pass moves each place halfway to the middle of its neighbours, where that stays
// clear of the margin.
void round_off(std::vector<glm::vec3>& places, const Outline& outline, int passes) {
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
      const glm::vec3 drawn = 0.5f * places[i] + 0.25f * (places[i - 1] + places[i + 1]);
      if (outline.contains(drawn) && outline.keeps_off(drawn, before_margin)) places[i] = drawn;
    }
}

// Whether the straight line between a base on the margin and an end stays in the outline.
bool straight(const glm::vec3& base, const glm::vec3& end, const Outline& outline) {
  const glm::vec3 start = base + 1e-3f * (end - base);
  return outline.contains(start) && outline.contains(end) && outline.holds(start, end);
}

// The line of a main vein from the base nearly to the tip, a place each stride: straight if the outline allows, else
// the shortest way around its corners, rounded.
std::vector<glm::vec3> main_vein(const glm::vec3& base, const glm::vec3& tip, const Outline& outline) {
  std::vector<glm::vec3> corners{base};
  const glm::vec3 end = base + before_tip * (tip - base);
  if (!straight(base, end, outline)) {
    Waypoints ways(outline, {tip}, detour_cell);
    glm::vec3 at = base;
    for (int k = 0; k < 64 && glm::distance(at, tip) > stride; ++k) {
      const glm::vec3 next = ways.next(at);
      if (next == tip || next == at) break;
      corners.push_back(at = next);
    }
    const glm::vec3 last = at + before_tip * (tip - at);
    if (outline.holds(at, last)) corners.push_back(last);
  } else {
    corners.push_back(end);
  }
  std::vector<glm::vec3> places{base};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const float count = std::max(1.0f, std::ceil(glm::distance(corners[i - 1], corners[i]) / stride));
    for (float k = 1; k <= count; ++k) places.push_back(corners[i - 1] + (k / count) * (corners[i] - corners[i - 1]));
  }
  if (corners.size() > 2) round_off(places, outline, 40);
  return places;
}

}  // namespace panicle::particles::leaf
