#include "models/bunch/berry/pressing/berry_surfaces.hpp"

#include <doctest/doctest.h>

#include <array>

#include "models/bunch/berry/packings.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::test;

namespace {

// Checks that a surface is closed, sound, star-shaped and faces outwards; returns its volume over that of its free
// form.
double check_surface(const Mesh& mesh, const BerryBody& body, const BerryForm& form, double turned) {
  check_sound(mesh);
  const Surface surface = surface_of(mesh, 0, mesh.indices.size());
  CHECK(surface.open_edges == 0);
  CHECK(share_turned(mesh) <= turned);
  const Star star(mesh, body.centre);
  bool outward = true;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    outward = outward && glm::dot(star.corner(t), glm::cross(star.corner(t + 1), star.corner(t + 2))) > 0;
  }
  CHECK(outward);
  for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
    outward = outward && glm::dot(normal_of(mesh, i), position_of(mesh, i) - glm::dvec3(body.centre)) > 0;
  }
  CHECK(outward);
  return surface.volume / form_volume(form, body.half_width, body.half_length);
}

struct Pressed {
  double worst_volume = 0;  // the largest deviation from 1
  double deepest = 0;       // millimetres
};

Pressed check_pressed(const std::vector<BerryBody>& bodies, const BerryForm& form, double turned = 0,
                      std::uint32_t segments = 12) {
  const BerrySurfaces surfaces = press_berries(bodies, form, {segments});
  REQUIRE(surfaces.positions.size() == surfaces.uvs.size() / 2 * 3 * bodies.size());
  REQUIRE(surfaces.pressed.size() == surfaces.uvs.size() / 2 * bodies.size());
  std::vector<Mesh> meshes;
  Pressed result;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    meshes.push_back(mesh_of(surfaces, i));
    result.worst_volume =
        std::max(result.worst_volume, std::fabs(check_surface(meshes[i], bodies[i], form, turned) - 1));
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Star star(meshes[i], bodies[i].centre);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const double reach = star.furthest() + Star(meshes[j], bodies[j].centre).furthest();
      if (i == j || glm::length(glm::dvec3(bodies[i].centre - bodies[j].centre)) > reach) continue;
      result.deepest = std::max(result.deepest, penetration(meshes[j], star));
    }
  }
  return result;
}

BerryBody ball(glm::vec3 centre, float radius) { return {centre, {0, -1, 0}, radius, radius, 0, 0}; }

}  // namespace

TEST_CASE("berries of heaps with overlaps of 15 % of a radius never intersect and keep their volume") {
  struct Kind {
    float aspect, spread, taper, blunt;
  };
  for (const Kind& kind :
       {Kind{1, 0, 0, 0}, Kind{1, 0.15f, 0, 0}, Kind{1, 0.4f, 0, 0}, Kind{1.3f, 0.1f, 0, 0},
        Kind{1.3f, 0.1f, -0.7f, 0.2f}, Kind{0.8f, 0.1f, 0.5f, 0}, Kind{2.5f, 0.1f, 0, 1}, Kind{3, 0.2f, 0.3f, 0.5f}}) {
    CAPTURE(kind.aspect);
    CAPTURE(kind.spread);
    CAPTURE(kind.blunt);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      CAPTURE(seed);
      const Heap heap{seed, 24, kind.aspect, kind.spread};
      const Pressed pressed = check_pressed(heap_of(heap), {kind.taper, kind.blunt, Fruit::grape});
      CHECK(pressed.deepest < 1e-4);
      CHECK(pressed.worst_volume < 0.005);
    }
  }
}

TEST_CASE("berries with any overlap never intersect and have sound surfaces") {
  for (const float overlap : {0.3f, 0.6f, 1.0f}) {
    CAPTURE(overlap);
    Heap heap{3, 20, 1.4f, 0.3f};
    heap.overlap = overlap;
    const Pressed pressed = check_pressed(heap_of(heap), {-0.5f, 0.3f, Fruit::grape}, 0.02);
    CHECK(pressed.deepest < 1e-4);
  }
}

