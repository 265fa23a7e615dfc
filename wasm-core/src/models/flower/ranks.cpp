#include "models/flower/ranks.hpp"

#include <algorithm>
#include <cmath>

namespace panicle::flower {

// By volume, its position in its organ: along it from 0 at the base to 1 at the end, and beside its middle line from 0
// to 1.
std::vector<glm::vec2> organ_coordinates(const Derived& derived) {
  std::vector<glm::vec2> places(derived.map.volumes(), glm::vec2(0));
  std::vector<float> longest(derived.instances.size(), 0);
  std::vector<std::uint16_t> widest(derived.instances.size(), 0);
  const auto half = [&](std::uint32_t volume) {
    const VolumeValues& values = derived.values[derived.record_of[volume]];
    return 0.5f * std::abs(values[static_cast<std::size_t>(Field::translation)] *
                           values[static_cast<std::size_t>(Field::height)]);
  };
  for (const Record& record : derived.records) {
    const bool begins = record.before == invalid || record.instance != record.maker;
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

}  // namespace panicle::flower
