#include "models/particles/boundary.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

namespace panicle::particles {
namespace {

constexpr std::uint32_t sides = 32;
constexpr int pieces = 6;  // of a spline between two points

// A solid of revolution of a profile's heights and radii: 1 is the box's half width and height, 0 its middle and lowest
// point.
Surface turned(std::span<const glm::vec2> profile, const glm::vec3& low, const glm::vec3& high) {
  Surface surface = surface_of_revolution(profile, glm::vec3(0), sides);
  const glm::vec3 foot(0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z));
  const glm::vec3 size(0.5f * (high.x - low.x), high.y - low.y, 0.5f * (high.z - low.z));
  for (glm::vec3& p : surface.points) p = foot + p * size;
  return surface;
}

}  // namespace

Surface form_between(Form form, std::span<const glm::vec2> profile, const Surface& mesh, const glm::vec3& low,
                     const glm::vec3& high) {
  const glm::vec3 middle = 0.5f * (low + high), half = 0.5f * (high - low);
  constexpr std::array<glm::vec2, 2> up{{{1, 0}, {0, 1}}}, down{{{0, 0}, {1, 1}}};
  switch (form) {
    case Form::box:
      return box(low, high);
    case Form::cone:
      return turned(up, low, high);
    case Form::cone_down:
      return turned(down, low, high);
    case Form::bowl: {
      Surface surface = ellipsoid(glm::vec3(middle.x, high.y, middle.z), {half.x, 2 * half.y, half.z}, sides);
      for (glm::vec3& p : surface.points) p.y = std::min(p.y, high.y);
      return surface;
    }
    case Form::spline:
      return turned(profile, low, high);
    case Form::mesh:
      return stretched(mesh, low, high);
    case Form::ellipsoid:
      break;
  }
  return ellipsoid(middle, half, sides);
}

std::vector<glm::vec2> spline_through(std::span<const glm::vec2> points) {
  std::vector<glm::vec2> line;
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

std::vector<glm::vec2> profile_of(std::span<const glm::vec2> points, std::span<const glm::vec2> otherwise) {
  return spline_through(points.size() > 1 ? points : otherwise);
}

void note_on(const Surface& mesh, Form& form, std::vector<std::string>& notes) {
  if (mesh.triangles.empty()) {
    form = Form::ellipsoid;
    notes.push_back("There is no mesh, so the boundary is an ellipsoid; drop a closed mesh.");
    return;
  }
  note_seams(mesh, "mesh", notes);
}

void note_seams(const Surface& mesh, const std::string& name, std::vector<std::string>& notes) {
  const Seams seams = seams_of(mesh);
  if (seams.open > 0)
    notes.push_back("The " + name + " is open at " + std::to_string(seams.open) +
                    " edges; what lies behind a gap may be taken for inside or outside.");
  if (seams.turned > 0)
    notes.push_back("Triangles of the " + name + " are turned against each other at " + std::to_string(seams.turned) +
                    " edges; parts of it may count as holes.");
}

Surface inner_boundary(const Surface& outer, const Surface& own, const glm::vec3& low, const glm::vec3& high,
                       const glm::vec3& about, float size) {
  if (!(size > 0)) return {};
  if (own.triangles.empty()) return scaled(outer, about, size);
  return stretched(own, about + size * (low - about), about + size * (high - about));
}

}  // namespace panicle::particles
