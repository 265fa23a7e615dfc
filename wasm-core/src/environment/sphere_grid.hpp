// The structure a newborn internode feels: the spheres accepted so far, on a uniform grid (paper section 4.3.2).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace panicle {

struct Sphere {
  glm::vec3 centre{0};
  float radius = 0;
};

// Result of probing with one sphere.
struct Push {
  std::uint32_t contacts = 0;  // n: how many accepted spheres it overlaps
  glm::vec3 force{0};          // F = (1/n) Σ v_j d_j / R, R the probe's diameter (equation 1)
};

class SphereGrid {
 public:
  // `largest` bounds the radius of every sphere that will be added; cells are sized from it.
  explicit SphereGrid(float largest);

  // Adds a sphere and returns its id (0, 1, …).
  std::uint32_t add(const Sphere& sphere);

  // All overlaps of `probe` with the structure, but for the sphere `except` (none: no_sphere). Spheres that only
  // touch do not overlap; a clearance of 1e−5 of the sum of radii keeps them apart after rounding. Summed in the order of ids, so the
  // answer does not hang on the grid. A centre on top of the probe's pushes along `tie`, a unit vector.
  Push probe(const Sphere& probe, std::uint32_t except, const glm::vec3& tie) const;

  std::span<const Sphere> spheres() const;

  static constexpr std::uint32_t no_sphere = 0xffffffffu;

  // Layout below is the implementation's own.
};

}  // namespace panicle
