#include "models/bunch/measures/measures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/measures/measures_compactness.hpp"
#include "models/bunch/measures/measures_form.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using enum Measure;

namespace {

float uniform(std::uint64_t k) { return static_cast<float>(hash_combine(3, k) >> 40) / 16777216.0f; }

// A bunch of balls, in millimetres; no stems.
Grown balls(const std::vector<glm::vec3>& centres, float radius) {
  Grown grown;
  for (const glm::vec3& centre : centres) {
    grown.berries.push_back({centre / 1000.0f, radius / 1000, {0, -1, 0}, -1, 0});
    grown.traits.push_back({2 * radius / 1000, 2 * radius / 1000});
  }
  return grown;
}

// As wide as it is deep, straight down from the top, its tip rounded.
Envelope block(float half_width, float length) {
  Profile profile{length, {}};
  profile.sides.fill({half_width, 0});
  return Envelope(profile, 1, half_width);
}

Envelope spindle(float half_width, float length, float pixel = 1) {
  Profile profile{length, {}};
  profile.sides.fill({half_width, length / 4});
  return Envelope(profile, pixel, pixel * half_width / 4);
}

std::vector<HungEnvelope> hung(const Envelope& envelope, float lean = 0) { return {{envelope, lean}}; }

// Places of a cubic lattice that `inside` admits.
template <typename Inside>
std::vector<glm::vec3> lattice(float spacing, Inside inside) {
  std::vector<glm::vec3> places;
  for (int x = -10; x <= 10; ++x)
    for (int y = 0; y >= -24; --y)
      for (int z = -10; z <= 10; ++z) {
        const glm::vec3 place = spacing * (glm::vec3(x, y, z) - glm::vec3(0, 0.5f, 0));
        if (inside(place)) places.push_back(place);
      }
  return places;
}

// Sections of quarter ellipses, as the outline's own.
auto within(const Envelope& envelope) {
  return [&envelope](const glm::vec3& p) {
    const float x = p.x / envelope.half_width(p.x > 0 ? 0 : 1, -p.y);
    const float z = p.z / envelope.half_width(p.z > 0 ? 2 : 3, -p.y);
    return x * x + z * z <= 1;
  };
}

bool in_box(const glm::vec3& p) { return std::abs(p.x) < 40 && std::abs(p.z) < 40 && p.y > -150; }

struct Measured {
  Measured(const Grown& grown, const std::vector<HungEnvelope>& envelopes) : values(measure(grown, envelopes)) {
    REQUIRE(values.size() == measure_count);
  }
  float operator[](Measure key) const { return values[static_cast<std::size_t>(key)]; }
  std::vector<float> values;
};

doctest::Approx about(double value, double share = 0.01) { return doctest::Approx(value).epsilon(share); }

constexpr Measure shares[] = {coverage,   spill,         coverage_front, coverage_side, spill_front,  spill_side,
                              fill_ratio, visible_front, visible_side,   visible_mean,  pedicels_seen};

}  // namespace

TEST_CASE("one ball measures what geometry says") {
  const Envelope envelope = block(30, 200);
  const Measured one(balls({{0, -100, 0}}, 10), hung(envelope));
  const double area = 100 * pi, volume = 4.0 / 3 * pi;
  CHECK(one[coverage] == about(area / envelope.area(0)));
  CHECK(one[spill] == 0);
  CHECK(one[bunch_length] == about(20, 1e-4));
  CHECK(one[bunch_width] == about(20, 1e-4));
  CHECK(one[berry_volume] == about(volume, 1e-4));
  CHECK(one[berry_weight] == about(1.08 * volume, 1e-4));
  CHECK(one[bunch_weight] == about(1.08 * volume, 1e-4));
  CHECK(one[compactness] == about(1.08 * volume / 4, 1e-4));
  CHECK(one[hull_volume] == about(volume));
  CHECK(one[fill_ratio] == about(1));
  CHECK(one[outline_volume] == about(envelope.volume() / 1000));
  CHECK(one[berry_count] == 1);
  CHECK(one[diameter] == about(20, 1e-4));
  CHECK(one[diameter_spread] == 0);
  CHECK(one[uniformity] == 2);
  CHECK(one[berry_shape] == 2);
  CHECK(one[visible_front] == 1);
  CHECK(one[visible_mean] == about(1, 1e-5));
  CHECK(one[gap] == about(20, 1e-4));
  CHECK(one[contacts] == 0);
  CHECK(std::isnan(one[pedicel_length]));
  CHECK(std::isnan(one[pedicels_seen]));
  CHECK(std::isnan(one[peduncle_length]));
}

