#include <doctest/doctest.h>

#include <array>
#include <string>

#include "foundation/english.hpp"
#include "maps.hpp"

using namespace panicle::generalized_map;

namespace {

// The boundary of a volume as a sphere's, and the cells as orbits that are gone through one by one.
void check_by_orbits(const Map& map) {
  std::vector<std::array<std::uint32_t, 3>> cells(map.volumes());
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Orbits orbits = orbits_of(map, of_cell(i) & in_volume);
    std::vector<bool> counted(orbits.count, false);
    for (std::uint32_t d = 0; d < map.darts(); ++d) {
      if (counted[orbits.of_dart[d]]) continue;
      counted[orbits.of_dart[d]] = true;
      ++cells[map.volume_of()[d]][i];
    }
  }
  for (std::uint32_t v = 0; v < map.volumes(); ++v) {
    CHECK(cells[v][0] == map.volume(v).vertices);
    CHECK(cells[v][1] == map.volume(v).edges);
    CHECK(cells[v][2] == map.volume(v).faces);
    CHECK(cells[v][0] - cells[v][1] + cells[v][2] == 2);
  }
  CHECK(orbits(map, in_volume) == map.volumes());
}

// Are the darts of two colours, so that every involution leads to the other one?
bool is_orientable(const Map& map) {
  std::vector<std::uint8_t> colour(map.darts(), 0);
  OrbitWalk walk(map);
  for (std::uint32_t first = 0; first < map.darts(); ++first) {
    if (colour[first]) continue;
    colour[first] = 1;
    for (const std::uint32_t d : walk.of(first, all_involutions))
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = map.alpha(i, d);
        if (next == d) continue;
        if (!colour[next]) colour[next] = static_cast<std::uint8_t>(3 - colour[d]);
        if (colour[next] == colour[d]) return false;
      }
  }
  return true;
}

struct Tally {
  std::array<std::uint32_t, static_cast<std::size_t>(Refusal::full) + 1> refusals{};
  std::uint32_t operations = 0, whole = 0;
};

// Sequences of 6 to 14 operations, each followed by the checker.
Tally run(std::uint64_t first, std::uint64_t end) {
  Tally tally;
  Map map;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    map.clear();
    const std::uint64_t turns = 6 + seed % 9;
    for (std::uint64_t turn = 0; turn < turns; ++turn) {
      ++tally.refusals[static_cast<std::size_t>(random_operation(map, seed, turn))];
      ++tally.operations;
      const Finding finding = check(map);
      tally.whole += finding.fault == Fault::nothing;
      if (finding.fault != Fault::nothing) {
        CAPTURE(seed);
        CAPTURE(turn);
        FAIL_CHECK(std::string(words(finding.fault)));
        break;
      }
    }
    if (seed % 20 == 0) {
      CAPTURE(seed);
      check_by_orbits(map);
      CHECK(is_orientable(map));
    }
  }
  return tally;
}

}  // namespace

// In parts, which the tests' runner has beside each other.
TEST_CASE("10,000 random sequences leave whole maps after every operation: 1") {
  const Tally tally = run(0, 5000);
  CHECK(tally.operations > 48'000);
  CHECK(tally.whole == tally.operations);
  CHECK(tally.refusals[static_cast<std::size_t>(Refusal::nothing)] > tally.operations / 2);
}

TEST_CASE("10,000 random sequences leave whole maps after every operation: 2") {
  const Tally tally = run(5000, 10'000);
  CHECK(tally.whole == tally.operations);
  for (const Refusal refusal : {Refusal::no_face, Refusal::occupied, Refusal::not_adjacent, Refusal::unequal,
                                Refusal::same_volume, Refusal::uneven, Refusal::folded}) {
    CAPTURE(panicle::english(message_of(refusal).encoded()));
    CHECK(tally.refusals[static_cast<std::size_t>(refusal)] > 0);
  }
}
