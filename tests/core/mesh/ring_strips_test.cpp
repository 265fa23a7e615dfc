#include "mesh/ring_strips.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

using namespace panicle;

TEST_CASE("a strip has one triangle for each side of both rings, all with the same orientation") {
  for (std::uint32_t inner = 1; inner <= 12; ++inner) {
    for (std::uint32_t outer = 1; outer <= 12; ++outer) {
      std::vector<std::array<std::uint32_t, 3>> triangles;
      const std::uint32_t first_outer = 100;
      strip_between(0, inner, first_outer, outer,
                    [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles.push_back({a, b, c}); });
      CHECK(triangles.size() == inner + outer);
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
      for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
      for (std::uint32_t i = 0; i < inner; ++i) CHECK(edges[{i, i + 1}] == 1);
      for (std::uint32_t j = 0; j < outer; ++j) CHECK(edges[{first_outer + j + 1, first_outer + j}] == 1);
      // All other edges but the two at the ends are shared by two triangles, one each way.
      std::size_t open = 0;
      for (const auto& [edge, uses] : edges) {
        if (uses == 0) continue;
        CHECK(uses == 1);
        open += edges.count({edge.second, edge.first}) == 0;
      }
      CHECK(open == inner + outer + 2);
    }
  }
}

TEST_CASE("diagonals are short: neither ring runs ahead of the other by more than a side") {
  constexpr std::uint32_t inner = 7, outer = 18;
  strip_between(0, inner, 100, outer, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto share = [](std::uint32_t v) {
      return v < 100 ? static_cast<double>(v) / inner : static_cast<double>(v - 100) / outer;
    };
    const auto [least, most] = std::minmax({share(a), share(b), share(c)});
    CHECK(most - least <= 1.0 / inner + 1e-9);
  });
}
