// Properties of curved shoots: smooth in place and direction, thinner towards their tips, with a bounded number of
// pieces; without them, shoots are straight.
#include <algorithm>
#include <glm/geometric.hpp>

#include "models/growth/moment.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

struct Tree {
  Population population;
  Form form;
};

const Tree& tree() {
  static const Tree made = [] {
    Tree grown_tree{grown(text_named("table-1-sigma1"), 7), {}};
    grown_tree.form = form_of(grown_tree.population, FormHabit{});
    return grown_tree;
  }();
  return made;
}

constexpr CurveHabit curves{.pieces = 8, .gnarl = 0.05f, .sag = 0.2f, .rise = 0.4f, .tip = 0.25f, .seed = 1};

Moment curved(float time) {
  return sound(moment_of(tree().population, tree().form, time, WoodHabit{}, Limits{}, curves));
}

}  // namespace

TEST_CASE("a curved shoot is continuous in place and direction over its nodes") {
  ShootCurve curve;
  for (std::uint32_t q = 0; q < tree().form.paths.size(); ++q) {
    const ShootPath& path = tree().form.paths[q];
    curve.set(tree().population, tree().form, curves, q);
    for (std::uint32_t i = 0; i < path.count; ++i) {
      CHECK(glm::length(curve.at(i, 0)) == doctest::Approx(0));
      const float length = glm::length(curve.at(i, 1));
      if (i + 1 == path.count || length < 0.05f) continue;
      // Directions just before and after the node, by differences.
      const float step = 1e-2f;
      const glm::vec3 before = curve.at(i, 1) - curve.at(i, 1 - step), after = curve.at(i + 1, step);
      if (glm::length(curve.at(i + 1, 1)) < 0.05f) continue;
      CHECK(glm::dot(glm::normalize(before), glm::normalize(after)) > 0.96f);
    }
  }
}

TEST_CASE("an internode has at most the requested number of pieces, and short ones have fewer") {
  ShootCurve curve;
  std::uint32_t most = 0;
  for (std::uint32_t q = 0; q < tree().form.paths.size(); ++q) {
    curve.set(tree().population, tree().form, curves, q);
    for (std::uint32_t i = 0; i < tree().form.paths[q].count; ++i) {
      CHECK(curve.pieces(i) >= 1);
      CHECK(curve.pieces(i) <= curves.pieces);
      most = std::max(most, curve.pieces(i));
      if (glm::length(curve.at(i, 1)) < 0.05f) CHECK(curve.pieces(i) <= 2);
    }
  }
  CHECK(most == curves.pieces);
}

TEST_CASE("curved shoots are thinner and thinner from their base to their tip") {
  for (const float time : {3.5f, 7.0f}) {
    const Moment moment = curved(time);
    for (std::size_t i = 0; i < moment.segments.size(); ++i) {
      const Segment& segment = moment.segments[i];
      CHECK(segment.radius > 0);
      CHECK(segment.radius_end > 0);
      CHECK(segment.radius_end <= segment.radius * 1.0001f);
      if (segment.parent < 0) continue;
      const Segment& parent = moment.segments[static_cast<std::size_t>(segment.parent)];
      CHECK(segment.start == parent.end);
      CHECK(segment.radius <= parent.radius_end * 1.0001f);
    }
  }
}

TEST_CASE("a bare tip is a quarter as thick as its shoot after the last fork, where the taper says so") {
  const Moment moment = curved(7);
  for (std::size_t i = 0; i < moment.segments.size(); ++i) {
    const std::int32_t shoot = moment.axes[i];
    const bool last = i + 1 == moment.segments.size() || moment.axes[i + 1] != shoot;
    const auto q = static_cast<std::uint32_t>(shoot);
    const bool forked = std::any_of(tree().population.shoots.begin(), tree().population.shoots.end(),
                                    [&](const Shoot& each) { return each.parent == shoot; });
    if (!last || forked) continue;
    const auto base = static_cast<std::size_t>(moment.first_of_shoot[q]);
    CHECK(moment.segments[i].radius_end <= 0.2501f * WoodHabit{}.twig / 2);
    CHECK(moment.segments[i].radius_end < moment.segments[base].radius);
  }
}

TEST_CASE("a branch starts on the curve of its parent, and no end jumps as a curved tree ages") {
  constexpr float step = 0.02f;
  Moment before = curved(2);
  for (float time = 2 + step; time < 4; time += step) {
    Moment now = curved(time);
    for (std::uint32_t q = 0; q < tree().form.paths.size(); ++q) {
      const auto tip = [&](const Moment& moment) {
        std::int32_t last = -1;
        for (std::uint32_t node = 1; node <= tree().form.paths[q].count; ++node)
          if (const std::int32_t at = moment.of_node[tree().form.paths[q].first + node]; at >= 0) last = at;
        return last;
      };
      const std::int32_t a = tip(before), b = tip(now);
      if (a < 0 || b < 0) continue;
      CHECK(glm::distance(before.segments[static_cast<std::size_t>(a)].end,
                          now.segments[static_cast<std::size_t>(b)].end) <= 8 * step);
    }
    before = std::move(now);
  }
}

TEST_CASE("without curves an internode is straight, however its habit is") {
  CurveHabit straight = curves;
  straight.pieces = 0;
  const Moment moment = sound(moment_of(tree().population, tree().form, 7, WoodHabit{}, Limits{}, straight)),
               usual = sound(moment_of(tree().population, tree().form, 7, WoodHabit{}, Limits{}));
  REQUIRE(moment.segments.size() == usual.segments.size());
  for (std::size_t i = 0; i < usual.segments.size(); ++i) {
    CHECK(moment.segments[i].end == usual.segments[i].end);
    CHECK(moment.segments[i].radius == usual.segments[i].radius);
  }
}

TEST_CASE("more segments than the limit are an error, of curves too") {
  Limits limits;
  limits.segments = 1000;
  const auto moment = moment_of(tree().population, tree().form, 7, WoodHabit{}, limits, curves);
  REQUIRE(!moment);
  CHECK(moment.error().reason == Reason::limit);
}

TEST_CASE("branches of a trunk are in whorls of about the requested size, evenly around it") {
  const Population population = grown(
      "footprint -> GrowVol(1, 1, 4, 10, 1, 0)\n"
      "tree -> DivFunc(\"sigma1\"){branches}\nk == N - 1 -> nbr = 15\n",
      3);
  FormHabit habit;
  habit.whorl_size = 5;
  const Form form = form_of(population, habit);
  // Places along the trunk's second internode, in order.
  std::vector<float> places;
  for (std::uint32_t q = 0; q < form.paths.size(); ++q)
    if (population.shoots[q].parent == 0 && form.paths[q].internode == 1) places.push_back(form.paths[q].along);
  std::sort(places.begin(), places.end());
  REQUIRE(places.size() == 15);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float within = i % 5 > 0 ? places[i] - places[i - 1] : 0;
    CHECK(within < 0.025f);
    if (i > 0 && i % 5 == 0) CHECK(places[i] - places[i - 1] > 0.25f);
  }
}
