// The shape of a tree's leaves, and their places.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "foliage/blade.hpp"
#include "foundation/english.hpp"
#include "models/particles/space_growing.hpp"
#include "models/tree/measures/measures.generated.hpp"

namespace panicle::particles {
namespace {

using panicle::Blade;
using panicle::make_blade;
using tree::Measure;

glm::vec3 position(const Mesh& mesh, std::size_t i) {
  return {mesh.positions[3 * i], mesh.positions[3 * i + 1], mesh.positions[3 * i + 2]};
}
glm::vec3 normal(const Mesh& mesh, std::size_t i) {
  return {mesh.normals[3 * i], mesh.normals[3 * i + 1], mesh.normals[3 * i + 2]};
}

double area_of(const Mesh& mesh, std::size_t triangles) {
  double area = 0;
  for (std::size_t t = 0; t < 3 * triangles; t += 3) {
    const glm::vec3 a = position(mesh, mesh.indices[t]);
    area += 0.5 * static_cast<double>(glm::length(
                      glm::cross(position(mesh, mesh.indices[t + 1]) - a, position(mesh, mesh.indices[t + 2]) - a)));
  }
  return area;
}

float measure(const Plant& plant, Measure which) { return plant.measures[static_cast<std::size_t>(which)]; }

TEST_CASE("a blade is the flat leaf at the end of its petiole, looking to +Z, its tip to +Y") {
  const Blade blade = make_blade(flat_leaf(), 1, 15);
  const Mesh& mesh = blade.mesh;
  REQUIRE(mesh.indices.size() / 3 == 3);
  REQUIRE(mesh.positions.size() / 3 == 7);
  const glm::vec3 base = position(mesh, 0), tip = position(mesh, 2);
  CHECK(glm::distance(base, tip) == doctest::Approx(1).epsilon(0.05));
  CHECK(base.y == doctest::Approx(leaf_petiole[0]).epsilon(0.1));
  CHECK(tip.y > base.y + 0.9f);
  // The petiole's foot is where the twig ends.
  CHECK(glm::distance(0.5f * (position(mesh, 4) + position(mesh, 5)), glm::vec3(0)) < 1e-6f);
  glm::vec3 mean(0);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(glm::length(normal(mesh, i)) == doctest::Approx(1).epsilon(1e-4));
    mean += 0.25f * normal(mesh, i);
  }
  CHECK(mean.z > 0.9f);
  CHECK(std::fabs(mean.x) < 1e-5f);
  CHECK(std::fabs(mean.y) < 0.15f);
  CHECK(mesh.uvs[2] == leaf_uvs[2]);
  // The petiole has the midrib's colour.
  for (std::size_t i = 4; i < 7; ++i) CHECK(mesh.uvs[2 * i] == leaf_uvs[0]);
}

TEST_CASE("its halves fold up along the midrib, its tip hangs, and it has the requested breadth") {
  const auto edge = [](float fold) { return position(make_blade(flat_leaf(), 1, fold).mesh, 1); };
  const float rise = edge(30).z - edge(0).z;
  CHECK(rise == doctest::Approx(0.3f * 0.5f).epsilon(0.05));
  CHECK(edge(30).x == doctest::Approx(0.3f * std::sqrt(0.75f)).epsilon(0.02));
  const Mesh flat = make_blade(flat_leaf(), 1, 0).mesh;
  const float chord = 0.5f * (position(flat, 0).z + position(flat, 2).z);
  CHECK(0.5f * (position(flat, 1).z + position(flat, 3).z) > chord + 0.05f);
  const Blade narrow = make_blade(flat_leaf(), 0.5f, 0), broad = make_blade(flat_leaf(), 1, 0);
  CHECK(narrow.area == doctest::Approx(0.5f * broad.area).epsilon(0.03));
}

TEST_CASE("the area is that of the triangles, without the petiole; needles have theirs, a missing leaf 0") {
  const Blade blade = make_blade(flat_leaf(), 1, 20);
  CHECK(static_cast<double>(blade.area) == doctest::Approx(area_of(blade.mesh, 2)));
  const Blade needles = make_needles(1), wide = make_needles(2);
  CHECK(static_cast<double>(needles.area) == doctest::Approx(area_of(needles.mesh, 5)));
  CHECK(wide.area == doctest::Approx(2 * needles.area));
  CHECK(make_blade({}, 1, 20).mesh.indices.empty());
  CHECK(make_blade({}, 1, 20).area == 0);
}

TEST_CASE("the leaf area of a tree is that of the drawn leaves") {
  for (const float kind : {0.0f, 3.0f}) {
    const Plant plant =
        grow_tree({.parameters = {{"particles", 300}, {"leaf_kind", kind}}, .outputs = "measures meshes"});
    CHECK(plant.notes.empty());
    const Mesh& blade = plant.meshes[1].mesh;
    const double own = area_of(blade, kind == 0 ? 5 : 2);
    double area = 0;
    for (const Organ& leaf : plant.organs) area += own * static_cast<double>(leaf.scale * leaf.scale);
    CHECK(static_cast<double>(measure(plant, Measure::leaf_area)) == doctest::Approx(area).epsilon(1e-3));
    CHECK(static_cast<double>(measure(plant, Measure::leaf_count)) == static_cast<double>(plant.organs.size()));
  }
}

TEST_CASE("a request without a leaf grows the same tree without leaves, with a note") {
  const SpaceOptions options{.parameters = {{"particles", 200}}, .outputs = "measures meshes"};
  SpaceOptions without = options;
  without.leaf = false;
  const Plant plant = grow_tree(without);
  CHECK(has_note(plant, "no leaf shape"));
  CHECK(plant.fingerprint == grow_tree(options).fingerprint);
  CHECK(plant.meshes.size() == 1);
  for (const Organ& leaf : plant.organs) CHECK(leaf.mesh == -1);
  CHECK(std::isnan(measure(plant, Measure::leaf_area)));
  CHECK(std::isnan(measure(plant, Measure::leaf_index)));
  // Needles need no shape, and a bare tree has no note.
  without.parameters.push_back({"leaf_kind", 0.0f});
  CHECK(grow_tree(without).meshes.size() == 2);
  CHECK(
      grow_tree({.parameters = {{"particles", 200}, {"leaves", 0}}, .outputs = "meshes", .leaf = false}).notes.empty());
}

TEST_CASE("an invalid leaf is refused") {
  const std::array<float, 3> odd{0, 0, 1};
  const std::array<ColumnView, 2> blocks{{
      {"model", Element::text, 1, 4, reinterpret_cast<const std::uint8_t*>("tree")},
      {"leaf.points", Element::float32, 1, 3, reinterpret_cast<const std::uint8_t*>(odd.data())},
  }};
  Request request(blocks, nullptr);
  const Result<Plant> plant = tree::model.grow(request, {});
  REQUIRE(!plant);
  CHECK(english(plant.error().message).find("leaf") != std::string::npos);
}

}  // namespace
}  // namespace panicle::particles
