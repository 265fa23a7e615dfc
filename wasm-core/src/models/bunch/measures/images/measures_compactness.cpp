#include "models/bunch/measures/images/measures_compactness.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "spatial/point_grid.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

constexpr std::size_t nearest_few = 3;
constexpr float about = 6;         // number of nearest berries over which pressure is averaged
constexpr float touching = 0.03f;  // gap over mean diameter up to which berries count as touching

// Half of a berry's extent along the unit vector `u`: the mean of the furthest point (support) and of the skin on the
// line through its centre, which for a ball are the same.
float half_extent(const BerryBody& berry, const glm::vec3& u) {
  const float along = berry.direction.x * u.x + berry.direction.y * u.y + berry.direction.z * u.z;
  const float w = berry.half_width * berry.half_width, l = berry.half_length * berry.half_length;
  const float support = std::sqrt(w + (l - w) * along * along);
  const float inverse = (1 - along * along) / w + along * along / l;
  return (support + 1 / std::sqrt(inverse)) / 2;
}

// The gap between the skins of two berries, below 0 where they overlap; `most` if it is certainly larger.
float gap_between(const BerryBody& a, const BerryBody& b, float most) {
  const glm::vec3 away = b.centre - a.centre;
  const float square = away.x * away.x + away.y * away.y + away.z * away.z;
  const float far = most + std::max(a.half_width, a.half_length) + std::max(b.half_width, b.half_length);
  if (square >= far * far) return most;
  const float distance = std::sqrt(square);
  const glm::vec3 u = distance > 0 ? away / distance : glm::vec3(0, 1, 0);
  return distance - half_extent(a, u) - half_extent(b, u);
}

// A value over a whole, limited to 0 … 1.
float share(float value, float whole) { return std::clamp(value / whole, 0.0f, 1.0f); }

}  // namespace

// How close together berries are: mean gap to the nearest three (at most a mean diameter each), mean number of
// contacts, and mean overlap over six neighbours and the diameter.
Compactness measure_compactness(const Subject& subject) {
  const float diameter = 2 * subject.mean_radius;
  float furthest = 0;
  std::vector<glm::vec3> centres;
  for (const BerryBody& berry : subject.berries) {
    centres.push_back(berry.centre);
    furthest = std::max({furthest, berry.half_width, berry.half_length});
  }
  const PointGrid near(centres, 2 * furthest + diameter);
  Compactness sums;
  for (std::uint32_t i = 0; i < subject.berries.size(); ++i) {
    std::array<float, nearest_few> gaps;
    gaps.fill(diameter);
    near.visit(centres[i], [&](std::uint32_t j) {
      if (j == i) return;
      const float gap = gap_between(subject.berries[i], subject.berries[j], diameter);
      sums.contacts += gap < touching * diameter;
      sums.pressed += std::max(0.0f, -gap) / (about * diameter);
      float rest = std::max(gap, 0.0f);
      for (float& one : gaps)
        if (rest < one) std::swap(rest, one);
    });
    for (const float gap : gaps) sums.gap += gap / nearest_few;
  }
  const auto count = static_cast<float>(subject.berries.size());
  return {sums.gap / count, sums.contacts / count, sums.pressed / count};
}

// The density note, 1 (very loose) … 9 (very dense), of OIV descriptor 204: a sum of how close, hidden, held and
// deformed the berries are. `pedicels_seen`: share of their length, 0 … 1.
float density_note(const Subject& subject, const Compactness& compactness, float pedicels_seen) {
  constexpr float apart = 0.5f;  // gap over diameter at which berries are wholly apart
  constexpr float bared = 0.7f;  // share of pedicels visible at which all count as visible
  constexpr float held =
      6;  // contacts that hold every berry fast, as in a heap of balls just jammed; four can hold one
  constexpr float deformed = 0.16f;  // pressure at which berries are deformed
  const float close = 1 - share(compactness.gap, apart * 2 * subject.mean_radius);
  const float hidden = 1 - share(pedicels_seen, bared);
  return 1 + 2 * close + 2 * hidden + 2 * share(compactness.contacts, held) + 2 * share(compactness.pressed, deformed);
}

}  // namespace panicle::bunch
