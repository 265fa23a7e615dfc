// Triangulates any closed polyline in space, such as the path of a turtle, which may cross itself, return to a point,
// and lie in no plane.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/work_budget.hpp"

namespace panicle {

// Triangles, three indices of corners each, by clipping ears (Meisters 1975) in the plane that shows most of the
// polygon; seen against its normal they go counter-clockwise. None has two corners at one place or all on a line. A
// polygon that does not cross itself in that plane is filled exactly; of one that does, each of its corners gets its
// ear all the same. Corners that are not finite are passed over. Empty: fewer than three different corners are left, or
// all lie on a line. The looks for corners in an ear are counted as work where there is a budget; where they are too
// many, or the budget is used up, ears are taken as they come.
std::vector<std::uint32_t> fill_polygon(std::span<const glm::vec3> corners, WorkBudget* budget = nullptr);

}  // namespace panicle