TEST_CASE("coverage and spill of a ball on the outline's edge") {
  const Envelope envelope = block(30, 200);
  const double disc = 100 * pi;
  const Measured edge(balls({{30, -100, 0}}, 10), hung(envelope));
  CHECK(edge[coverage_front] == about(disc / 2 / envelope.area(0), 0.02));
  CHECK(edge[coverage_side] == about(disc / envelope.area(2), 0.02));
  CHECK(edge[coverage] == about(1.5 * disc / (envelope.area(0) + envelope.area(2)), 0.02));
  CHECK(edge[spill] == 0);
  // The outline grown by the radius ends at the centre of a ball that touches it from outside.
  const Measured outside(balls({{40, -100, 0}}, 10), hung(envelope));
  CHECK(outside[spill_front] == about(0.5, 0.05));
  CHECK(outside[spill_side] == 0);
  CHECK(outside[spill] == about(0.25, 0.05));
  const Measured far(balls({{0, -100, 0}, {90, -100, 0}}, 10), hung(envelope));
  CHECK(far[spill_front] == about(0.5));
}

TEST_CASE("a full outline is covered, gaps smaller than a berry count as full, larger ones do not") {
  const Envelope envelope = block(40, 200);
  const Measured full(balls(lattice(10, within(envelope)), 8), hung(envelope));
  CHECK(full[coverage] > 0.99f);
  CHECK(full[spill] < 0.003f);
  const Envelope wide = block(60, 200);
  const auto flat = [](const glm::vec3& p) { return std::abs(p.x) < 60 && std::abs(p.z) < 1 && p.y > -200; };
  const Measured loose(balls(lattice(20, flat), 8), hung(wide));
  const Measured sparse(balls(lattice(40, flat), 8), hung(wide));
  CHECK(loose[coverage_front] > 1.15 * pi * 64 / 400);
  CHECK(sparse[coverage_front] < 1.1 * pi * 64 / 1600);
}

TEST_CASE("a second outline leans to the left, and both count as one") {
  const Envelope envelope = spindle(40, 160);
  const SinCos turn = sincos_degrees(50);
  std::vector<glm::vec3> leaning = lattice(10, within(envelope));
  for (glm::vec3& p : leaning) p = {p.x * turn.cosine + p.y * turn.sine, p.y * turn.cosine - p.x * turn.sine, p.z};
  CHECK(leaning.back().x < 0);
  const Grown grown = balls(leaning, 8);
  const Measured right(grown, hung(envelope, 50)), wrong(grown, hung(envelope, -50));
  CHECK(right[coverage_front] > 0.98f);
  CHECK(right[coverage_side] > 0.98f);
  CHECK(right[spill] < 0.01f);
  CHECK(wrong[coverage_front] < 0.6f);
  CHECK(wrong[spill_front] > 0.3f);
  std::vector<HungEnvelope> both = hung(envelope);
  both.push_back({envelope, 50});
  const Measured half(grown, both);
  CHECK(half[coverage_front] > 0.5f);
  CHECK(half[coverage_front] < 0.8f);
  CHECK(half[spill] < 0.01f);
}

TEST_CASE("an outline that barely leans is drawn as one that does not") {
  const Envelope envelope = spindle(40, 160);
  const Grown grown = balls(lattice(14, within(envelope)), 7);
  const Measured upright(grown, hung(envelope, 0)), leaning(grown, hung(envelope, 0.2f));
  for (const Measure key : {coverage_front, coverage_side}) CHECK(leaning[key] == about(upright[key], 0.02));
}

TEST_CASE("who hides whom") {
  const Measured pair(balls({{0, -50, 0}, {0, -50, 30}}, 10), {});
  CHECK(pair[visible_front] == 0.5f);
  CHECK(pair[visible_side] == 1);
  CHECK(pair[visible_mean] == about(25.0 / 26, 1e-4));  // hidden from the front, the front one from behind: a half each
  Grown near = balls({{0, -50, 0}, {0, -50, 30}}, 10);
  near.traits[1].width = near.traits[1].length = 0.004f;
  CHECK(Measured(near, {})[visible_front] == 1);  // the small one before the large one
}

