// The tubes of a bunch's internodes.
#pragma once

#include <span>
#include <vector>

#include "models/bunch/skeleton.hpp"
#include "stems/tubes.hpp"

namespace panicle::bunch {

// The internodes as neutral segments, tagged by their kind.
std::vector<Segment> segments_of(std::span<const Internode> skeleton);

// Sweeps the internodes to a mesh. The rachis (−1) and each first-order axis with its pedicels (Internode::axis) are
// groups. A pedicel widens under its berry; a withered one narrows to its tip. With `natural`, stems taper evenly, and
// their nodes do not swell where they crowd. Positions are in the skeleton's unit times `scale`.
StemMesh sweep_internodes(std::span<const Internode> skeleton, const TubeOptions& options, float scale,
                          bool natural = false);

}  // namespace panicle::bunch
