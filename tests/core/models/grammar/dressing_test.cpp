#include "models/grammar/dressing.hpp"

#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "models/grammar/growing.hpp"
#include "models/grammar/surfaces.hpp"

namespace panicle::grammar {
namespace {

lsystem::Turtle standing() {
  lsystem::Turtle turtle;
  turtle.heading = {0, 1, 0};
  turtle.left = {-1, 0, 0};
  turtle.up = {0, 0, 1};
  return turtle;
}

glm::vec3 turned(const glm::vec4& q, const glm::vec3& v) {
  const glm::vec3 axis(q);
  return v + 2.0f * glm::cross(axis, glm::cross(axis, v) + q.w * v);
}

const std::vector<glm::vec3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST_CASE("each polygon is an organ and a run of one mesh, in its colour; a note counts polygons without area") {
  Sketch sketch{Limits{}};
  lsystem::Turtle turtle = standing();
  sketch.polygon(turtle, triangle, {});
  turtle.colour = 5;
  sketch.polygon(turtle, triangle, {});
  sketch.polygon(turtle, std::span(triangle).first(2), {});
  Plant plant;
  dress(plant, sketch, {.metres = 0.1f, .sky = true});
  CHECK(plant.organs.size() == 3);
  CHECK(plant.organs[0].mesh == -1);
  CHECK(column_in<std::uint8_t>(plant.columns, "organs.colour") == std::vector<std::uint8_t>{3, 5, 5});
  const PlantMesh* blades = mesh_of(plant, "blades");
  REQUIRE(blades);
  REQUIRE(blades->runs.size() == 2);
  CHECK(column_in<std::uint8_t>(blades->columns, "colour") == std::vector<std::uint8_t>{3, 5});
  CHECK(blades->runs[1].first_vertex == 3);
  CHECK(blades->mesh.positions[3] == doctest::Approx(0.1));
  CHECK(blades->mesh.normals[2] == doctest::Approx(1));
  CHECK(column_in<std::uint8_t>(blades->columns, "sky").size() == 6);
  REQUIRE(plant.notes.size() == 1);
  CHECK(english(plant.notes[0]).find("A polygon is not visible") == 0);
}

TEST_CASE("corners of polygons without triangles are omitted") {
  Sketch sketch{Limits{}};
  const std::vector<glm::vec3> untidy{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}};
  sketch.polygon(standing(), untidy, {});
  Plant plant;
  dress(plant, sketch, {});
  const PlantMesh* blades = mesh_of(plant, "blades");
  REQUIRE(blades);
  CHECK(blades->mesh.positions.size() == 9);
  CHECK(blades->mesh.uvs.size() == 6);
  CHECK(blades->mesh.indices.size() == 3);
}

TEST_CASE("surfaces are organs with a mesh each, turned as the turtle is") {
  Sketch sketch{Limits{}};
  lsystem::Turtle turtle = standing();
  lsystem::pitch(turtle, 40);
  lsystem::roll(turtle, 130);
  lsystem::turn(turtle, -75);
  sketch.surface(turtle, "leaf", 2, {});
  sketch.surface(turtle, "petal", 1, {});
  sketch.surface(turtle, "leaf", 3, {});
  sketch.disc(turtle, 0.5f, {});
  sketch.surface(turtle, "fern", 1, {});
  sketch.surface(turtle, "fern", 1, {});
  Plant plant;
  dress(plant, sketch, {.metres = 1});
  REQUIRE(plant.organs.size() == 4);
  CHECK(plant.organ_tags[plant.organs[0].tag] == "leaf");
  CHECK(plant.organs[0].mesh == plant.organs[2].mesh);
  CHECK(plant.meshes[static_cast<std::size_t>(plant.organs[1].mesh)].name == "petal");
  CHECK(plant.meshes[static_cast<std::size_t>(plant.organs[3].mesh)].name == "disc");
  CHECK(plant.meshes.size() == 4);
  CHECK(plant.organs[2].scale == 3);
  const glm::vec4 q = plant.organs[0].rotation;
  CHECK(glm::distance(turned(q, {0, 1, 0}), turtle.heading) < 1e-5f);
  CHECK(glm::distance(turned(q, {0, 0, 1}), turtle.up) < 1e-5f);
  CHECK(glm::distance(turned(q, {1, 0, 0}), -turtle.left) < 1e-5f);
  REQUIRE(sketch.notes.size() == 1);
  CHECK(english(sketch.notes[0]).find("There is no surface “~fern”. Available surfaces: ~leaf, ~petal") == 0);
}

TEST_CASE("half turns in every direction give unit quaternions") {
  for (const float theta : {0.0f, 90.0f, 180.0f, 179.99f})
    for (const float phi : {0.0f, 90.0f, 180.0f, 180.01f})
      for (const float psi : {0.0f, 180.0f, 120.0f}) {
        Sketch sketch{Limits{}};
        lsystem::Turtle turtle = standing();
        lsystem::turn(turtle, theta);
        lsystem::pitch(turtle, phi);
        lsystem::roll(turtle, psi);
        sketch.surface(turtle, "leaf", 1, {});
        Plant plant;
        dress(plant, sketch, {.meshes = false});
        const glm::vec4 q = plant.organs[0].rotation;
        CHECK(glm::length(q) == doctest::Approx(1));
        CHECK(glm::distance(turned(q, {0, 1, 0}), turtle.heading) < 1e-4f);
        CHECK(glm::distance(turned(q, {0, 0, 1}), turtle.up) < 1e-4f);
      }
}

TEST_CASE("a colour other than 1 is the palette's, and a greater one is the last") {
  Sketch sketch{Limits{}};
  lsystem::Turtle turtle = standing();
  for (const std::int32_t colour : {-3, 1, 4, 8, 12}) {
    turtle.colour = colour;
    sketch.sphere(turtle, 1, {});
  }
  Plant plant;
  dress(plant, sketch, {.meshes = false});
  CHECK(column_in<std::uint8_t>(plant.columns, "organs.colour") == std::vector<std::uint8_t>{7, 7, 4, 8, 8});
}

TEST_CASE("a preview meshes many lines coarsely and few as usual; segments and organs are the same") {
  const auto vertices = [](const std::string& length, const std::string& outputs) {
    const Plant plant =
        grow({.text = "derivation length: " + length + "\naxiom: A\nA --> F [ +(30) A ] [ -(30) /(90) A ] A",
              .outputs = outputs});
    REQUIRE(mesh_of(plant, "stems"));
    return std::pair(mesh_of(plant, "stems")->mesh.positions.size(), plant.fingerprint);
  };
  const auto [fine, fingerprint] = vertices("8", "meshes");
  const auto [coarse, same] = vertices("8", "meshes coarse");
  CHECK(coarse < fine / 2);
  CHECK(same == fingerprint);
  CHECK(vertices("5", "meshes coarse") == vertices("5", "meshes"));
}

}  // namespace
}  // namespace panicle::grammar
