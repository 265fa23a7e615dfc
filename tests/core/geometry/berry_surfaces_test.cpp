#include "geometry/berry_surfaces.hpp"

#include <doctest/doctest.h>

#include "packings.hpp"

using namespace panicle;
using namespace panicle::test;

namespace {

// Closed, sound, star-shaped, facing outwards; and its volume over that of its
// free form.
double check_surface(const Mesh &mesh, const BerryBody &body,
                     const BerryForm &form) {
  check_sound(mesh);
  const Surface surface = surface_of(mesh, 0, mesh.indices.size());
  CHECK(surface.open_edges == 0);
  CHECK(share_turned(mesh) < 0.003);
  const Star star(mesh, body.centre);
  bool outward = true;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    outward = outward &&
              glm::dot(star.corner(t),
                       glm::cross(star.corner(t + 1), star.corner(t + 2))) > 0;
  }
  CHECK(outward);
  for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
    outward =
        outward && glm::dot(normal_of(mesh, i),
                            position_of(mesh, i) - glm::dvec3(body.centre)) > 0;
  }
  CHECK(outward);
  return surface.volume / form_volume(form, body.half_width, body.half_length);
}

struct Pressed {
  double worst_volume = 0; // the largest deviation from 1
  double deepest = 0;      // millimetres
};

Pressed check_pressed(const std::vector<BerryBody> &bodies,
                      const BerryForm &form, std::uint32_t segments = 12) {
  const BerrySurfaces surfaces = press_berries(bodies, form, {segments});
  REQUIRE(surfaces.positions.size() ==
          surfaces.uvs.size() / 2 * 3 * bodies.size());
  REQUIRE(surfaces.pressed.size() == surfaces.uvs.size() / 2 * bodies.size());
  std::vector<Mesh> meshes;
  Pressed result;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    meshes.push_back(mesh_of(surfaces, i));
    result.worst_volume =
        std::max(result.worst_volume,
                 std::fabs(check_surface(meshes[i], bodies[i], form) - 1));
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Star star(meshes[i], bodies[i].centre);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const double reach =
          star.furthest() + Star(meshes[j], bodies[j].centre).furthest();
      if (i == j ||
          glm::length(glm::dvec3(bodies[i].centre - bodies[j].centre)) > reach)
        continue;
      result.deepest = std::max(result.deepest, penetration(meshes[j], star));
    }
  }
  return result;
}

BerryBody ball(glm::vec3 centre, float radius) {
  return {centre, {0, -1, 0}, radius, radius, 0, 0};
}

} // namespace

TEST_CASE("heaps of berries that overlap by 15 % of a radius pass through each "
          "other nowhere and keep their volume") {
  struct Kind {
    float aspect, spread, taper, blunt;
  };
  for (const Kind &kind :
       {Kind{1, 0, 0, 0}, Kind{1, 0.15f, 0, 0}, Kind{1, 0.4f, 0, 0},
        Kind{1.3f, 0.1f, 0, 0}, Kind{1.3f, 0.1f, -0.7f, 0.2f},
        Kind{0.8f, 0.1f, 0.5f, 0}, Kind{2.5f, 0.1f, 0, 1},
        Kind{3, 0.2f, 0.3f, 0.5f}}) {
    CAPTURE(kind.aspect);
    CAPTURE(kind.spread);
    CAPTURE(kind.blunt);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      CAPTURE(seed);
      const Heap heap{seed, 24, kind.aspect, kind.spread};
      const Pressed pressed =
          check_pressed(heap_of(heap), {kind.taper, kind.blunt, Fruit::grape});
      MESSAGE("aspect ", kind.aspect, " deepest ", pressed.deepest,
              " worst volume ", pressed.worst_volume);
      CHECK(pressed.deepest < 1e-4);
      CHECK(pressed.worst_volume < 0.03);
    }
  }
}

TEST_CASE("however deep berries overlap, none passes through another and all "
          "stay sound") {
  for (const float overlap : {0.3f, 0.6f, 1.0f}) {
    CAPTURE(overlap);
    Heap heap{3, 20, 1.4f, 0.3f};
    heap.overlap = overlap;
    const Pressed pressed =
        check_pressed(heap_of(heap), {-0.5f, 0.3f, Fruit::grape});
    CHECK(pressed.deepest < 1e-4);
  }
}

TEST_CASE("berries at one place are sound, though nothing can part them") {
  const std::vector<BerryBody> bodies = {ball({1, 2, 3}, 5), ball({1, 2, 3}, 5),
                                         ball({1, 2, 3.0001f}, 4)};
  const BerrySurfaces surfaces = press_berries(bodies, {}, {});
  for (std::size_t i = 0; i < bodies.size(); ++i)
    check_sound(mesh_of(surfaces, i));
}
