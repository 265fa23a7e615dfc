#include "models/flower/ranks.hpp"

#include <algorithm>
#include <cmath>

namespace panicle::flower {

std::vector<glm::vec2> places_in_organs(const Derived& derived) {
  std::vector<glm::vec2> places(derived.map.volumes(), glm::vec2(0));
  std::vector<float> longest(derived.instances.size(), 0);
  std::vector<std::uint16_t> widest(derived.instances.size(), 0);
  const auto half = [&](std::uint32_t volume) {
    const VolumeValues& values = derived.values[derived.record_of[volume]];
    return 0.5f * std::abs(values[static_cast<std::size_t>(Field::translation)] *
                           values[static_cast<std::size_t>(Field::height)]);
  };
  for (const Record& record : derived.records) {
    const bool begins = record.before == nobody || record.instance != record.maker;
    widest[record.instance] = std::max(widest[record.instance], record.rank.beside);
    if (begins || record.kind == Record::Kind::rest) continue;
    const std::uint32_t before = derived.records[record.before].volume, v = record.volume;
    places[v].x = places[before].x + (record.rank.beside == 0 ? half(before) + half(v) : 0);
    longest[record.instance] = std::max(longest[record.instance], places[v].x);
  }
  for (std::uint32_t v = 0; v < places.size(); ++v) {
    const Record& record = derived.records[derived.record_of[v]];
    const float along = longest[record.instance];
    const std::uint16_t beside = widest[record.instance];
    places[v] = {along > 0 ? places[v].x / along : 0,
                 beside > 0 ? static_cast<float>(record.rank.beside) / static_cast<float>(beside) : 0};
  }
  return places;
}

std::vector<glm::vec2> places_of_corners(const Derived& derived, const ClosedSurface& surface,
                                         const std::vector<std::uint32_t>& volume) {
  const std::vector<glm::vec2> places = places_in_organs(derived);
  const auto organ = [&](std::uint32_t half) {
    return derived.records[derived.record_of[volume[surface.face[half]]]].instance;
  };
  // Half-edges by their origins: those of a vertex stand together.
  std::vector<std::uint32_t> begin(surface.positions.size() + 1, 0), about(surface.half_edges());
  for (const std::uint32_t vertex : surface.origin) ++begin[vertex + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) about[end[surface.origin[h]]++] = h;

  std::vector<glm::vec2> corners(surface.half_edges());
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    float along = 0, beside = 1, count = 0;
    for (std::uint32_t i = begin[surface.origin[h]]; i < end[surface.origin[h]]; ++i) {
      if (organ(about[i]) != organ(h)) continue;
      const glm::vec2& place = places[volume[surface.face[about[i]]]];
      along += place.x;
      beside = std::min(beside, place.y);
      ++count;
    }
    corners[h] = {along / count, beside};
  }
  return corners;
}

std::vector<glm::vec2> refined_places(const ClosedSurface& surface, const std::vector<glm::vec2>& corners) {
  std::vector<glm::vec3> sums(surface.faces, glm::vec3(0));
  std::vector<glm::vec2> fine(4 * corners.size());
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    const std::uint32_t next = surface.next[h];
    sums[surface.face[h]] += glm::vec3(corners[h], 1);
    fine[4 * h] = corners[h];
    fine[4 * h + 1] = fine[4 * next + 3] = 0.5f * (corners[h] + corners[next]);
  }
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    const glm::vec3& sum = sums[surface.face[h]];
    fine[4 * h + 2] = {sum.x / sum.z, sum.y / sum.z};
  }
  return fine;
}

}  // namespace panicle::flower
