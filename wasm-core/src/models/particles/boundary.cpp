#include "models/particles/boundary.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "models/particles/messages.generated.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint32_t sides = 32;
constexpr int pieces = 6;  // of a spline between two points

// Revolves a profile about a vertical axis into the box from `low` to `high`. Radii (x) of 1 reach its sides, heights
// (y) run from 0 at its bottom to 1 at its top.
Surface revolved_into_box(std::span<const glm::vec2> profile, const glm::vec3& low, const glm::vec3& high) {
  Surface surface = surface_of_revolution(profile, glm::vec3(0), sides);
  const glm::vec3 foot(0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z));
  const glm::vec3 size(0.5f * (high.x - low.x), high.y - low.y, 0.5f * (high.z - low.z));
  for (glm::vec3& p : surface.points) p = foot + p * size;
  return surface;
}

}  // namespace

// Builds a boundary of the given form that fills the box from `low` to `high`. `profile` is used by Form::spline,
// `mesh` by Form::mesh.
Surface form_between(Form form, std::span<const glm::vec2> profile, const Surface& mesh, const glm::vec3& low,
                     const glm::vec3& high) {
  const glm::vec3 middle = 0.5f * (low + high), half = 0.5f * (high - low);
  constexpr std::array<glm::vec2, 2> up{{{1, 0}, {0, 1}}}, down{{{0, 0}, {1, 1}}};
  switch (form) {
    case Form::box:
      return box(low, high);
    case Form::cone:
      return revolved_into_box(up, low, high);
    case Form::cone_down:
      return revolved_into_box(down, low, high);
    case Form::bowl: {
      Surface surface = ellipsoid(glm::vec3(middle.x, high.y, middle.z), {half.x, 2 * half.y, half.z}, sides);
      for (glm::vec3& p : surface.points) p.y = std::min(p.y, high.y);
      return surface;
    }
    case Form::spline:
      return revolved_into_box(profile, low, high);
    case Form::mesh:
      return stretched(mesh, low, high);
    case Form::ellipsoid:
      break;
  }
  return ellipsoid(middle, half, sides);
}

// Samples a Catmull-Rom spline through the points: six pieces between two points; the first and the last point are
// repeated as neighbours, and x is clamped to 0 or more.
std::vector<glm::vec2> spline_through(std::span<const glm::vec2> points) {
  std::vector<glm::vec2> line;
  // The point i + by, or the first or last one beyond the ends.
  const auto at = [&](std::size_t i, int by) {
    const auto last = static_cast<std::int64_t>(points.size()) - 1;
    return points[static_cast<std::size_t>(std::clamp<std::int64_t>(static_cast<std::int64_t>(i) + by, 0, last))];
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::vec2 a = at(i, -1), b = at(i, 0), c = at(i, 1), d = at(i, 2);
    for (int k = 0; k < pieces; ++k) {
      const float t = static_cast<float>(k) / pieces;
      line.push_back(
          0.5f * (2.0f * b + t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)))));
    }
  }
  if (!points.empty()) line.push_back(points.back());
  for (glm::vec2& p : line) p.x = std::max(p.x, 0.0f);
  return line;
}

// A smooth profile through `points`, or through `otherwise` if there are fewer than two.
std::vector<glm::vec2> profile_of(std::span<const glm::vec2> points, std::span<const glm::vec2> otherwise) {
  return spline_through(points.size() > 1 ? points : otherwise);
}

// Adds notes on a mesh that shall be the outer boundary: if it has no triangles, replaces the form by an ellipsoid and
// notes that; else notes its seams.
void note_on(const Surface& mesh, Form& form, std::vector<std::string>& notes) {
  if (mesh.triangles.empty()) {
    form = Form::ellipsoid;
    notes.push_back(message(messages::particles::no_mesh));
    return;
  }
  note_seams(mesh, "outer", notes);
}

// Adds notes on open edges and on triangles that are turned the wrong way. `boundary`, "outer" or "inner", is the
// mesh's name in the messages.
void note_seams(const Surface& mesh, const char* boundary, std::vector<std::string>& notes) {
  const Seams seams = seams_of(mesh);
  if (seams.open > 0) notes.push_back(message(messages::particles::mesh_open, boundary, seams.open));
  if (seams.turned > 0) notes.push_back(message(messages::particles::mesh_inconsistent, boundary, seams.turned));
}

// Builds the boundary of the hollow: the mesh `own` in the box `low` … `high`, or the outer boundary if `own` is empty,
// scaled by `size` about the point `about`. Empty for size 0.
Surface inner_boundary(const Surface& outer, const Surface& own, const glm::vec3& low, const glm::vec3& high,
                       const glm::vec3& about, float size) {
  if (!(size > 0)) return {};
  if (own.triangles.empty()) return scaled(outer, about, size);
  return stretched(own, about + size * (low - about), about + size * (high - about));
}

}  // namespace panicle::particles