TEST_CASE("pedicels are seen where no berry is before them") {
  Grown grown = balls({{0, -50, 0}}, 10);
  grown.internodes = {{-1, Kind::rachis, State::grown, -1, {0, 0, 0}, {0, -0.03f, 0}, 0.002f, 0.002f},
                      {0, Kind::pedicel, State::grown, 0, {0, -0.03f, 0}, {0, -0.04f, 0}, 0.001f, 0.001f}};
  grown.berries[0].parent = 1;
  const Measured bare(grown, {});
  CHECK(bare[pedicels_seen] == about(1, 1e-5));
  CHECK(bare[pedicel_length] == about(10, 1e-4));
  CHECK(bare[peduncle_length] == about(40, 1e-4));
  for (const glm::vec3 place : {glm::vec3(0, -35, 14), glm::vec3(0, -35, -14)}) {
    grown.berries.push_back({place / 1000.0f, 0.01f, {0, -1, 0}, -1, 1});
    grown.traits.push_back({0.02f, 0.02f});
  }
  CHECK(Measured(grown, {})[pedicels_seen] == about(0.5, 1e-5));
}

// The note of density of balls, each looked at beside each other: docs/measuring.md in double.
double note_of(const std::vector<glm::vec3>& centres, double radius, double seen) {
  const double d = 2 * radius;
  double gap = 0, contacts = 0, pressed = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    std::vector<double> gaps(3, d);
    for (std::size_t j = 0; j < centres.size(); ++j) {
      if (j == i) continue;
      const double one = glm::length(glm::dvec3(centres[j]) - glm::dvec3(centres[i])) - d;
      contacts += one < 0.03 * d;
      pressed += std::max(0.0, -one) / (6 * d);
      gaps.push_back(std::max(0.0, one));
    }
    std::sort(gaps.begin(), gaps.end());
    gap += (gaps[0] + gaps[1] + gaps[2]) / 3;
  }
  const auto share = [&](double sum, double whole) {
    return std::min(1.0, sum / static_cast<double>(centres.size()) / whole);
  };
  return 1 + 2 * (1 - share(gap, 0.2 * d)) + 2 * (1 - std::min(1.0, seen / 0.4)) + 2 * share(contacts, 5.5) +
         2 * share(pressed, 0.13);
}

TEST_CASE("the note of density is what looking at every pair gives") {
  double least = 9, most = 1;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::vector<glm::vec3> centres;
    const std::uint64_t count = 1 + seed;
    const auto draw = [&](std::uint64_t k) { return uniform(5000 * (seed + 1) + k) - 0.5f; };
    const float extent = 15 * std::cbrt(static_cast<float>(count)) * (0.8f + uniform(seed));
    for (std::uint64_t i = 0; i < count; ++i)
      centres.push_back(extent * glm::vec3(draw(3 * i), draw(3 * i + 1), draw(3 * i + 2)));
    const float radius = 3 + 5 * uniform(seed + 77), seen = uniform(seed + 99);
    Subject subject(balls(centres, radius));
    const float note = density_note(subject, measure_compactness(subject), seen);
    CHECK(note == about(note_of(centres, radius, seen), 1e-3));
    least = std::min<double>(least, note);
    most = std::max<double>(most, note);
  }
  CHECK(least < 2.5);
  CHECK(most > 5);
}

TEST_CASE("a bunch weighs its berries at 1.08 and its stems, cones' frustums, at 1 gram a cubic centimetre") {
  Grown grown = balls({{0, -50, 0}}, 10);
  const float berry = Measured(grown, {})[bunch_weight];
  CHECK(berry == about(1.08 * 4 * pi / 3, 1e-4));  // of 1 cm
  grown.internodes = {{-1, Kind::rachis, State::grown, -1, {0, 0, 0}, {0, -0.03f, 0}, 0.002f, 0.001f},
                      {0, Kind::axis, State::grown, 0, {0, -0.03f, 0}, {0.03f, -0.07f, 0}, 0.0015f, 0.0015f}};
  const double frustum = pi / 3 * 30 * (4 + 2 + 1), cylinder = pi * 50 * 2.25;
  CHECK(Measured(grown, {})[bunch_weight] - berry == about((frustum + cylinder) / 1000, 1e-3));
}

