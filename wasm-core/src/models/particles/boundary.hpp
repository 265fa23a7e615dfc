// The boundary of a tree or a root (Rodkaew et al. 2003, section 4.1): a form stretched to a box.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "spatial/solid.hpp"

namespace panicle::particles {

enum class Form : std::uint32_t { ellipsoid, box, cone, cone_down, bowl, spline, mesh };

// The form with `low` and `high` as its box; a bowl is widest at the top. `profile`: of a spline, the result of
// `spline_through`. `mesh`: of a mesh, in any unit.
Surface form_between(Form form, std::span<const glm::vec2> profile, const Surface& mesh, const glm::vec3& low,
                     const glm::vec3& high);

// A smooth line through points (radius, height), for a profile: Catmull–Rom, radii never below 0.
std::vector<glm::vec2> spline_through(std::span<const glm::vec2> points);

// The line through the given points, or through `otherwise` if there are fewer than two.
std::vector<glm::vec2> profile_of(std::span<const glm::vec2> points, std::span<const glm::vec2> otherwise);

// The inner boundary: the outer boundary scaled by `size` about the place `about`; or, where `own` has triangles, that
// mesh (in any unit) stretched to the scaled box of the outer boundary. `low` and `high`: the unscaled box. Empty where
// `size` is 0.
Surface inner_boundary(const Surface& outer, const Surface& own, const glm::vec3& low, const glm::vec3& high,
                       const glm::vec3& about, float size);

// Adds a note for the gaps of a boundary's mesh, and one for triangles turned against each other. `boundary`: "outer"
// or "inner", as the notes select it.
void note_seams(const Surface& mesh, const char* boundary, std::vector<std::string>& notes);

// Adds notes about a dropped mesh, one sentence each: gaps, sides turned against each other. Without a mesh, the form
// becomes an ellipsoid.
void note_on(const Surface& mesh, Form& form, std::vector<std::string>& notes);

}  // namespace panicle::particles
