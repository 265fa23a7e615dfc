#include "generalized_map/check.hpp"

#include <doctest/doctest.h>

#include <string>

#include "maps.hpp"

namespace panicle::generalized_map {

struct RawAccess {
  static std::uint32_t& alpha(Map& map, std::uint32_t i, std::uint32_t d) { return map.alpha_[i][d]; }
  static std::uint32_t& volume_of(Map& map, std::uint32_t d) { return map.volume_[d]; }
  static Face& face_of(Map& map, std::uint32_t d) { return map.face_[d]; }
  static Volume& volume(Map& map, std::uint32_t v) { return map.list_[v]; }
  static std::uint32_t& corner(Map& map, std::uint32_t i) { return map.corners_[i]; }
  static void sew(Map& map, std::uint32_t i, std::uint32_t a, std::uint32_t b) { map.sew(i, a, b); }
};

}  // namespace panicle::generalized_map

using namespace panicle::generalized_map;

namespace {

// Of everything: sewn, attached, glued, split.
Map example() {
  Map map = corner_of_cubes();
  map.glue(1, side(2), 2, side(4));
  map.grow(0, end_face, 6, 0);
  map.split(0, base_face, 0, 0);
  map.split(2, side(3), 0, 0);
  return map;
}

std::string found(const Map& map) { return words(check(map).fault); }

}  // namespace

TEST_CASE("every kind of fault is found and named") {
  const Map whole = example();
  CHECK(found(whole) == "nothing");
  const auto spoilt = [&](const auto& spoil) {
    Map map = whole;
    spoil(map);
    return check(map).fault;
  };
  CHECK(spoilt([](Map& map) { RawAccess::alpha(map, 3, 5) = map.darts(); }) == Fault::dangling);
  CHECK(spoilt([](Map& map) { RawAccess::alpha(map, 1, 5) = none; }) == Fault::dangling);
  CHECK(spoilt([](Map& map) { RawAccess::alpha(map, 0, 5) = 9; }) == Fault::involution);
  CHECK(spoilt([](Map& map) { RawAccess::alpha(map, 1, 5) = 5; }) == Fault::involution);
  CHECK(spoilt([](Map& map) {
          const std::uint32_t other = map.alpha(1, 5);
          RawAccess::alpha(map, 1, 5) = 5;
          RawAccess::alpha(map, 1, other) = other;
        }) == Fault::fixed);
  CHECK(spoilt([](Map& map) {  // two edges of different faces, each sewn to the other's at one end alone
          const std::uint32_t a = map.base_corner(1, 0), b = map.base_corner(1, 2);
          const std::uint32_t a2 = map.alpha(2, a), b2 = map.alpha(2, b);
          RawAccess::sew(map, 2, a, b2);
          RawAccess::sew(map, 2, b, a2);
        }) == Fault::product);
  CHECK(spoilt([](Map& map) { RawAccess::volume_of(map, 7) = 99; }) == Fault::foreign);
  CHECK(spoilt([](Map& map) { RawAccess::volume_of(map, 7) = 1; }) == Fault::foreign);
  CHECK(spoilt([](Map& map) { RawAccess::face_of(map, 7) = 3; }) == Fault::foreign);
  CHECK(spoilt([](Map& map) {  // two free sides of one volume sewn to each other
          const std::uint32_t v = map.grow(3, end_face, 6, 0).volume;
          std::uint32_t a = map.dart_of(v, side(1)), b = map.dart_of(v, side(3));
          for (int i = 0; i < 8; ++i) {
            RawAccess::sew(map, 3, a, b);
            a = map.alpha(i % 2, a);
            b = map.alpha(i % 2, b);
          }
        }) == Fault::folded);
  CHECK(spoilt([](Map& map) { ++RawAccess::volume(map, 1).vertices; }) == Fault::cells);
  CHECK(spoilt([](Map& map) { --RawAccess::volume(map, 1).edges; }) == Fault::cells);
  CHECK(spoilt([](Map& map) { ++RawAccess::volume(map, 1).faces; }) == Fault::cells);
  CHECK(spoilt([](Map& map) { std::swap(RawAccess::corner(map, 0), RawAccess::corner(map, 5)); }) == Fault::corner);
  CHECK(spoilt([](Map& map) { RawAccess::volume(map, 1).parent = 77; }) == Fault::descent);
  CHECK(spoilt([](Map& map) { RawAccess::volume(map, 1).parent_face = 6; }) == Fault::descent);
  CHECK(spoilt([](Map& map) { RawAccess::volume(map, 3).attached = false; }) == Fault::descent);
}

TEST_CASE("check finds a change of any single number of a map") {
  const Map whole = example();
  std::uint32_t unnoticed = 0;
  Map map = whole;
  for (std::uint32_t d = 0; d < map.darts(); ++d) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      std::uint32_t& alpha = RawAccess::alpha(map, i, d);
      const std::uint32_t was = alpha;
      for (const std::uint32_t other : {d ^ 1, (d + 7) % map.darts(), d, map.darts() + d}) {
        if (other == was) continue;
        alpha = other;
        unnoticed += check(map).fault == Fault::nothing;
      }
      alpha = was;
    }
    RawAccess::volume_of(map, d) ^= 1;
    unnoticed += check(map).fault == Fault::nothing;
    RawAccess::volume_of(map, d) ^= 1;
    RawAccess::face_of(map, d) ^= 1;
    unnoticed += check(map).fault == Fault::nothing;
    RawAccess::face_of(map, d) ^= 1;
  }
  CHECK(unnoticed == 0);
  CHECK(found(map) == "nothing");
}

TEST_CASE("a map of a million darts takes at most 40 bytes a dart, and has the cells that it should") {
  Map map;
  constexpr std::uint32_t order = 12, volumes = 7000;
  map.reserve(prism_darts(order) * volumes, volumes);
  map.plant(order, 0);
  for (std::uint32_t v = 1; v < volumes; ++v) map.grow(v - 1, end_face, order, 0);
  CHECK(map.darts() == 1'008'000);
  CHECK(map.bytes() <= 40ull * map.darts());
  CHECK(map.bytes() < 24ull * map.darts());
  CHECK(found(map) == "nothing");
}