TEST_CASE("closer berries are denser, from the loosest note to the densest") {
  const Envelope envelope = block(40, 200);
  float before = 0;
  for (const float radius : {4.0f, 6.0f, 7.0f, 7.49f, 8.0f, 8.5f}) {
    CAPTURE(radius);
    Subject subject(balls(lattice(15, within(envelope)), radius));
    const float seen = std::max(0.0f, 0.8f - radius / 10);
    const float note = density_note(subject, measure_compactness(subject), seen);
    CHECK((note > before || radius > 8));
    CHECK(note == about(note_of(lattice(15, within(envelope)), radius, seen), 1e-3));
    before = note;
  }
  CHECK(before > 8);
  Subject touching(balls(lattice(15, in_box), 7.5f));
  const Compactness close = measure_compactness(touching);
  CHECK(close.gap < 1e-3f);
  CHECK(close.contacts > 4.5f);
  CHECK(close.contacts < 6);
  CHECK(close.pressed < 1e-3f);
  Subject apart(balls({{0, 0, 0}, {25, 0, 0}}, 10));
  CHECK(measure_compactness(apart).gap == about((5 + 20 + 20) / 3.0, 1e-4));
}

TEST_CASE("bunches of known shape") {
  const auto shaped = [](auto half_width) {
    const auto inside = [&](const glm::vec3& p) {
      const float w = half_width(-p.y / 200);
      return p.y > -200 && p.x * p.x + p.z * p.z <= w * w;
    };
    return Measured(balls(lattice(8, inside), 4), {});
  };
  const Measured cylinder = shaped([](float) { return 40.0f; });
  const Measured cone = shaped([](float t) { return 60 - 50 * t; });
  const Measured funnel = shaped([](float t) { return t < 0.3f ? 70.0f : 25.0f; });
  CHECK(cylinder[bunch_shape] == 1);
  CHECK(cone[bunch_shape] == 2);
  CHECK(funnel[bunch_shape] == 3);
  CHECK(cylinder[wings] == 0);
  CHECK(cone[wings] == 0);
  CHECK(funnel[wings] == 4);
  std::vector<glm::vec3> winged =
      lattice(8, [](const glm::vec3& p) { return p.y > -200 && p.x * p.x + p.z * p.z <= 900; });
  for (int k = 0; k < 10; ++k) winged.push_back({-30 - 8 * k, -20, 0});
  CHECK(Measured(balls(winged, 4), {})[wings] == 1);
}

TEST_CASE("berries are named after their form") {
  CHECK(berry_shape_note({}, 0.9f) == 1);
  CHECK(berry_shape_note({}, 1) == 2);
  CHECK(berry_shape_note({}, 1.2f) == 3);
  CHECK(berry_shape_note({}, 1.7f) == 4);
  CHECK(berry_shape_note({0, 0.8f}, 1.5f) == 5);
  CHECK(berry_shape_note({-0.5f, 0.6f}, 1.3f) == 6);
  CHECK(berry_shape_note({-0.5f, 0}, 1.3f) == 7);
  CHECK(berry_shape_note({0.5f, 0}, 1.3f) == 8);
  CHECK(berry_shape_note({0, 0.8f}, 3) == 10);
  CHECK(uniformity_note(0.07f) == 2);
  CHECK(uniformity_note(0.3f) == 1);
}

TEST_CASE("the peduncle ends where the bunch first branches") {
  Grown grown;
  const auto add = [&](std::int32_t parent, float from, float to) {
    grown.internodes.push_back({parent, Kind::rachis, State::grown, -1, {0, from, 0}, {0, to, 0}, 0.001f, 0.001f});
  };
  add(-1, 0, -0.02f);
  add(0, -0.02f, -0.05f);
  add(1, -0.05f, -0.06f);
  add(1, -0.05f, -0.07f);
  const Measured measured(grown, {});
  CHECK(measured[peduncle_length] == about(50, 1e-4));
  CHECK(measured[berry_count] == 0);
}

