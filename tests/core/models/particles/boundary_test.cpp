#include "models/particles/boundary.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "spatial/solid.hpp"
#include "spatial/surfaces.hpp"

namespace panicle::particles {
namespace {

TEST_CASE("each form fills its box from end to end, and no further") {
  const std::vector<glm::vec2> barrel{{0.5f, 0}, {1, 0.5f}, {0.5f, 1}};
  const glm::vec3 low(-2, 1, -1), high(2, 4, 1);
  for (const Form form :
       {Form::ellipsoid, Form::box, Form::cone, Form::cone_down, Form::bowl, Form::spline, Form::mesh}) {
    const Solid solid(form_between(form, barrel, corner(), low, high));
    CAPTURE(static_cast<int>(form));
    for (int k = 0; k < 3; ++k) {
      CHECK(solid.low()[k] == doctest::Approx(low[k]).epsilon(0.01));
      CHECK(solid.high()[k] == doctest::Approx(high[k]).epsilon(0.01));
    }
    CHECK(solid.contains({form == Form::mesh ? -1.0f : 0.0f, 2, form == Form::mesh ? 0.1f : 0.0f}));
  }
  const auto holds = [&](Form form, float x, float y) {
    return Solid(form_between(form, {}, {}, low, high)).contains({x, y, 0});
  };
  CHECK(holds(Form::cone, 1.7f, 1.2f));
  CHECK_FALSE(holds(Form::cone, 1.7f, 3.8f));
  CHECK(holds(Form::cone_down, 1.7f, 3.8f));
  CHECK_FALSE(holds(Form::cone_down, 1.7f, 1.2f));
  CHECK(holds(Form::bowl, 1.7f, 3.8f));
  CHECK_FALSE(holds(Form::bowl, 1.7f, 1.2f));
}

TEST_CASE("the inner boundary is the outer one made smaller, or a mesh of its own in that box") {
  const glm::vec3 low(-2, 1, -1), high(2, 4, 1), about(0, 4, 0);
  const Surface outer = form_between(Form::ellipsoid, {}, {}, low, high);
  for (const Surface& own : {Surface{}, corner()}) {
    const Solid inner(inner_boundary(outer, own, low, high, about, 0.5f));
    CHECK(inner.low().x == doctest::Approx(-1).epsilon(0.01));
    CHECK(inner.high().y == doctest::Approx(4).epsilon(0.01));
    CHECK(inner.low().y == doctest::Approx(2.5).epsilon(0.01));
    CHECK(inner_boundary(outer, own, low, high, about, 0).triangles.empty());
  }
  // The corner that is cut off is no part of it.
  const glm::vec3 cut(0.7f, 3.6f, 0);
  const bool round = Solid(inner_boundary(outer, {}, low, high, {0, 2.5f, 0}, 0.9f)).contains(cut);
  const bool cornered = Solid(inner_boundary(outer, corner(), low, high, {0, 2.5f, 0}, 0.9f)).contains(cut);
  CHECK(round);
  CHECK_FALSE(cornered);
}

TEST_CASE("a spline passes its points, and never below 0") {
  const std::vector<glm::vec2> points{{0, 0}, {1, 1}, {0, 2}, {0, 3}, {1, 4}};
  const std::vector<glm::vec2> line = spline_through(points);
  for (const glm::vec2& point : points) {
    float nearest = 1;
    for (const glm::vec2& p : line) nearest = std::min(nearest, glm::distance(p, point));
    CHECK(nearest < 1e-5f);
  }
  for (const glm::vec2& p : line) CHECK(p.x >= 0);
  CHECK(line.size() > 3 * points.size());
  CHECK(spline_through({}).empty());
}

TEST_CASE("notes on a mesh name its open edges and its turned triangles") {
  Form form = Form::mesh;
  std::vector<std::string> notes;
  Surface whole = box({0, 0, 0}, {1, 1, 1});
  note_on(whole, form, notes);
  CHECK(notes.empty());
  // Points listed once for each triangle count as the same points.
  Surface loose;
  for (const std::uint32_t corner_of : whole.triangles) {
    loose.triangles.push_back(static_cast<std::uint32_t>(loose.points.size()));
    loose.points.push_back(whole.points[corner_of]);
  }
  note_on(loose, form, notes);
  CHECK(notes.empty());
  Surface open = whole;
  open.triangles.resize(open.triangles.size() - 3);
  note_on(open, form, notes);
  REQUIRE(notes.size() == 1);
  CHECK(english(notes[0]).find("open at 3 edges") != std::string::npos);
  notes.clear();
  std::swap(whole.triangles[0], whole.triangles[1]);
  note_on(whole, form, notes);
  REQUIRE(notes.size() == 1);
  CHECK(english(notes[0]).find("face opposite ways at 3 edges") != std::string::npos);
  notes.clear();
  note_on({}, form, notes);
  CHECK(form == Form::ellipsoid);
  REQUIRE(notes.size() == 1);
}

}  // namespace
}  // namespace panicle::particles