TEST_CASE("berries at one place have sound surfaces, though no plane separates them") {
  const std::vector<BerryBody> bodies = {ball({1, 2, 3}, 5), ball({1, 2, 3}, 5), ball({1, 2, 3.0001f}, 4)};
  const BerrySurfaces surfaces = press_berries(bodies, {}, {});
  for (std::size_t i = 0; i < bodies.size(); ++i) check_sound(mesh_of(surfaces, i));
}

TEST_CASE("every fruit has a sound surface, stays on its side of planes and keeps its volume") {
  for (const Fruit fruit : {Fruit::currant, Fruit::bramble, Fruit::lychee, Fruit::longan, Fruit::duku}) {
    CAPTURE(static_cast<int>(fruit));
    Heap heap{5, 9, 1.1f, 0.1f};
    heap.overlap = 0.1f;
    const Pressed pressed = check_pressed(heap_of(heap), {0, 0, fruit}, 0.025, 10);
    CHECK(pressed.deepest < 1e-4);
    CHECK(pressed.worst_volume < 0.03);
  }
}

TEST_CASE("a lone berry has its form with scar and seat, at every place and size") {
  const BerryForm form{-0.4f, 0.3f, Fruit::grape};
  for (const float size : {1e-3f, 8.0f, 500.0f}) {
    BerryBody body{{3 * size, -2 * size, size}, {0.6f, 0, 0.8f}, size, 1.5f * size, 0, 77};
    const Mesh mesh = mesh_of(press_berries(std::vector{body}, form, {}), 0);
    CHECK(check_surface(mesh, body, form, 0) == doctest::Approx(1).epsilon(1.1e-3));
    double along = 0, across = 0;
    for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
      const glm::dvec3 p = position_of(mesh, i) - glm::dvec3(body.centre);
      const double height = glm::dot(p, glm::dvec3(body.direction));
      along = std::max(along, std::fabs(height));
      across = std::max(across, glm::length(p - height * glm::dvec3(body.direction)));
      if (mesh.uvs[2 * i + 1] == 1) CHECK(height > 1.4 * size);
      if (mesh.uvs[2 * i + 1] == 0) CHECK(height < -1.4 * size);
    }
    CHECK(along == doctest::Approx(1.5 * size).epsilon(0.02));
    CHECK(across == doctest::Approx(size).epsilon(0.02));
  }
  CHECK(press_berries({}, form, {}).positions.empty());
}

TEST_CASE("berries hang in every direction, straight up too") {
  for (const glm::vec3 direction : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1e-4f, 1, -1e-4f),
                                    glm::vec3(-1e-7f, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)}) {
    BerryBody body{{0, 0, 0}, glm::normalize(direction), 5, 9, 0, 3};
    const Mesh mesh = mesh_of(press_berries(std::vector{body}, {}, {}), 0);
    CHECK(check_surface(mesh, body, {}, 0) == doctest::Approx(1).epsilon(2e-3));
  }
}

TEST_CASE("two balls meet in the plane of the circle they share: flat and marked there, free elsewhere") {
  const std::vector<BerryBody> bodies = {ball({0, 0, 0}, 10), ball({14, 0, 0}, 5)};
  const BerrySurfaces surfaces = press_berries(bodies, {}, {48});
  const Mesh large = mesh_of(surfaces, 0), small = mesh_of(surfaces, 1);
  const std::size_t each = surfaces.uvs.size() / 2;
  double face = 0, other_face = 14;
  for (std::uint32_t i = 0; i < each; ++i) {
    face = std::max(face, position_of(large, i).x);
    other_face = std::min(other_face, position_of(small, i).x);
  }
  // The overlap of 1 is split as 5 : 10: the small one is dented twice as deep.
  CHECK(face == doctest::Approx(10 - 1 / 3.0).epsilon(1e-3));
  CHECK(other_face == doctest::Approx(face).epsilon(1e-3));
  for (std::uint32_t i = 0; i < each; ++i) {
    const double x = position_of(large, i).x;
    if (x > face - 1e-4) {
      CHECK(surfaces.pressed[i] == 255);
      if (std::hypot(position_of(large, i).y, position_of(large, i).z) < 1.5) {
        CHECK(normal_of(large, i).x == doctest::Approx(1).epsilon(1e-4));
      }
    }
    if (x < face - 1.5) CHECK(surfaces.pressed[i] == 0);
  }
}

