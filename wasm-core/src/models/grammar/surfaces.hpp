// The surfaces that a text can name with ~: small meshes that stand on the turtle and point where it heads, of length 1
// but for what `about` says.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/mesh.hpp"

namespace panicle::grammar {

struct Surface {
  std::string_view name;      // as texts have it
  std::string_view material;  // its kind
  std::uint8_t colour;        // by nature, of the palette
  float area;                 // that it hides, at size 1
};

inline constexpr std::array<Surface, 8> surfaces = {{
    {"leaf", "blade", 3, 0.3f},
    {"petal", "petal", 5, 0.4f},
    {"sepal", "sepal", 2, 0.2f},
    {"flower", "petal", 5, 0.6f},  // five petals, 1 across
    {"disc", "petal", 6, 0.7f},    // 1 across, square to the heading
    {"cone", "stem", 6, 0.4f},     // half as wide as long
    {"bud", "sepal", 2, 0.5f},
    {"berry", "skin", 7, 0.8f},  // 1 across
}};

// The place of a name among them; nothing where there is none of that name.
std::optional<std::uint32_t> surface_named(std::string_view name);

// y where the turtle heads, z to its upper side; triangles counter-clockwise seen from outside, or from above.
Mesh make_surface(std::uint32_t which);

}  // namespace panicle::grammar
