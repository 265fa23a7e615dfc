#include "plant/geometry_check.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "foundation/english.hpp"

using namespace panicle;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

// A plant with one of each: a segment, an organ, a mesh of two parts, and the model's own columns.
Plant one_of_each() {
  Plant plant;
  plant.tags = {"stem", "branch"};
  plant.organ_tags = {"leaf"};
  plant.segments.push_back({});
  plant.segments.back().tag = 1;
  plant.organs.push_back({});
  PlantMesh mesh{"petals", "petal", {}, {}, {}};
  mesh.mesh.positions.assign(3 * 3000, 1.0f);
  mesh.mesh.normals.assign(3 * 3000, 0.5f);
  mesh.mesh.uvs.assign(2 * 3000, 0.5f);
  mesh.runs = {{{0, 2000, 0, 0}, "Lower"}, {{2000, 1000, 0, 0}, "Upper"}};
  plant.meshes.push_back(std::move(mesh));
  return plant;
}

void check_refused(const Plant& plant, const char* what) {
  const Diagnostic error = check_geometry(plant);
  const std::string sentence = english(error.message);
  CAPTURE(sentence);
  CHECK(error.reason == Reason::evaluation);
  CHECK(sentence.find(what) == 0);
}

}  // namespace

TEST_CASE("check_geometry accepts a plant of finite numbers with any other columns") {
  Plant plant = one_of_each();
  plant.columns.add("constants", std::vector<float>{nan, infinity});
  plant.columns.add("berries.spheres", std::vector<float>(4, 1e30f), 4);
  CHECK(check_geometry(plant).reason == Reason::none);
  CHECK(check_geometry(Plant{}).reason == Reason::none);
}

TEST_CASE("check_geometry names the segment, organ, mesh part or column that is not finite") {
  for (const float value : {infinity, -infinity, nan}) {
    for (float Segment::* member : {&Segment::radius, &Segment::radius_end}) {
      Plant plant = one_of_each();
      plant.segments[0].*member = value;
      check_refused(plant, "Segment 1 of");
    }
    for (glm::vec3 Segment::* member : {&Segment::start, &Segment::end})
      for (int k = 0; k < 3; ++k) {
        Plant plant = one_of_each();
        (plant.segments[0].*member)[k] = value;
        check_refused(plant, "Segment 1 of");
      }
    Plant moved = one_of_each();
    moved.organs[0].position.y = value;
    check_refused(moved, "Organ 1 of");
    Plant turned = one_of_each();
    turned.organs[0].rotation.w = value;
    check_refused(turned, "Organ 1 of");
    Plant scaled = one_of_each();
    scaled.organs[0].scale = value;
    check_refused(scaled, "Organ 1 of");
    for (std::vector<float> Mesh::* values : {&Mesh::positions, &Mesh::normals, &Mesh::uvs}) {
      Plant plant = one_of_each();
      (plant.meshes[0].mesh.*values).back() = value;
      check_refused(plant, "Part “Upper” of the mesh “petals”");
      (plant.meshes[0].mesh.*values).front() = value;
      check_refused(plant, "Part “Lower” of the mesh “petals”");
      plant.meshes[0].runs.clear();
      check_refused(plant, "The mesh “petals”");
    }
    for (const char* name : {"berries.spheres", "thinned.places", "berries.positions", "berries.normals"}) {
      Plant plant = one_of_each();
      plant.columns.add(name, std::vector<float>{1, value, 1, 1}, 4);
      check_refused(plant, ("The values “" + std::string(name) + "”").c_str());
    }
  }
}
