#include "spatial/volume.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"
#include "near.hpp"
#include "spatial/surfaces.hpp"

namespace panicle {
namespace {

using Kind = Volume::Kind;
constexpr Kind kinds[] = {Kind::box, Kind::sphere, Kind::ellipsoid, Kind::cylinder, Kind::cone};

float unit(std::uint64_t stream, std::uint64_t i) { return random_unit(11, stream, i); }
glm::vec3 dart(std::uint64_t stream, std::uint64_t i) {
  return 2.0f * glm::vec3(unit(stream, 3 * i), unit(stream, 3 * i + 1), unit(stream, 3 * i + 2)) - 1.0f;
}

// Somewhere, of any proportions, turned any way.
struct Placed {
  glm::vec3 centre, size;
  glm::quat rotation;

  explicit Placed(std::uint64_t i)
      : centre(3.0f * dart(1, i)), size(0.3f + 1.2f * (dart(2, i) + 1.0f)), rotation(1, 0, 0, 0) {
    const glm::vec3 axis = random_direction(5, 3, i);
    const float half = 3.1f * unit(4, i);
    rotation = glm::quat(std::cos(half), std::sin(half) * axis);
  }
  // Of a place in the volume's own frame, where the box is −1 … 1.
  glm::vec3 at(const glm::vec3& u, Kind kind) const {
    return centre + rotation * (0.5f * u * (kind == Kind::sphere ? glm::vec3(size.x) : size));
  }
  Volume volume(Kind kind, const Surface& mesh = {}) const { return {kind, centre, size, rotation, mesh}; }
};

// How far a place of its own frame is from being outside (below 0: it is), in halves of the box.
float depth(Kind kind, const glm::vec3& u) {
  const float round = std::hypot(u.x, u.z), high = std::fabs(u.y);
  switch (kind) {
    case Kind::box:
      return 1 - std::max({std::fabs(u.x), high, std::fabs(u.z)});
    case Kind::cylinder:
      return 1 - std::max(round, high);
    case Kind::cone:
      return std::min(1 - high, 0.5f * (1 - u.y) - round);
    default:
      return 1 - glm::length(u);
  }
}

TEST_CASE("contains is right for each kind of volume, moved and rotated") {
  for (const Kind kind : kinds)
    for (std::uint64_t v = 0; v < 30; ++v) {
      const Placed placed(v);
      const Volume volume = placed.volume(kind);
      for (std::uint64_t i = 0; i < 100; ++i) {
        const glm::vec3 u = 1.3f * dart(7, 100 * v + i);
        const float deep = depth(kind, u);
        if (std::fabs(deep) > 1e-4f) CHECK(volume.contains(placed.at(u, kind)) == (deep > 0));
      }
    }
}

// The whole way up to `far` is inside, and a point a little further is not.
void check_reach(const Volume& volume, const glm::vec3& from, const glm::vec3& way, float most, float little) {
  const float far = volume.reach(from, way, most);
  CHECK(far >= 0);
  CHECK(far <= most);
  CHECK(volume.contains(from + far * way));
  int outside = 0;
  for (int k = 0; k < 40; ++k) outside += volume.contains(from + far * static_cast<float>(k) / 40.0f * way) ? 0 : 1;
  CHECK(outside == 0);
  if (far < most) CHECK_FALSE(volume.contains(from + (far + little) * way));
}

TEST_CASE("reach ends just before the surface, still inside") {
  for (const Kind kind : kinds)
    for (std::uint64_t v = 0; v < 60; ++v) {
      const Placed placed(v);
      const Volume volume = placed.volume(kind);
      CAPTURE(static_cast<int>(kind));
      CAPTURE(v);
      for (std::uint64_t i = 0; i < 60; ++i) {
        const glm::vec3 from = placed.at(dart(8, 60 * v + i), kind), way = random_direction(5, 9, 60 * v + i);
        if (!volume.contains(from)) {
          CHECK(volume.reach(from, way, 10) == 0);
          continue;
        }
        check_reach(volume, from, way, 10, 2e-3f);
        check_reach(volume, from, way, 0.1f, 2e-3f);
      }
    }
}

TEST_CASE("reach from a centre is half the size, or the requested length where there is room") {
  const Volume ball(Kind::sphere, {1, 2, 3}, {2, 9, 9}, {1, 0, 0, 0});
  CHECK(ball.reach({1, 2, 3}, {0, 1, 0}, 5) == near(1, 1e-4));
  CHECK(ball.reach({1, 2, 3}, {0, 0.6f, 0.8f}, 0.7f) == 0.7f);
  CHECK(ball.reach({1, 2.5f, 3}, {1, 0, 0}, 5) == near(std::sqrt(0.75), 1e-4));
  const Volume box(Kind::box, {0, 0, 0}, {2, 4, 6}, glm::quat(std::sqrt(0.5f), 0, std::sqrt(0.5f), 0));
  // The reach ends a hundred-thousandth of the size before the surface.
  CHECK(box.reach({0, 0, 0}, {1, 0, 0}, 9) < 3 - 2e-5);
  CHECK(box.reach({0, 0, 0}, {1, 0, 0}, 9) == near(3, 1e-4));  // turned by a right angle about the upright
  CHECK(box.reach({0, 0, 0}, {0, 0, 1}, 9) == near(1, 1e-4));
  const Volume cone(Kind::cone, {0, 0, 0}, {2, 2, 2}, {1, 0, 0, 0});
  CHECK(cone.reach({0, -0.5f, 0}, {0, 1, 0}, 9) == near(1.5, 1e-4));
  CHECK(cone.reach({0, -0.5f, 0}, {0, -1, 0}, 9) == near(0.5, 1e-4));
  CHECK(cone.reach({0, 0, 0}, {1, 0, 0}, 9) == near(0.5, 1e-4));
  const Volume cylinder(Kind::cylinder, {0, 0, 0}, {2, 4, 2}, {1, 0, 0, 0});
  CHECK(cylinder.reach({0, 0, 0}, {0.6f, 0.8f, 0}, 9) == near(1 / 0.6, 1e-4));
  CHECK(cylinder.reach({0, 0, 0}, {0, -1, 0}, 9) == near(2, 1e-4));
  CHECK(cylinder.reach({0, 0, 0}, {0, -1, 0}, 0) == 0);
}

TEST_CASE("a mesh of 20,000 triangles contains the same places as its ball") {
  const Surface mesh = ellipsoid({4, 4, 4}, {9, 9, 9}, 142);
  CHECK(mesh.triangles.size() / 3 > 19'000);
  for (std::uint64_t v = 0; v < 3; ++v) {
    const Placed placed(v);
    const Volume body = placed.volume(Kind::mesh, mesh), smooth = placed.volume(Kind::ellipsoid);
    for (std::uint64_t i = 0; i < 400; ++i) {
      const glm::vec3 u = 1.2f * dart(12, i), from = placed.at(u, Kind::mesh), way = random_direction(5, 13, i);
      if (std::fabs(glm::length(u) - 1) < 2e-3f) continue;
      CHECK(body.contains(from) == smooth.contains(from));
      CHECK(body.reach(from, way, 4) == doctest::Approx(smooth.reach(from, way, 4)).epsilon(0.01));
    }
  }
}

TEST_CASE("reach in a concave mesh ends where the way first leaves") {
  const Volume bend(Kind::mesh, {1, 1, 0.5f}, {2, 2, 1}, {1, 0, 0, 0}, corner());
  CHECK(bend.contains({1.8f, 0.5f, 0.5f}));
  CHECK_FALSE(bend.contains({1.8f, 1.5f, 0.5f}));
  const float slope = std::sqrt(0.5f);
  CHECK(bend.reach({0.2f, 1.9f, 0.5f}, {slope, -slope, 0}, 5) == near(0.8 / 0.70710678, 1e-3));
  // Along a face, an edge and through a corner.
  CHECK(bend.reach({0.5f, 0.5f, 0.5f}, {0, 1, 0}, 5) == near(1.5, 1e-3));
  CHECK(bend.reach({0.5f, 1, 0.5f}, {1, 0, 0}, 5) <= 1.5f);
  check_reach(bend, {0.5f, 0.5f, 0.5f}, {slope, slope, 0}, 5, 2e-3f);
  for (std::uint64_t v = 0; v < 20; ++v) {
    const Placed placed(v);
    const Volume turned = placed.volume(Kind::mesh, corner());
    for (std::uint64_t i = 0; i < 60; ++i) {
      const glm::vec3 from = placed.at(dart(14, 60 * v + i), Kind::mesh), way = random_direction(5, 15, 60 * v + i);
      if (turned.contains(from)) check_reach(turned, from, way, 6, 4e-3f);
    }
  }
}

TEST_CASE("reach passes through overlapping parts of a mesh") {
  Surface two = box({0, 0, 0}, {2, 1, 1});
  append(two, box({1, 0, 0}, {3, 1, 1}));
  const Volume both(Kind::mesh, {1.5f, 0.5f, 0.5f}, {3, 1, 1}, {1, 0, 0, 0}, two);
  CHECK(both.reach({0.5f, 0.5f, 0.5f}, {1, 0, 0}, 9) == near(2.5, 1e-3));
  CHECK(both.reach({2.5f, 0.3f, 0.6f}, {-1, 0, 0}, 9) == near(2.5, 1e-3));
}

TEST_CASE("a mesh without triangles contains no place, and reach from outside is 0") {
  const Volume none(Kind::mesh, {0, 0, 0}, {1, 1, 1}, {1, 0, 0, 0}, {});
  CHECK_FALSE(none.contains({0, 0, 0}));
  CHECK(none.reach({0, 0, 0}, {0, 1, 0}, 1) == 0);
  const Volume box(Kind::box, {0, 0, 0}, {1, 1, 1}, glm::quat(0, 0, 0, 0));
  CHECK(box.contains({0.4f, 0.4f, 0.4f}));
  CHECK(box.reach({NAN, 0, 0}, {0, 1, 0}, 1) == 0);
}

}  // namespace
}  // namespace panicle