TEST_CASE("a berry that is pressed bulges where it is free") {
  const std::vector<BerryBody> bodies = {ball({0, 0, 0}, 10), ball({17.5f, 0, 0}, 10), ball({-17.5f, 0, 0}, 10)};
  const Mesh middle = mesh_of(press_berries(bodies, {}, {}), 0);
  double free = 0;
  for (std::uint32_t i = 0; i < middle.positions.size() / 3; ++i) {
    const glm::dvec3 p = position_of(middle, i);
    if (std::fabs(p.x) < 2) free = std::max(free, glm::length(p));
  }
  CHECK(free > 10.1);
  CHECK(free < 11);
}

namespace {

// A ball of radius 10 with six more about it, their centres at that distance.
std::vector<BerryBody> walled_in(float distance) {
  std::vector<BerryBody> bodies = {ball({0, 0, 0}, 10)};
  for (const float side : {-1.0f, 1.0f}) {
    bodies.push_back(ball({side * distance, 0, 0}, 10));
    bodies.push_back(ball({0, side * distance, 0}, 10));
    bodies.push_back(ball({0, 0, side * distance}, 10));
  }
  return bodies;
}

}  // namespace

TEST_CASE("neighbours make room for a berry that needs more than half of the gaps") {
  const Pressed pressed = check_pressed(walled_in(15.6f), {}, 0.01, 24);
  CHECK(pressed.worst_volume < 0.03);
  CHECK(pressed.deepest < 1e-4);
}

TEST_CASE("a berry without any room loses volume instead of crossing its planes") {
  const Pressed pressed = check_pressed(walled_in(10), {}, 0.02, 24);
  CHECK(pressed.worst_volume > 0.05);
  CHECK(pressed.worst_volume < 0.9);
  CHECK(pressed.deepest < 1e-4);
}

TEST_CASE("shrivelled berries have furrows of their own, and lose the furrows' volume") {
  std::vector<BerryBody> bodies = {ball({0, 0, 0}, 8), ball({30, 0, 0}, 8), ball({60, 0, 0}, 8)};
  bodies[0].shrivel = bodies[1].shrivel = 1;
  bodies[1].id = 9;
  const BerrySurfaces surfaces = press_berries(bodies, {}, {});
  const auto roughness = [&](std::size_t berry) {
    const Mesh mesh = mesh_of(surfaces, berry);
    double least = 99, most = 0;
    for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
      const double r = glm::length(position_of(mesh, i) - glm::dvec3(bodies[berry].centre));
      least = std::min(least, r);
      most = std::max(most, r);
    }
    return (most - least) / 8;
  };
  CHECK(roughness(0) > 0.12);
  CHECK(roughness(2) < 0.06);
  CHECK(check_surface(mesh_of(surfaces, 0), bodies[0], {}, 0.02) == doctest::Approx(0.75).epsilon(0.005));
  CHECK(check_surface(mesh_of(surfaces, 2), bodies[2], {}, 0) == doctest::Approx(1).epsilon(0.002));
  double differ = 0;
  const Mesh first = mesh_of(surfaces, 0), second = mesh_of(surfaces, 1);
  for (std::uint32_t i = 0; i < first.positions.size() / 3; ++i) {
    differ = std::max(differ, std::fabs(glm::length(position_of(first, i)) -
                                        glm::length(position_of(second, i) - glm::dvec3(30, 0, 0))));
  }
  CHECK(differ > 0.5);
}

