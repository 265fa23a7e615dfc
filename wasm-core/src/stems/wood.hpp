// The wood of a tree or a root as a mesh.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "stems/root_flare.hpp"
#include "stems/segment.hpp"
#include "stems/tubes.hpp"

namespace panicle {

// Sweeps branches as smooth tubes, and twigs as plain ones. `axes`: of each segment the axis that it belongs to; those
// of one are one tube. `targets`: the bases of trunks on the ground, or of hanging roots; `flare` shapes them.
StemMesh sweep_wood(std::span<const Segment> segments, std::span<const std::int32_t> axes,
                    std::span<const glm::vec3> targets, const RootFlareOptions& flare);

}  // namespace panicle
