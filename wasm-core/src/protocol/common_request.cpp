#include "protocol/common_request.hpp"

namespace panicle {

// Reads the blocks that all models have in common.
CommonRequest read_common(Request& request) {
  CommonRequest common;
  request.text("model");
  common.seed = request.word("seed", common.seed);
  common.meshes = request.wants("meshes");
  common.measures = request.wants("measures");
  common.sky = request.wants("sky");
  common.mesh_fingerprint = common.meshes && request.wants("mesh_fingerprint");
  common.parameters = request.floats("parameters");
  return common;
}

}  // namespace panicle
