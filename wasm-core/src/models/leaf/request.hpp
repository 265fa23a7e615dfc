// The request of a leaf.
#pragma once

#include <string>
#include <vector>

#include "models/leaf/parameters.generated.hpp"
#include "models/leaf/shape/margin.hpp"
#include "protocol/common_request.hpp"
#include "protocol/parameter_values.hpp"

namespace panicle::particles::leaf {

using Values = panicle::Values<Parameter, parameter_table>;

// Blocks besides those of all models: the output `draft` (few particles and triangles, for as long as something is
// dragged), `outline` (float32, three to a point: margin.hpp), `detail` (float32: triangles of the blade against the
// default, 0.02 … 4).
struct LeafRequest : CommonRequest {
  Values values;
  std::vector<ControlPoint> outline;
  float detail = 1;
  bool draft = false;
};

// Errors: bad_request; those of read_outline.
Result<LeafRequest> read_request(Request& request, std::vector<std::string>& notes);

}  // namespace panicle::particles::leaf
