// The properties of a berry besides its place, at an age.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/bunch/berry/berry_body.hpp"
#include "models/bunch/grown.hpp"
#include "models/bunch/natural/flowers.hpp"
#include "models/bunch/natural/ripening.hpp"

namespace panicle::bunch {

// The inputs of one berry's traits.
struct RipeningInputs {
  BerryBody body;      // millimetres
  float along = 0;     // 0 at the base … 1 at the tip of the bunch
  float exposure = 0;  // 0 … 1
  bool sets = true;    // false: a flower that will not set
};

struct Season {
  float age = 100;     // percent
  float sunlight = 0;  // 0 … 1: how much exposure counts
  float vigour = 1;    // 0 … 1
  float seeds = 4;     // most seeds of a berry
};

Traits traits_of(const RipeningInputs& berry, const Flower& flower, const Season& season, std::uint64_t seed);

}  // namespace panicle::bunch
