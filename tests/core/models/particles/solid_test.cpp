#include "models/particles/solid.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"
#include "models/particles/boundary.hpp"

namespace panicle::particles {
namespace {

glm::vec3 dart(std::uint64_t i, float reach) {
  return reach * glm::vec3(2 * random_unit(7, 1, i) - 1, 2 * random_unit(7, 2, i) - 1, 2 * random_unit(7, 3, i) - 1);
}

// An L of two boxes that share a face, as one surface with the shared face left out: concave.
Surface corner() {
  const std::vector<glm::vec2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  Surface made;
  for (const float z : {0.0f, 1.0f})
    for (const glm::vec2& p : outline) made.points.emplace_back(p.x, p.y, z);
  for (std::uint32_t k = 0; k < 6; ++k) {
    const std::uint32_t a = k, b = (k + 1) % 6;
    made.triangles.insert(made.triangles.end(), {a, b, b + 6, a, b + 6, a + 6});
  }
  for (const auto& [a, b, c] : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    made.triangles.insert(made.triangles.end(), {a, c, b});
    made.triangles.insert(made.triangles.end(), {a + 6, b + 6, c + 6});
  }
  return made;
}

bool in_corner(const glm::vec3& p) {
  return p.x > 0 && p.y > 0 && p.z > 0 && p.z < 1 && p.x < 2 && p.y < 2 && (p.x < 1 || p.y < 1);
}

TEST_CASE("a box holds what is in it") {
  const Solid solid(box({-1, 0, -2}, {1, 3, 2}));
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = dart(i, 4);
    const bool inside = std::fabs(p.x) < 1 && p.y > 0 && p.y < 3 && std::fabs(p.z) < 2;
    CHECK(solid.contains(p) == inside);
  }
}

TEST_CASE("a ball holds what is in it, but for what its facets cut off") {
  const Solid solid(ellipsoid({1, 2, 3}, {2, 1, 1.5f}, 48));
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = glm::vec3(1, 2, 3) + dart(i, 2.2f);
    const float from = glm::length((p - glm::vec3(1, 2, 3)) / glm::vec3(2, 1, 1.5f));
    if (from < 0.985f) CHECK(solid.contains(p));
    if (from > 1.0001f) CHECK_FALSE(solid.contains(p));
  }
}

TEST_CASE("a bay is outside, also at heights where faces and corners lie in the slice") {
  const Solid solid(corner());
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 p = glm::vec3(1) + dart(i, 1.3f);
    CHECK(solid.contains(p) == in_corner(p));
  }
  CHECK_FALSE(solid.contains({1.5f, 1.5f, 0.5f}));
  // The slice through the flat face at y = 1 has the one half's cross-section or the other's, and is closed.
  for (float x = 0.05f; x < 1; x += 0.1f) CHECK(solid.contains({x, 1, 0.5f}));
  CHECK_FALSE(solid.contains({2.5f, 1, 0.5f}));
  CHECK_FALSE(solid.contains({-0.5f, 1, 0.5f}));
}

TEST_CASE("parts that overlap, touch or are turned inside out count as they wind") {
  Surface two = box({0, 0, 0}, {2, 2, 2});
  append(two, box({1, 1, 1}, {3, 3, 3}));
  const Solid both(two);
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const glm::vec3 p = glm::vec3(1.5f) + dart(i, 1.8f);
    const auto in = [&p](float low, float high) {
      return p.x > low && p.x < high && p.y > low && p.y < high && p.z > low && p.z < high;
    };
    CHECK(both.contains(p) == (in(0, 2) || in(1, 3)));
  }
  Surface touching = box({0, 0, 0}, {1, 1, 1});
  append(touching, box({0, 1, 0}, {1, 2, 1}));
  const Solid stacked(touching);
  for (float y = 0.05f; y < 2; y += 0.05f) CHECK(stacked.contains({0.5f, y, 0.5f}));
  CHECK(stacked.contains({0.5f, 1, 0.5f}));
  Surface turned = box({0, 0, 0}, {1, 1, 1});
  for (std::size_t t = 0; t < turned.triangles.size(); t += 3) std::swap(turned.triangles[t], turned.triangles[t + 1]);
  CHECK(Solid(turned).contains({0.5f, 0.5f, 0.5f}));
  // A hole: what is turned within another.
  Surface hollow = box({-1, -1, -1}, {2, 2, 2});
  append(hollow, turned);
  CHECK_FALSE(Solid(hollow).contains({0.5f, 0.5f, 0.5f}));
  CHECK(Solid(hollow).contains({1.5f, 0.5f, 0.5f}));
}

