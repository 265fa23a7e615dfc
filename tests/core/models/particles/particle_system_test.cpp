#include "models/particles/particle_system.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "foundation/random.hpp"
#include "models/particles/scatter.hpp"
#include "near.hpp"
#include "shapes.hpp"

using namespace panicle;
using namespace panicle::particles;

namespace {

Rules rules_for(float spacing) { return {.step = 0.35f * spacing, .merge = 0.7f * spacing}; }

// Checks the properties of the trails of any crowd that has run.
void check_tree(const ParticleSystem& crowd, const Trails& trails, std::size_t started, double energy) {
  REQUIRE(trails.size() >= 1);
  CHECK(trails.next[0] == -1);
  std::size_t starts = 0;
  std::vector<double> passing(trails.size(), 0);
  for (std::size_t i = trails.size(); i-- > 0;) {
    if (i > 0) {
      REQUIRE(trails.next[i] >= 0);
      REQUIRE(static_cast<std::size_t>(trails.next[i]) < i);
    }
    if (trails.particle[i] >= 0) {
      passing[i] += energy;
      ++starts;
    }
    CHECK(trails.energy[i] == passing[i]);
    if (i > 0) passing[static_cast<std::size_t>(trails.next[i])] += passing[i];
  }
  CHECK(starts == started);
  CHECK(trails.energy[0] == energy * static_cast<double>(started));
  CHECK(crowd.arrived() == energy * static_cast<double>(started));
  CHECK(crowd.places().empty());
  CHECK(crowd.merges() + crowd.joins() <= started);
}

}  // namespace

TEST_CASE("all energy arrives and trails form one tree, for any shape, seed, rule and way of starting") {
  for (std::uint64_t seed = 0; seed < 160; ++seed) {
    CAPTURE(seed);
    const auto chance = [&](std::uint64_t stream) { return random_unit(seed, stream, 0); };
    const bool flat = seed % 2 == 0;
    const Round region(flat, 1, seed % 3 == 0 ? 0.8f : 0.0f);
    const std::uint32_t count = 1 + static_cast<std::uint32_t>(400 * chance(1));
    const float spacing = spacing_of(region, count);
    const auto starts = scatter(region, static_cast<Pattern>(seed % 3), count, spacing, seed);
    Rules rules = rules_for(spacing);
    rules.step = spacing * (0.05f + 2 * chance(2));
    rules.merge = spacing * 2 * chance(3);  // often less than the least that ends
    rules.pull = 3 * chance(4);
    rules.printed = seed % 5 == 0;
    rules.neighbourhood = seed % 7 == 0 ? spacing * 3 * chance(5) : 0;
    rules.join = seed % 4 == 0 ? spacing * chance(6) : 0;
    const Straight guide(3.0f * random_direction(seed, 7, 0) * chance(8));
    const double energy = seed % 11 == 0 ? 3 : 1;
    ParticleSystem crowd(starts, energy, guide, rules);
    crowd.run();
    check_tree(crowd, crowd.trails(), starts.size(), energy);
    CHECK(crowd.stragglers() == 0);
    CHECK_FALSE(crowd.step());
  }
}

TEST_CASE("particles run until all have arrived, or until the limit of moves") {
  const Straight guide({0, 0, 0});
  const std::vector<glm::vec3> starts{{1, 0, 0}, {0, 2, 0}};
  const Rules rules{.step = 0.1f, .merge = 0.1f, .pull = 0};
  ParticleSystem whole(starts, 1, guide, rules);
  CHECK(whole.run());
  CHECK(whole.arrived() == 2);
  ParticleSystem short_of_one(starts, 1, guide, rules);
  CHECK_FALSE(short_of_one.run(whole.moves() - 1));
  CHECK(short_of_one.arrived() == 1);
  CHECK(short_of_one.moves() == whole.moves() - 1);
  CHECK(short_of_one.run(whole.moves()));
  CHECK(short_of_one.arrived() == 2);
}

