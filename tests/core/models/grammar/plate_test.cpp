#include "models/grammar/plate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "mesh/polygon.hpp"
#include "models/grammar/growing.hpp"
#include "near.hpp"

namespace panicle::grammar {
namespace {

using Corners = std::vector<glm::vec3>;

float unit(std::uint64_t stream, std::uint64_t i) { return random_unit(5, stream, i); }

glm::vec3 at(const Mesh& mesh, std::uint32_t v) {
  return {mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]};
}

double area_of(const Corners& corners, const std::vector<std::uint32_t>& triangles) {
  double area = 0;
  for (std::size_t k = 0; k < triangles.size(); k += 3) {
    const glm::dvec3 a(corners[triangles[k]]), b(corners[triangles[k + 1]]), c(corners[triangles[k + 2]]);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return area;
}

// The signed volume of triangles, positive where they face outwards.
double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::dvec3 a(at(mesh, mesh.indices[k])), b(at(mesh, mesh.indices[k + 1])), c(at(mesh, mesh.indices[k + 2]));
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6;
}

// The number of edges that are not run through equally often in both directions, and the greatest number of triangles
// at an edge; points at one place are one.
struct Edges {
  std::size_t open = 0, most = 0;
};

Edges edges_of(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  const auto place = [&](std::uint32_t v) {
    const glm::vec3 p = at(mesh, v);
    return Place{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
  };
  std::map<std::pair<Place, Place>, std::pair<std::size_t, std::size_t>> ways;
  for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
    const Place a = place(mesh.indices[k]), b = place(mesh.indices[k % 3 == 2 ? k - 2 : k + 1]);
    if (a < b)
      ++ways[{a, b}].first;
    else
      ++ways[{b, a}].second;
  }
  Edges found;
  for (const auto& [edge, count] : ways) {
    found.open += count.first == count.second ? 0 : 1;
    found.most = std::max(found.most, count.first + count.second);
  }
  return found;
}

Mesh plate_of(const Corners& corners, float thickness) {
  Mesh mesh;
  std::vector<std::uint32_t> from;
  add_plate(mesh, corners, fill_polygon(corners), thickness, from);
  CHECK(from.size() == mesh.positions.size() / 3);
  CHECK(mesh.normals.size() == mesh.positions.size());
  return mesh;
}

TEST_CASE("a plate of a square sheet is a box, for both orientations of the square") {
  Corners square{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}};
  for (const bool back : {false, true}) {
    if (back) square = Corners(square.rbegin(), square.rend());
    const Mesh mesh = plate_of(square, 0.5f);
    CHECK(mesh.indices.size() == 3 * 12);
    CHECK(volume_of(mesh) == near(3, 1e-5));
    const Edges edges = edges_of(mesh);
    CHECK(edges.open == 0);
    CHECK(edges.most == 2);
    for (std::uint32_t v = 0; v < mesh.positions.size() / 3; ++v) {
      CHECK(std::fabs(at(mesh, v).z) == doctest::Approx(0.25));
      // Faces and walls have the normals of a box.
      const glm::vec3 n(mesh.normals[3 * v], mesh.normals[3 * v + 1], mesh.normals[3 * v + 2]);
      CHECK(std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) == doctest::Approx(1));
      CHECK(glm::dot(n, at(mesh, v) - glm::vec3(1, 1.5f, 0)) > 0);
    }
  }
}

TEST_CASE("a plate is closed and its volume is area times thickness, for any outline and bends") {
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    const auto count = static_cast<std::size_t>(5 + 60 * unit(1, trial));
    const float bend = trial % 3 == 0 ? 0 : 0.5f * unit(2, trial), size = trial % 2 == 0 ? 1.0f : 1e-3f;
    Corners corners;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [sine, cosine] = sincos_degrees(360.0f * static_cast<float>(i) / static_cast<float>(count));
      const float r = 0.3f + 0.7f * unit(3, 100 * trial + i);
      const glm::vec3 p(r * cosine, r * sine, 0);
      // Bent over a cylinder, as blades droop.
      corners.push_back(size * glm::vec3(p.x, p.y, -bend * p.x * p.x));
    }
    CAPTURE(trial);
    const std::vector<std::uint32_t> triangles = fill_polygon(corners);
    const float thickness = 0.005f * size;
    const Mesh mesh = plate_of(corners, thickness);
    const Edges edges = edges_of(mesh);
    CHECK(edges.open == 0);
    CHECK(edges.most == 2);
    CHECK(volume_of(mesh) == near(area_of(corners, triangles) * static_cast<double>(thickness), 0.01));
  }
}

