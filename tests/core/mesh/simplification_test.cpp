// In which order a mesh can do without its vertices: by the laws of collapses, applied one by one.
#include "mesh/simplification.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "foundation/random.hpp"

using namespace panicle;

namespace {

// A grid of n × n squares, lifted; its border is fixed.
template <class Height>
Patch grid(std::uint32_t n, Height height) {
  Patch patch;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      patch.positions.emplace_back(x, y, height(x, y));
      patch.is_fixed.push_back(x == 0 || y == 0 || x == n || y == n);
    }
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
      patch.triangles.push_back({a, b, d});
      patch.triangles.push_back({a, d, c});
    }
  patch.counted = static_cast<std::uint32_t>(patch.triangles.size());
  return patch;
}

glm::vec3 normal_of(const Patch& patch, const std::array<std::uint32_t, 3>& triangle) {
  const glm::vec3& a = patch.positions[triangle[0]];
  return glm::cross(patch.positions[triangle[1]] - a, patch.positions[triangle[2]] - a);
}

bool is_flat(const std::array<std::uint32_t, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Applies the list of collapses and checks each step; returns how many triangles turned over.
void check_laws(const Patch& patch, const std::vector<Collapse>& thinning) {
  auto triangles = patch.triangles;
  std::set<std::uint32_t> gone;
  float error = 0;
  for (const Collapse& each : thinning) {
    REQUIRE(patch.is_fixed[each.vertex] == 0);
    REQUIRE(gone.insert(each.vertex).second);
    REQUIRE_FALSE(gone.contains(each.into));
    REQUIRE(each.error >= error);
    error = each.error;
    std::uint32_t left = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto before = triangles[t];
      std::replace(triangles[t].begin(), triangles[t].end(), each.vertex, each.into);
      if (is_flat(triangles[t])) continue;
      left += t < patch.counted;
      if (before != triangles[t]) REQUIRE(glm::dot(normal_of(patch, before), normal_of(patch, triangles[t])) > 0);
    }
    REQUIRE(each.triangles == left);
  }
}

}  // namespace

TEST_CASE("simplification: flat parts collapse at hardly any error, and fixed vertices stay") {
  const Patch flat = grid(12, [](std::uint32_t, std::uint32_t) { return 0.0f; });
  const std::vector<Collapse> thinning = thinning_of(flat);
  check_laws(flat, thinning);
  CHECK(thinning.size() == 11 * 11);
  // Only the share of an edge's length that counts as error.
  CHECK(thinning.back().error < 0.2f);
}

TEST_CASE("simplification: a ridge outlasts the planes beside it") {
  const auto roof = [](std::uint32_t x, std::uint32_t) { return 4 - std::abs(static_cast<float>(x) - 6); };
  const Patch patch = grid(12, roof);
  const std::vector<Collapse> thinning = thinning_of(patch);
  check_laws(patch, thinning);
  // Ninety-nine of its vertices are in a plane or along the ridge; the height stays until those are gone.
  for (const Collapse& each : thinning)
    if (each.error < 0.3f)
      CHECK(patch.positions[each.vertex].z <= patch.positions[each.into].z + (each.vertex % 13 == 6 ? 0.0f : 12.0f));
  std::size_t on_ridge = 0, cheap = 0;
  for (const Collapse& each : thinning) {
    if (each.error > 0.3f) break;
    ++cheap;
    on_ridge += each.vertex % 13 == 6 && each.into % 13 != 6;
  }
  CHECK(cheap > 90);
  CHECK(on_ridge == 0);
}

TEST_CASE("simplification: errors, counts and collapses are consistent on a rough surface") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Patch patch = grid(9, [&](std::uint32_t x, std::uint32_t y) { return 1.5f * random_unit(seed, 7, 100 * x + y); });
    if (seed % 2 == 0) patch.counted = static_cast<std::uint32_t>(patch.triangles.size() / 2);
    const std::vector<Collapse> thinning = thinning_of(patch);
    CHECK(thinning.size() > 20);
    check_laws(patch, thinning);
    const std::vector<Collapse> again = thinning_of(patch);
    CHECK(std::equal(thinning.begin(), thinning.end(), again.begin(), again.end(), [](const auto& a, const auto& b) {
      return a.vertex == b.vertex && a.into == b.into && a.error == b.error;
    }));
  }
}

