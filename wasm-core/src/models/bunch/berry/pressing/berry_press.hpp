// Presses one berry against the planes between it and its neighbours, at constant volume.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/berry/berry_gauge.hpp"
#include "models/bunch/berry/berry_pattern.hpp"
#include "models/bunch/berry/pressing/berry_contacts.hpp"

namespace panicle::bunch {

// Presses one berry after the other, all in unit space: the surface in direction e lies at 1 / gauge(e), where the
// gauge is the soft maximum of the free surface's over a bulge and of those of the planes. It is never less than any of
// these, so that every vertex stays on its own side of every plane.
class BerryPress {
 public:
  static constexpr float max_bulge = 1.25f;  // how much further than its free form a berry may bulge

  explicit BerryPress(const BerryPattern& pattern);

  // Fits a berry between its planes so that its triangles hold `volume`, or as near to that as they allow. Holds a
  // reference to `free` until `write`. Returns the share of `volume` that is missing.
  float fit(const GaugeTable& free, std::span<const BerryPlane> planes, float volume);

  // Writes the berry last fitted, in world space: as many vertices as the pattern has.
  void write(const BerryFrame& frame, float* positions, float* normals, std::uint8_t* pressed) const;

 private:
  struct Volume {
    float value, slope;  // and its derivative by the logarithm of the bulge
  };

  void write_four(const BerryFrame& frame, std::size_t i, float* positions, float* normals,
                  std::uint8_t* pressed) const;
  void clip(std::span<const BerryPlane> planes);
  float bulge_to(float volume);
  Volume rough_volume();
  float exact_volume() const;

  const BerryPattern& pattern_;
  const GaugeTable* free_ = nullptr;
  GaugeTable planes_;
  std::vector<float> soft_;  // radius of the rim that a vertex may lie on
  std::vector<float> radius_;
  float nearest_ = 0, bulge_ = 1;
};

}  // namespace panicle::bunch
