#include "models/leaf/shape/margin.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/english.hpp"
#include "foundation/random.hpp"
#include "models/leaf/outlines.hpp"
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

// The error message of an outline.
std::string trouble_with(const std::vector<float>& rows) {
  std::vector<std::string> notes;
  const auto points = read_outline(rows, notes);
  if (!points) return english(points.error().message);
  const auto margin = spline(points.value());
  return margin ? "" : english(margin.error().message);
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
  // The margin hardly turns at smooth points, and turns at sharp ones.
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

TEST_CASE("an outline in the other sense is reversed, with the same base") {
  const auto one = points_of({0, 0, 1, 0.4f, 0.4f, 0, 0, 1, 3, -0.4f, 0.4f, 0});
  const auto other = points_of({0, 0, 1, -0.4f, 0.4f, 0, 0, 1, 3, 0.4f, 0.4f, 0});
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].place == other[i].place);
}

TEST_CASE("invalid outlines are refused with a message that contains the place") {
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

TEST_CASE("any crossing edges are found") {
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

TEST_CASE("teeth have the requested number, depth and shape; the margin's points and tips stay") {
  const auto margin = spline(default_outline());
  REQUIRE(margin);
  std::vector<std::string> notes;
  CHECK(toothed(margin.value(), {.count = 0}, notes).points == margin->points);
  const Outline plain(margin->points);
  for (const ToothShape shape : {ToothShape::dentate, ToothShape::serrate, ToothShape::crenate,
                                 ToothShape::double_serrate, ToothShape::crenate_serrate})
    for (const std::uint32_t count : {1u, 6u, 20u, 80u}) {
      CAPTURE(count);
      const Margin cut = toothed(margin.value(), {count, 0.4f, shape}, notes);
      CHECK(crossing(cut.points).first == crossing(cut.points).second);
      CHECK(cut.points[0] == margin->points[0]);
      CHECK(cut.points[cut.tip] == margin->points[margin->tip]);
      CHECK(Outline(cut.points).area() < plain.area());
      // Teeth are cut in: no point is outside the margin, and on each side as many points on the margin have a notch on
      // both sides.
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
      // Their tips are on the original margin, in order; of a doubled saw those of the large teeth.
      CHECK(cut.teeth.size() == 2 * count);
      CHECK(std::is_sorted(cut.teeth.begin(), cut.teeth.end()));
      for (const std::size_t tip : cut.teeth) CHECK(plain.distance({cut.points[tip].x, cut.points[tip].y, 0}) < 1e-3f);
      if (count > 1) CHECK(notches <= 2 * each * (count + 1));
      if (count == 6) CHECK(deepest == near(0.4 * 1.1 / 6, 0.25));
    }
  CHECK(notes.empty());
}

namespace {

Margin margin_of(const std::vector<float>& rows) {
  const auto margin = spline(points_of(rows));
  REQUIRE(margin);
  return margin.value();
}

// The width of the polygon at a height, from its right side to its left one.
float width_at(std::span<const glm::vec2> points, float y) {
  float right = 9, left = -9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec2 a = points[i], b = points[(i + 1) % points.size()];
    if ((a.y > y) == (b.y > y)) continue;
    const float x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    (x > 0 ? right : left) = x > 0 ? std::min(right, x) : std::max(left, x);
  }
  return right - left;
}

}  // namespace

TEST_CASE("teeth leave most of a narrow lobe, and have the requested depth where the blade is wide") {
  // Broad below, a long thin tip above.
  const Margin margin = margin_of(
      mirrored({{0, 0, 1}, {0.3f, 0.2f, 0}, {0.2f, 0.45f, 0}, {0.035f, 0.6f, 0}, {0.02f, 0.9f, 0}, {0, 1, 3}}));
  std::vector<std::string> notes;
  for (const ToothShape shape : {ToothShape::dentate, ToothShape::serrate, ToothShape::crenate_serrate}) {
    const Margin cut = toothed(margin, {14, 0.6f, shape}, notes);
    CHECK(crossing(cut.points).first == crossing(cut.points).second);
    for (float y = 0.6f; y < 0.96f; y += 0.002f) {
      CAPTURE(y);
      CHECK(width_at(cut.points, y) > 0.5f * width_at(margin.points, y));
    }
    const Outline plain(margin.points);
    float deepest = 0;
    for (const glm::vec2& p : cut.points)
      if (p.y < 0.4f) deepest = std::max(deepest, plain.distance({p.x, p.y, 0}));
    CHECK(deepest == doctest::Approx(0.6 * 1.25 / 14).epsilon(0.25));
  }
}

TEST_CASE("teeth without room in a fold are left out with a note; all others are unchanged") {
  // The bay above the right lobe is drawn down along the margin below: the lobe hangs by a thread.
  const std::vector<float> whole{0,      0,     1, 0.3f,  0.05f, 1, 0.6f,  0.3f,  3, 0.45f, 0.42f, 1, 0.35f,  0.41f, 1,
                                 0.25f,  0.4f,  1, 0.2f,  0.7f,  0, 0,     1,     3, -0.2f, 0.7f,  0, -0.25f, 0.4f,  1,
                                 -0.45f, 0.42f, 1, -0.6f, 0.3f,  3, -0.3f, 0.05f, 1};
  std::vector<float> folded = whole;
  folded[12] = 0.5374f;
  folded[13] = 0.2531f;
  folded[15] = 0.3574f;
  folded[16] = 0.1031f;
  const Margin plain = margin_of(folded);
  const Teeth teeth{20, 0.5f, ToothShape::dentate};
  std::vector<std::string> notes;
  const Margin before = toothed(margin_of(whole), teeth, notes);
  CHECK(notes.empty());
  const Margin cut = toothed(plain, teeth, notes);
  REQUIRE(notes.size() == 1);
  CHECK(english(notes[0]).find("were left out") != std::string::npos);
  CHECK(crossing(cut.points).first == crossing(cut.points).second);
  CHECK(cut.teeth.size() > before.teeth.size() / 2);
  // The unchanged left side has its teeth, cut as deep.
  const auto left = [](const Margin& margin, const Margin& uncut) {
    const Outline outline(uncut.points);
    std::pair<std::size_t, float> found{0, 0.0f};
    for (const std::size_t tooth : margin.teeth) found.first += margin.points[tooth].x < 0;
    for (const glm::vec2& p : margin.points)
      if (p.x < 0) found.second = std::max(found.second, outline.distance({p.x, p.y, 0}));
    return found;
  };
  const auto [number, depth] = left(cut, plain);
  const auto [number_before, depth_before] = left(before, margin_of(whole));
  CHECK(number + 4 >= number_before);  // they share out a longer margin
  CHECK(depth > 0.8f * depth_before);
}

TEST_CASE("an entire base has no teeth, and the teeth share the rest of the margin") {
  const auto margin = spline(default_outline());
  REQUIRE(margin);
  std::vector<std::string> notes;
  const Margin cut = toothed(margin.value(), {8, 0.4f, ToothShape::serrate, 0.4f}, notes);
  CHECK(cut.teeth.size() == 16);
  float length = 0;
  for (std::size_t i = 0; i < margin->points.size(); ++i)
    length += glm::distance(margin->points[i], margin->points[(i + 1) % margin->points.size()]);
  // The margin's own points are unchanged up to there, on both sides, and no farther.
  std::size_t right = 0, left = 0;
  while (cut.points[right] == margin->points[right]) ++right;
  while (cut.points[cut.points.size() - 1 - left] == margin->points[margin->points.size() - 1 - left]) ++left;
  for (const std::size_t same : {right, left}) {
    float along = 0;
    for (std::size_t i = 1; i < same; ++i) along += glm::distance(margin->points[i - 1], margin->points[i]);
    CHECK(along == doctest::Approx(0.2 * static_cast<double>(length)).epsilon(0.04));
  }
  CHECK(notes.empty());
}

TEST_CASE("a margin with teeth of any kind does not cross itself") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    // A star whose points come close to each other as they fall.
    std::vector<float> rows{0, 0, 1};
    const std::uint64_t count = 5 + seed % 9;
    for (std::uint64_t i = 1; i < count; ++i) {
      const float angle = -1.4f + 2.8f * static_cast<float>(i) / static_cast<float>(count);
      const float far = 0.15f + 0.08f * static_cast<float>(random_integer(seed, 1, i, 0, 10));
      rows.insert(rows.end(), {-far * std::sin(-angle), 0.1f + far * std::cos(angle),
                               static_cast<float>(random_integer(seed, 2, i, 0, 3))});
    }
    std::vector<std::string> notes;
    const auto margin = spline(points_of(rows));
    if (!margin) continue;
    const Teeth teeth{static_cast<std::uint32_t>(1 + seed), 1, static_cast<ToothShape>(seed % 5),
                      0.1f * static_cast<float>(seed % 4)};
    const Margin cut = toothed(margin.value(), teeth, notes);
    CHECK(crossing(cut.points).first == crossing(cut.points).second);
    CHECK(cut.points[cut.tip] == margin->points[margin->tip]);
    REQUIRE(cut.tips.size() == margin->tips.size());
    for (std::size_t i = 0; i < cut.tips.size(); ++i) CHECK(cut.points[cut.tips[i]] == margin->points[margin->tips[i]]);
  }
}