TEST_CASE("particles that share a place or a line arrive: one, two, many at a place, all at the target, none") {
  const Straight guide({0, 0, 0});
  const std::vector<std::vector<glm::vec3>> crowds = {
      {},
      {{1, 0, 0}},
      {{0, 0, 0}},
      {{1, 0, 0}, {1, 0, 0}},
      {{1, 0, 0}, {-1, 0, 0}},
      {{1, 0, 0}, {2, 0, 0}},
      {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}},
      std::vector<glm::vec3>(300, glm::vec3(0.5f, 0.2f, 0)),
      {{1, 0, 0}, {1.01f, 0, 0}, {0.99f, 0, 0}, {1, 0.01f, 0}},
  };
  for (const auto& starts : crowds)
    for (const bool printed : {false, true})
      for (const float pull : {0.0f, 0.75f, 1.0f, 2.0f}) {
        Rules rules{.step = 0.1f, .merge = 0.05f, .pull = pull, .printed = printed, .join = 0.05f};
        ParticleSystem crowd(starts, 1, guide, rules);
        crowd.run();
        check_tree(crowd, crowd.trails(), starts.size(), 1);
      }
}

TEST_CASE("a particle alone goes straight, step by step, and its last segment ends exactly at the target") {
  const Straight guide({0.05f, 0, 0});
  const glm::vec3 start(1, 0, 0);
  ParticleSystem crowd(std::span(&start, 1), 1, guide, {.step = 0.1f, .merge = 0.1f});
  crowd.run();
  CHECK(crowd.steps() == 10);
  const Trails trails = crowd.trails();
  REQUIRE(trails.size() == 11);
  CHECK(trails.places[0] == guide.target());
  CHECK(trails.places[10] == start);
  for (std::size_t i = 2; i < trails.size(); ++i)
    CHECK(glm::distance(trails.places[i], trails.places[i - 1]) == doctest::Approx(0.1f));
  CHECK(glm::distance(trails.places[1], trails.places[0]) <= 0.1001f);
}

TEST_CASE("the two pulls add up by their weights; as printed every move is as long as the step") {
  const Straight guide({0, -10, 0});
  const std::vector<glm::vec3> starts = {{0, 0, 0}, {1, 0, 0}};
  const auto first_move = [&](const Rules& rules) {
    ParticleSystem crowd(starts, 1, guide, rules);
    crowd.step();
    REQUIRE(crowd.places().size() == 2);
    return crowd.places()[0];
  };
  const glm::vec3 weighted = first_move({.step = 0.1f, .merge = 0.01f, .pull = 0.5f});
  CHECK(weighted.x == doctest::Approx(0.1f * 0.5f / 1.5f));
  CHECK(weighted.y == doctest::Approx(-0.1f / 1.5f));
  const glm::vec3 printed = first_move({.step = 0.1f, .merge = 0.01f, .printed = true});
  CHECK(glm::length(printed) == doctest::Approx(0.1f));
  CHECK(printed.x == doctest::Approx(-printed.y).epsilon(0.001));
  const glm::vec3 unseen = first_move({.step = 0.1f, .merge = 0.01f, .neighbourhood = 0.9f});
  CHECK(unseen.x == 0);
  CHECK(unseen.y == doctest::Approx(-0.1f));
}

TEST_CASE("the particle in front waits for one straight behind it") {
  const Straight guide({0, -10, 0});
  const std::vector<glm::vec3> starts = {{0, 0, 0}, {0, 1, 0}};
  ParticleSystem crowd(starts, 1, guide, {.step = 0.1f, .merge = 0.1f, .pull = 1});
  crowd.step();
  CHECK(crowd.places()[0] == starts[0]);
  CHECK(crowd.places()[1].y == doctest::Approx(0.9f));
  crowd.run();
  // A waiting particle adds no trail.
  const Trails trails = crowd.trails();
  CHECK(crowd.merges() == 1);
  for (std::size_t i = 1; i < trails.size(); ++i)
    CHECK(trails.places[i] != trails.places[static_cast<std::size_t>(trails.next[i])]);
}

TEST_CASE("the heavier goes on from the mean by energy, and energies add") {
  const Straight guide({0, -10, 0});
  // The outer two meet first; then they, twice as heavy, meet the third.
  const std::vector<glm::vec3> starts = {{0, 0, 0}, {0.3f, 0, 0}, {0.36f, 0, 0}};
  ParticleSystem crowd(starts, 1, guide, {.step = 1e-4f, .merge = 0.1f});
  crowd.step();
  REQUIRE(crowd.places().size() == 2);
  CHECK(crowd.energies()[0] == 1);
  CHECK(crowd.energies()[1] == 2);
  CHECK(crowd.places()[1].x == near(0.33f, 0.001));
  while (crowd.places().size() == 2) crowd.step();
  CHECK(crowd.energies()[0] == 3);
}