TEST_CASE("a plate is closed for any path of a turtle") {
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    Corners corners;
    glm::vec3 p(0);
    const auto count = static_cast<std::size_t>(3 + 30 * unit(4, trial));
    for (std::size_t i = 0; i < count; ++i) {
      // Paths there and back, repeated corners, crossings.
      if (i > 2 && unit(5, 100 * trial + i) < 0.3f)
        p = corners[i - 2];
      else
        p += glm::vec3(unit(6, 100 * trial + i), unit(7, 100 * trial + i), 0.3f * unit(8, 100 * trial + i)) - 0.4f;
      corners.push_back(p);
    }
    CAPTURE(trial);
    if (fill_polygon(corners).empty()) continue;
    const Mesh mesh = plate_of(corners, 0.01f);
    CHECK(edges_of(mesh).open == 0);
    for (const float value : mesh.positions) CHECK(value - value == 0);
    for (const float value : mesh.normals) CHECK(value - value == 0);
  }
}

TEST_CASE("corners in one plane take no more work, for any plane") {
  // The plane orthogonal to the direction that corners are sorted by. Comparing all pairs would take thousands of
  // millions of steps.
  const glm::vec3 way = glm::normalize(glm::vec3(0.61f, 0.47f, 0.64f));
  const glm::vec3 right = glm::normalize(glm::cross(way, {1, 0, 0})), up = glm::cross(way, right);
  constexpr std::uint32_t count = 100'000;
  Corners corners;
  std::vector<std::uint32_t> fan;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [sine, cosine] = sincos_degrees(360.0f * static_cast<float>(i) / static_cast<float>(count));
    corners.push_back(cosine * right + sine * up);
    if (i > 1) fan.insert(fan.end(), {0, i - 1, i});
  }
  Mesh mesh;
  std::vector<std::uint32_t> from;
  add_plate(mesh, corners, fan, 0.1f, from);
  CHECK(volume_of(mesh) == near(0.1 * 3.14159265, 1e-2));
}

TEST_CASE("a path in and out again has no wall") {
  for (const float beside : {0.0f, 1e-6f}) {
    CAPTURE(beside);
    const Corners slit{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 0.4f, 0}, {1 - beside, 1, 0}, {0, 1, 0}};
    const Mesh mesh = plate_of(slit, 0.1f);
    CHECK(volume_of(mesh) == near(0.2, 1e-4));
    CHECK(edges_of(mesh).open == 0);
    // Two faces, each of the four sides and the corner within, and four walls. Where the path does not come back to
    // exactly the same place, a face is cut differently and has two triangles more.
    CHECK(mesh.indices.size() == 3 * (2 * (beside > 0 ? 6 : 4) + 2 * 4));
  }
}

TEST_CASE("a grammar may set a polygon's thickness in its unit; without one it is a sheet") {
  const std::string square = " . f + f + f . }\n";
  const auto blades = [&](std::string before) {
    const Plant plant = grow(
        {.text = "angle increment: 90\naxiom: " + before + square, .parameters = {{"unit", 100}}, .outputs = "meshes"});
    const PlantMesh* mesh = mesh_of(plant, "blades");
    REQUIRE(mesh);
    CHECK(plant.notes.empty());
    REQUIRE(mesh->runs.size() == 1);
    CHECK(mesh->runs[0].index_count == mesh->mesh.indices.size());
    CHECK(mesh->runs[0].vertex_count == mesh->mesh.positions.size() / 3);
    CHECK(mesh->mesh.uvs.size() / 2 == mesh->mesh.positions.size() / 3);
    CHECK(column_in<std::uint32_t>(mesh->columns, "organ") == std::vector<std::uint32_t>{0});
    return *mesh;
  };
  CHECK(blades("{").mesh.indices.size() == 6);
  CHECK(blades("{(0)").mesh.indices.size() == 6);
  CHECK(volume_of(blades("{(0.02)").mesh) == near(0.1 * 0.1 * 0.002, 1e-3));
  CHECK(volume_of(blades("@D(2) {(0.02)").mesh) == near(8 * 0.1 * 0.1 * 0.002, 1e-3));
  const Result<Plant> wrong = try_grow({.text = "axiom: {(-1)" + square});
  REQUIRE(!wrong);
  CHECK(wrong.error().line == 1);
}

TEST_CASE("a blade's run has the index of its organ, also after a polygon without area") {
  const Plant plant = grow({.text = "axiom: @O(1) { . . } { . f + f . } {(0.1) . f + f . }\n", .outputs = "meshes"});
  const PlantMesh* mesh = mesh_of(plant, "blades");
  REQUIRE(mesh);
  CHECK(column_in<std::uint32_t>(mesh->columns, "organ") == std::vector<std::uint32_t>{2, 3});
}

}  // namespace
}  // namespace panicle::grammar
