// The visible parts of a tree: tubes, leaves, the light on them.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>
#include <vector>

#include "models/particles/crown_light.hpp"
#include "models/particles/space_growing.hpp"

namespace panicle::particles {
namespace {

TEST_CASE("meshes: tubes of bark along the branches, leaves and balls as organs that share a mesh each") {
  for (const auto& [age, material, attached] : {std::tuple{10.0f, "skin", "balls"}, {95.0f, "blade", "leaves"}}) {
    CAPTURE(age);
    const Plant plant = grow_tree({.parameters = {{"particles", 400}, {"age", age}}, .outputs = "meshes sky"});
    REQUIRE(plant.meshes.size() == 2);
    CHECK(plant.meshes[0].material == "bark");
    CHECK(plant.meshes[1].material == material);
    const Mesh& stems = plant.meshes[0].mesh;
    for (const std::uint32_t index : stems.indices) CHECK(index < stems.positions.size() / 3);
    for (const float value : stems.positions) CHECK(std::isfinite(value));
    for (std::size_t v = 0; v + 2 < stems.normals.size(); v += 3)
      CHECK(std::hypot(stems.normals[v], stems.normals[v + 1], stems.normals[v + 2]) ==
            doctest::Approx(1).epsilon(1e-3));
    CHECK(plant.organs.size() > 50);
    CHECK(column_in<std::uint8_t>(plant, "organs.sky").size() == plant.organs.size());
    for (const Organ& organ : plant.organs) CHECK(plant.meshes[static_cast<std::size_t>(organ.mesh)].name == attached);
  }
  CHECK(grow_tree({.parameters = {{"particles", 400}}}).meshes.empty());
}

TEST_CASE("there are meshes only for organs that exist") {
  const auto names = [](std::initializer_list<std::pair<std::string_view, float>> more) {
    std::vector<std::pair<std::string_view, float>> parameters{{"particles", 200}};
    parameters.insert(parameters.end(), more);
    std::vector<std::string> found;
    for (const PlantMesh& each : grow_tree({.parameters = parameters, .outputs = "meshes"}).meshes)
      found.push_back(each.name);
    return found;
  };
  CHECK(names({}) == std::vector<std::string>{"stems", "leaves"});
  CHECK(names({{"leaves", 0}}) == std::vector<std::string>{"stems"});
  CHECK(names({{"leaves", 0}, {"age", 50}}) == std::vector<std::string>{"stems", "balls"});
  CHECK(names({{"age", 50}}) == std::vector<std::string>{"stems", "balls"});
  CHECK(names({{"age", 95}}) == std::vector<std::string>{"stems", "leaves"});
}

TEST_CASE("the sky is darker inside a crown than on it") {
  const Plant plant =
      grow_tree({.parameters = {{"particles", 3000}, {"inner", 0}, {"leaf_size", 30}}, .outputs = "meshes sky"});
  const auto sky = column_in<std::uint8_t>(plant, "organs.sky");
  double inside = 0, outside = 0, insiders = 0, outsiders = 0;
  for (std::size_t i = 0; i < sky.size(); ++i) {
    const float from = glm::distance(plant.organs[i].position, {0, 5, 0});
    if (from < 1) inside += sky[i], ++insiders;
    if (from > 2.8f) outside += sky[i], ++outsiders;
  }
  CHECK(inside / insiders < 0.6 * outside / outsiders);
}

TEST_CASE("two leaves are at each origin and face the light") {
  const Plant plant = grow_tree({.parameters = {{"particles", 300}, {"sun", 90}, {"sun_height", 45}, {"sky", 0}}});
  CHECK(plant.organs.size() == 2 * count_of(plant, "particles"));
  const glm::vec3 light = towards_sun(90, 45);
  CHECK(light.x == doctest::Approx(std::sqrt(0.5f)));
  float facing = 0;
  for (const Organ& leaf : plant.organs) {
    const glm::vec4 q = leaf.rotation;
    CHECK(glm::length(q) == doctest::Approx(1).epsilon(1e-4));
    const glm::vec3 front(2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y));
    CHECK(glm::dot(front, light) > 0.3f);
    facing += glm::dot(front, light);
    CHECK(leaf.position == plant.segments[static_cast<std::size_t>(leaf.segment)].end);
  }
  CHECK(facing / static_cast<float>(plant.organs.size()) > 0.8f);
  CHECK(grow_tree({.parameters = {{"particles", 300}, {"leaves", 0}}}).organs.empty());
}

TEST_CASE("more than two leaves are one behind the other along the last shoot, the first at its tip") {
  const Plant plant = grow_tree({.parameters = {{"particles", 300}, {"leaves", 4}, {"leaf_size", 10}}});
  REQUIRE(plant.organs.size() == 4 * count_of(plant, "particles"));
  std::size_t apart = 0;
  for (std::size_t i = 0; i < plant.organs.size(); ++i) {
    const Segment& shoot = plant.segments[static_cast<std::size_t>(plant.organs[i].segment)];
    const float length = glm::distance(shoot.start, shoot.end), back = 0.04f * static_cast<float>(i % 4);
    const glm::vec3& place = plant.organs[i].position;
    CHECK(glm::distance(place, shoot.end) == doctest::Approx(std::min(back, length)).epsilon(1e-3));
    CHECK(glm::distance(place, shoot.start) <= length * 1.0001f);
    apart += back > 0 && length > back;
  }
  CHECK(apart > plant.organs.size() / 2);
}

TEST_CASE("visible normals of branches and twigs agree with their triangles, except one in ten thousand") {
  for (const float ragged : {0.0f, 0.3f}) {
    const Plant plant =
        grow_tree({.parameters = {{"particles", 1500}, {"ragged", ragged}, {"girth", 60}}, .outputs = "meshes"});
    const Mesh& mesh = plant.meshes[0].mesh;
    const auto vector = [](const std::vector<float>& values, std::uint32_t i) {
      return glm::vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    };
    std::size_t opposed = 0, triangles = 0;
    const auto around = column_in<std::uint32_t>(plant.meshes[0].columns, "segment");
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
      const glm::vec3 face = glm::cross(vector(mesh.positions, b) - vector(mesh.positions, a),
                                        vector(mesh.positions, c) - vector(mesh.positions, a));
      const glm::vec3 mean = vector(mesh.normals, a) + vector(mesh.normals, b) + vector(mesh.normals, c);
      ++triangles;
      if (glm::dot(face, mean) >= 0) continue;
      // The beginning of a branch lies within its parent, and is hidden.
      const Segment& own = plant.segments[around[a]];
      const glm::vec3 middle =
          (vector(mesh.positions, a) + vector(mesh.positions, b) + vector(mesh.positions, c)) / 3.0f;
      bool hidden = false;
      for (const Segment& other : plant.segments) {
        const glm::vec3 way = other.end - other.start;
        const float at = glm::clamp(glm::dot(middle - other.start, way) / glm::dot(way, way), 0.0f, 1.0f);
        const float radius = other.radius + at * (other.radius_end - other.radius);
        if (&other != &own && glm::distance(middle, other.start + at * way) < radius) hidden = true;
      }
      opposed += !hidden;
    }
    CHECK(10000 * opposed <= triangles);
  }
}

TEST_CASE("a twig has a few triangles") {
  const Plant plant = grow_tree({.parameters = {{"particles", 2000}}, .outputs = "meshes"});
  const std::size_t triangles = plant.meshes[0].mesh.indices.size() / 3;
  CHECK(triangles < 22 * count_of(plant, "particles"));
  // Twigs end in a point, where their particles started.
  const Mesh& mesh = plant.meshes[0].mesh;
  const auto around = column_in<std::uint32_t>(plant.meshes[0].columns, "segment");
  REQUIRE(around.size() == mesh.positions.size() / 3);
  std::vector<std::uint32_t> ends(plant.segments.size(), 0);
  for (std::size_t v = 0; v < around.size(); ++v)
    ends[around[v]] += glm::distance({mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]},
                                     plant.segments[around[v]].end) < 1e-5f;
  for (const std::size_t tip : tips_of(plant)) CHECK(ends[tip] >= 1);
}

}  // namespace
}  // namespace panicle::particles
