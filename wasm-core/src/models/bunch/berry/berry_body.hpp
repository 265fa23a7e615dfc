// A berry as a solid of revolution about its direction, for swelling, pressing and measuring.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace panicle::bunch {

// The fruit, which determines the surface of its berries; numbers are those of the parameter `fruit`.
enum class Fruit : std::uint8_t { grape = 0, currant = 1, bramble = 2, lychee = 3, longan = 4, duku = 5 };

// The form that all berries of a bunch share: how their meridian differs from an ellipse (OIV 223).
struct BerryForm {
  float taper = 0;  // −1 … 1: below 0 the pedicel's end is the wider (ovoid), above 0 the tip's (obovoid)
  float blunt = 0;  // 0 … 1: from an ellipse to a cylinder with round ends
  Fruit fruit = Fruit::grape;
  float curve = 0;   // 0 … 1: from straight to bent like a horn, each berry its own way
  float relief = 1;  // 0 … 1: strength of the fruit's relief; an ovary is smooth
};

struct BerryBody {
  glm::vec3 centre{0};
  glm::vec3 direction{0, -1, 0};  // unit, from the pedicel towards the tip scar
  float half_width = 0;           // across the direction
  float half_length = 0;          // along it
  float shrivel = 0;              // 0 … 1: how far it has dried; changes furrows, not size
  std::uint32_t id = 0;           // seeds the differences between berries
};

}  // namespace panicle::bunch
