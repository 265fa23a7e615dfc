// Outlines of leaves that tests share, as requests have them: rows of x, y, kind.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace panicle::particles::leaf {

using Half = std::vector<std::array<float, 3>>;

// A leaf alike on both sides, from its right half: base and tip, which are on the axis, and the points between.
inline std::vector<float> mirrored(const Half& half) {
  std::vector<float> rows;
  for (const auto& [x, y, kind] : half) rows.insert(rows.end(), {x, y, kind});
  for (std::size_t i = half.size() - 1; i-- > 1;) rows.insert(rows.end(), {-half[i][0], half[i][1], half[i][2]});
  return rows;
}

struct NamedOutline {
  std::string_view name;
  std::vector<float> rows;
  float ribs;  // the option that suits it
};

inline std::vector<NamedOutline> leaf_outlines() {
  return {
      {"ovate", {}, 1},
      {"willow",
       mirrored({{0, 0, 1}, {0.03f, 0.08f, 0}, {0.075f, 0.3f, 0}, {0.075f, 0.5f, 0}, {0.04f, 0.8f, 0}, {0, 1, 3}}), 1},
      {"lime",
       mirrored({{0, 0, 1},
                 {0.12f, -0.1f, 0},
                 {0.3f, -0.08f, 0},
                 {0.44f, 0.12f, 0},
                 {0.45f, 0.36f, 0},
                 {0.3f, 0.65f, 0},
                 {0.1f, 0.87f, 0},
                 {0, 1, 3}}),
       1},
      {"bodhi",
       mirrored({{0, 0, 1},
                 {0.2f, -0.03f, 0},
                 {0.36f, 0.12f, 0},
                 {0.35f, 0.35f, 0},
                 {0.18f, 0.6f, 0},
                 {0.05f, 0.73f, 0},
                 {0.02f, 0.85f, 0},
                 {0, 1, 3}}),
       1},
      {"oak",
       mirrored({{0, 0, 1},
                 {0.05f, 0.07f, 0},
                 {0.13f, 0.15f, 2},
                 {0.09f, 0.23f, 0},
                 {0.17f, 0.31f, 0},
                 {0.24f, 0.39f, 2},
                 {0.13f, 0.44f, 0},
                 {0.22f, 0.54f, 0},
                 {0.29f, 0.64f, 2},
                 {0.16f, 0.67f, 0},
                 {0.2f, 0.75f, 0},
                 {0.22f, 0.85f, 2},
                 {0.11f, 0.87f, 0},
                 {0.09f, 0.96f, 0},
                 {0, 1, 2}}),
       1},
      {"grapevine",
       mirrored({{0, 0, 1},
                 {0.09f, -0.18f, 0},
                 {0.25f, -0.22f, 3},
                 {0.38f, -0.08f, 0},
                 {0.45f, 0.1f, 0},
                 {0.35f, 0.16f, 0},
                 {0.5f, 0.3f, 0},
                 {0.56f, 0.5f, 3},
                 {0.38f, 0.53f, 0},
                 {0.22f, 0.52f, 0},
                 {0.27f, 0.68f, 0},
                 {0.16f, 0.85f, 0},
                 {0, 1, 3}}),
       2},
      {"maple",
       mirrored({{0, 0, 1},
                 {0.1f, -0.04f, 0},
                 {0.33f, 0, 3},
                 {0.27f, 0.09f, 0},
                 {0.3f, 0.17f, 0},
                 {0.62f, 0.36f, 3},
                 {0.44f, 0.44f, 0},
                 {0.43f, 0.55f, 0},
                 {0.18f, 0.44f, 1},
                 {0.23f, 0.66f, 0},
                 {0.13f, 0.76f, 0},
                 {0, 1, 3}}),
       2},
      {"ginkgo",
       mirrored({{0, 0, 1},
                 {0.07f, 0.14f, 0},
                 {0.3f, 0.38f, 0},
                 {0.6f, 0.56f, 1},
                 {0.48f, 0.83f, 0},
                 {0.25f, 0.98f, 0},
                 {0.06f, 0.98f, 0},
                 {0, 0.62f, 1}}),
       0},
      {"strawberry",
       mirrored({{0, 0, 1},
                 {0.14f, -0.1f, 0},
                 {0.35f, -0.02f, 0},
                 {0.57f, 0.2f, 0},
                 {0.6f, 0.42f, 3},
                 {0.38f, 0.4f, 0},
                 {0.16f, 0.22f, 0},
                 {0.03f, 0.09f, 1},
                 {0.12f, 0.28f, 0},
                 {0.27f, 0.55f, 0},
                 {0.26f, 0.82f, 0},
                 {0, 1, 2}}),
       2},
      {"grass", mirrored({{0, 0, 1}, {0.045f, 0.2f, 0}, {0.05f, 0.5f, 0}, {0.03f, 0.8f, 0}, {0, 1, 3}}), 3},
      {"hook",
       {0,    0,     1, 0.2f,  0.1f, 0, 0.55f, 0.3f,  0, 0.75f, 0.7f, 0, 0.5f, 1,    0,
        0.1f, 0.95f, 3, 0.45f, 0.8f, 0, 0.5f,  0.65f, 0, 0.35f, 0.4f, 0, 0.1f, 0.3f, 0},
       1},
  };
}

}  // namespace panicle::particles::leaf
