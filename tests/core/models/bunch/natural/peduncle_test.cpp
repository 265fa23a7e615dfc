// The peduncle: the stalk that bunches hang from.
#include "models/bunch/natural/peduncle.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

// A rachis of two internodes that branches after the first, and a second root beside it.
std::vector<Internode> skeleton() {
  const auto piece = [](std::int32_t parent, const glm::vec3& start, const glm::vec3& end) {
    Internode one;
    one.parent = parent;
    one.start = start;
    one.end = end;
    one.radius = one.radius_end = 0.002f;
    return one;
  };
  return {piece(-1, {0, 0, 0}, {0, -0.01f, 0}), piece(0, {0, -0.01f, 0}, {0, -0.02f, 0}),
          piece(0, {0, -0.01f, 0}, {0.01f, -0.01f, 0}), piece(-1, {0, 0, 0}, {-0.01f, -0.01f, 0})};
}

float measured(float requested, std::uint32_t seed) {
  BunchRequest request = natural_request(table3[0].profile(), seed);
  set(request, Parameter::peduncle, requested);
  request.measures = true;
  return grown(request).measures[static_cast<std::size_t>(Measure::peduncle_length)];
}

}  // namespace

TEST_CASE(
    "a peduncle is as long as asked for, down to the first branch, and all that grew from p1 grows from its end") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    std::vector<Internode> internodes = skeleton();
    const std::int32_t moved = add_peduncle(internodes, 0.05f, seed);
    REQUIRE(moved > 0);
    const auto end = static_cast<std::size_t>(moved - 1);
    CHECK(internodes[0].parent == -1);
    CHECK(internodes[0].start.y == doctest::Approx(0.04).epsilon(0.001));
    CHECK(glm::length(internodes[end].end) == 0);
    for (std::size_t i = 1; i <= end; ++i) {
      CHECK(internodes[i].parent == static_cast<std::int32_t>(i) - 1);
      CHECK(internodes[i].start == internodes[i - 1].end);
      CHECK(internodes[i].radius == internodes[i - 1].radius_end);
      CHECK(internodes[i].start.y < internodes[i - 1].start.y);
      CHECK(internodes[i].joint);
    }
    CHECK(internodes[end + 1].parent == moved - 1);
    CHECK(internodes[end + 2].parent == moved);
    CHECK(internodes[end + 4].parent == moved - 1);
    // Nearly straight: hardly longer than its ends are apart.
    std::vector<Internode> alone(internodes.begin(), internodes.begin() + moved);
    CHECK(length_to_first_branch(alone) < 1.02f * glm::length(internodes[0].start));
    // Thickest where it leaves the cane and at its node.
    CHECK(internodes[0].radius > 1.3f * internodes[end].radius_end);
    float node = 0, beside = 1;
    for (std::size_t i = 1; i < end; ++i) {
      node = std::max(node, internodes[i].radius_end);
      beside = std::min(beside, internodes[i].radius_end);
    }
    CHECK(node > 1.15f * beside);
  }
}

TEST_CASE("a bunch that branches later than the requested peduncle's length gets no peduncle") {
  std::vector<Internode> internodes = skeleton();
  CHECK(add_peduncle(internodes, 0.0105f, 1) == 0);
  CHECK(internodes.size() == 4);
  std::vector<Internode> none;
  CHECK(add_peduncle(none, 0.05f, 1) == 0);
}

TEST_CASE("a natural bunch has the requested peduncle's length, and is otherwise unchanged") {
  for (const float requested : {25.0f, 45.0f, 110.0f})
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
      CHECK(measured(requested, seed) == doctest::Approx(requested).epsilon(0.02));
  BunchRequest request = natural_request(table3[0].profile());
  set(request, Parameter::peduncle, 0);
  const GrownBunch bare = grown(request);
  set(request, Parameter::peduncle, 60);
  const GrownBunch hung = grown(request);
  REQUIRE(bare.berries.size() == hung.berries.size());
  for (std::size_t i = 0; i < bare.berries.size(); ++i) CHECK(bare.berries[i].centre == hung.berries[i].centre);
}

TEST_CASE("two bunches share a peduncle, and the first is measured by itself") {
  BunchRequest request = natural_request(table3[0].profile());
  request.measures = true;
  const GrownBunch one = grown(request);
  set(request, Parameter::wing, 0.6f);
  const GrownBunch two = grown(request);
  std::size_t roots = 0;
  for (const Internode& internode : two.internodes) roots += internode.parent < 0;
  CHECK(roots == 1);
  CHECK(one.second_root == -1);
  REQUIRE(two.second_root > 0);
  const auto wings = static_cast<std::size_t>(Measure::wings), shape = static_cast<std::size_t>(Measure::bunch_shape);
  CHECK(two.measures[shape] == one.measures[shape]);
  CHECK(two.measures[wings] == one.measures[wings] + 1);
}

TEST_CASE("a cane is at the peduncle's upper end, clear of the berries for any requested length") {
  BunchRequest request = natural_request(table3[0].profile());
  request.meshes = true;
  set(request, Parameter::cane, 1);
  for (const float requested : {0.0f, 70.0f}) {
    set(request, Parameter::peduncle, requested);
    const GrownBunch bunch = grown(request);
    const float top = bunch.internodes[0].start.y;
    CHECK(top > 0.015f);
    CHECK((requested == 0 || top > 0.05f));
    float near = 1;
    for (std::size_t i = 0; i < bunch.foliage->mesh.positions.size(); i += 3) {
      const float* p = &bunch.foliage->mesh.positions[i];
      near = std::min(near, glm::length(glm::vec3(p[0], p[1], p[2]) - bunch.internodes[0].start));
    }
    CHECK(near < 0.007f);
  }
}
