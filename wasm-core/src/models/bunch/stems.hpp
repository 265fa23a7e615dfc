// The tubes of a bunch's internodes.
#pragma once

#include <span>
#include <vector>

#include "models/bunch/skeleton.hpp"
#include "stems/tubes.hpp"

namespace panicle::bunch {

// The internodes as neutral segments, tagged by their kind.
std::vector<Segment> segments_of(std::span<const Internode> skeleton);

// A group of the mesh for the rachis (−1) and for each first-order axis with its pedicels (Internode::axis). A pedicel
// widens under its berry; a withered one narrows to its tip. Stems that grew `natural` taper evenly, and their nodes do
// not swell where they crowd. Positions come out in the skeleton's unit times `scale`.
StemMesh sweep_internodes(std::span<const Internode> skeleton, const TubeOptions& options, float scale,
                          bool natural = false);

}  // namespace panicle::bunch
