#include "spatial/query_budget.hpp"

#include <string>

namespace panicle {

Diagnostic QueryBudget::error() {
  return {Reason::limit,
          "The mesh has too many triangles behind each other to find out what is inside it; simplify the mesh, or let "
          "fewer things grow in it.",
          0, 0};
}

std::optional<Diagnostic> too_many_triangles(std::size_t triangles, const Limits& limits) {
  if (triangles <= limits.triangles) return {};
  return Diagnostic{Reason::limit,
                    "The meshes have " + std::to_string(triangles) + " triangles, more than " +
                        std::to_string(limits.triangles) + "; simplify them.",
                    0, 0};
}

}  // namespace panicle
