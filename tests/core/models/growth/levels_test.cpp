// Properties of the levels of every tree: the same tree at every distance, with fewer and fewer triangles.
#include "models/growth/levels.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "models/growth/foliage.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

constexpr float blade_area = 0.5f;

struct Tree {
  Plant plant;
  Moment moment;
  TreeLevels levels;
};

Tree tree_of(std::string_view text, std::uint16_t steps, std::uint64_t seed, bool leafy = true) {
  Tree tree;
  const Population population = grown(text, steps, seed);
  FormHabit habit;
  habit.seed = seed;
  const Form form = form_of(population, habit);
  tree.moment = sound(moment_of(population, form, steps, WoodHabit{}, Limits{}));
  LeafHabit leaves;
  leaves.many = 3;
  leaves.seed = seed;
  leaves.fallen = 0.5f;
  if (leafy)
    CHECK(add_leaves(tree.plant, population, form, tree.moment, steps, leaves, Limits{}).reason == Reason::none);
  tree.levels = levels_of(tree.moment, tree.plant.organs, blade_area, 0.3f);
  return tree;
}

glm::vec3 place(const Mesh& mesh, std::uint32_t vertex) {
  return {mesh.positions[3 * vertex], mesh.positions[3 * vertex + 1], mesh.positions[3 * vertex + 2]};
}

double area_of(const PlantMesh& level, std::size_t run) {
  double sum = 0;
  const MeshRun& of = level.runs[run];
  for (std::uint32_t i = of.first_index; i < of.first_index + of.index_count; i += 3) {
    const std::uint32_t* const at = &level.mesh.indices[i];
    const glm::vec3 a = place(level.mesh, at[0]);
    sum +=
        0.5 * static_cast<double>(glm::length(glm::cross(place(level.mesh, at[1]) - a, place(level.mesh, at[2]) - a)));
  }
  return sum;
}

std::pair<glm::vec3, glm::vec3> box_of(const Mesh& mesh) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (std::uint32_t v = 0; v < mesh.positions.size() / 3; ++v) {
    low = glm::min(low, place(mesh, v));
    high = glm::max(high, place(mesh, v));
  }
  return {low, high};
}

std::size_t triangles(const PlantMesh& level) { return level.mesh.indices.size() / 3; }

// Trees of the paper's Table 2, and others.
const std::vector<std::pair<const char*, std::uint16_t>> trees{
    {"table-1-sigma1", 5}, {"table-1-sigma1", 7}, {"table-1-star", 6},  {"table-1-hat", 7},
    {"figure-4", 7},       {"figure-7", 7},       {"table-1-sigma1", 9}};

}  // namespace

TEST_CASE(
    "each level has 2.5 times fewer triangles at the least, and the last of a tree of 190 nodes 150 at the most") {
  for (const auto& [name, steps] : trees)
    for (const bool leafy : {true, false}) {
      CAPTURE(name);
      CAPTURE(steps);
      CAPTURE(leafy);
      const Tree tree = tree_of(text_named(name), steps, 3, leafy);
      const auto& levels = tree.levels.meshes;
      for (std::size_t k = 0; k + 1 < level_count; ++k) {
        CAPTURE(k);
        CAPTURE(triangles(levels[k]));
        CHECK(static_cast<double>(triangles(levels[k])) >= 2.5 * static_cast<double>(triangles(levels[k + 1])));
      }
      CHECK(triangles(levels[3]) <= 150);
      CHECK(triangles(levels[3]) >= 3);
    }
}

TEST_CASE("each level has all of the leaves' area") {
  for (const auto& [name, steps] : trees) {
    CAPTURE(name);
    CAPTURE(steps);
    const Tree tree = tree_of(text_named(name), steps, 3);
    double whole = 0;
    for (const Organ& leaf : tree.plant.organs)
      if (leaf.tag != fallen_tag) whole += static_cast<double>(blade_area * leaf.scale * leaf.scale);
    for (const PlantMesh& level : tree.levels.meshes) CHECK(area_of(level, 1) == doctest::Approx(whole).epsilon(0.01));
    CHECK(whole > 0);
  }
}

TEST_CASE("each level reaches as far as the first, bare or in leaf") {
  for (const auto& [name, steps] : trees)
    for (const bool leafy : {true, false}) {
      CAPTURE(name);
      CAPTURE(steps);
      CAPTURE(leafy);
      const Tree tree = tree_of(text_named(name), steps, 3, leafy);
      const auto [low, high] = box_of(tree.levels.meshes[0].mesh);
      for (std::size_t k = 1; k < level_count; ++k) {
        CAPTURE(k);
        const auto [least, most] = box_of(tree.levels.meshes[k].mesh);
        for (int axis = 0; axis < 3; ++axis) {
          const float off = 0.05f * (high[axis] - low[axis]);
          CHECK(std::abs(least[axis] - low[axis]) <= off);
          CHECK(std::abs(most[axis] - high[axis]) <= off);
        }
      }
    }
}

TEST_CASE("a tree in flower has blossoms at every distance") {
  Tree tree = tree_of(text_named("table-1-sigma1"), 7, 3);
  std::vector<Organ> organs = tree.plant.organs;
  const std::size_t leaves = organs.size();
  for (std::size_t i = 0; i < leaves; ++i) {
    Organ blossom = organs[i];
    blossom.tag = blossom_tag;
    blossom.scale = 0.04f;
    organs.push_back(blossom);
  }
  const TreeLevels levels = levels_of(tree.moment, organs, blade_area, 0.3f);
  const double whole = area_of(levels.meshes[0], 2);
  CHECK(whole == doctest::Approx(static_cast<double>(leaves) * 0.3 * 0.04 * 0.04).epsilon(0.01));
  for (const PlantMesh& level : levels.meshes) {
    CHECK(area_of(level, 2) == doctest::Approx(whole).epsilon(0.01));
    CHECK(level.runs[2].index_count > 0);
  }
  CHECK(triangles(levels.meshes[3]) <= 150);
}

