#include "spatial/closed_surface.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <utility>

#include "foundation/bits.hpp"
#include "foundation/mathematics.hpp"

namespace panicle {

// The box between two corners, as twelve triangles.
Surface box(const glm::vec3& low, const glm::vec3& high) {
  Surface made;
  for (std::uint32_t i = 0; i < 8; ++i)
    made.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  made.triangles = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  return made;
}

// Revolves a profile of radii (x) and heights (y) about the vertical axis through `foot`; discs close it at both ends.
Surface surface_of_revolution(std::span<const glm::vec2> profile, const glm::vec3& foot, std::uint32_t sides) {
  Surface made;
  if (profile.empty()) return made;
  const auto middle = [&](float y) { made.points.push_back(foot + glm::vec3(0, y, 0)); };
  middle(profile.front().y);
  for (const glm::vec2& ring : profile)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const auto [sine, cosine] = sincos_degrees(360.0f * static_cast<float>(k) / static_cast<float>(sides));
      made.points.push_back(foot + glm::vec3(ring.x * cosine, ring.y, ring.x * sine));
    }
  middle(profile.back().y);
  const auto at = [&](std::size_t ring, std::uint32_t k) {
    return static_cast<std::uint32_t>(1 + ring * sides + k % sides);
  };
  const auto top = static_cast<std::uint32_t>(made.points.size() - 1);
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    made.triangles.insert(made.triangles.end(), {a, b, c});
  };
  for (std::uint32_t k = 0; k < sides; ++k) {
    triangle(0, at(0, k), at(0, k + 1));
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
      triangle(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
      triangle(at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
    }
    triangle(top, at(profile.size() - 1, k + 1), at(profile.size() - 1, k));
  }
  return made;
}

// An ellipsoid with `sides` segments around the vertical axis and half as many rows from pole to pole.
Surface ellipsoid(const glm::vec3& centre, const glm::vec3& radii, std::uint32_t sides) {
  std::vector<glm::vec2> profile;
  const std::uint32_t rings = std::max(sides / 2, 2u);
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    const auto [sine, cosine] = sincos_degrees(180.0f * static_cast<float>(ring) / static_cast<float>(rings));
    profile.push_back({sine, -cosine});
  }
  Surface made = surface_of_revolution(profile, glm::vec3(0), sides);
  made.points.front() = {0, -1, 0};
  made.points.back() = {0, 1, 0};
  for (glm::vec3& p : made.points) p = centre + p * radii;
  return made;
}

// The surface scaled about a point.
Surface scaled(const Surface& surface, const glm::vec3& about, float factor) {
  Surface made = surface;
  for (glm::vec3& p : made.points) p = about + factor * (p - about);
  return made;
}

// The surface stretched so that its box is the one from `low` to `high`.
Surface stretched(Surface surface, const glm::vec3& low, const glm::vec3& high) {
  if (surface.points.empty()) return surface;
  glm::vec3 from = surface.points[0], to = from;
  for (const glm::vec3& p : surface.points) {
    from = glm::min(from, p);
    to = glm::max(to, p);
  }
  for (glm::vec3& p : surface.points)
    for (int k = 0; k < 3; ++k)
      p[k] = to[k] > from[k] ? low[k] + (high[k] - low[k]) * ((p[k] - from[k]) / (to[k] - from[k]))
                             : 0.5f * (low[k] + high[k]);
  return surface;
}

// Appends another surface's points and triangles.
void append(Surface& surface, const Surface& other) {
  const auto first = static_cast<std::uint32_t>(surface.points.size());
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for (const std::uint32_t corner : other.triangles) surface.triangles.push_back(first + corner);
}

// Counts the edges where a surface is open or turned over: sorts the edges of all triangles, so that those between the
// same two places are next to each other.
Seams seams_of(const Surface& surface) {
  // Points at the same place are one: each has the number of the first of them in an order of places.
  using Place = std::array<std::uint32_t, 3>;
  std::vector<std::pair<Place, std::uint32_t>> places;
  places.reserve(surface.points.size());
  for (const glm::vec3& p : surface.points)
    places.push_back({{bit_cast<std::uint32_t>(p.x + 0.0f), bit_cast<std::uint32_t>(p.y + 0.0f),
                       bit_cast<std::uint32_t>(p.z + 0.0f)},
                      static_cast<std::uint32_t>(places.size())});
  std::sort(places.begin(), places.end());
  std::vector<std::uint32_t> number(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    number[places[i].second] =
        i > 0 && places[i].first == places[i - 1].first ? number[places[i - 1].second] : places[i].second;
  // The ends of each edge, the lower number first, and whether it is run through upwards.
  struct Run {
    std::uint32_t low, high;
    int up;
    // Whether two runs are of one edge, in either direction.
    bool same_edge(const Run& other) const { return low == other.low && high == other.high; }
  };
  std::vector<Run> runs;
  runs.reserve(surface.triangles.size());
  for (std::size_t t = 0; t + 2 < surface.triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = number[surface.triangles[t + k]], b = number[surface.triangles[t + (k + 1) % 3]];
      if (a != b) runs.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(runs.begin(), runs.end(), [](const Run& one, const Run& other) {
    return one.low != other.low ? one.low < other.low : one.high < other.high;
  });
  Seams seams;
  for (std::size_t i = 0; i < runs.size();) {
    const std::size_t first = i;
    int sum = 0;
    for (; i < runs.size() && runs[i].same_edge(runs[first]); ++i) sum += runs[i].up;
    if ((i - first) % 2 != 0)
      ++seams.open;
    else if (sum != 0)
      ++seams.turned;
  }
  return seams;
}

}  // namespace panicle