TEST_CASE("without berries or outlines what does not apply is no number, and the rest is") {
  const Envelope envelope = block(30, 200);
  const Measured none(Grown{}, hung(envelope));
  for (std::size_t k = 0; k < measure_count; ++k) {
    const bool applies = k == static_cast<std::size_t>(berry_count) || k == static_cast<std::size_t>(outline_volume);
    CHECK(std::isnan(none.values[k]) == !applies);
  }
  const Measured loose(balls(lattice(15, within(envelope)), 7), {});
  for (const Measure key : {coverage, coverage_front, coverage_side, spill, spill_front, spill_side, outline_volume})
    CHECK(std::isnan(loose[key]));
  for (const Measure key : {bunch_length, hull_volume, fill_ratio, density, visible_mean}) CHECK(loose[key] > 0);
}

TEST_CASE("the order of berries does not matter") {
  const Envelope envelope = spindle(45, 180);
  Grown grown = balls(lattice(15, within(envelope)), 7.4f);
  for (std::size_t i = 0; i < grown.berries.size(); ++i) {
    grown.berries[i].centre += 0.002f * glm::vec3(uniform(3 * i), uniform(3 * i + 1), uniform(3 * i + 2));
    grown.traits[i].length *= 1 + 0.2f * uniform(i + 9000);
  }
  const Measured forwards(grown, hung(envelope));
  std::reverse(grown.berries.begin(), grown.berries.end());
  std::reverse(grown.traits.begin(), grown.traits.end());
  const Measured backwards(grown, hung(envelope));
  for (std::size_t k = 0; k < measure_count; ++k) {
    CAPTURE(k);
    if (!std::isnan(forwards.values[k])) CHECK(backwards.values[k] == about(forwards.values[k], 1e-4));
  }
}

TEST_CASE("twice the size is twice the lengths, eight times the volumes and the same shares") {
  const Envelope envelope = spindle(45, 180), large = spindle(45, 180, 2);
  std::vector<glm::vec3> places = lattice(17, within(envelope));
  const Measured once(balls(places, 8), hung(envelope));
  for (glm::vec3& place : places) place *= 2;
  const Measured twice(balls(places, 16), hung(large));
  for (const Measure key : {bunch_length, bunch_width, diameter, berry_length, gap})
    CHECK(twice[key] == about(2 * once[key], 1e-3));
  for (const Measure key : {bunch_weight, berry_volume, hull_volume, outline_volume, berry_weight})
    CHECK(twice[key] == about(8 * once[key], 1e-3));
  for (const Measure key : {coverage, fill_ratio, density, contacts, visible_mean})
    CHECK(twice[key] == about(once[key], 0.01));
}

TEST_CASE("a small move is a small change of the fit") {
  const Envelope envelope = spindle(45, 180);
  std::vector<glm::vec3> places = lattice(17, within(envelope));
  Measured before(balls(places, 8), hung(envelope));
  float worst = 0;
  for (int step = 0; step < 40; ++step) {
    for (glm::vec3& place : places) place += glm::vec3(0.11f, -0.07f, 0.05f);
    const Measured after(balls(places, 8), hung(envelope));
    worst = std::max(worst, std::abs(after[coverage] - before[coverage]));
    before = after;
  }
  CHECK(worst < 0.006f);
}

TEST_CASE("grown bunches: density follows its control, the second outline hangs where the second bunch does") {
  const auto grown = [](Parameter key, float value) {
    Request request = tests::natural_request(tests::table3[2].profile());
    request.measures = true;
    tests::set(request, key, value);
    const auto result = grow(request);
    REQUIRE(result);
    REQUIRE(result->measures.size() == measure_count);
    return result->measures;
  };
  const auto of = [](const std::vector<float>& measures, Measure key) {
    return measures[static_cast<std::size_t>(key)];
  };
  float before = 0;
  for (const float asked : {1.0f, 3.0f, 5.0f, 7.0f, 9.0f}) {
    const float note = of(grown(Parameter::density, asked), density);
    CHECK(note > before + 0.5f);
    CHECK(std::abs(note - asked) < 2);
    before = note;
  }
  const std::vector<float> twofold = grown(Parameter::wing, 0.6f);
  CHECK(of(twofold, coverage_front) > 0.85f);
  CHECK(of(twofold, coverage_side) > 0.85f);
  CHECK(of(twofold, spill_front) < 0.06f);
}

