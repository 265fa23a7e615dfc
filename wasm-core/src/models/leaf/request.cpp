#include "models/leaf/request.hpp"

#include <algorithm>
#include <utility>

namespace panicle::particles::leaf {
namespace {

constexpr float least_detail = 0.02f, most_detail = 4;

}  // namespace

Result<LeafRequest> read_request(Request& request, std::vector<std::string>& notes) {
  request.text("model");
  LeafRequest leaf_request{.values = Values(request.floats("parameters"), notes), .outline = {}};
  leaf_request.seed = request.word("seed", 1);
  leaf_request.meshes = request.wants("meshes");
  leaf_request.measures = request.wants("measures");
  leaf_request.sky = request.wants("sky");
  leaf_request.mesh_fingerprint = request.wants("mesh_fingerprint");
  leaf_request.draft = request.wants("draft");
  const auto rows = request.floats("outline");
  const auto detail = request.floats("detail");
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;
  if (!detail.empty() && detail[0] == detail[0]) {
    leaf_request.detail = std::clamp(detail[0], least_detail, most_detail);
    if (leaf_request.detail != detail[0]) notes.push_back("The detail was brought into its range, 0.02 to 4.");
  }
  auto outline = read_outline(rows, notes);
  if (!outline) return outline.error();
  leaf_request.outline = std::move(outline.value());
  return leaf_request;
}

}  // namespace panicle::particles::leaf
