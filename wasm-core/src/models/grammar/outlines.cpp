#include "models/grammar/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::grammar {
namespace {

constexpr float fold = 0.25f;   // height of the margins above the midrib, over their distance
constexpr float droop = 0.16f;  // how far the tip lies below the base's plane
constexpr float point = 1e-3f;  // rays shorter than this have no length
constexpr std::uint32_t whole_rings = 3;

// The length of the outline's ray at t, 0 towards the tip … 1 towards the base: the offset plus a product of four
// factors, which are the fall to the base, exponential slimness, lobes and teeth.
float unscaled_ray(const Outline& outline, float t) {
  const auto waves = [t](float degrees) { return sincos_degrees(degrees * t).cosine; };
  return outline.offset + power(std::max(0.0f, 1 - outline.fall * t), outline.bow) * exponential(-outline.slim * t) *
                              power(1 - outline.lobe + outline.lobe * std::fabs(waves(outline.turns)), outline.round) *
                              (1 + outline.teeth * waves(3600));
}

// Normal of the surface z = fold · |x| − droop · y².
glm::vec3 normal_at(const glm::vec2& p) {
  const float across = p.x == 0 ? 0 : std::copysign(fold, p.x);
  return glm::normalize(glm::vec3(-across, 2 * droop * p.y, 1));
}

}  // namespace

// The length of the ray at t, from 0 towards the tip to 1 towards the base, over that towards the tip.
float ray(const Outline& outline, float t) { return unscaled_ray(outline, t) / unscaled_ray(outline, 0); }

// The mesh of a leaf blade inside an outline of rays from its base; folded along the midrib and drooping. `plain`:
// fewer triangles.
Mesh blade_within(const Outline& outline, bool plain) {
  const std::uint32_t rings = plain ? 1 : whole_rings;
  const auto rays = static_cast<std::int32_t>(plain ? outline.rays / 2 : outline.rays);
  std::vector<glm::vec2> ends;
  float across = 0;
  for (std::int32_t i = -rays; i <= rays; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(rays);
    const auto [sine, cosine] = sincos_degrees(outline.theta * t);
    ends.push_back(ray(outline, std::fabs(t)) * glm::vec2(sine, cosine));
    across = std::max(across, 2 * std::fabs(ends.back().x));
  }
  Mesh mesh;
  const auto add = [&](const glm::vec2& p) {
    put(mesh.positions, glm::vec3(p, fold * std::fabs(p.x) - droop * p.y * p.y));
    put(mesh.normals, normal_at(p));
    put(mesh.uvs, glm::vec2(0.5f + p.x / across, 1 - p.y));
  };
  add(glm::vec2(0));
  for (const glm::vec2& end : ends)
    for (std::uint32_t ring = 1; ring <= rings; ++ring)
      add(end * (static_cast<float>(ring) / static_cast<float>(rings)));
  // From left to right, so that triangles go round the upper side the other way. A ray without length has no area.
  for (std::uint32_t i = 0; i + 1 < ends.size(); ++i) {
    const std::uint32_t a = 1 + rings * i, b = a + rings;
    if (glm::length(ends[i]) < point || glm::length(ends[i + 1]) < point) continue;
    put(mesh.indices, 0u, b, a);
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      put(mesh.indices, a + ring, b + ring + 1, a + ring + 1);
      put(mesh.indices, a + ring, b + ring, b + ring + 1);
    }
  }
  return mesh;
}

}  // namespace panicle::grammar