TEST_CASE("wild bunches give shares between 0 and 1 or no numbers") {
  const float wild[] = {
      0, 1e-6f, 1e6f, 1e30f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    Grown grown;
    std::uint64_t drawn = 10000 * seed;
    const auto draw = [&] { return uniform(drawn++); };
    const auto place = [&] { return 0.2f * glm::vec3(draw() - 0.5f, -draw(), draw() - 0.5f); };
    const auto count = static_cast<std::uint64_t>(40 * draw());
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto parent = static_cast<std::int32_t>(static_cast<float>(i) * draw()) - 1;
      grown.internodes.push_back({parent, Kind::pedicel, State::grown, 0, place(), place(), 0.003f * draw(), 0});
      grown.berries.push_back({place(), 0.01f * draw(), glm::normalize(place() + glm::vec3(0, 0, 0.1f)), parent, 0});
      if (seed % 3 == 0) grown.berries.back().centre.x *= wild[seed / 3 % 6];
      grown.traits.push_back({0.02f * draw(), 0.04f * draw()});
      if (seed % 5 == 0) grown.traits.back().width *= wild[seed / 5 % 6];
    }
    Profile profile{600 * draw(), {}};
    for (SidePoint& side : profile.sides) side = {300 * draw(), 600 * draw()};
    std::vector<HungEnvelope> envelopes = hung(Envelope(profile, 0.43f, 20 * draw()));
    if (seed % 2) envelopes.push_back({envelopes[0].envelope, 25 + 95 * draw()});
    const Measured measured(grown, envelopes);
    for (const Measure key : shares) {
      if (key == fill_ratio || std::isnan(measured[key])) continue;
      CHECK(measured[key] >= 0);
      CHECK(measured[key] <= 1.00001f);
    }
  }
}

TEST_CASE("what spills in one view is spilled over the silhouettes of both") {
  const Envelope envelope = block(30, 200);
  const std::vector<HungEnvelope> upright = hung(envelope);
  const Measured front(balls({{40, -100, 0}}, 10), upright), side(balls({{0, -100, 40}}, 10), upright);
  CHECK(side[spill_front] == 0);
  CHECK(side[spill_side] == about(front[spill_front], 0.05));
  CHECK(side[spill] == about(front[spill], 0.05));
  CHECK(side[spill] > 0.2f);
}

TEST_CASE("two outlines hold what both hold") {
  const Envelope large = block(30, 200), small = block(20, 90);
  const Grown grown = balls({{0, -50, 0}}, 10);
  const Measured both(grown, {{large, 0}, {small, 55}});
  CHECK(both[outline_volume] == about((large.volume() + small.volume()) / 1000, 1e-4));
}

TEST_CASE("fingers touch along their sides, and have their gap from skin to skin") {
  const auto gap_of = [](float apart, const glm::vec3& along, const glm::vec3& away) {
    Grown grown = balls({{0, -50, 0}, glm::vec3(0, -50, 0) + away * apart}, 10);
    for (std::size_t i = 0; i < 2; ++i) {
      grown.berries[i].direction = along;
      grown.traits[i].length = 0.06f;
    }
    return Measured(grown, {})[gap];
  };
  const glm::vec3 down(0, -1, 0), right(1, 0, 0);
  const float width = 20, length = 60, mean = width * std::cbrt(length / width);
  const auto expected = [&](float apart) {
    return (apart + 2 * mean) / 3;
  };  // of the nearest three, two of which are missing
  CHECK(gap_of(width + 4, down, right) == about(expected(4), 0.01));
  CHECK(gap_of(length + 4, down, down) == about(expected(4), 0.01));
}

TEST_CASE("the side is looked at from the left, as the side view is") {
  // A large ball at the left hides what is behind it from there, and from nowhere else.
  Grown grown = balls({{-60, -50, 0}, {0, -45, 0}, {0, -55, 4}, {2, -50, -4}}, 5);
  grown.berries[0].radius = 0.03f;
  grown.traits[0].width = grown.traits[0].length = 0.06f;
  CHECK(Measured(grown, {})[visible_side] == about(0.25, 1e-4));
  for (Berry& berry : grown.berries) berry.centre.x = -berry.centre.x;
  CHECK(Measured(grown, {})[visible_side] == about(1, 1e-4));
}