TEST_CASE("raisins fold and cave in unevenly: some of the skin stays, some lies deep; rinds keep their form") {
  BerryBody body = ball({0, 0, 0}, 8);
  body.shrivel = 1;
  double shallow = 99, deep = 0;
  for (std::uint32_t id = 1; id <= 8; ++id) {
    body.id = id;
    const Mesh mesh = mesh_of(press_berries(std::vector{body}, {}, {}), 0);
    // The roughness of each octant.
    std::array<double, 8> least, most;
    least.fill(99);
    most.fill(0);
    for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
      const glm::dvec3 p = position_of(mesh, i);
      const std::size_t octant = (p.x > 0) + 2 * (p.y > 0) + 4 * (p.z > 0);
      least[octant] = std::min(least[octant], glm::length(p));
      most[octant] = std::max(most[octant], glm::length(p));
    }
    for (std::size_t k = 0; k < 8; ++k) {
      shallow = std::min(shallow, (most[k] - least[k]) / 8);
      deep = std::max(deep, (most[k] - least[k]) / 8);
    }
  }
  CHECK(deep > 0.3);
  CHECK(shallow < 0.5 * deep);
  const auto held = [&](Fruit fruit) {
    const BerryForm form{0, 0, fruit};
    return check_surface(mesh_of(press_berries(std::vector{body}, form, {}), 0), body, form, 0.03);
  };
  CHECK(held(Fruit::grape) < 0.78);
  CHECK(held(Fruit::longan) > 0.9);
}

TEST_CASE("bent berries bow sideways, keep their ends and their volume, and intersect no other") {
  const BerryForm straight{-0.2f, 0, Fruit::grape}, bent{-0.2f, 0, Fruit::grape, 1};
  const BerryBody body{{0, 0, 0}, {0, -1, 0}, 8, 19, 0, 3};
  // Distance of the middle of a slice from the axis, over the half width.
  const auto bow = [&](const BerryForm& form, double from, double to) {
    const Mesh mesh = mesh_of(press_berries(std::vector{body}, form, {}), 0);
    glm::dvec3 low(99), high(-99);
    for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
      const glm::dvec3 p = position_of(mesh, i);
      if (p.y / 19 < from || p.y / 19 > to) continue;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const glm::dvec3 middle = (low + high) * 0.5;
    return std::hypot(middle.x, middle.z) / 8;
  };
  CHECK(bow(straight, -0.2, 0.2) < 0.05);
  CHECK(bow(bent, -0.2, 0.2) > 0.45);
  CHECK(bow(bent, -1, -0.95) < 0.3);
  Heap heap{4, 16, 2.4f, 0.1f};
  heap.overlap = 0.1f;
  const Pressed pressed = check_pressed(heap_of(heap), bent, 0.03);
  CHECK(pressed.deepest < 1e-4);
  CHECK(pressed.worst_volume < 0.03);
}

TEST_CASE("an ovary of every fruit is smooth") {
  const BerryBody body = ball({0, 0, 0}, 8);
  const auto roughness = [&](float relief) {
    const Mesh mesh = mesh_of(press_berries(std::vector{body}, {0, 0, Fruit::lychee, 0, relief}, {}), 0);
    double least = 99, most = 0;
    for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
      least = std::min(least, glm::length(position_of(mesh, i)));
      most = std::max(most, glm::length(position_of(mesh, i)));
    }
    return (most - least) / 8;
  };
  CHECK(roughness(1) > 0.05);
  CHECK(roughness(0) < 0.01);
}

TEST_CASE("the tip scar is a mark, not a hole") {
  const Mesh mesh = mesh_of(press_berries(std::vector{ball({0, 0, 0}, 8)}, {}, {}), 0);
  double least = 99;
  for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i)
    if (position_of(mesh, i).y < -6) least = std::min(least, glm::length(position_of(mesh, i)));
  CHECK(least > 0.985 * 8);
}

TEST_CASE("the same bodies give the same bytes, and a surface depends only on its neighbours") {
  const std::vector<BerryBody> bodies = heap_of({6, 30});
  const BerrySurfaces once = press_berries(bodies, {}, {}), again = press_berries(bodies, {}, {});
  CHECK(once.positions == again.positions);
  CHECK(once.normals == again.normals);
  CHECK(once.pressed == again.pressed);
  std::vector<BerryBody> more = bodies;
  more.push_back(ball({500, 0, 0}, 8));
  const BerrySurfaces with = press_berries(more, {}, {});
  CHECK(std::equal(once.positions.begin(), once.positions.end(), with.positions.begin()));
}
