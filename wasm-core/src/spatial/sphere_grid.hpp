// A uniform grid of the spheres accepted so far, for overlap tests of a newborn internode (paper section 4.3.2).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/lanes.hpp"
#include "spatial/sphere.hpp"

namespace panicle {

// Result of probing with one sphere.
struct Push {
  std::uint32_t contacts = 0;  // n: how many accepted spheres it overlaps
  glm::vec3 force{0};          // F = (1/n) Σ v_j d_j / R, R the probe's diameter (equation 1)
};

// Growing probes far oftener than it adds (up to 50 times to 1). So each cell lists every sphere that a probe centred
// anywhere in that cell could touch: a probe then reads one list, and the work of visiting neighbours is done once, by
// add.
class SphereGrid {
 public:
  // `largest` is the radius that spheres and probes hardly ever exceed; cells are sized from it. Larger ones are right
  // too but slow: such a probe tests every sphere, adding such a sphere may rebuild the grid.
  explicit SphereGrid(float largest);

  // Adds a sphere and returns its id (0, 1, …). One that is not finite or whose radius is negative is refused:
  // no_sphere.
  std::uint32_t add(const Sphere& sphere);

  // Sums up all overlaps of `probe` with the structure, but for the sphere `except` (none: no_sphere). Two spheres
  // overlap when their centres are nearer than 1 + 1e−5 times the sum of their radii; the clearance keeps those
  // accepted apart after rounding. Summed in the order of ids, so the result does not depend on the grid. A sphere
  // whose centre is that of the probe pushes along `tie`, a unit vector. A depth counts for a million diameters at
  // most, so that a point is pushed too. A probe that is not finite touches nothing.
  Push probe(const Sphere& probe, std::uint32_t except, const glm::vec3& tie) const;

  std::span<const Sphere> spheres() const { return spheres_; }

  static constexpr std::uint32_t no_sphere = 0xffffffffu;

 private:
  struct Key {
    std::int32_t x, y, z;
    bool operator==(const Key&) const = default;
  };
  // A place in the hash table: empty while capacity is 0.
  struct Cell {
    Key key{0, 0, 0};
    std::uint32_t first = 0, count = 0, capacity = 0;  // of its list within lists_
  };

  // Spheres side by side, for arithmetic on several at once.
  static constexpr std::uint32_t lanes = 4;
  struct Group {
    Four x, y, z, radius;
  };
  // The surroundings of the last probe, valid for any probe between low and high. The tries of one newborn stay in one
  // neighbourhood.
  struct Nearby {
    glm::dvec3 low{0}, high{0};
    std::vector<std::uint32_t> ids;
    std::vector<Group> groups;

    // Makes the box empty.
    void forget() { high = low; }
    // Whether the box contains a point.
    bool around(const glm::dvec3& p) const {
      return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y && p.z >= low.z && p.z < high.z;
    }
  };

  void size_cells(float largest);
  std::int32_t cell_of(double coordinate) const;
  double lower_end(std::int32_t cell) const;
  std::size_t slot_of(const Key& key) const;
  void enlist(std::uint32_t id);
  void append(const Key& key, std::uint32_t id);
  void grow_table();
  void gather(const glm::vec3& centre) const;

  float largest_ = 0;
  double edge_ = 1, per_edge_ = 1;
  std::vector<Sphere> spheres_;
  std::vector<Cell> table_;  // open addressing, a power of two long
  std::size_t occupied_ = 0;
  std::vector<std::uint32_t> lists_;  // ids, each cell's in ascending order
  mutable Nearby nearby_;             // remembers, changes no answer; one thread at a time
};

}  // namespace panicle