TEST_CASE("where their mean is outside, the heavier goes on from where it is") {
  // A gap beside the middle, with free sight across.
  class Gap final : public Guide {
   public:
    using Guide::Guide;
    glm::vec3 aim(const glm::vec3&) const override { return target(); }
    bool open(const glm::vec3& p) const override { return std::fabs(p.x) > 0.05f; }
  } guide({0, -10, 0});
  // The two at one place meet first.
  for (const std::vector<glm::vec3>& starts : {std::vector<glm::vec3>{{0.1f, 0, 0}, {-0.1f, 0, 0}, {-0.1f, 0, 0}},
                                               {{-0.1f, 0, 0}, {-0.1f, 0, 0}, {0.1f, 0, 0}}}) {
    ParticleSystem crowd(starts, 1, guide, {.step = 1e-4f, .merge = 0.3f});
    while (crowd.places().size() > 1) crowd.step();
    CHECK(crowd.energies()[0] == 3);
    CHECK(crowd.places()[0].x == near(-0.1f, 0.01));
  }
}

TEST_CASE("a step that would leave the shape is taken towards the aim alone") {
  class Sides final : public Guide {
   public:
    using Guide::Guide;
    glm::vec3 aim(const glm::vec3& p) const override { return {p.x, -10, 0}; }
    bool open(const glm::vec3& p) const override { return p.x < 0.01f || p.x > 0.9f; }
  } guide({0, -10, 0});
  const std::vector<glm::vec3> starts = {{0, 0, 0}, {1, 0, 0}};
  ParticleSystem crowd(starts, 1, guide, {.step = 0.3f, .merge = 0.01f});
  crowd.step();
  CHECK(crowd.places()[0] == glm::vec3(0, -0.3f, 0));
  CHECK(crowd.places()[1] == glm::vec3(1, -0.3f, 0));
}

TEST_CASE("particles ignore neighbours behind a wall, walk round it, and never cross it") {
  const Walled guide({0.5f, -0.8f, 0});
  class Square final : public Region {
   public:
    explicit Square(const Guide& walls) : walls_(&walls) {}
    glm::vec3 low() const override { return {-1, -1, 0}; }
    glm::vec3 high() const override { return {1, 1, 0}; }
    bool contains(const glm::vec3& p) const override {
      return std::fabs(p.x) <= 1 && std::fabs(p.y) <= 1 && walls_->open(p);
    }

   private:
    const Guide* walls_;
  } region(guide);
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    for (const float join : {0.0f, 0.02f}) {
      const float spacing = spacing_of(region, 400);
      const auto starts = scatter(region, Pattern::blue, 400, spacing, seed);
      Rules rules = rules_for(spacing);
      rules.join = join;
      ParticleSystem crowd(starts, 1, guide, rules);
      crowd.run();
      const Trails trails = crowd.trails();
      check_tree(crowd, trails, starts.size(), 1);
      std::size_t through = 0;
      for (std::size_t i = 1; i < trails.size(); ++i)
        through += !guide.sees(trails.places[i], trails.places[static_cast<std::size_t>(trails.next[i])]);
      CHECK(through == 0);
    }
}

TEST_CASE("two particles with diverging ways draw each other back until the step budget is used up") {
  // A ledge over the target: particles leave each half by its own end.
  class Ledge final : public Guide {
   public:
    using Guide::Guide;
    glm::vec3 aim(const glm::vec3& p) const override {
      return p.y > -0.05f && std::fabs(p.x) < 2 ? glm::vec3(p.x < 0 ? -2.2f : 2.2f, 0, 0) : target();
    }
    float way(const glm::vec3& p) const override { return glm::distance(p, aim(p)) + glm::distance(aim(p), target()); }
  } guide({0, -5, 0});
  const std::vector<glm::vec3> starts = {{-1, 0, 0}, {1, 0, 0}};
  const float longest = guide.way(starts[0]);
  ParticleSystem crowd(starts, 1, guide, {.step = 0.1f, .merge = 0.1f, .pull = 1});
  for (int step = 0; step < static_cast<int>(4 * longest / 0.1f); ++step) crowd.step();
  CHECK(crowd.places()[0] == starts[0]);
  CHECK(crowd.places()[1] == starts[1]);
  crowd.run();
  CHECK(crowd.stragglers() == 0);
  CHECK(crowd.steps() < 6 * longest / 0.1f);
  check_tree(crowd, crowd.trails(), 2, 1);
}