TEST_CASE("simplification: among equal collapses the lower number goes first") {
  // A flat star of six about a vertex, everything else fixed: all ways cost the same.
  Patch star;
  star.positions.emplace_back(0, 0, 0);
  star.is_fixed.push_back(0);
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    star.positions.emplace_back(x, y, 0);
    star.is_fixed.push_back(1);
  }
  for (std::uint32_t i = 1; i <= 4; ++i) star.triangles.push_back({0, i, i % 4 + 1});
  star.counted = 4;
  const std::vector<Collapse> thinning = thinning_of(star);
  REQUIRE(thinning.size() == 1);
  CHECK(thinning[0].into == 1);
  CHECK(thinning[0].triangles == 2);
}

TEST_CASE("simplification: the centre of a fan of thousands stays, and its neighbours collapse") {
  Patch fan;
  fan.positions.emplace_back(0, 0, 1);
  const std::uint32_t rim = 4000;
  for (std::uint32_t ring = 1; ring <= 2; ++ring)
    for (std::uint32_t i = 0; i < rim; ++i) {
      const float turn = 6.2831853f * static_cast<float>(i) / static_cast<float>(rim);
      fan.positions.emplace_back(static_cast<float>(ring) * std::cos(turn), static_cast<float>(ring) * std::sin(turn),
                                 0);
    }
  fan.is_fixed.assign(fan.positions.size(), 0);
  for (std::uint32_t i = 0; i < rim; ++i) {
    const std::uint32_t a = 1 + i, b = 1 + (i + 1) % rim;
    fan.triangles.push_back({0, a, b});
    fan.triangles.push_back({a, a + rim, b + rim});
    fan.triangles.push_back({a, b + rim, b});
  }
  fan.counted = static_cast<std::uint32_t>(fan.triangles.size());
  const std::vector<Collapse> thinning = thinning_of(fan);
  CHECK(thinning.size() > 7000);
  for (std::size_t i = 0; i < 3000; ++i) REQUIRE(thinning[i].vertex != 0);
  float error = 0;
  for (const Collapse& each : thinning) {
    CHECK(each.error >= error);
    error = each.error;
  }
}

TEST_CASE("simplification: a patch above the limit is thinned on grids, without comparing collapses") {
  constexpr std::uint32_t most = 2000;
  const auto hills = [](std::uint32_t x, std::uint32_t y) {
    return 3 * std::sin(0.1f * static_cast<float>(x)) * std::cos(0.1f * static_cast<float>(y));
  };
  std::uint64_t few = 0, many = 0;
  thinning_of(grid(30, hills), most, &few);
  const Patch large = grid(300, hills);
  const std::vector<Collapse> thinning = thinning_of(large, most, &many);
  CHECK(few > 1000);
  CHECK(many == 0);
  // A list all the same: no vertex goes twice, none that stays goes, errors and triangles are in order.
  std::set<std::uint32_t> gone;
  float error = 0;
  std::uint32_t left = large.counted;
  for (const Collapse& each : thinning) {
    REQUIRE(large.is_fixed[each.vertex] == 0);
    REQUIRE(gone.insert(each.vertex).second);
    REQUIRE_FALSE(gone.contains(each.into));
    REQUIRE(each.error >= error);
    REQUIRE(each.triangles <= left);
    error = each.error;
    left = each.triangles;
  }
  CHECK(left < 1300);
  // The list's count of remaining triangles is right.
  std::vector<std::uint32_t> to(large.positions.size());
  for (std::uint32_t v = 0; v < to.size(); ++v) to[v] = v;
  for (std::size_t i = thinning.size(); i-- > 0;) to[thinning[i].vertex] = to[thinning[i].into];
  std::uint32_t counted = 0;
  for (auto triangle : large.triangles) {
    for (std::uint32_t& corner : triangle) corner = to[corner];
    counted += !is_flat(triangle);
  }
  CHECK(counted == left);
}