TEST_CASE("what is certain of a box is so for every place in it") {
  const Solid solid(ellipsoid({0, 0, 0}, {1, 1, 1}, 32));
  int sure = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const glm::vec3 low = dart(i, 1.1f), high = low + 0.1f;
    const Share share = solid.share_of(low, high);
    if (share == Share::some) continue;
    ++sure;
    for (std::uint64_t k = 0; k < 8; ++k) {
      const glm::vec3 p = low + 0.1f * (0.5f * dart(8 * i + k, 1) + 0.5f);
      CHECK(solid.contains(p) == (share == Share::all));
    }
  }
  CHECK(sure > 1500);
  CHECK(solid.share_of({-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f}) == Share::all);
  CHECK(solid.share_of({2, 2, 2}, {3, 3, 3}) == Share::none);
}

TEST_CASE("of solids far apart what is certain is known as well as of one") {
  Surface two = ellipsoid({0, 0, 0}, {1, 1, 1}, 32);
  append(two, ellipsoid({100, 0, 0}, {1, 1, 1}, 32));
  const Solid solid(two);
  CHECK(solid.share_of({99.9f, -0.1f, -0.1f}, {100.1f, 0.1f, 0.1f}) == Share::all);
  CHECK(solid.share_of({40, -0.5f, -0.5f}, {60, 0.5f, 0.5f}) == Share::none);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const glm::vec3 p = dart(i, 1.1f);
    const float length = glm::length(p);
    if (length < 0.95f || length > 1) CHECK(solid.contains(p + glm::vec3(100, 0, 0)) == (length < 1));
  }
}

TEST_CASE("nothing is in nothing, and nowhere is nowhere") {
  const Solid none({});
  CHECK_FALSE(none.contains({0, 0, 0}));
  CHECK(none.share_of({0, 0, 0}, {1, 1, 1}) != Share::all);
  const Solid solid(box({0, 0, 0}, {1, 1, 1}));
  CHECK_FALSE(solid.contains({NAN, 0.5f, 0.5f}));
  CHECK_FALSE(solid.contains({0.5f, INFINITY, 0.5f}));
  const Solid flat(box({0, 0, 0}, {1, 0, 1}));
  CHECK_FALSE(flat.contains({0.5f, 0.5f, 0.5f}));
  const Solid point(box({1, 1, 1}, {1, 1, 1}));
  CHECK_FALSE(point.contains({1, 1, 1.5f}));
}

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

TEST_CASE("notes on a mesh say where it is open and where it is turned") {
  Form form = Form::mesh;
  std::vector<std::string> notes;
  Surface whole = box({0, 0, 0}, {1, 1, 1});
  note_on(whole, form, notes);
  CHECK(notes.empty());
  // Points that stand in the list once for each triangle are the same points.
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
  CHECK(notes[0].find("open at 3 edges") != std::string::npos);
  notes.clear();
  std::swap(whole.triangles[0], whole.triangles[1]);
  note_on(whole, form, notes);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("turned against each other at 3 edges") != std::string::npos);
  notes.clear();
  note_on({}, form, notes);
  CHECK(form == Form::ellipsoid);
  REQUIRE(notes.size() == 1);
}

}  // namespace
}  // namespace panicle::particles
