// Particles against alternatives with the same result: a search for neighbours that compares all pairs, and a tree by
// space colonisation of as many points.
#pragma once

#include <cstdint>

namespace panicle::bench {

// So many particles of blue noise in a disc (flat) or a ball, run to a target below it; work: merges.
double run_crowd(std::uint32_t particles, bool flat);

// The same steps (section 2.1 of the paper), each particle looking at every other; without trails. Work: merges.
double run_brute_crowd(std::uint32_t particles, bool flat);

// Runions et al. 2007, "Modeling trees with a space colonization algorithm": buds grow towards the attraction points
// that are nearest to them, until each point is reached or out of reach; as many points, in the same disc or ball.
// Work: nodes.
double colonise(std::uint32_t points, bool flat);

}  // namespace panicle::bench
