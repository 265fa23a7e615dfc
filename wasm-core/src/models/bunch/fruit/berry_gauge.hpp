// The free surface of a berry, tabulated at the pattern's directions.
#pragma once

#include <cstdint>
#include <vector>

#include "models/bunch/fruit/berry_meridian.hpp"
#include "models/bunch/fruit/berry_pattern.hpp"
#include "models/bunch/fruit/fruit_skin.hpp"

namespace panicle::bunch {

// A function of direction and its gradient, one value a vertex of the pattern, padding included. Of a gauge (1 /
// distance of a surface from the centre) the gradient is the outward normal, scaled to give the gauge times direction.
struct GaugeTable {
  std::vector<float> value, x, y, z;

  explicit GaugeTable(std::size_t padded = 0) : value(padded), x(padded), y(padded), z(padded) {}
};

// Form and skin, which all berries of a bunch share.
GaugeTable free_gauge(const BerryPattern& pattern, const BerryMeridian& meridian, const FruitSkin& skin);

// The share of a berry's volume that its furrows take when it is wholly shrivelled.
inline constexpr float furrowed_volume = 0.12f;

// Furrows of a drying berry: each berry mixes two fields by an angle of its own and is creased where the mix is 0.
class Furrows {
 public:
  explicit Furrows(const BerryPattern& pattern);

  // The gauge `free` with the furrows of berry `id`, `shrivel` 0 … 1 deep, into `result` of the same size.
  void carve(const GaugeTable& free, std::uint32_t id, float shrivel, GaugeTable& result) const;

 private:
  GaugeTable first_, second_;
};

}  // namespace panicle::bunch
