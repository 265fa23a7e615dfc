#include "models/leaf/petiole.hpp"

#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr int pieces = 14;
constexpr float under_blade = 0.04f;  // leaf lengths by which it begins before the blade's base
constexpr float bow = 35;             // degrees, over its length
constexpr float widens = 1.35f;       // at its foot
constexpr float taper_in = 0.6f;      // of its radius, where it begins under the midrib

}  // namespace

// Builds the petiole as segments of a stem: from under the blade's base away from the blade, with a bow downwards.
// `length` and `radius` in metres; empty if the length is 0.
std::vector<Segment> make_petiole(const Bending& bending, float length, float radius) {
  std::vector<Segment> segments;
  const auto add = [&](const glm::vec3& end, float from, float to) {
    const auto parent = static_cast<std::int32_t>(segments.size()) - 1;
    const glm::vec3 start = segments.empty() ? bending({0, under_blade}, -0.5f * radius) : segments.back().end;
    segments.push_back({parent, 0, start, end, from, to});
  };
  if (!(length > 0)) return segments;
  const glm::vec3 base = bending({0, 0});
  add(base, taper_in * radius, radius);
  const glm::vec3 start = bending({0, 0}) - bending({0, 0.01f});
  const glm::vec3 way = glm::length(start) > 0 ? glm::normalize(start) : glm::vec3(0, -1, 0);
  const glm::vec3 down = -bending.normal({0, 0});
  glm::vec3 at = base;
  for (int k = 0; k < pieces; ++k) {
    const float t = (static_cast<float>(k) + 0.5f) / pieces;
    const auto [sine, cosine] = sincos_degrees(bow * t);
    at += (length / pieces) * (cosine * way + sine * down);
    // The radius after a number of pieces; the petiole widens towards its foot.
    const auto girth = [&](int step) {
      const float share = static_cast<float>(step) / pieces;
      return radius * (1 + (widens - 1) * share * share * share);
    };
    add(at, girth(k), girth(k + 1));
  }
  return segments;
}

}  // namespace panicle::particles::leaf
