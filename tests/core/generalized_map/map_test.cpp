#include "generalized_map/map.hpp"

#include <doctest/doctest.h>

#include "foundation/english.hpp"
#include "maps.hpp"

using namespace panicle::generalized_map;

TEST_CASE("a prism of any order n has 12 n darts, 2 n vertices, 3 n edges and n + 2 faces") {
  for (const std::uint32_t n : {3u, 4u, 5u, 21u, 1000u, 4096u}) {
    CAPTURE(n);
    Map map;
    CHECK(map.plant(n, 7).volume == 0);
    CHECK(is_whole(map));
    CHECK(map.darts() == 12 * n);
    CHECK(map.volume(0).label == 7);
    CHECK(orbits(map, of_cell(0)) == 2 * n);
    CHECK(orbits(map, of_cell(1)) == 3 * n);
    CHECK(orbits(map, of_cell(2)) == n + 2);
    CHECK(orbits(map, of_cell(3)) == 1);
    CHECK(map.degree(map.dart_of(0, base_face)) == n);
    CHECK(map.degree(map.dart_of(0, end_face)) == n);
    for (std::uint32_t i = 1; i <= n; i += n / 3) {
      const std::uint32_t lower_left = map.dart_of(0, side(i));
      CHECK(map.face_of()[lower_left] == side(i));
      CHECK(map.degree(lower_left) == 4);
      CHECK(map.alpha(2, lower_left) == map.base_corner(0, i - 1));
      CHECK(map.is_free(0, side(i)));
    }
  }
}

TEST_CASE("a volume that grows on a face of its order is sewn: the two faces become one") {
  Map map;
  map.plant(6, 0);
  const GrowResult up = map.grow(0, end_face, 6, 1);
  CHECK(up.refusal == Refusal::nothing);
  CHECK_FALSE(up.attached);
  CHECK(is_whole(map));
  CHECK(orbits(map, of_cell(0)) == 18);
  CHECK(orbits(map, of_cell(1)) == 30);
  CHECK(orbits(map, of_cell(2)) == 15);
  CHECK(map.volume(1).parent == 0);
  CHECK(map.volume(1).parent_face == end_face);
  // Corner on corner, edge on edge.
  for (std::uint32_t i = 0; i < 6; ++i) CHECK(map.alpha(3, map.end_corner(0, i)) == map.base_corner(1, i));
  const GrowResult out = map.grow(1, side(3), 4, 2);
  CHECK_FALSE(out.attached);
  CHECK(is_whole(map));
  // Its C1 is at the side's lower edge.
  CHECK(map.alpha(3, map.base_corner(2, 0)) == map.dart_of(1, side(3)));
}

TEST_CASE("a volume on a base has its first side at the base's first edge, and the map is orientable") {
  Map map;
  map.plant(5, 0);
  CHECK_FALSE(map.grow(0, base_face, 5, 0).attached);
  CHECK(is_whole(map));
  const std::uint32_t corner = map.base_corner(1, 0);
  CHECK(map.volume_of()[map.alpha(3, corner)] == 0);
  CHECK(map.alpha(3, corner) == map.alpha(0, map.base_corner(0, 0)));
}

TEST_CASE("where orders differ the volume is attached to the face, not sewn, and the face is occupied") {
  Map map;
  map.plant(18, 0);
  const GrowResult carpel = map.grow(0, end_face, 6, 1);
  CHECK(carpel.refusal == Refusal::nothing);
  CHECK(carpel.attached);
  CHECK(is_whole(map));
  CHECK(map.volume(1).attached);
  CHECK(map.volume(1).parent == 0);
  CHECK(map.alpha(3, map.base_corner(1, 0)) == map.base_corner(1, 0));
  CHECK_FALSE(map.is_free(0, end_face));
  CHECK(map.is_free(0, side(1)));
  CHECK(map.grow(0, end_face, 18, 1).refusal == Refusal::occupied);
  CHECK(map.grow(0, side(2), 16, 1).attached);
  CHECK_FALSE(map.is_free(0, side(2)));
  CHECK(map.volumes() == 3);
}

TEST_CASE("operations that are refused leave the map unchanged") {
  Map map = stack_of(4, 2);
  const std::uint32_t darts = map.darts();
  CHECK(map.plant(2, 0).refusal == Refusal::order);
  CHECK(map.plant(4097, 0).refusal == Refusal::order);
  CHECK(map.grow(0, side(1), 2, 0).refusal == Refusal::order);
  CHECK(map.grow(0, side(5), 4, 0).refusal == Refusal::no_face);
  CHECK(map.grow(2, end_face, 4, 0).refusal == Refusal::no_face);
  CHECK(map.grow(0, end_face, 4, 0).refusal == Refusal::occupied);
  CHECK(map.glue(0, side(5), 1, side(1)) == Refusal::no_face);
  CHECK(map.glue(0, side(1), 0, side(2)) == Refusal::same_volume);
  CHECK(map.glue(0, end_face, 1, side(2)) == Refusal::occupied);
  CHECK(map.glue(0, side(1), 1, side(2)) == Refusal::not_adjacent);
  CHECK(map.split(0, side(5), 0, 0).refusal == Refusal::no_face);
  CHECK(map.darts() == darts);
  CHECK(map.volumes() == 2);
  CHECK(is_whole(map));
  for (std::uint32_t i = 1; i <= static_cast<std::uint32_t>(Refusal::full); ++i)
    CHECK(panicle::english(message_of(static_cast<Refusal>(i)).encoded()).size() > 20);
}

