// grow(request) → grown bunch. No files, no clock, no state: the same request gives the same bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "lsystem/trace/derivation_trace.hpp"
#include "models/bunch/foliage/leaf.hpp"
#include "models/bunch/grown.hpp"

namespace panicle::bunch {

struct BunchRequest {
  std::uint32_t seed = 1;
  std::vector<float> parameters;                    // in the order of parameter_table; NaN or missing: the default
  std::int32_t m = 0;                               // rachis segments in place of the profile's; 0: from the profile
  std::vector<std::int32_t> n;                      // n₁ … n₍m−1₎ in place of the profile's; empty: from the profile
  std::string_view grammar;                         // empty: the procedure's own
  std::shared_ptr<const lsystem::Program> program;  // that text compiled, with lineages; null: compiled here
  std::optional<std::uint32_t> steps;               // of the derivation, in place of the text's own
  std::vector<std::uint32_t> thinned;               // ids of berries removed by hand
  std::optional<lsystem::TraceRequest> trace;       // the step of the first bunch's derivation to trace
  FlatLeaf leaf;                                    // shape of the leaves on the cane
  bool meshes = true;
  bool measures = true;
  bool sky = false;                  // of the meshes' vertices, where meshes are requested
  bool mesh_fingerprint = false;     // of the meshes, where they are requested
  std::uint32_t stem_sides = 0;      // 0: default
  std::uint32_t berry_segments = 0;  // 0: default
};

// Parameters out of range are clamped with a note; a grammar that cannot be used is an error with line and column.
Result<GrownBunch> grow(const BunchRequest& request, const Limits& limits = {});

}  // namespace panicle::bunch
