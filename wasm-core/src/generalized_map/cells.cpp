#include "generalized_map/cells.hpp"

#include <algorithm>
#include <tuple>

namespace panicle::generalized_map {

// A dart is one of the two half-edges of an edge of a face.

// Numbers the orbits of all darts under the given involutions: the darts of an orbit form one cell, such as a vertex.
Orbits orbits_of(const Map& map, Involved involved) {
  Orbits orbits;
  const std::uint32_t darts = map.darts();
  orbits.of_dart.assign(darts, none);
  std::vector<std::uint32_t> waiting;
  const std::uint32_t* generators[4];
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < 4; ++i)
    if (involved & with(i)) generators[count++] = map.alphas(i).data();
  for (std::uint32_t first = 0; first < darts; ++first) {
    if (orbits.of_dart[first] != none) continue;
    orbits.of_dart[first] = orbits.count;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const std::uint32_t d = waiting.back();
      waiting.pop_back();
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = generators[i][d];
        if (orbits.of_dart[next] != none) continue;
        orbits.of_dart[next] = orbits.count;
        waiting.push_back(next);
      }
    }
    ++orbits.count;
  }
  return orbits;
}

// The darts of one orbit, beginning with `dart`: all that can be reached from it by the involutions in the set
// `involved`; valid until the next call. A visited dart is marked with the number of the call.
std::span<const std::uint32_t> OrbitWalk::of(std::uint32_t dart, Involved involved) {
  seen_.resize(map_.darts(), 0);
  if (++question_ == 0) {
    std::fill(seen_.begin(), seen_.end(), 0);
    question_ = 1;
  }
  found_.assign(1, dart);
  seen_[dart] = question_;
  for (std::size_t at = 0; at < found_.size(); ++at)
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (!(involved & with(i))) continue;
      const std::uint32_t next = map_.alpha(i, found_[at]);
      if (seen_[next] == question_) continue;
      seen_[next] = question_;
      found_.push_back(next);
    }
  return found_;
}

// The volumes that are sewn to faces of the volume v, sorted, each pair of faces once.
std::vector<Neighbour> neighbours(OrbitWalk& walk, const Map& map, std::uint32_t v) {
  std::vector<Neighbour> found;
  for (const std::uint32_t d : walk.of(map.base_corner(v, 0), in_volume)) {
    const std::uint32_t beyond = map.alpha(3, d);
    if (beyond != d) found.push_back({map.face_of()[d], map.volume_of()[beyond], map.face_of()[beyond]});
  }
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::tie(a.own, a.volume, a.other) < std::tie(b.own, b.volume, b.other);
  });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Those neighbours of the volume v that have a label.
std::vector<Neighbour> neighbours(OrbitWalk& walk, const Map& map, std::uint32_t v, std::uint32_t label) {
  std::vector<Neighbour> found = neighbours(walk, map, v);
  std::erase_if(found, [&](const Neighbour& each) { return map.volume(each.volume).label != label; });
  return found;
}

}  // namespace panicle::generalized_map
