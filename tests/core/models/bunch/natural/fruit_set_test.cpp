#include "models/bunch/natural/settling/fruit_set.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

// Uniformly random buds in a cube.
std::vector<Bud> cloud(std::size_t count, float edge, std::uint64_t seed) {
  std::vector<Bud> buds;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](std::uint64_t k) { return random_unit(seed, k, i); };
    buds.push_back({{edge * at(1), edge * at(2), edge * at(3)}, at(4)});
  }
  return buds;
}

double sum(const std::vector<float>& shares) {
  double total = 0;
  for (const float share : shares) total += share;
  return total;
}

}  // namespace

TEST_CASE("in a crowd of flowers berries fill the requested share of space") {
  const float size = 10, edge = 120;
  const auto buds = cloud(6000, edge, 1);
  for (const float fill : {0.2f, 0.4f, 0.6f}) {
    const double berries = sum(choose_set(ranks_of(buds, size), fill));
    CHECK(berries * 3.14159 / 6 * size * size * size / (edge * edge * edge) == doctest::Approx(fill).epsilon(0.25));
  }
}

TEST_CASE("lonely flowers always set; misplaced ones, and weak ones beside strong ones, seldom") {
  std::vector<Bud> buds{{{0, 0, 0}, 0.9f}, {{100, 0, 0}, 0.9f}, {{200, 0, 0}, 0.9f}, {{201, 0, 0}, 0.1f}};
  buds[1].misplaced = 1;
  buds[2].strength = 0.05f;
  const auto shares = choose_set(ranks_of(buds, 10), 0.5f);
  CHECK(shares[0] == 1);
  CHECK(shares[1] == 0);
  CHECK(shares[2] == 0);
  CHECK(shares[3] == 1);
}

TEST_CASE("setting at one end does not depend on the other end") {
  auto buds = cloud(600, 80, 2);
  const auto before = choose_set(ranks_of(buds, 10), 0.5f);
  for (const Bud& far : cloud(300, 80, 3)) buds.push_back({far.place + glm::vec3(500, 0, 0), far.chance});
  const auto after = choose_set(ranks_of(buds, 10), 0.5f);
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(before[i] == after[i]);
}

TEST_CASE("exactly the requested count sets") {
  const auto buds = cloud(900, 90, 4);
  for (const float wanted : {1.0f, 40.0f, 333.0f, 899.0f, 900.0f, 5000.0f}) {
    int berries = 0;
    for (const float share : choose_count(ranks_of(buds, 10), wanted)) berries += share > 0;
    CHECK(std::abs(berries - std::min(wanted, 900.0f)) <= std::max(1.0f, 0.02f * wanted));
  }
}

TEST_CASE("shares change little when places do") {
  const auto buds = cloud(500, 80, 5);
  auto moved = buds;
  for (Bud& bud : moved) bud.place *= 1.0005f;
  const auto a = choose_set(ranks_of(buds, 10), 0.5f), b = choose_set(ranks_of(moved, 10), 0.5f);
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference += std::abs(a[i] - b[i]);
  CHECK(difference < 0.02 * sum(a));
}

TEST_CASE("crowding is weighted by strength: weak flowers beside a strong one take little of its room") {
  const auto set = [](float neighbours) {
    std::vector<Bud> buds{{{0, 0, 0}, 0.5f}};
    for (int k = 0; k < 6; ++k) {
      Bud bud{{k < 3 ? 3.0f : -3.0f, static_cast<float>(k % 3 - 1) * 3, 0}, 0.5f};
      bud.strength = neighbours;
      buds.push_back(bud);
    }
    return ranks_of(buds, 10)[0];
  };
  CHECK(set(0.1f) < 0.5f * set(1));
  CHECK(set(0.001f) == doctest::Approx(0.5 * (1.0 / 6) / (32.0 / 105 * 1.3 * 1.3 * 1.3)).epsilon(0.02));
}

TEST_CASE("buds of another bunch do not crowd, at any place") {
  std::vector<Bud> buds{{{0, 0, 0}, 0.5f}, {{1, 0, 0}, 0.5f}};
  const float crowded = ranks_of(buds, 10)[0];
  buds[1].bunch = 1;
  CHECK(ranks_of(buds, 10)[0] < 0.6f * crowded);
}
