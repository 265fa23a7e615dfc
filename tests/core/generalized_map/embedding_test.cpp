#include "generalized_map/embedding.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "maps.hpp"

using namespace panicle::generalized_map;

namespace {

struct Placed {
  Embedding embedding;
  Placed(const Map& map, const std::vector<Shape>& shapes) {
    embedding.build(map);
    embedding.place(shapes);
  }
  glm::vec3 at(std::uint32_t dart) const { return embedding.positions()[embedding.vertex_of()[dart]]; }
};

void check_near(const glm::vec3& a, const glm::vec3& b) {
  CAPTURE(a.x);
  CAPTURE(a.y);
  CAPTURE(a.z);
  CHECK(glm::distance(a, b) < 1e-4f);
}

glm::vec3 centre_of(const Map& map, const Placed& placed, std::uint32_t v, Face face) {
  glm::vec3 sum(0);
  float corners = 0;
  const std::uint32_t start = map.dart_of(v, face);
  std::uint32_t d = start;
  do {
    sum += placed.at(d);
    ++corners;
    d = map.alpha(1, map.alpha(0, d));
  } while (d != start);
  return sum / corners;
}

// Twice the area of a face, as a vector along which it looks: out of the volume but for the base.
glm::vec3 area_of(const Map& map, const Placed& placed, std::uint32_t v, Face face) {
  const glm::vec3 centre = centre_of(map, placed, v, face);
  glm::vec3 sum(0);
  const std::uint32_t start = map.dart_of(v, face);
  std::uint32_t d = start;
  do {
    const std::uint32_t next = map.alpha(0, d);
    sum += glm::cross(placed.at(d) - centre, placed.at(next) - centre);
    d = map.alpha(1, next);
  } while (d != start);
  return sum;
}

// The volume inside a map's boundary, as the sum of the cones of its faces (divergence theorem).
double volume_of(const Map& map, const Placed& placed, std::uint32_t v) {
  double sum = 0;
  for (Face face = 0; face < map.volume(v).order + 2; ++face) {
    const double sign = face == base_face ? -1 : 1;
    sum += sign * glm::dot(centre_of(map, placed, v, face), area_of(map, placed, v, face)) / 6;
  }
  return sum;
}

constexpr Shape cube{};

}  // namespace

TEST_CASE("frames are right-handed and of unit length on every face") {
  for (const std::uint32_t order : {3u, 4u, 21u})
    for (Face face = 0; face < order + 2; ++face) {
      const Frame frame = turned(on_face(turned({}, {10, -40, 200}), order, face), {5, 6, 7});
      check_near(glm::cross(frame.x, frame.y), frame.z);
      CHECK(glm::length(frame.x) == doctest::Approx(1));
      CHECK(glm::dot(frame.x, frame.y) == doctest::Approx(0).epsilon(1e-5));
    }
}

TEST_CASE("turns are applied one after another about the turned axes") {
  const Frame over = turned({}, {90, 0, 0});
  check_near(over.z, {0, -1, 0});
  check_near(over.y, {0, 0, 1});
  check_near(turned({}, {0, 90, 0}).z, {1, 0, 0});
  check_near(turned({}, {0, 0, 90}).x, {0, 1, 0});
  check_near(turned({}, {90, 90, 0}).z, {1, 0, 0});
  check_near(turned({}, {90, 0, 90}).x, {0, 0, 1});
}

TEST_CASE("a planted prism stands at the origin; order 4 is a box, others have their corners on an ellipse") {
  Map map;
  map.plant(4, 0);
  const Placed box(map, {{0, 0, 0, 5, 3, 2}});
  CHECK(box.embedding.vertices() == 8);
  check_near(box.at(map.base_corner(0, 0)), {-1.5f, -1, 0});
  check_near(box.at(map.base_corner(0, 1)), {1.5f, -1, 0});
  check_near(box.at(map.end_corner(0, 2)), {1.5f, 1, 5});
  CHECK(volume_of(map, box, 0) == doctest::Approx(30));
  Map round;
  round.plant(6, 0);
  const Placed disc(round, {{0, 0, 0, 1, 4, 2, 0}});  // a translation of 0 leaves it flat
  for (std::uint32_t i = 0; i < 6; ++i) {
    const glm::vec3 corner = disc.at(round.end_corner(0, i));
    CHECK(corner.x * corner.x / 4 + corner.y * corner.y == doctest::Approx(1));
    CHECK(corner.z == 0);
  }
  // Its first side looks along −y.
  CHECK(disc.at(round.base_corner(0, 0)).y == doctest::Approx(disc.at(round.base_corner(0, 1)).y));
  CHECK(disc.at(round.base_corner(0, 0)).x < disc.at(round.base_corner(0, 1)).x);
}

