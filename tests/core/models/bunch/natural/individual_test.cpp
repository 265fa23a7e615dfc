// Variation between seeds.
#include "models/bunch/natural/individual.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

const Profile drawn = table3[0].profile();

bool same(const Profile& a, const Profile& b) {
  bool all = a.length == b.length;
  for (std::size_t i = 0; i < 4; ++i)
    all = all && a.sides[i].width == b.sides[i].width && a.sides[i].drop == b.sides[i].drop;
  return all;
}

struct Spread {
  double mean = 0, variation = 0;
};

template <class Of>
Spread over_seeds(std::uint32_t seeds, Of of) {
  double sum = 0, squares = 0;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const double x = of(seed);
    sum += x;
    squares += x * x;
  }
  const double mean = sum / seeds;
  return {mean, std::sqrt(std::max(0.0, squares / seeds - mean * mean)) / mean};
}

// The ratios by which a seed changes the profile, each of which has a random number of its own: length, cross-section,
// four half-widths, four drops and the wing. With a fixed berry count the volume per berry is constant, so that widths
// show each side's own ratio; those of `free` bunches are wider or narrower as a whole. The variability is one at
// which no factor meets its limit.
std::array<double, 11> ratios_of(std::uint64_t seed) {
  constexpr float variability = 0.4f;
  const Profile counted = individual(drawn, seed, variability, true),
                free = individual(drawn, seed, variability, false);
  const double longer = counted.length / drawn.length;
  const double wider = free.sides[0].width / counted.sides[0].width;
  std::array<double, 11> ratios{longer, wider * wider / longer};
  for (std::size_t i = 0; i < 4; ++i) {
    ratios[2 + i] = counted.sides[i].width / drawn.sides[i].width * std::sqrt(longer);
    ratios[6 + i] = counted.sides[i].drop / drawn.sides[i].drop / longer;
  }
  ratios[10] = wing_share(seed, variability);
  return ratios;
}

// Pearson's correlation of two columns.
double correlation(const std::vector<std::array<double, 11>>& rows, std::size_t a, std::size_t b) {
  const auto n = static_cast<double>(rows.size());
  double sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  for (const auto& row : rows) {
    sum_a += row[a] / n;
    sum_b += row[b] / n;
  }
  for (const auto& row : rows) {
    aa += (row[a] - sum_a) * (row[a] - sum_a);
    bb += (row[b] - sum_b) * (row[b] - sum_b);
    ab += (row[a] - sum_a) * (row[b] - sum_b);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace

TEST_CASE("without variability, and for seed 1, the profile is the handles'") {
  for (const std::uint64_t seed : {0u, 2u, 77u, 0xffffffffu}) {
    CHECK(same(individual(drawn, seed, 0, false), drawn));
    CHECK(!same(individual(drawn, seed, 1, false), drawn));
  }
  CHECK(same(individual(drawn, 1, 2, false), drawn));
}

TEST_CASE("profiles spread by the variability about the handles', evenly already over the first seeds") {
  for (const std::uint32_t seeds : {20u, 1000u})
    for (const float variability : {0.5f, 1.0f}) {
      CAPTURE(seeds);
      CAPTURE(variability);
      const auto at = [&](std::uint32_t seed) { return individual(drawn, seed, variability, false); };
      const Spread length = over_seeds(seeds, [&](std::uint32_t seed) { return at(seed).length; });
      const Spread width = over_seeds(seeds, [&](std::uint32_t seed) { return at(seed).sides[0].width; });
      const Spread drop = over_seeds(seeds, [&](std::uint32_t seed) { return at(seed).sides[2].drop; });
      CHECK(length.mean == doctest::Approx(drawn.length).epsilon(0.02));
      CHECK(width.mean == doctest::Approx(drawn.sides[0].width).epsilon(0.03));
      CHECK(drop.mean == doctest::Approx(drawn.sides[2].drop).epsilon(0.06));
      CHECK(length.variation == doctest::Approx(0.15 * variability).epsilon(0.1));
      CHECK(width.variation == doctest::Approx(0.18 * variability).epsilon(0.25));
      CHECK(drop.variation == doctest::Approx(0.19 * variability).epsilon(0.3));
    }
}

TEST_CASE("long bunches tend to be thick ones, and all other ratios of a seed are independent") {
  std::vector<std::array<double, 11>> rows;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) rows.push_back(ratios_of(seed));
  CHECK(correlation(rows, 1, 0) == doctest::Approx(0.5).epsilon(0.15));
  // The part of the cross-section that length does not explain: the residual of a linear regression.
  Spread length, section;
  double together = 0;
  length = over_seeds(400, [&](std::uint32_t seed) { return rows[seed - 1][0]; });
  section = over_seeds(400, [&](std::uint32_t seed) { return rows[seed - 1][1]; });
  for (const auto& row : rows) together += (row[0] - length.mean) * (row[1] - section.mean) / 400;
  const double slope = together / std::pow(length.variation * length.mean, 2);
  for (auto& row : rows) row[1] -= slope * (row[0] - length.mean);
  for (std::size_t a = 0; a < 11; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      CAPTURE(a);
      CAPTURE(b);
      CHECK(std::abs(correlation(rows, a, b)) < 0.13);
    }
}

TEST_CASE("a seed changes every profile in the same proportion") {
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Profile profile = random_profile(k);
    const auto seed = static_cast<std::uint32_t>(random_bits(k, 3, 3));
    const Profile one = individual(drawn, seed, 1, false), other = individual(profile, seed, 1, false);
    CHECK(other.length / profile.length == doctest::Approx(one.length / drawn.length).epsilon(1e-4));
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(other.sides[i].width >= 0);
      CHECK((other.sides[i].width < 12.5f) == (profile.sides[i].width < 12.5f));  // a raceme stays a raceme
      if (profile.sides[i].width > 40)
        CHECK(other.sides[i].width / profile.sides[i].width ==
              doctest::Approx(one.sides[i].width / drawn.sides[i].width).epsilon(1e-4));
    }
  }
}

