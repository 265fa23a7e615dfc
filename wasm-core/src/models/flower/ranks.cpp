#include "models/flower/ranks.hpp"

#include <algorithm>
#include <cmath>

namespace panicle::flower {

Ranks ranks_of(const Derived& derived) {
  Ranks ranks;
  ranks.of_volume.resize(derived.map.volumes());
  ranks.most.resize(derived.instances.size());
  for (const Record& record : derived.records) {
    if (record.kind == Record::Kind::rest) continue;
    Rank& rank = ranks.of_volume[record.volume];
    const bool begins = record.before == nobody || record.instance != record.maker;
    if (!begins) {
      rank = ranks.of_volume[derived.records[record.before].volume];
      const bool on_axis = rank.beside == 0 && record.side == 0;
      ++(on_axis ? rank.along : rank.beside);
    }
    Rank& most = ranks.most[record.instance];
    most.along = std::max(most.along, rank.along);
    most.beside = std::max(most.beside, rank.beside);
  }
  return ranks;
}

std::vector<glm::vec2> places_in_organs(const Derived& derived) {
  const Ranks ranks = ranks_of(derived);
  std::vector<glm::vec2> places(derived.map.volumes(), glm::vec2(0));
  std::vector<float> longest(derived.instances.size(), 0);
  const auto half = [&](std::uint32_t volume) {
    const VolumeValues& values = derived.values[derived.record_of[volume]];
    return 0.5f * std::abs(values[static_cast<std::size_t>(Field::translation)] *
                           values[static_cast<std::size_t>(Field::height)]);
  };
  for (const Record& record : derived.records) {
    const bool begins = record.before == nobody || record.instance != record.maker;
    if (begins || record.kind == Record::Kind::rest) continue;
    const std::uint32_t before = derived.records[record.before].volume, v = record.volume;
    places[v].x = places[before].x + (ranks.of_volume[v].beside == 0 ? half(before) + half(v) : 0);
    longest[record.instance] = std::max(longest[record.instance], places[v].x);
  }
  for (std::uint32_t v = 0; v < places.size(); ++v) {
    const std::uint32_t instance = derived.records[derived.record_of[v]].instance;
    const float along = longest[instance];
    const std::uint16_t beside = ranks.most[instance].beside;
    places[v] = {along > 0 ? places[v].x / along : 0,
                 beside > 0 ? static_cast<float>(ranks.of_volume[v].beside) / static_cast<float>(beside) : 0};
  }
  return places;
}

}  // namespace panicle::flower
