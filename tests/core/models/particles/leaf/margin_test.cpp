#include "models/particles/leaf/margin.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/random.hpp"
#include "models/particles/leaf/outlines.hpp"
#include "models/particles/outline.hpp"
#include "near.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

namespace {

std::vector<ControlPoint> points_of(const std::vector<float>& rows) {
  std::vector<std::string> notes;
  const auto points = read_outline(rows, notes);
  REQUIRE(points);
  return points.value();
}

// What is wrong with an outline, in words.
std::string trouble_with(const std::vector<float>& rows) {
  std::vector<std::string> notes;
  const auto points = read_outline(rows, notes);
  if (!points) return points.error().message;
  const auto margin = spline(points.value());
  return margin ? "" : margin.error().message;
}

}  // namespace

TEST_CASE("the spline passes through its points, keeps corners and is round between") {
  const auto points = points_of({0, 0, 1, 0.4f, 0, 0, 0.5f, 0.5f, 0, 0, 1, 3, -0.5f, 0.5f, 0, -0.4f, 0, 0});
  const auto margin = spline(points);
  REQUIRE(margin);
  REQUIRE(margin->controls.size() == 6);
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(glm::distance(margin->points[margin->controls[i]], points[i].place) < 2e-6f);
  CHECK(margin->tip == margin->controls[3]);
  CHECK(margin->tips == std::vector<std::size_t>{margin->tip});
  // At smooth points it hardly turns from piece to piece, at sharp ones it does.
  const std::size_t count = margin->points.size();
  const auto turn = [&](std::size_t i) {
    const glm::vec2 in = margin->points[i] - margin->points[(i + count - 1) % count];
    const glm::vec2 out = margin->points[(i + 1) % count] - margin->points[i];
    return glm::dot(in, out) / (glm::length(in) * glm::length(out));
  };
  CHECK(turn(margin->controls[1]) > 0.97f);
  CHECK(turn(margin->controls[2]) > 0.97f);
  CHECK(turn(margin->tip) < 0.7f);
  CHECK(turn(0) < 0.95f);
}

TEST_CASE("an outline the other way round is turned, its base kept") {
  const auto one = points_of({0, 0, 1, 0.4f, 0.4f, 0, 0, 1, 3, -0.4f, 0.4f, 0});
  const auto other = points_of({0, 0, 1, -0.4f, 0.4f, 0, 0, 1, 3, 0.4f, 0.4f, 0});
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].place == other[i].place);
}

TEST_CASE("outlines that cannot be are refused in words that say where") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(trouble_with({0, 0}).find("x, y and kind") != std::string::npos);
  CHECK(trouble_with({0, 0, 0, 1, 1, 0}).find("2 points") != std::string::npos);
  CHECK(trouble_with(std::vector<float>(3 * 401, 0.5f)).find("401 points") != std::string::npos);
  CHECK(trouble_with({0, 0, 0, nan, 1, 0, 1, 1, 0}).find("Point 2") != std::string::npos);
  CHECK(trouble_with({0, 0, 0, 1, 0, 0, 1, 1e9f, 0}).find("Point 3") != std::string::npos);
  CHECK(trouble_with({0, 0, 0, 1, 1, 0, 0.5f, 0.5f, 0}).find("no area") != std::string::npos);
  const std::string crossing = trouble_with({0, 0, 1, 1, 0, 1, 0.2f, 1, 1, 0.8f, 1, 1, 0, 0.1f, 1});
  CHECK(crossing.find("crosses itself") != std::string::npos);
  CHECK(trouble_with({}) == "");
  for (const NamedOutline& outline : leaf_outlines()) CHECK(trouble_with(outline.rows) == "");
  std::vector<std::string> notes;
  const std::vector<float> odd{0, 0, 7, 1, 0, nan, 0, 1, 0.5f};
  REQUIRE(read_outline(odd, notes));
  CHECK(notes.size() == 1);
}

