#include "models/leaf/request.hpp"

#include <algorithm>
#include <utility>

namespace panicle::particles::leaf {
namespace {

constexpr float least_detail = 0.02f, most_detail = 4;

}  // namespace

Result<Asked> read_request(Request& request, std::vector<std::string>& notes) {
  request.text("model");
  Asked asked{.values = Values(request.floats("parameters"), notes), .outline = {}};
  asked.seed = request.word("seed", 1);
  asked.meshes = request.wants("meshes");
  asked.measures = request.wants("measures");
  asked.sky = request.wants("sky");
  asked.mesh_fingerprint = request.wants("mesh_fingerprint");
  asked.draft = request.wants("draft");
  const auto rows = request.floats("outline");
  const auto detail = request.floats("detail");
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;
  if (!detail.empty() && detail[0] == detail[0]) {
    asked.detail = std::clamp(detail[0], least_detail, most_detail);
    if (asked.detail != detail[0]) notes.push_back("The detail was brought into its range, 0.02 to 4.");
  }
  auto outline = read_outline(rows, notes);
  if (!outline) return outline.error();
  asked.outline = std::move(outline.value());
  return asked;
}

}  // namespace panicle::particles::leaf
