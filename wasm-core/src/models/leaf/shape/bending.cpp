#include "models/leaf/shape/bending.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace panicle::particles::leaf {
namespace {

constexpr float crease = 0.08f;       // of the half width: distance from the midrib within which a fold is round
constexpr float second_side = 0.37f;  // of a wave: delay of the left margin's waves
constexpr float beside = 1e-3f;       // leaf lengths, for slopes
constexpr float straight = 0.05f;     // degrees below which there is no curl

}  // namespace

// The place of a point p of the flat chart (leaf lengths) on the bent middle surface, in metres. `folded` is the sine
// and cosine of the fold's angle.
glm::vec3 Bending::sheet(const glm::vec2& p, const SinCos& folded) const {
  // Across: both halves turned up, round at the crease.
  const float radius = crease * half_width, out = std::sqrt(p.x * p.x + radius * radius) - radius;
  const auto [rise, reach] = folded;
  const float x = p.x * reach;
  float z = out * rise;
  // Waves grow with the square of the distance from the midrib.
  const float across = p.x / half_width, wave = waves * p.y + (p.x < 0 ? second_side : 0.0f);
  z += undulation * half_width * std::min(across * across, 2.0f) * sincos_degrees(360 * (wave - std::floor(wave))).sine;
  if (std::fabs(curl) < straight) return scale * glm::vec3(x, p.y, z);
  // Along: a circular arc, which turns the tip down.
  const float radius_of_arc = 180 / (curl * pi);
  const auto [sine, cosine] = sincos_degrees(curl * p.y);
  return scale * glm::vec3(x, (radius_of_arc + z) * sine, (radius_of_arc + z) * cosine - radius_of_arc);
}

// The unit normal of the upper face, from central differences.
glm::vec3 Bending::normal(const glm::vec2& p) const {
  const SinCos folded = sincos_degrees(fold);
  const auto at = [&](float x, float y) { return sheet(p + glm::vec2(x, y), folded); };
  const glm::vec3 across = at(beside, 0) - at(-beside, 0), up = at(0, beside) - at(0, -beside);
  const glm::vec3 normal = glm::cross(across, up);
  const float length = glm::length(normal);
  return length > 0 ? normal / length : glm::vec3(0, 0, 1);
}

// The place `above` metres over the middle surface at the point p of the chart.
glm::vec3 Bending::operator()(const glm::vec2& p, float above) const {
  const glm::vec3 flat = sheet(p, sincos_degrees(fold));
  return above == 0 ? flat : flat + above * normal(p);
}

}  // namespace panicle::particles::leaf
