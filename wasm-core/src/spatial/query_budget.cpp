#include "spatial/query_budget.hpp"

#include "spatial/messages.generated.hpp"

namespace panicle {

// The error of a query that used up its budget.
Diagnostic QueryBudget::error() { return {Reason::limit, message(messages::spatial::mesh_too_deep)}; }

// The error if there are more triangles than the limits allow; none otherwise.
std::optional<Diagnostic> too_many_triangles(std::size_t triangles, const Limits& limits) {
  if (triangles <= limits.triangles) return {};
  return Diagnostic{Reason::limit, message(messages::spatial::too_many_triangles, triangles, limits.triangles)};
}

}  // namespace panicle
