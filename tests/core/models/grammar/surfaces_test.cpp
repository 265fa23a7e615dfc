#include "models/grammar/surfaces.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

using namespace panicle;
using namespace panicle::grammar;

namespace {

glm::vec3 at(const std::vector<float>& values, std::uint32_t row) {
  return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

}  // namespace

TEST_CASE("every surface is a valid mesh of about unit size with matching normals") {
  for (std::uint32_t which = 0; which < surfaces.size(); ++which) {
    CAPTURE(surfaces[which].name);
    for (const bool plain : {false, true}) {
      const Mesh mesh = make_surface(which, plain);
      REQUIRE(mesh.positions.size() == mesh.normals.size());
      REQUIRE(mesh.uvs.size() / 2 == mesh.positions.size() / 3);
      glm::vec3 low(9), high(-9);
      for (std::uint32_t v = 0; v < mesh.positions.size() / 3; ++v) {
        CHECK(glm::length(at(mesh.normals, v)) == doctest::Approx(1).epsilon(1e-4));
        low = glm::min(low, at(mesh.positions, v));
        high = glm::max(high, at(mesh.positions, v));
      }
      const glm::vec3 size = high - low;
      // Lobes of leaves may be longer than their midribs.
      if (which < first_outline_surface)
        CHECK(std::max({size.x, size.y, size.z}) == doctest::Approx(1).epsilon(0.1));
      else
        CHECK(high.y == doctest::Approx(1).epsilon(1e-4));
      for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
        const std::uint32_t a = mesh.indices[k], b = mesh.indices[k + 1], c = mesh.indices[k + 2];
        const glm::vec3 twice =
            glm::cross(at(mesh.positions, b) - at(mesh.positions, a), at(mesh.positions, c) - at(mesh.positions, a));
        REQUIRE(glm::length(twice) > 1e-6f);
        CHECK(glm::dot(twice, at(mesh.normals, a) + at(mesh.normals, b) + at(mesh.normals, c)) > 0);
      }
    }
    CHECK(make_surface(which, true).indices.size() < 0.7 * static_cast<double>(make_surface(which).indices.size()));
  }
}

TEST_CASE("surfaces are found by their names") {
  CHECK(surface_named("leaf") == 0u);
  CHECK(surface_named("berry") == 7u);
  CHECK(surface_named("ovate") == first_outline_surface);
  CHECK(!surface_named("Leaf"));
  CHECK(!surface_named(""));
}
