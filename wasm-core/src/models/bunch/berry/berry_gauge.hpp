// The free surface of a berry, tabulated at the pattern's directions.
#pragma once

#include <cstdint>
#include <vector>

#include "models/bunch/berry/berry_meridian.hpp"
#include "models/bunch/berry/berry_pattern.hpp"
#include "models/bunch/berry/fruit_skin.hpp"

namespace panicle::bunch {

// A function of direction and its gradient, one value a vertex of the pattern, padding included. The gradient of a
// gauge (1 / distance of a surface from the centre) is the outward normal, scaled to give the gauge times direction.
struct GaugeTable {
  std::vector<float> value, x, y, z;

  // A table for `padded` directions, a multiple of four.
  explicit GaugeTable(std::size_t padded = 0) : value(padded), x(padded), y(padded), z(padded) {}
};

// A meridian's solid bent like a horn: points at height y are shifted sideways, along +X of unit space, the ends a
// little the other way.
struct BentForm {
  const BerryMeridian& meridian;
  float curve = 0;  // 0 … 1
};

// How much farther than its straight form a bent one may reach.
float bow_reach(float curve);

// The gauge of form and skin, which all berries of a bunch share.
GaugeTable free_gauge(const BerryPattern& pattern, const BentForm& form, const FruitSkin& skin);

// The share of a berry's volume that its furrows and dents take when it is wholly shrivelled.
inline constexpr float furrowed_volume = 0.25f;

// Furrows and dents of a drying berry. Each berry mixes two fields of fine waves by an angle of its own and is creased
// where the mix is 0, deeply in some places and hardly in others; two fields of broad waves set these places, and those
// where the skin caves in.
class Furrows {
 public:
  explicit Furrows(const BerryPattern& pattern);

  // Writes the gauge `free` with the furrows of berry `id`, `shrivel` 0 … 1 deep, into `result` of the same size.
  void carve(const GaugeTable& free, std::uint32_t id, float shrivel, GaugeTable& result) const;

 private:
  GaugeTable first_, second_, broad_, other_broad_;
};

}  // namespace panicle::bunch
