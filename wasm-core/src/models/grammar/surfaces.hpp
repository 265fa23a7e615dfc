// The surfaces that a grammar can name with ~: small meshes that begin at the turtle and point along its heading, of
// length 1 unless stated otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mesh/mesh.hpp"

namespace panicle::grammar {

struct NamedSurface {
  std::string_view name;      // as written in grammars
  std::string_view material;  // its material
  std::uint8_t colour;        // default colour of the palette
  float area;                 // mean area that it hides, at size 1
};

inline constexpr std::array<NamedSurface, 20> surfaces = {{
    {"leaf", "blade", 3, 0.3f},
    {"petal", "petal", 5, 0.4f},
    {"sepal", "sepal", 2, 0.2f},
    {"flower", "petal", 5, 0.6f},  // five petals, 1 across
    {"disc", "petal", 6, 0.7f},    // 1 across, square to the heading
    {"cone", "stem", 6, 0.4f},     // half as wide as long
    {"bud", "sepal", 2, 0.5f},
    {"berry", "skin", 7, 0.8f},  // 1 across
    // Leaves of one formula: the outlines of outlines.hpp, in their order.
    {"ovate", "blade", 3, 0.23f},
    {"elliptic", "blade", 3, 0.18f},
    {"lanceolate", "blade", 3, 0.09f},
    {"obovate", "blade", 3, 0.19f},
    {"oblanceolate", "blade", 3, 0.1f},
    {"orbicular", "blade", 3, 0.39f},
    {"deltoid", "blade", 3, 0.29f},
    {"cordate", "blade", 3, 0.48f},
    {"reniform", "blade", 3, 1.05f},
    {"fivelobed", "blade", 3, 0.63f},
    {"threelobed", "blade", 3, 0.57f},
    {"toothed", "blade", 3, 0.2f},
}};

inline constexpr std::uint32_t first_outline_surface = 8;

// The index of a surface by its name; none for an unknown name.
std::optional<std::uint32_t> surface_named(std::string_view name);

// Builds a surface: y along the turtle's heading, z to its upper side; triangles counter-clockwise seen from outside,
// or from above. `plain`: of the same size with about a quarter of the triangles.
Mesh make_surface(std::uint32_t which, bool plain = false);

}  // namespace panicle::grammar