TEST_CASE("a volume on each face stands outwards, with the face for its base") {
  Map map;
  map.plant(4, 0);
  for (Face face = 0; face < 6; ++face) map.grow(0, face, 4, 0);
  const Placed placed(map, std::vector<Shape>(7, Shape{0, 0, 0, 2, 1, 1}));
  const glm::vec3 middle(0, 0, 1);
  const glm::vec3 ways[] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  for (Face face = 0; face < 6; ++face) {
    CAPTURE(face);
    const std::uint32_t v = face + 1u;
    check_near(placed.embedding.frames()[v].z, ways[face]);
    CHECK(glm::dot(area_of(map, placed, 0, face), ways[face]) * (face == base_face ? -1 : 1) > 0);
    const glm::vec3 base_centre = centre_of(map, placed, v, base_face);
    check_near(base_centre, middle + ways[face] * (face < 2 ? 1.0f : 0.5f));
    check_near(centre_of(map, placed, v, end_face), base_centre + 2.0f * ways[face]);
    CHECK(volume_of(map, placed, v) > 0);
    // Untwisted: each corner of the end above its own of the base, as far as the face allows.
    for (std::uint32_t i = 0; i < 4; ++i)
      CHECK(glm::dot(placed.at(map.base_corner(v, i)) - base_centre, placed.at(map.end_corner(v, i)) - base_centre) >
            0);
  }
}

TEST_CASE("a child turns with its parent, and its base stays on the parent's end") {
  Map map = stack_of(6, 3);
  const Placed placed(map, {{0, 0, 0, 2}, {90, 0, 0, 3}, {0, 0, 0, 1}});
  check_near(centre_of(map, placed, 0, end_face), {0, 0, 2});
  check_near(centre_of(map, placed, 1, end_face), {0, -3, 2});
  check_near(centre_of(map, placed, 2, end_face), {0, -4, 2});
  for (std::uint32_t i = 0; i < 6; ++i) check_near(placed.at(map.base_corner(1, i)), placed.at(map.end_corner(0, i)));
}

TEST_CASE("an attached volume has a base of its own, in the middle of the face") {
  Map map;
  map.plant(18, 0);
  map.grow(0, end_face, 6, 0);
  const Placed placed(map, {{0, 0, 0, 2, 8, 8}, {0, 0, 0, 1, 1, 1}});
  CHECK(placed.embedding.vertices() == 36 + 12);
  check_near(centre_of(map, placed, 1, base_face), {0, 0, 2});
  check_near(centre_of(map, placed, 1, end_face), {0, 0, 3});
  CHECK(glm::distance(placed.at(map.base_corner(1, 0)), {0, 0, 2}) == doctest::Approx(0.5));
}

TEST_CASE("glued vertices are at the mean of both proposals") {
  Map map = corner_of_cubes();
  const Placed apart(map, {cube, cube, cube});
  const Adjacency hinge = map.adjacent(1, side(2), 0, side(4));
  map.glue(1, side(2), 2, side(4));
  const Placed together(map, {cube, cube, cube});
  // The face's other edge: two places have become one.
  const std::uint32_t a = map.alpha(0, map.alpha(1, map.alpha(0, hinge.own)));
  const std::uint32_t b = map.alpha(0, map.alpha(1, map.alpha(0, hinge.other)));
  CHECK(glm::distance(apart.at(a), apart.at(b)) > 1);
  check_near(together.at(a), (apart.at(a) + apart.at(b)) * 0.5f);
  check_near(together.at(a), together.at(b));
  CHECK(together.embedding.vertices() == apart.embedding.vertices() - 2);
}

