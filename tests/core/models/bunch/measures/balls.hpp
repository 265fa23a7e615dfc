// Bunches of balls and outlines of plain shape, whose measures follow from geometry.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "foundation/random.hpp"
#include "models/bunch/measures/measures.generated.hpp"
#include "models/bunch/measures/measures.hpp"

namespace panicle::bunch {

inline float uniform(std::uint64_t k) { return static_cast<float>(hash_combine(3, k) >> 40) / 16777216.0f; }

// A bunch of balls, in millimetres; no stems.
inline GrownBunch balls(const std::vector<glm::vec3>& centres, float radius) {
  GrownBunch grown;
  for (const glm::vec3& centre : centres) {
    grown.berries.push_back({centre / 1000.0f, radius / 1000, {0, -1, 0}, -1, 0});
    grown.traits.push_back({2 * radius / 1000, 2 * radius / 1000});
  }
  return grown;
}

// As wide as it is deep, straight down from the top, its tip rounded.
inline Envelope block(float half_width, float length) {
  Profile profile{length, {}};
  profile.sides.fill({half_width, 0});
  return Envelope(profile, 1, half_width);
}

inline Envelope spindle(float half_width, float length, float pixel = 1) {
  Profile profile{length, {}};
  profile.sides.fill({half_width, length / 4});
  return Envelope(profile, pixel, pixel * half_width / 4);
}

inline std::vector<HungEnvelope> hung(const Envelope& envelope, float lean = 0) { return {{envelope, lean}}; }

// Points of a cubic lattice that are `inside`.
template <typename Inside>
std::vector<glm::vec3> lattice(float spacing, Inside inside) {
  std::vector<glm::vec3> places;
  for (int x = -10; x <= 10; ++x)
    for (int y = 0; y >= -24; --y)
      for (int z = -10; z <= 10; ++z) {
        const glm::vec3 place = spacing * (glm::vec3(x, y, z) - glm::vec3(0, 0.5f, 0));
        if (inside(place)) places.push_back(place);
      }
  return places;
}

// Sections of quarter ellipses, as the outline's own.
inline auto within(const Envelope& envelope) {
  return [&envelope](const glm::vec3& p) {
    const float x = p.x / envelope.half_width(p.x > 0 ? 0 : 1, -p.y);
    const float z = p.z / envelope.half_width(p.z > 0 ? 2 : 3, -p.y);
    return x * x + z * z <= 1;
  };
}

struct Measured {
  Measured(const GrownBunch& grown, const std::vector<HungEnvelope>& envelopes) : values(measure(grown, envelopes)) {
    REQUIRE(values.size() == measure_count);
  }
  float operator[](Measure key) const { return values[static_cast<std::size_t>(key)]; }
  std::vector<float> values;
};

inline doctest::Approx about(double value, double share = 0.01) { return doctest::Approx(value).epsilon(share); }

}  // namespace panicle::bunch