TEST_CASE("particles that do not arrive are moved to the target after twice the step budget") {
  // An aim that always lies to the left of the target's direction: straight ways never arrive while neighbours pull.
  class Swirl final : public Guide {
   public:
    using Guide::Guide;
    glm::vec3 aim(const glm::vec3& p) const override { return p + glm::vec3(p.y, -p.x, 0); }
  } guide({0, 0, 0});
  const std::vector<glm::vec3> starts = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
  ParticleSystem crowd(starts, 1, guide, {.step = 0.05f, .merge = 0.02f});
  crowd.run();
  CHECK(crowd.steps() <= 2 * (4 * 20 + 1) + 1);
  CHECK(crowd.stragglers() > 0);
  check_tree(crowd, crowd.trails(), 3, 1);
}

TEST_CASE("with joining, a leaf's trails cross a fraction as often") {
  const Round region(true);
  const float spacing = spacing_of(region, 600);
  const auto starts = scatter(region, Pattern::blue, 600, spacing, 1);
  const Straight guide({0, -1.1f, 0});
  const auto crossings = [&](float join) {
    Rules rules = rules_for(spacing);
    rules.join = join * spacing;
    ParticleSystem crowd(starts, 1, guide, rules);
    crowd.run();
    const Trails trails = crowd.trails();
    const auto side = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& p) {
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    std::size_t found = 0;
    for (std::size_t i = 1; i < trails.size(); ++i)
      for (std::size_t j = 1; j < i; ++j) {
        const glm::vec3 a = trails.places[i], b = trails.places[static_cast<std::size_t>(trails.next[i])];
        const glm::vec3 c = trails.places[j], d = trails.places[static_cast<std::size_t>(trails.next[j])];
        found += side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
      }
    return found;
  };
  const std::size_t free = crossings(0), joined = crossings(0.25f);
  CHECK(free > 100);
  CHECK(joined * 2 < free);
}

TEST_CASE("the same starts give the same trails to the bit") {
  const Round region(false);
  const auto starts = scatter(region, Pattern::blue, 700, spacing_of(region, 700), 4);
  const Straight guide({0, -2, 0});
  const auto run = [&] {
    ParticleSystem crowd(starts, 1, guide, rules_for(0.2f));
    crowd.run();
    return crowd.trails();
  };
  const Trails one = run(), other = run();
  CHECK(one.places == other.places);
  CHECK(one.next == other.next);
}

TEST_CASE("two particles alone are neighbours at any distance") {
  const Straight guide({0, 0, 0});
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    const auto place = [&](std::uint64_t i) {
      return glm::vec3(random_unit(seed, i, 0), random_unit(seed, i, 1), random_unit(seed, i, 2));
    };
    const std::vector<glm::vec3> points{place(0), place(1)};
    Neighbours neighbours;
    neighbours.build(points);
    CHECK(neighbours.nearest(0, 1e9f, guide) == 1);
    CHECK(neighbours.nearest(1, 1e9f, guide) == 0);
  }
}

TEST_CASE("nearest and pairs are the same as from all points, ties to the lowest index") {
  const Straight guide({0, 0, 0});
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    std::vector<glm::vec3> points(2 + seed * 5);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = {random_unit(seed, 1, i), random_unit(seed, 2, i), seed % 2 ? random_unit(seed, 3, i) : 0};
      if (seed % 4 == 1) points[i] = glm::round(points[i] * 4.0f);  // many at equal distances and places
      if (seed % 8 == 2) points[i].y = 0;
    }
    Neighbours neighbours;
    neighbours.build(points);
    const float reach = seed % 3 == 0 ? 0.3f : 1e9f;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      std::uint32_t nearest = Neighbours::none;
      float best = reach * reach;
      for (std::uint32_t j = 0; j < points.size(); ++j) {
        const glm::vec3 way = points[j] - points[i];
        const float square = way.x * way.x + way.y * way.y + way.z * way.z;
        if (j == i || square > best || (square == best && nearest != Neighbours::none)) continue;
        best = square;
        nearest = j;
      }
      CHECK(neighbours.nearest(i, reach, guide) == nearest);
    }
    std::vector<Pair> found;
    neighbours.pairs(0.3f, found);
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) pairs += glm::distance(points[i], points[j]) < 0.3f;
    CHECK(found.size() == pairs);
  }
}