TEST_CASE("counted berries have the same room in every seed's bunch, but for its sides") {
  for (std::uint32_t seed = 1; seed < 100; ++seed) {
    const Profile own = individual(drawn, seed, 1, true);
    float across = 0, before = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      across += own.sides[i].width;
      before += drawn.sides[i].width;
    }
    const float room = own.length * across * across / (drawn.length * before * before);
    CHECK(room > 0.75f);
    CHECK(room < 1.3f);
  }
}

TEST_CASE("gaps are long waves about the mean fill, other ones for each seed") {
  const Gaps none(5, 0, 15), some(5, 1, 15), others(6, 1, 15);
  double sum = 0, squares = 0, apart = 0;
  const int places = 4000;
  for (std::uint64_t k = 0; k < places; ++k) {
    const glm::vec3 place = 600.0f * glm::vec3(random_unit(1, 1, k), random_unit(1, 2, k), random_unit(1, 3, k));
    CHECK(none.fill_at(place) == 1);
    const float fill = some.fill_at(place);
    CHECK(fill > 0.6f);
    CHECK(std::abs(some.fill_at(place + glm::vec3(0.1f, 0, 0)) - fill) < 0.01f);
    sum += fill;
    squares += (fill - 1) * (fill - 1);
    apart += std::abs(others.fill_at(place) - fill);
  }
  CHECK(sum / places == doctest::Approx(1).epsilon(0.03));
  CHECK(std::sqrt(squares / places) == doctest::Approx(0.127).epsilon(0.15));
  CHECK(apart / places > 0.08);
}

TEST_CASE("the bunch fills its own seed's outline, and returns it") {
  BunchRequest request = natural_request(table3[1].profile(), 5);
  request.measures = true;
  const GrownBunch varied = grown(request);
  CHECK(same(varied.profile, individual(table3[1].profile(), 5, 1, false)));
  CHECK(varied.plan.sides[0].point.width == table3[1].profile().sides[0].width);
  CHECK(varied.measures[static_cast<std::size_t>(Measure::coverage)] > 0.85f);
  set(request, Parameter::variability, 0);
  const GrownBunch even = grown(request);
  CHECK(same(even.profile, table3[1].profile()));
  CHECK(even.fingerprint != varied.fingerprint);
}
