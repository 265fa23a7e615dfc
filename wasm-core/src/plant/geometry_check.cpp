#include "plant/geometry_check.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "foundation/bits.hpp"
#include "plant/messages.generated.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t exponent = 0x7f800000;

// Whether a number is neither infinite nor NaN: its exponent's bits are not all 1.
bool is_finite(float value) { return (bit_cast<std::uint32_t>(value) & exponent) != exponent; }
// The same for all three coordinates.
bool is_finite(const glm::vec3& p) { return is_finite(p.x) && is_finite(p.y) && is_finite(p.z); }

// The index of the first that is not finite; the number of all where there is none.
std::size_t first_not_finite(std::span<const float> values) {
  constexpr std::size_t chunk = 1024;
  for (std::size_t i = 0; i < values.size(); i += chunk) {
    const auto part = values.subspan(i, std::min(chunk, values.size() - i));
    std::uint32_t found = 0;
    for (const float value : part) found |= (bit_cast<std::uint32_t>(value) & exponent) == exponent;
    for (std::size_t k = 0; found && k < part.size(); ++k)
      if (!is_finite(part[k])) return i + k;
  }
  return values.size();
}

// Numbers in rows of `width`.
struct Rows {
  std::span<const float> values;
  std::size_t width;
};

// The error for geometry that is not finite.
Diagnostic not_finite_error(const Message& why) { return {Reason::evaluation, why}; }

// Names the part of a mesh that a vertex belongs to; the mesh itself where it has no parts.
Message vertex_not_finite(const PlantMesh& mesh, std::size_t vertex) {
  for (const MeshRun& run : mesh.runs)
    if (vertex >= run.first_vertex && vertex - run.first_vertex < run.vertex_count)
      return message(messages::plant::mesh_part_not_finite, run.name, mesh.name);
  return message(messages::plant::mesh_not_finite, mesh.name);
}

// Whether a column holds places or directions, by the end of its name.
bool holds_places(std::string_view column) {
  for (const std::string_view ending : {"spheres", "places", "positions", "normals"})
    if (column.ends_with(ending)) return true;
  return false;
}

}  // namespace

// Checks that all coordinates of a plant are finite; an error for the first that is not.
Diagnostic check_geometry(const Plant& plant) {
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const Segment& segment = plant.segments[i];
    if (!is_finite(segment.start) || !is_finite(segment.end) || !is_finite(segment.radius) ||
        !is_finite(segment.radius_end))
      return not_finite_error(message(messages::plant::segment_not_finite, i + 1));
  }
  for (std::size_t i = 0; i < plant.organs.size(); ++i) {
    const Organ& organ = plant.organs[i];
    const glm::vec4& turn = organ.rotation;
    if (!is_finite(organ.position) || !is_finite(organ.scale) || !is_finite(turn.w) || !is_finite(glm::vec3(turn)))
      return not_finite_error(message(messages::plant::organ_not_finite, i + 1));
  }
  for (const PlantMesh& mesh : plant.meshes) {
    const Mesh& all = mesh.mesh;
    for (const auto& [values, width] : {Rows{all.positions, 3}, Rows{all.normals, 3}, Rows{all.uvs, 2}})
      if (const std::size_t at = first_not_finite(values); at < values.size())
        return not_finite_error(vertex_not_finite(mesh, at / width));
  }
  for (std::size_t i = 0; i < plant.columns.size(); ++i) {
    const ColumnView column = plant.columns[i];
    const std::span<const float> values = column.as<float>();
    if (holds_places(column.name) && first_not_finite(values) < values.size())
      return not_finite_error(message(messages::plant::column_not_finite, column.name));
  }
  return {};
}

}  // namespace panicle
