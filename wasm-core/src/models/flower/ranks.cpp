#include "models/flower/ranks.hpp"

#include <algorithm>

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

}  // namespace panicle::flower