TEST_CASE("a map refuses to have more darts than its limit") {
  Map map(200);
  CHECK(map.plant(4, 0).refusal == Refusal::nothing);
  for (std::uint32_t v = 0; v < 3; ++v) CHECK(map.grow(v, end_face, 4, 0).refusal == Refusal::nothing);
  CHECK(map.grow(3, end_face, 4, 0).refusal == Refusal::full);
  CHECK(map.split(0, end_face, 0, 0).refusal == Refusal::full);
  CHECK(map.darts() == 192);
  CHECK(is_whole(map));
}

TEST_CASE("adjacent faces are glued about their edge") {
  Map map = corner_of_cubes(5);
  // Volumes 1 and 2 stand at right angles on two sides of a cube: the faces that look at the corner between them are
  // adjacent.
  const Adjacency hinge = map.adjacent(1, side(2), 5, side(4));
  CHECK(hinge.volume == 2);
  CHECK(map.adjacent(1, side(2), 6, side(4)).volume == none);
  CHECK(map.adjacent(1, side(4), 5, side(2)).volume == none);
  CHECK(map.adjacent(0, side(2), 5, side(2)).volume == none);  // taken
  const std::uint32_t vertices = orbits(map, of_cell(0)), faces = orbits(map, of_cell(2));
  CHECK(map.glue(1, side(2), 2, side(4)) == Refusal::nothing);
  CHECK(is_whole(map));
  CHECK(map.alpha(3, hinge.own) == hinge.other);
  CHECK(orbits(map, of_cell(0)) == vertices - 2);
  CHECK(orbits(map, of_cell(2)) == faces - 1);
  CHECK(map.glue(1, side(2), 2, side(4)) == Refusal::occupied);
}

TEST_CASE("faces of different order are adjacent, and are not glued") {
  Map map;
  map.plant(6, 0);
  map.grow(0, side(1), 4, 0);
  // Its C1 looks down, at the hexagon's own base.
  CHECK(map.across_gap(map.dart_of(1, side(1))) != none);
  CHECK(map.glue(0, side(2), 1, side(2)) == Refusal::nothing);
  CHECK(map.glue(0, base_face, 1, side(1)) == Refusal::unequal);
  CHECK(is_whole(map));
}

TEST_CASE("neighbours are listed with their labels and faces") {
  Map map = corner_of_cubes(1);
  map.relabel(2, 9);
  map.glue(1, side(2), 2, side(4));
  OrbitWalk walk(map);
  const std::vector<Neighbour> middle = {{side(2), 1, base_face}, {side(3), 2, base_face}};
  CHECK(neighbours(walk, map, 0) == middle);
  CHECK(neighbours(walk, map, 0, 9) == std::vector<Neighbour>{middle[1]});
  CHECK(neighbours(walk, map, 1, 9) == std::vector<Neighbour>{{side(2), 2, side(4)}});
  CHECK(neighbours(walk, map, 1, 4).empty());
}

TEST_CASE("an orbit has the darts that its involutions reach, independent of earlier queries") {
  Map map = stack_of(4, 2);
  OrbitWalk walk(map);
  const std::uint32_t dart = map.end_corner(0, 2);
  CHECK(walk.of(dart, of_cell(0) & in_volume).size() == 6);
  CHECK(walk.of(dart, of_cell(0)).size() == 12);
  CHECK(walk.of(dart, of_cell(1)).size() == 8);
  CHECK(walk.of(dart, of_cell(2)).size() == 16);
  CHECK(walk.of(dart, in_volume).size() == 48);
  CHECK(walk.of(dart, 0).size() == 1);
  map.grow(1, end_face, 4, 0);
  CHECK(walk.of(dart, all_involutions).size() == 144);
  CHECK(walk.of(dart, all_involutions).front() == dart);
}

TEST_CASE("a cleared map equals a new one") {
  Map map = corner_of_cubes();
  map.split(0, end_face, 0, 0);
  map.clear();
  CHECK(map.darts() == 0);
  CHECK(map.cuts().empty());
  CHECK(is_whole(map));
  map.plant(3, 0);
  CHECK(is_whole(map));
  CHECK(map.darts() == 36);
}
