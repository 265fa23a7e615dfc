#include "models/leaf/request.hpp"

#include <algorithm>
#include <utility>

#include "models/leaf/messages.generated.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float least_detail = 0.02f, max_detail = 4;

}  // namespace

// Reads the outline, the level of detail, and whether a draft is enough; details out of range are clamped with a note.
Result<LeafRequest> read_request(Request& request, std::vector<std::string>& notes) {
  const CommonRequest common = read_common(request);
  LeafRequest leaf_request{common, Values(common.parameters, notes), {}};
  leaf_request.draft = request.wants("draft");
  const auto rows = request.floats("outline");
  const auto detail = request.floats("detail");
  if (Diagnostic error = request.trouble(); error.reason != Reason::none) return error;
  if (!detail.empty() && detail[0] == detail[0]) {
    leaf_request.detail = std::clamp(detail[0], least_detail, max_detail);
    if (leaf_request.detail != detail[0]) notes.push_back(message(messages::leaf::detail_clamped));
  }
  auto outline = read_outline(rows, notes);
  if (!outline) return outline.error();
  leaf_request.outline = std::move(outline.value());
  return leaf_request;
}

}  // namespace panicle::particles::leaf
