// Generalized maps: the cost of building one, of checking it, and of placing its vertices.
#pragma once

#include <cstdint>

namespace panicle::bench {

// A vein of order 8 with six lateral prisms a step, each glued to the one of the step before, up to so many darts, from
// nothing; work: darts.
double build_map(std::uint32_t darts);

// Of a map made so before the clock starts. Work: darts; negative where the map is not whole.
double check_map(std::uint32_t darts);
double embed_map(std::uint32_t darts);  // its vertices numbered and its volumes put in order
double place_map(std::uint32_t darts);  // places all vertices by shapes, after embed_map

}  // namespace panicle::bench
