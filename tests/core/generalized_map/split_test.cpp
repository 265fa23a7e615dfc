#include <doctest/doctest.h>

#include "maps.hpp"

using namespace panicle::generalized_map;

namespace {

// Is a volume a prism by its cells?
bool is_prism(const Map& map, std::uint32_t v, std::uint32_t n) {
  const Volume& volume = map.volume(v);
  return volume.order == n && volume.vertices == 2 * n && volume.edges == 3 * n && volume.faces == n + 2;
}

std::uint32_t beyond(const Map& map, std::uint32_t v, Face face) {
  const std::uint32_t dart = map.dart_of(v, face), other = map.alpha(3, dart);
  return other == dart ? none : map.volume_of()[other];
}

}  // namespace

TEST_CASE("split along its end, a prism becomes the rest below and the part above") {
  for (const std::uint32_t n : {3u, 4u, 7u}) {
    CAPTURE(n);
    Map map = stack_of(n, 3, 1);
    const SplitResult parted = map.split(1, end_face, 2, 3);
    CHECK(parted.refusal == Refusal::nothing);
    CHECK(parted.rest == 1);
    CHECK(parted.part == 3);
    CHECK(is_whole(map));
    CHECK(map.darts() == 48 * n);
    CHECK(is_prism(map, 1, n));
    CHECK(is_prism(map, 3, n));
    CHECK(map.volume(1).label == 2);
    CHECK(map.volume(3).label == 3);
    CHECK(beyond(map, 1, base_face) == 0);
    CHECK(beyond(map, 1, end_face) == 3);
    CHECK(beyond(map, 3, end_face) == 2);
    CHECK(map.volume(3).parent == 1);
    CHECK(map.volume(2).parent == 3);
    CHECK(map.volume(2).parent_face == end_face);
    for (std::uint32_t i = 0; i < n; ++i) {
      CHECK(map.alpha(3, map.end_corner(1, i)) == map.base_corner(3, i));
      CHECK(map.alpha(3, map.end_corner(3, i)) == map.base_corner(2, i));
      CHECK(map.degree(map.dart_of(3, side(i + 1))) == 4);
    }
  }
}

TEST_CASE("split along its base, the part stands on the support and the rest on the part") {
  Map map = stack_of(5, 2, 1);
  const SplitResult parted = map.split(1, base_face, 2, 3);
  CHECK(is_whole(map));
  CHECK(is_prism(map, 1, 5));
  CHECK(is_prism(map, 2, 5));
  CHECK(beyond(map, 0, end_face) == parted.part);
  CHECK(beyond(map, parted.part, end_face) == 1);
  CHECK(map.volume(2).parent == 0);
  CHECK(map.volume(2).parent_face == end_face);
  CHECK(map.volume(1).parent == 2);
  CHECK(map.is_free(1, end_face));
  CHECK(map.grow(1, end_face, 5, 0).refusal == Refusal::nothing);
  CHECK(is_whole(map));
}

TEST_CASE("split along a side, the part is a cube that stands on the cut, and the rest is the prism") {
  Map map;
  map.plant(6, 1);
  map.grow(0, side(2), 4, 4);
  const SplitResult parted = map.split(0, side(2), 1, 2);
  CHECK(is_whole(map));
  CHECK(map.darts() == 72 + 48 + 48);
  CHECK(is_prism(map, 0, 6));
  CHECK(is_prism(map, parted.part, 4));
  CHECK(beyond(map, 0, side(2)) == 2);
  CHECK(beyond(map, 2, base_face) == 0);
  CHECK(beyond(map, 2, end_face) == 1);
  CHECK(map.volume(1).parent == 2);
  CHECK(map.volume(2).parent == 0);
  CHECK(map.volume(2).parent_face == side(2));
  // Each side of the rest keeps its neighbour; the part that was cut off is replaced.
  for (std::uint32_t i = 0; i < 6; ++i) {
    CHECK(map.degree(map.dart_of(0, side(i + 1))) == 4);
    CHECK(map.face_of()[map.dart_of(0, side(i + 1))] == side(i + 1));
    CHECK(map.alpha(1, map.alpha(0, map.base_corner(0, i))) == map.base_corner(0, (i + 1) % 6));
    CHECK(map.alpha(1, map.alpha(0, map.end_corner(0, i))) == map.end_corner(0, (i + 1) % 6));
  }
  CHECK(map.grow(0, side(1), 4, 0).attached == false);
  CHECK(map.grow(2, side(1), 4, 0).attached == false);
  CHECK(is_whole(map));
}

TEST_CASE("a neighbour gets vertices on the edges that are cut and an edge across the face that is divided") {
  Map map;
  map.plant(4, 0);
  map.grow(0, side(3), 4, 0);
  map.split(0, end_face, 0, 0);
  CHECK(is_whole(map));
  CHECK(map.volume(1).vertices == 10);
  CHECK(map.volume(1).edges == 15);
  CHECK(map.volume(1).faces == 7);
  OrbitWalk walk(map);
  CHECK(neighbours(walk, map, 1) == std::vector<Neighbour>{{base_face, 0, side(3)}, {base_face, 2, side(3)}});
  // The neighbour has grown on the rest.
  CHECK(map.volume(1).parent == 0);
}

