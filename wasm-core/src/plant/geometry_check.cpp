#include "plant/geometry_check.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "foundation/bits.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t exponent = 0x7f800000;

bool is_finite(float value) { return (bit_cast<std::uint32_t>(value) & exponent) != exponent; }
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

struct Rows {
  std::span<const float> values;
  std::size_t width;
};

Diagnostic refused(const std::string& what) {
  return {Reason::evaluation, what + " has numbers that are not finite, and cannot be drawn; make sizes smaller.", 0,
          0};
}

std::string named(const char* kind, std::size_t number, const std::vector<std::string>& tags, std::uint32_t tag) {
  std::string name = kind + std::to_string(number + 1);
  if (tag < tags.size()) name += " (" + tags[tag] + ")";
  return name;
}

// The part of a mesh that a vertex belongs to; the mesh itself where it has no parts.
std::string part_of(const PlantMesh& mesh, std::size_t vertex) {
  for (const MeshRun& run : mesh.runs)
    if (vertex >= run.first_vertex && vertex - run.first_vertex < run.vertex_count)
      return "“" + run.name + "” of the mesh “" + mesh.name + "”";
  return "The mesh “" + mesh.name + "”";
}

bool holds_places(std::string_view column) {
  for (const std::string_view ending : {"spheres", "places", "positions", "normals"})
    if (column.ends_with(ending)) return true;
  return false;
}

}  // namespace

Diagnostic check_geometry(const Plant& plant) {
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const Segment& segment = plant.segments[i];
    if (!is_finite(segment.start) || !is_finite(segment.end) || !is_finite(segment.radius) ||
        !is_finite(segment.radius_end))
      return refused(named("Segment ", i, plant.tags, segment.tag));
  }
  for (std::size_t i = 0; i < plant.organs.size(); ++i) {
    const Organ& organ = plant.organs[i];
    const glm::vec4& turn = organ.rotation;
    if (!is_finite(organ.position) || !is_finite(organ.scale) || !is_finite(turn.w) || !is_finite(glm::vec3(turn)))
      return refused(named("Organ ", i, plant.organ_tags, organ.tag));
  }
  for (const PlantMesh& mesh : plant.meshes) {
    const Mesh& all = mesh.mesh;
    for (const auto& [values, width] : {Rows{all.positions, 3}, Rows{all.normals, 3}, Rows{all.uvs, 2}})
      if (const std::size_t at = first_not_finite(values); at < values.size())
        return refused(part_of(mesh, at / width));
  }
  for (std::size_t i = 0; i < plant.columns.size(); ++i) {
    const ColumnView column = plant.columns[i];
    const std::span<const float> values = column.as<float>();
    if (holds_places(column.name) && first_not_finite(values) < values.size())
      return refused("The column “" + std::string(column.name) + "”");
  }
  return {};
}

}  // namespace panicle
