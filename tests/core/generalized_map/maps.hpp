// Helpers of the tests of maps.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>

#include "foundation/random.hpp"
#include "generalized_map/cells.hpp"
#include "generalized_map/check.hpp"

namespace panicle::generalized_map {

inline std::uint32_t orbits(const Map& map, Involved involved) { return orbits_of(map, involved).count; }

inline bool is_whole(const Map& map) {
  const Finding finding = check(map);
  CAPTURE(finding.at);
  CHECK(std::string_view(words(finding.fault)) == "nothing");
  return finding.fault == Fault::nothing;
}

// A cube on a cube on a cube …, as a stem is.
inline Map stack_of(std::uint32_t order, std::uint32_t volumes, std::uint32_t label = 0) {
  Map map;
  map.plant(order, label);
  for (std::uint32_t v = 1; v < volumes; ++v) map.grow(v - 1, end_face, order, label);
  return map;
}

// Two lobes side by side on one side of a cube that lies between them and a third: three cubes, of which 1 and 2 have
// grown on sides of 0 that meet in an edge.
inline Map corner_of_cubes(std::uint32_t label = 0) {
  Map map;
  map.plant(4, label);
  map.grow(0, side(2), 4, label);
  map.grow(0, side(3), 4, label);
  return map;
}

// Tries one random operation, which may be refused; deterministic for the same numbers.
inline Refusal random_operation(Map& map, std::uint64_t seed, std::uint64_t turn, std::uint32_t largest = 6) {
  const auto draw = [&](std::uint64_t stream, std::uint32_t high) {
    return static_cast<std::uint32_t>(random_integer(seed, stream, turn, 0, static_cast<std::int32_t>(high)));
  };
  if (map.volumes() == 0) return map.plant(3 + draw(0, largest - 3), 0).refusal;
  const std::uint32_t v = draw(1, map.volumes() - 1);
  const auto face = static_cast<Face>(draw(2, map.volume(v).order + 1));
  const std::uint32_t kind = draw(3, 9);
  if (kind < 5)
    return map.grow(v, face, draw(4, 4) ? map.degree(map.dart_of(v, face)) : 3 + draw(5, largest - 3), draw(6, 2))
        .refusal;
  if (kind < 7) return map.split(v, face, draw(6, 2), draw(7, 2), turn / 4).refusal;
  if (kind < 9 && map.is_free(v, face)) {  // the neighbour across a gap: few random pairs are adjacent
    std::uint32_t d = map.dart_of(v, face);
    for (std::uint32_t turns = draw(8, 7); turns > 0; --turns) d = map.alpha(1, map.alpha(0, d));
    const std::uint32_t beyond = map.across_gap(d);
    return map.glue(v, face, map.volume_of()[beyond], map.face_of()[beyond]);
  }
  return map.glue(v, face, draw(9, map.volumes() - 1), static_cast<Face>(draw(10, 5)));
}

}  // namespace panicle::generalized_map
