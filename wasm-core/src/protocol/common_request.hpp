// The blocks that the requests of all models have.
#pragma once

#include <cstdint>
#include <span>

#include "protocol/request.hpp"

namespace panicle {

struct CommonRequest {
  std::uint32_t seed = 1;
  bool meshes = false, measures = false, sky = false;
  bool mesh_fingerprint = false;      // false without meshes
  std::span<const float> parameters;  // in the order of the model's table; NaN or missing: the default
};

// Reads `model`, `seed`, `outputs` and `parameters`. Errors: those of Request::trouble().
CommonRequest read_common(Request& request);

}  // namespace panicle
