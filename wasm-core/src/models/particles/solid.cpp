#include "models/particles/solid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "foundation/mathematics.hpp"

namespace panicle::particles {

Solid::Solid(Surface surface) : surface_(std::move(surface)) {
  const std::vector<glm::vec3>& points = surface_.points;
  if (points.empty()) return;
  low_ = high_ = points[0];
  for (const glm::vec3& p : points) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  const std::size_t triangles = surface_.triangles.size() / 3;
  const std::size_t rows = std::clamp<std::size_t>(triangles, 1, 1024);
  row_height_ = std::max((high_.y - low_.y) / static_cast<float>(rows), std::numeric_limits<float>::min());
  first_.assign(rows + 1, 0);
  const auto reach = [this](std::size_t triangle) {
    const auto height = [&](std::size_t k) { return surface_.points[surface_.triangles[3 * triangle + k]].y; };
    const auto [low, high] = std::minmax({height(0), height(1), height(2)});
    return std::pair(row_of(low), row_of(high));
  };
  for (std::size_t t = 0; t < triangles; ++t)
    for (auto [row, last] = reach(t); row <= last; ++row) ++first_[row + 1];
  for (std::size_t row = 0; row < rows; ++row) first_[row + 1] += first_[row];
  members_.resize(first_[rows]);
  std::vector<std::uint32_t> free(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < triangles; ++t)
    for (auto [row, last] = reach(t); row <= last; ++row) members_[free[row]++] = t;
}

std::size_t Solid::row_of(float y) const {
  const auto rows = static_cast<float>(first_.size() - 1);
  return static_cast<std::size_t>(std::clamp((y - low_.y) / row_height_, 0.0f, rows - 1));
}

bool Solid::contains(const glm::vec3& p) const {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] >= low_[k] && p[k] <= high_[k])) return false;
  int turns = 0;
  const std::size_t row = row_of(p.y);
  for (std::uint32_t m = first_[row]; m < first_[row + 1]; ++m) {
    const std::uint32_t* corners = &surface_.triangles[3 * members_[m]];
    // Where the plane enters and leaves the triangle, in its own sense: corners at the plane's height count as below.
    glm::vec2 in(0), out(0);
    int crossed = 0;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& a = surface_.points[corners[k]];
      const glm::vec3& b = surface_.points[corners[(k + 1) % 3]];
      const bool below = a.y <= p.y;
      if (below == (b.y <= p.y)) continue;
      // From the lower end, so that both triangles at an edge find the same place.
      const glm::vec3& lower = below ? a : b;
      const glm::vec3& upper = below ? b : a;
      const float at = (p.y - lower.y) / (upper.y - lower.y);
      (below ? in : out) = {lower.x + at * (upper.x - lower.x), lower.z + at * (upper.z - lower.z)};
      ++crossed;
    }
    if (crossed != 2 || (in.y <= p.z) == (out.y <= p.z)) continue;
    const float side = (out.x - in.x) * (p.z - in.y) - (out.y - in.y) * (p.x - in.x);
    if (in.y <= p.z && side > 0) ++turns;
    if (out.y <= p.z && side < 0) --turns;
  }
  return turns != 0;
}

Surface box(const glm::vec3& low, const glm::vec3& high) {
  Surface made;
  for (std::uint32_t i = 0; i < 8; ++i)
    made.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  made.triangles = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  return made;
}

Surface revolved(std::span<const glm::vec2> profile, const glm::vec3& foot, std::uint32_t sides) {
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

Surface ellipsoid(const glm::vec3& centre, const glm::vec3& radii, std::uint32_t sides) {
  std::vector<glm::vec2> profile;
  const std::uint32_t rings = std::max(sides / 2, 2u);
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    const auto [sine, cosine] = sincos_degrees(180.0f * static_cast<float>(ring) / static_cast<float>(rings));
    profile.push_back({sine, -cosine});
  }
  Surface made = revolved(profile, glm::vec3(0), sides);
  made.points.front() = {0, -1, 0};
  made.points.back() = {0, 1, 0};
  for (glm::vec3& p : made.points) p = centre + p * radii;
  return made;
}

Surface scaled(const Surface& surface, const glm::vec3& about, float factor) {
  Surface made = surface;
  for (glm::vec3& p : made.points) p = about + factor * (p - about);
  return made;
}

}  // namespace panicle::particles
