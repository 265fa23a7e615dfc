// The root, requested as the page requests it; the part shared with the tree is tested there.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "models/particles/space_growing.hpp"
#include "models/root/measures/measures.generated.hpp"
#include "plant/branching.hpp"
#include "spatial/surfaces.hpp"

namespace panicle::particles {
namespace {

using root::Measure;

float measure(const Plant& plant, Measure which) { return plant.measures[static_cast<std::size_t>(which)]; }

TEST_CASE("for every volume and seed roots run up to the collar, and stay below ground") {
  for (float shape = 0; shape < 5; ++shape)
    for (const std::uint32_t seed : {1u, 5u})
      for (const float slant : {0.0f, 1.0f, 6.0f}) {
        CAPTURE(shape);
        CAPTURE(slant);
        const Plant plant = grow_root(
            {.parameters = {{"shape", shape}, {"slant", slant}, {"particles", 500}, {"energy", 2}}, .seed = seed});
        const auto arrived = column_in<float>(plant, "targets.energy");
        REQUIRE(arrived.size() == 1);
        CHECK(arrived[0] == 2 * static_cast<float>(count_of(plant, "particles")));
        CHECK(count_of(plant, "particles") > 300);
        CHECK(tips_of(plant).size() == count_of(plant, "particles"));
        for (const Segment& segment : plant.segments) {
          CHECK(segment.end.y <= 1e-4f);
          if (segment.parent < 0) CHECK(segment.start == glm::vec3(0));
        }
        for (const std::size_t tip : tips_of(plant)) {
          const glm::vec3 p = plant.segments[tip].end;
          CHECK(p.y >= -1.2f);
          CHECK(std::hypot(p.x, shape == 3 ? 0 : p.z) <= 1.001f);
        }
      }
}

TEST_CASE("a slight slant gives a tap root, a great one fibres") {
  const auto axis = [](float slant, std::uint32_t seed) {
    const Plant plant = grow_root({.parameters = {{"slant", slant}, {"particles", 1500}}, .seed = seed});
    const auto energy = column_in<float>(plant, "segments.energy");
    // The thickest that passes 0.6 m below the collar near the axis.
    float passing = 0;
    for (std::size_t i = 0; i < plant.segments.size(); ++i) {
      const Segment& segment = plant.segments[i];
      if (segment.start.y > -0.6f && segment.end.y <= -0.6f && std::hypot(segment.start.x, segment.start.z) < 0.2f)
        passing = std::max(passing, energy[i]);
    }
    return passing / static_cast<float>(count_of(plant, "particles"));
  };
  float level = 0, steep = 0;
  for (std::uint32_t seed = 1; seed < 6; ++seed) {
    level += axis(0.2f, seed);
    steep += axis(5, seed);
  }
  CHECK(level > 2 * steep);
}

TEST_CASE("topsoil thins roots downwards by its depth") {
  const Plant plant = grow_root(
      {.parameters = {{"shape", 3}, {"pattern", 3}, {"topsoil", 0.3f}, {"particles", 6000}, {"reach", 1.2f}}});
  std::uint32_t upper = 0, lower = 0;
  for (const std::size_t tip : tips_of(plant)) ++(plant.segments[tip].end.y > -0.6f ? upper : lower);
  // ∫ e^(−y / 0.3) over each half: e² = 7.39 times as many above.
  CHECK(static_cast<float>(upper) / static_cast<float>(lower) == doctest::Approx(7.39f).epsilon(0.12));
}

TEST_CASE("tips bend down by gravitropism") {
  const auto fall = [](float gravitropism) {
    const Plant plant =
        grow_root({.parameters = {{"gravitropism", gravitropism}, {"particles", 1200}, {"reach", 4}, {"top", 2}}});
    float sum = 0;
    for (const std::size_t tip : tips_of(plant)) {
      std::size_t at = tip;
      const glm::vec3 end = plant.segments[tip].end;
      while (glm::distance(plant.segments[at].start, end) < 0.6f && plant.segments[at].parent >= 0)
        at = static_cast<std::size_t>(plant.segments[at].parent);
      sum += glm::normalize(end - plant.segments[at].start).y;
    }
    return sum / static_cast<float>(tips_of(plant).size());
  };
  CHECK(fall(0.8f) < fall(0) - 0.05f);
  CHECK(fall(-0.8f) > fall(0) + 0.1f);
}

TEST_CASE("roots grow round stones, below ground") {
  const Plant plant =
      grow_root({.parameters = {{"particles", 800}}, .obstacles = {0.2f, -0.5f, -0.5f, 0.6f, 0.5f, 0.5f}});
  std::uint32_t through = 0;
  for (const Segment& segment : plant.segments) {
    const glm::vec3 middle = 0.5f * (segment.start + segment.end);
    through += middle.x > 0.2f && middle.x < 0.6f && middle.y > -0.5f && std::fabs(middle.z) < 0.5f;
    CHECK(segment.end.y <= 1e-4f);
  }
  CHECK(through == 0);
}

TEST_CASE("several plants are in a row, above a volume at the given depth") {
  const Plant plant =
      grow_root({.parameters = {{"stems", 2}, {"width", 4}, {"top", 0.3f}, {"particles", 600}, {"life", 0}},
                 .outputs = "measures"});
  CHECK(column_in<float>(plant, "targets.places") == std::vector<float>{-1, 0, 0, 1, 0, 0});
  for (const std::size_t tip : tips_of(plant)) CHECK(plant.segments[tip].end.y <= -0.3f);
  CHECK(measure(plant, Measure::deepest) == doctest::Approx(1.5f).epsilon(0.1));
}

TEST_CASE("measures follow from the grown root") {
  // A trunk that forks in two, one of which forks again.
  const float r = 0.1f;
  const std::vector<Segment> segments{{-1, 0, {0, 0, 0}, {0, 1, 0}, r, r},
                                      {0, 0, {0, 1, 0}, {1, 1, 0}, r, r},
                                      {0, 0, {0, 1, 0}, {0, 2, 0}, r, 0},
                                      {1, 0, {1, 1, 0}, {2, 1, 0}, r, r},
                                      {1, 0, {1, 1, 0}, {1, 1, 1}, r, r}};
  const Branching found = branching_of(segments);
  CHECK(found.tips == 3);
  CHECK(found.forks == 2);
  CHECK(found.order == 2);
  CHECK(found.of_order[0] == 3);
  CHECK(found.of_order[1] == 1);
  CHECK(found.bifurcation == doctest::Approx(3));
  CHECK(found.fork_angle == doctest::Approx(90));
  CHECK(found.length == doctest::Approx(5));
  CHECK(found.volume == doctest::Approx(3.14159265 * (4 * 0.01 + 0.01 / 3)));
  CHECK(found.surface == doctest::Approx(3.14159265 * (4 * 0.2 + 0.1 * std::sqrt(1.01))));
  CHECK(found.high == 2);
  CHECK(found.width_x == 2);
  CHECK(found.width_z == 1);
  CHECK(found.thickest == doctest::Approx(0.2f));
  CHECK(std::isnan(branching_of(std::span(segments).first(1)).bifurcation));
  CHECK(branching_of({}).order == 0);

  const Plant plant = grow_root(
      {.parameters = {{"shape", 3}, {"width", 1}, {"depth", 1}, {"reach", 2}, {"inner", 0.5f}, {"particles", 800}},
       .outputs = "measures"});
  REQUIRE(plant.measures.size() == root::measure_count);
  CHECK(measure(plant, Measure::root_volume) == doctest::Approx(2 * (1 - 0.125f)).epsilon(0.03));
  CHECK(measure(plant, Measure::tips) == static_cast<float>(count_of(plant, "particles")));
  CHECK(measure(plant, Measure::density) ==
        doctest::Approx(0.001f * measure(plant, Measure::wood_length) / measure(plant, Measure::root_volume)));
}

TEST_CASE("a mesh whose triangles lie behind each other too often is an error, as is one of too many triangles") {
  const Surface mesh = spanning_tetrahedra(100);
  SpaceOptions options{.parameters = {{"particles", 200}, {"shape", 5}}, .triangles = mesh.triangles};
  for (const glm::vec3& p : mesh.points) options.points.insert(options.points.end(), {p.x, p.y, p.z});
  CHECK(request_root(options));
  options.limits.looks = 1'000'000;
  const Result<Plant> stopped = request_root(options);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().reason == Reason::limit);
  CHECK(english(stopped.error().message).find("simplify the mesh") != std::string::npos);
  options.limits.triangles = 399;
  const Result<Plant> refused = request_root(options);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().reason == Reason::limit);
  CHECK(english(refused.error().message) == "The meshes have 400 triangles; the limit is 399. Simplify them.");
}

}  // namespace
}  // namespace panicle::particles