TEST_CASE("thick wood is omitted last, and the tolerance states the omitted thickness") {
  const Tree tree = tree_of(text_named("table-1-sigma1"), 7, 3);
  const auto& tolerance = tree.levels.tolerance;
  CHECK(tolerance[0] == 0);
  for (std::size_t k = 1; k < level_count; ++k) CHECK(tolerance[k] > tolerance[k - 1]);
  // The trunk remains: some wood of the last level is as thick as the trunk's base, at the base.
  const PlantMesh& last = tree.levels.meshes[3];
  float wide = 0;
  for (std::uint32_t v = 0; v < last.runs[0].vertex_count; ++v)
    if (const glm::vec3 p = place(last.mesh, v); p.y < 0.1f) wide = std::max(wide, glm::length(glm::vec2(p.x, p.z)));
  CHECK(wide == doctest::Approx(tree.moment.segments[0].radius).epsilon(0.01));
}

TEST_CASE("meshes are valid: runs cover them, normals are unit and point out, each vertex sees some sky") {
  for (const bool leafy : {true, false}) {
    const Tree tree = tree_of(text_named("figure-4"), 7, 5, leafy);
    for (const PlantMesh& level : tree.levels.meshes) {
      const Mesh& mesh = level.mesh;
      REQUIRE(level.runs.size() == 3);
      CHECK(level.runs[0].name == "bark");
      CHECK(level.runs[1].name == "leaves");
      CHECK(level.runs[0].vertex_count == level.runs[1].first_vertex);
      CHECK(level.runs[2].name == "blossoms");
      CHECK(level.runs[1].first_vertex + level.runs[1].vertex_count == level.runs[2].first_vertex);
      CHECK(level.runs[2].first_vertex + level.runs[2].vertex_count == mesh.positions.size() / 3);
      CHECK(level.runs[1].first_index + level.runs[1].index_count == level.runs[2].first_index);
      CHECK(level.runs[2].first_index + level.runs[2].index_count == mesh.indices.size());
      CHECK(mesh.normals.size() == mesh.positions.size());
      REQUIRE(level.columns.size() == 1);
      CHECK(level.columns[0].name == "sky");
      CHECK(level.columns[0].rows == mesh.positions.size() / 3);
      for (std::uint32_t v = 0; v < mesh.normals.size() / 3; ++v)
        CHECK(glm::length(glm::vec3(mesh.normals[3 * v], mesh.normals[3 * v + 1], mesh.normals[3 * v + 2])) ==
              doctest::Approx(1).epsilon(1e-3));
      std::size_t opposed = 0;
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::uint32_t* const at = &mesh.indices[i];
        REQUIRE(std::max({at[0], at[1], at[2]}) < mesh.positions.size() / 3);
        const glm::vec3 a = place(mesh, at[0]), face = glm::cross(place(mesh, at[1]) - a, place(mesh, at[2]) - a);
        glm::vec3 normal(0);
        for (int k = 0; k < 3; ++k)
          normal += glm::vec3(mesh.normals[3 * at[k]], mesh.normals[3 * at[k] + 1], mesh.normals[3 * at[k] + 2]);
        if (glm::dot(face, normal) < 0) ++opposed;
      }
      CHECK(opposed <= mesh.indices.size() / 3 / 50);
    }
  }
}

TEST_CASE("the inside of a crown sees less of the sky than its outside") {
  const Tree tree = tree_of(text_named("table-1-sigma1"), 10, 3);
  const PlantMesh& level = tree.levels.meshes[0];
  const auto [low, high] = box_of(level.mesh);
  const glm::vec3 middle = 0.5f * (low + high), half = 0.5f * (high - low);
  double inner = 0, outer = 0;
  std::size_t inners = 0, outers = 0;
  for (std::uint32_t v = level.runs[1].first_vertex; v < level.mesh.positions.size() / 3; ++v) {
    const float far = glm::length((place(level.mesh, v) - middle) / half);
    const double sky = level.columns[0].data[v];
    if (far < 0.35f) inner += sky, ++inners;
    if (far > 0.9f) outer += sky, ++outers;
  }
  REQUIRE(inners > 20);
  REQUIRE(outers > 20);
  CHECK(inner / static_cast<double>(inners) < 0.9 * outer / static_cast<double>(outers));
}

TEST_CASE("a tree of age 0 has levels without triangles, and the same tree has the same levels") {
  const Population population = grown(text_named("table-1-sigma1"), 6);
  const Form form = form_of(population, {});
  const Moment none = sound(moment_of(population, form, 0, WoodHabit{}, Limits{}));
  for (const PlantMesh& level : levels_of(none, {}, blade_area, 0).meshes) CHECK(level.mesh.indices.empty());
  const Tree one = tree_of(text_named("figure-4"), 6, 8), again = tree_of(text_named("figure-4"), 6, 8);
  for (std::size_t k = 0; k < level_count; ++k) {
    CHECK(one.levels.meshes[k].mesh.positions == again.levels.meshes[k].mesh.positions);
    CHECK(one.levels.meshes[k].mesh.indices == again.levels.meshes[k].mesh.indices);
  }
}