TEST_CASE("neighbours split in one step share the cut, others have separate ones") {
  for (const bool together : {true, false}) {
    CAPTURE(together);
    Map map;
    map.plant(4, 0);
    map.grow(0, side(3), 4, 0);  // its C3 looks up, as the first's end does
    CHECK(map.split(0, end_face, 0, 0, together ? 1 : none).refusal == Refusal::nothing);
    const std::uint32_t before = orbits(map, of_cell(0));
    const SplitResult parted = map.split(1, side(3), 0, 0, together ? 1 : none);
    CHECK(is_whole(map));
    if (!together) {
      CHECK(map.cuts().size() == 8);
      continue;
    }
    CHECK(parted.refusal == Refusal::nothing);
    // Two of the four cuts were there.
    CHECK(map.cuts().size() == 6);
    CHECK(orbits(map, of_cell(0)) == before + 2);
    CHECK(is_prism(map, 1, 4));
    CHECK(is_prism(map, parted.part, 4));
    OrbitWalk walk(map);
    CHECK(neighbours(walk, map, parted.part).size() == 2);
    CHECK(neighbours(walk, map, 1).size() == 2);
  }
}

TEST_CASE("a volume that is split from both sides in one step is cut twice") {
  Map map;
  map.plant(4, 0);
  map.split(0, side(1), 0, 0, 1);
  const SplitResult parted = map.split(0, side(3), 0, 0, 1);
  CHECK(is_whole(map));
  CHECK(is_prism(map, 0, 4));
  CHECK(is_prism(map, parted.part, 4));
  CHECK(map.cuts().size() == 8);
}

TEST_CASE("faces that a neighbour's split has changed are split as they are") {
  Map map;
  map.plant(4, 0);
  map.grow(0, side(3), 4, 0);
  map.split(0, side(4), 0, 0);  // across volume 1's base
  const SplitResult parted = map.split(1, side(1), 0, 0);
  CHECK(parted.refusal == Refusal::nothing);
  CHECK(is_whole(map));
  CHECK(is_prism(map, parted.part, 5));
}

TEST_CASE("split refuses a face with a corner that no edge leaves") {
  // Four cubes around an edge: the cut of the first one's edge puts a vertex on the opposite cube, which has no new
  // faces.
  Map map = corner_of_cubes();
  map.grow(1, side(2), 4, 0);
  bool glued = false;
  for (std::uint32_t i = 1; i <= 4; ++i) glued |= map.glue(3, side(i), 2, side(4)) == Refusal::nothing;
  CHECK(glued);
  map.split(0, end_face, 0, 0);
  CHECK(is_whole(map));
  CHECK(map.volume(3).vertices == 9);
  CHECK(map.volume(3).faces == 6);
  const std::uint32_t darts = map.darts();
  std::uint32_t uneven = 0;
  for (Face face = 0; face < 6; ++face) {
    Map copy = map;
    const Refusal refusal = copy.split(3, face, 0, 0).refusal;
    uneven += refusal == Refusal::uneven;
    if (refusal != Refusal::nothing) CHECK(copy.darts() == darts);
    CHECK(is_whole(copy));
  }
  CHECK(uneven == 2);
}

TEST_CASE("a volume attached to the face that is cut off goes with it") {
  Map map;
  map.plant(8, 0);
  map.grow(0, end_face, 3, 0);
  map.grow(0, side(1), 5, 0);
  map.split(0, end_face, 0, 0);
  CHECK(is_whole(map));
  CHECK(map.volume(1).parent == 3);
  CHECK(map.volume(1).parent_face == end_face);
  CHECK(map.volume(2).parent == 0);
  CHECK_FALSE(map.is_free(3, end_face));
  CHECK_FALSE(map.is_free(0, side(1)));
  CHECK(map.is_free(3, side(1)));
  // A volume that is attached unsewn and split along its base gives its place to the part.
  const SplitResult parted = map.split(1, base_face, 0, 0);
  CHECK(is_whole(map));
  CHECK(map.volume(parted.part).attached);
  CHECK(map.volume(parted.part).parent == 3);
  CHECK_FALSE(map.volume(1).attached);
  CHECK_FALSE(map.is_free(3, end_face));
}

TEST_CASE("the widest prism is split sixty times, each in proportion to its sides") {
  constexpr std::uint32_t n = largest_order;
  Map map = stack_of(n, 1, 1);
  for (std::uint32_t i = 0; i < 59; ++i) {
    const SplitResult parted = map.split(0, end_face, 1, 2);
    REQUIRE(parted.refusal == Refusal::nothing);
    CHECK(is_prism(map, 0, n));
    CHECK(is_prism(map, parted.part, n));
  }
  CHECK(is_whole(map));
  CHECK(map.darts() == 60 * 12 * n);
}
