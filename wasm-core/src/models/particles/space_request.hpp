// The shared part of requests of a tree and of a root: outputs, and inputs besides the parameters.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/obstacles.hpp"
#include "protocol/common_request.hpp"
#include "spatial/solid.hpp"

namespace panicle::particles {

// Blocks: `profile` (float32, pairs of radius and height: 1 is half the width and the whole height of the boundary),
// `volume.points` (float32, triples) and `volume.triangles` (uint32, triples) of a dropped mesh, `targets` (float32,
// triples in metres), `hollow.points` and `hollow.triangles` likewise of a mesh that is the inner boundary, `obstacles`
// and `obstacles.round` (float32, six each in metres: the low and the high corner of a box, and of one that an
// ellipsoid fills: another tree's crown, which shades as one); and the blocks of every request.
struct SpaceRequest : CommonRequest {
  static constexpr std::size_t max_targets = 256;

  explicit SpaceRequest(const CommonRequest& common) : CommonRequest(common) {}

  bool light = false;
  std::vector<glm::vec2> profile;
  Surface volume, hollow;
  std::vector<glm::vec3> targets;
  std::vector<Box> obstacles, rounds;
};

// Errors: bad_request, for blocks of another form; bad_input, for numbers that are not finite or beyond 10 km, corners
// that are none of the mesh's points, more targets or obstacles than allowed; limit, for too many triangles.
Result<SpaceRequest> read_space(Request& request, const Limits& limits);

}  // namespace panicle::particles
