// The request of a leaf.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/leaf/parameters.generated.hpp"
#include "models/leaf/shape/margin.hpp"
#include "protocol/parameter_values.hpp"
#include "protocol/request.hpp"

namespace panicle::particles::leaf {

using Values = panicle::Values<Parameter, parameter_table>;

// Blocks: `model`, `seed`, `outputs` (meshes, measures, sky, mesh_fingerprint; draft: few particles and triangles, for
// as long as something is dragged), `parameters`, `outline` (float32, three to a point: margin.hpp), `detail` (float32:
// triangles of the blade against the default, 0.02 … 4).
struct LeafRequest {
  Values values;
  std::vector<ControlPoint> outline;
  std::uint64_t seed = 1;
  float detail = 1;
  bool meshes = false, measures = false, sky = false, mesh_fingerprint = false, draft = false;
};

// Errors: bad_request; those of read_outline.
Result<LeafRequest> read_request(Request& request, std::vector<std::string>& notes);

}  // namespace panicle::particles::leaf