TEST_CASE("edges that cross are found, whichever they are") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<glm::vec2> points;
    for (std::uint64_t i = 0; i < 4 + seed % 6; ++i)
      points.push_back({static_cast<float>(random_integer(seed, 1, i, 0, 7)) / 8,
                        static_cast<float>(random_integer(seed, 2, i, 0, 7)) / 8});
    const std::size_t count = points.size();
    bool twice = false, crossed = false;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < i; ++k) twice = twice || points[i] == points[k];
    if (twice) continue;
    // By the definition, in doubles, which hold eighths exactly.
    const auto side = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
      const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      return turn > 0 ? 1 : turn < 0 ? -1 : 0;
    };
    const auto on = [&](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
      return side(a, b, p) == 0 && glm::dot(p - a, p - b) <= 0;
    };
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const glm::dvec2 a(points[i]), b(points[(i + 1) % count]), c(points[k]), d(points[(k + 1) % count]);
        if ((k + 1) % count == i || (i + 1) % count == k) {
          const bool after = (k + 1) % count == i;
          const glm::dvec2 outer = after ? c : d, shared = after ? a : c, inner = after ? b : a;
          crossed = crossed || on(shared, outer, inner) || on(shared, inner, outer);
        } else {
          crossed = crossed || on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b) ||
                    (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0);
        }
      }
    const EdgePair found = crossing(points);
    CHECK((found.first != found.second) == crossed);
  }
}

TEST_CASE("teeth are as many, as deep and as the shape has them; the margin's points and tips stay") {
  const auto margin = spline(default_outline());
  REQUIRE(margin);
  std::vector<std::string> notes;
  CHECK(toothed(margin.value(), {.count = 0}, notes).points == margin->points);
  const Outline plain(margin->points);
  for (const ToothShape shape :
       {ToothShape::dentate, ToothShape::serrate, ToothShape::crenate, ToothShape::double_serrate})
    for (const std::uint32_t count : {1u, 6u, 20u, 80u}) {
      CAPTURE(count);
      const Margin cut = toothed(margin.value(), {count, 0.4f, shape}, notes);
      CHECK(crossing(cut.points).first == crossing(cut.points).second);
      CHECK(cut.points[0] == margin->points[0]);
      CHECK(cut.points[cut.tip] == margin->points[margin->tip]);
      CHECK(Outline(cut.points).area() < plain.area());
      // Teeth are cut in: nothing stands out, and on each side as many places on the margin have a notch on both sides.
      std::size_t notches = 0;
      float deepest = 0;
      const std::size_t size = cut.points.size();
      for (std::size_t i = 0; i < size; ++i) {
        const glm::vec3 p(cut.points[i].x, cut.points[i].y, 0);
        const float depth = plain.distance(p);
        CHECK((depth < 2e-4f || plain.contains(p)));
        deepest = std::max(deepest, depth);
        const auto depth_at = [&](std::size_t k) { return plain.distance({cut.points[k].x, cut.points[k].y, 0}); };
        notches += depth > 1e-4f && depth > depth_at((i + 1) % size) && depth >= depth_at((i + size - 1) % size);
      }
      const std::size_t each = shape == ToothShape::double_serrate ? 2 : 1;
      // Between n teeth are n − 1 notches a side; those at the ends are no deeper than their distance lets them be.
      CHECK(notches >= 2 * each * (count - 1));
      // Their tips are on the margin as it was, in order; of a doubled saw those of the large ones.
      CHECK(cut.teeth.size() == 2 * count);
      CHECK(std::is_sorted(cut.teeth.begin(), cut.teeth.end()));
      for (const std::size_t tip : cut.teeth) CHECK(plain.distance({cut.points[tip].x, cut.points[tip].y, 0}) < 1e-3f);
      if (count > 1) CHECK(notches <= 2 * each * (count + 1));
      if (count == 6) CHECK(deepest == near(0.4 * 1.1 / 6, 0.25));
    }
  CHECK(notes.empty());
}

TEST_CASE("teeth that would meet in a narrow lobe are cut less deep, and it is said") {
  // A needle with two points.
  const auto margin =
      spline(points_of({0, 0, 1, 0.012f, 0.5f, 1, 0.1f, 1, 3, 0, 0.52f, 1, -0.1f, 1, 3, -0.012f, 0.5f, 1}));
  REQUIRE(margin);
  std::vector<std::string> notes;
  const Margin cut = toothed(margin.value(), {6, 1, ToothShape::dentate}, notes);
  CHECK(notes.size() == 1);
  CHECK(crossing(cut.points).first == crossing(cut.points).second);
  CHECK(cut.tips.size() == 2);
}
