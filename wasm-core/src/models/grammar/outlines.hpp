// Outlines of leaves by one formula (Seo, Kim and Lee 2014, table 2, as in grammars/grammar/leaf.lsys): rays from the
// base, i of k to each side of the midrib, turn by `theta` · t and are as long as a function of t = i / k. A surface
// with an outline's name is a leaf of that grammar, grown once for many organs.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "mesh/mesh.hpp"

namespace panicle::grammar {

// Constants of the grammar, with the same names.
struct Outline {
  std::string_view name;
  float theta = 105;  // angle of the last ray from the midrib, degrees
  float offset = 0, fall = 1, bow = 1.5f, slim = 0, lobe = 0, turns = 0, round = 1, teeth = 0;
  std::uint32_t rays = 12;  // k of the grammar
};

inline constexpr std::array<Outline, 12> outlines = {{
    {.name = "ovate"},
    {.name = "elliptic", .theta = 60, .bow = 1},
    {.name = "lanceolate", .theta = 60, .fall = 0, .slim = 3},
    {.name = "obovate", .theta = 40, .offset = 0.2f, .fall = 0, .lobe = 1, .turns = 90},
    {.name = "oblanceolate", .theta = 20, .offset = 0.3f, .fall = 0, .lobe = 1, .turns = 90},
    {.name = "orbicular", .theta = 90, .fall = 0, .lobe = 1, .turns = 90},
    {.name = "deltoid", .theta = 75, .offset = 0.6f, .fall = 0, .slim = 2},
    {.name = "cordate", .theta = 160, .offset = 0.3f},
    {.name = "reniform", .theta = 150, .offset = 0.6f, .fall = 0, .lobe = 1, .turns = 60},
    {.name = "fivelobed",
     .theta = 140,
     .offset = 0.5f,
     .fall = 0.4f,
     .bow = 1,
     .lobe = 0.85f,
     .turns = 360,
     .rays = 32},
    {.name = "threelobed",
     .theta = 120,
     .offset = 0.45f,
     .fall = 0.35f,
     .bow = 1,
     .lobe = 1,
     .turns = 225,
     .round = 0.8f,
     .rays = 32},
    {.name = "toothed", .offset = 0.1f, .teeth = 0.15f, .rays = 60},
}};

// Length of the ray at t, 0 at the midrib and 1 at the last ray, over the midrib's length.
float ray(const Outline& outline, float t);

// The blade: its base at the origin, its tip at y = 1, its upper side to z, folded along the midrib, the tip drooping.
// `plain`: with as few triangles as its outline needs.
Mesh blade_within(const Outline& outline, bool plain = false);

}  // namespace panicle::grammar
