// The visible parts of a leaf: thickness of veins and petiole, meshes, moving particles.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/leaf/leaf_growing.hpp"
#include "near.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

namespace {

const PlantMesh* mesh_at(const Plant& plant, std::string_view name) {
  for (const PlantMesh& mesh : plant.meshes)
    if (mesh.name == name) return &mesh;
  return nullptr;
}

}  // namespace

TEST_CASE("the thickest vein has the requested width, and at forks widths, cross-sections or cubes add up by the law") {
  struct Case {
    float law, exponent;
    // Where veins meet, the sums of radii to this power are equal.
    double power;
  };
  // Linear; Leonardo's rule; Murray's.
  for (const auto& [law, exponent, power] : {Case{0, absent, 1}, Case{1, absent, 2}, Case{2, 1.0f / 3, 3}}) {
    const Plant plant = leaf_of(
        {{{Parameter::law, law}, {Parameter::exponent, exponent}, {Parameter::vein, 2}, {Parameter::particles, 300}}});
    std::vector<double> arriving(plant.segments.size(), 0);
    std::vector<int> children(plant.segments.size(), 0);
    // No vein is thinner than 0.01 mm: the law does not hold where a vein is clamped to that.
    std::vector<bool> bounded(plant.segments.size(), false);
    float widest = 0;
    for (const Segment& segment : plant.segments) {
      widest = std::max(widest, segment.radius);
      if (segment.parent < 0) continue;
      arriving[static_cast<std::size_t>(segment.parent)] += std::pow(segment.radius, power);
      ++children[static_cast<std::size_t>(segment.parent)];
      if (segment.radius < 5.01e-6f) bounded[static_cast<std::size_t>(segment.parent)] = true;
    }
    CHECK(widest > 0.0008f);
    CHECK(widest <= 0.001001f);
    int forks = 0;
    for (std::size_t i = 0; i < plant.segments.size(); ++i) {
      if (children[i] < 2 || bounded[i]) continue;
      ++forks;
      CAPTURE(law);
      CHECK(std::pow(arriving[i], 1 / power) == near(plant.segments[i].radius, 0.02));
    }
    CHECK(forks > 20);
  }
}

TEST_CASE("a petiole has the requested thickness, independent of the veins") {
  for (const auto& [vein, wide] : {std::pair{0.3f, 2.4f}, {3.0f, 1.2f}}) {
    const Plant plant = leaf_of(
        {{{Parameter::particles, 100}, {Parameter::vein, vein}, {Parameter::petiole_width, wide}}, {}, 1, "meshes"});
    const PlantMesh* stalk = mesh_at(plant, "petiole");
    REQUIRE(stalk != nullptr);
    // Where it meets the blade, at the origin: half of the girth there is half its thickness.
    float widest = 0;
    for (std::size_t i = 0; i + 2 < stalk->mesh.positions.size(); i += 3)
      if (std::fabs(stalk->mesh.positions[i + 1]) < 5e-4f)
        widest = std::max(widest, std::fabs(stalk->mesh.positions[i]));
    CHECK(widest == near(0.0005f * wide, 0.05));
  }
}

TEST_CASE("particles are large enough to be seen, the larger the fewer there are, and apart from each other") {
  const auto radius_of = [](float particles) {
    const Plant plant = leaf_of({{{Parameter::particles, particles}, {Parameter::age, 0}}});
    REQUIRE(!plant.organs.empty());
    float least = plant.organs.front().scale;
    for (const Organ& organ : plant.organs) least = std::min(least, organ.scale);
    return least / 0.09f;
  };
  const float few = radius_of(400), some = radius_of(2000), many = radius_of(20000);
  CHECK(few == near(0.006f, 1e-3));
  CHECK(some > 0.003f);
  CHECK(some < few);
  CHECK(many == near(0.0022f, 1e-3));
}

TEST_CASE("age runs from scattered particles to whole trails, with both in the middle") {
  const auto at = [](float age) {
    return leaf_of({{{Parameter::particles, 400}, {Parameter::age, age}}, {}, 1, "meshes"});
  };
  const Plant begin = at(0), middle = at(50), end = at(100);
  CHECK(begin.segments.empty());
  CHECK(begin.organs.size() == count_at(begin, "particles"));
  CHECK(middle.organs.size() < begin.organs.size());
  CHECK(middle.organs.size() > 0);
  CHECK(middle.segments.size() > 100);
  CHECK(end.organs.empty());
  CHECK(mesh_at(end, "particle") == nullptr);
  for (const Organ& organ : middle.organs) {
    REQUIRE(organ.mesh >= 0);
    CHECK(middle.meshes[static_cast<std::size_t>(organ.mesh)].name == "particle");
    CHECK(organ.scale > 0);
  }
  // Counts are those of the whole run.
  CHECK(count_at(middle, "steps") == count_at(end, "steps"));
  CHECK(count_at(middle, "energy") == count_at(end, "energy"));
}

TEST_CASE(
    "meshes come where they are asked for, with the sky where that is, and fewer triangles for less detail or a "
    "draft") {
  const auto triangles = [](const Plant& plant) { return mesh_at(plant, "upper")->mesh.indices.size() / 3; };
  const Plant full = leaf_of({{}, {}, 1, "meshes sky"}), light = leaf_of({{}, {}, 1, "meshes", {0.05f}});
  const Plant draft = leaf_of({{}, {}, 1, "meshes draft"});
  CHECK(leaf_of({}).meshes.empty());
  for (const char* name : {"upper", "lower", "petiole"}) {
    const PlantMesh* mesh = mesh_at(full, name);
    REQUIRE(mesh != nullptr);
    bool sky = false;
    for (std::size_t i = 0; i < mesh->columns.size(); ++i)
      if (mesh->columns[i].name == "sky") {
        sky = true;
        CHECK(mesh->columns[i].rows == mesh->mesh.positions.size() / 3);
      }
    CHECK(sky);
  }
  CHECK(mesh_at(full, "upper")->material == "blade");
  CHECK(mesh_at(full, "petiole")->material == "stem");
  CHECK(triangles(light) * 7 < triangles(full));
  CHECK(triangles(draft) * 2 < triangles(full));
  CHECK(count_at(draft, "particles") < 1000);
  const Plant bare = leaf_of({{{Parameter::petiole, 0}}, {}, 1, "meshes"});
  CHECK(mesh_at(bare, "petiole") == nullptr);
}
