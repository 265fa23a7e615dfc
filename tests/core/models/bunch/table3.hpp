// Table 3 of Huang et al. 2013 as data: the drawn profile (l, w, r) and the paper's counts (m, n, rd).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "models/bunch/plan.hpp"

namespace panicle::tests {

struct Table3Row {
  std::string_view name;
  float l;
  std::int32_t m;
  struct Side {
    float w, r;
    std::int32_t n, rd;
  };
  std::array<Side, 4> sides;  // p3, p4, p5, p6

  bunch::Profile profile() const {
    bunch::Profile profile{l, {}};
    for (std::size_t i = 0; i < 4; ++i) profile.sides[i] = {sides[i].w, sides[i].r};
    return profile;
  }
};

inline constexpr std::array<Table3Row, 14> table3 = {{
    {"short conical", 253, 9, {{{79, 76, 3, 4}, {116, 91, 5, 6}, {101, 112, 4, 8}, {97, 103, 4, 8}}}},
    {"shouldered conical", 377, 13, {{{190, 130, 8, 7}, {110, 150, 4, 9}, {150, 150, 6, 10}, {150, 150, 6, 11}}}},
    {"long conical", 512, 18, {{{150, 150, 6, 8}, {150, 102, 6, 7}, {150, 150, 6, 10}, {150, 150, 6, 11}}}},
    {"cylindrical", 523, 18, {{{47, 133, 2, 7}, {47, 136, 2, 9}, {80, 105, 3, 8}, {63, 108, 3, 9}}}},
    {"winged cylindrical", 525, 18, {{{190, 86, 8, 5}, {199, 113, 8, 7}, {150, 150, 6, 10}, {150, 150, 6, 11}}}},
    {"real grape 15(a)", 267, 9, {{{47, 18, 2, 1}, {51, 35, 2, 3}, {71, 45, 3, 5}, {83, 52, 3, 6}}}},
    {"real grape 15(b)", 377, 13, {{{167, 85, 7, 5}, {182, 84, 7, 6}, {202, 78, 8, 6}, {214, 72, 9, 7}}}},
    {"real grape 15(c)", 461, 16, {{{202, 63, 8, 4}, {135, 89, 5, 6}, {167, 95, 7, 7}, {186, 115, 7, 9}}}},
    {"real grape 15(d)", 272, 9, {{{64, 217, 3, 8}, {43, 243, 2, 8}, {57, 218, 2, 8}, {78, 204, 3, 8}}}},
    {"redcurrant", 528, 18, {{{9, 17, 0, 1}, {10, 19, 0, 2}, {10, 17, 0, 3}, {9, 16, 0, 4}}}},
    {"rubus", 122, 4, {{{10, 17, 0, 1}, {8, 17, 0, 2}, {10, 19, 0, 3}, {9, 22, 0, 3}}}},
    {"lychee", 65, 2, {{{42, 33, 2, 1}, {52, 33, 2, 1}, {43, 51, 2, 1}, {44, 48, 2, 1}}}},
    {"longan", 243, 8, {{{127, 79, 5, 4}, {111, 56, 4, 4}, {132, 56, 5, 5}, {134, 73, 5, 7}}}},
    {"duku", 477, 16, {{{10, 16, 0, 1}, {8, 19, 0, 2}, {9, 15, 0, 3}, {11, 15, 0, 4}}}},
}};

}  // namespace panicle::tests