TEST_CASE("a vertex of a cut without proposals lies midway on its edge, and children stand on it") {
  Map map = stack_of(4, 2);
  const SplitResult parted = map.split(1, side(2), 0, 0);
  // The part has half the length, at half the distance: together the shape before the split.
  const Placed placed(map, {cube, {0, 0, 0, 1, 0.5f, 1}, {0, 0, 0, 0.5f, 1, 1}});
  std::uint32_t midway = 0;
  for (const Cut& cut : map.cuts()) midway += placed.at(cut.first) == (placed.at(cut.from) + placed.at(cut.to)) * 0.5f;
  CHECK(midway == 4);
  // Two on the first cube's end, where the part's base is, too; the others are corners of the rest's own.
  check_near(centre_of(map, placed, parted.part, base_face), {0, 0, 1.5f});
  check_near(centre_of(map, placed, parted.part, end_face), {0.5f, 0, 1.5f});
  CHECK(volume_of(map, placed, 1) == doctest::Approx(0.5));
  CHECK(volume_of(map, placed, parted.part) == doctest::Approx(0.5));
}

TEST_CASE("split along its end and base, the parts fill the volume") {
  for (const Face face : {end_face, base_face}) {
    Map map = stack_of(5, 3);
    map.split(1, face, 0, 0);
    std::vector<Shape> shapes(4, Shape{0, 0, 0, 2, 3, 3});
    shapes[1].height = shapes[3].height = 1;
    const Placed placed(map, shapes);
    check_near(centre_of(map, placed, 2, end_face), {0, 0, 6});
    CHECK(volume_of(map, placed, 1) == doctest::Approx(volume_of(map, placed, 3)));
    CHECK(volume_of(map, placed, 0) == doctest::Approx(2 * volume_of(map, placed, 3)));
  }
}

TEST_CASE("place gives the same bytes for the same shapes, and may be repeated with others") {
  Map map;
  for (std::uint64_t turn = 0; turn < 200; ++turn) random_operation(map, 3, turn);
  std::vector<Shape> shapes(map.volumes(), Shape{3, 4, 5, 1, 2, 3});
  Placed placed(map, shapes);
  const auto positions = placed.embedding.positions();
  const std::vector<glm::vec3> before(positions.begin(), positions.end());
  for (const glm::vec3& position : before) CHECK(std::isfinite(position.x + position.y + position.z));
  for (Shape& shape : shapes) shape.height = 2;
  placed.embedding.place(shapes);
  CHECK(std::memcmp(before.data(), placed.embedding.positions().data(), before.size() * sizeof(glm::vec3)) != 0);
  for (Shape& shape : shapes) shape.height = 1;
  placed.embedding.place(shapes);
  CHECK(std::memcmp(before.data(), placed.embedding.positions().data(), before.size() * sizeof(glm::vec3)) == 0);
}

TEST_CASE("every vertex of random maps has a finite position") {
  // In the first 400 maps one vertex is in no volume's end and was made by no cut.
  for (std::uint64_t seed = 240; seed < 300; ++seed) {
    CAPTURE(seed);
    Map map;
    for (std::uint64_t turn = 0; turn < 40; ++turn) random_operation(map, seed, turn);
    const Placed placed(map, std::vector<Shape>(map.volumes(), Shape{3, -4, 5, 1, 1, 1}));
    CHECK(placed.embedding.vertices() == orbits(map, of_cell(0)));
    float furthest = 0;
    for (const glm::vec3& position : placed.embedding.positions()) {
      CHECK(position != glm::vec3(0));  // where they are before anybody proposes
      furthest = std::max(furthest, glm::length(position));
    }
    CHECK(furthest < 2.0f * static_cast<float>(map.volumes()) + 2);  // false for NaN, too
    CHECK(furthest > 0.5f);
  }
}

TEST_CASE("map and embedding together take at most 40 bytes a dart") {
  Map map;
  map.reserve(prism_darts(8) * 1000, 1000);
  map.plant(8, 0);
  for (std::uint32_t v = 1; v < 1000; ++v) map.grow(v - 1, end_face, 8, 0);
  const Placed placed(map, std::vector<Shape>(1000));
  CHECK(map.bytes() + placed.embedding.bytes() <= 40ull * map.darts());
}
