#include "models/flower/level.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <string_view>
#include <utility>

#include "foundation/bytes.hpp"
#include "mesh/normals.hpp"
#include "models/flower/skin.hpp"
#include "models/flower/units.hpp"

namespace panicle::flower {
namespace {

constexpr float crease = -0.25f;  // the cosine between two normals that are not smoothed into one

// The index of a kind of material in the order of runs.
std::size_t place_of(std::string_view kind) {
  return static_cast<std::size_t>(std::find(material_kinds.begin(), material_kinds.end(), kind) -
                                  material_kinds.begin());
}

}  // namespace

// Builds a level of detail from the triangles that remain of the boundary; `places` are the boundary's vertices.
Level::Level(RemainingTriangles remains, const std::vector<glm::vec3>& places)
    : volumes_(std::move(remains.volumes)), wide_(std::move(remains.wide)) {
  split_at_edges(remains.vertices, places);
}

// Gives each triangle the vertices of the smooth surface at its corners: one for each vertex of the boundary, and
// further ones where the normal of a triangle differs too much from the sum of those that share the vertex so far.
void Level::split_at_edges(const std::vector<std::uint32_t>& vertices, const std::vector<glm::vec3>& places) {
  std::vector<glm::vec3> normals;  // of `smooth_`, sums
  // Linked lists of the smooth vertices at each vertex of the boundary.
  std::vector<std::uint32_t> first(places.size(), invalid), next;
  for (std::size_t t = 0; t < vertices.size(); t += 3) {
    const glm::vec3 normal = triangle_normal(places[vertices[t]], places[vertices[t + 1]], places[vertices[t + 2]]);
    const float length = glm::length(normal);
    for (std::size_t i = t; i < t + 3; ++i) {
      std::uint32_t* side = &first[vertices[i]];
      while (*side != invalid && glm::dot(normals[*side], normal) < crease * glm::length(normals[*side]) * length)
        side = &next[*side];
      if (*side == invalid) {
        *side = static_cast<std::uint32_t>(smooth_.size());
        corners_.push_back(*side);
        smooth_.push_back(vertices[i]);
        normals.push_back(normal);
        // `side` may be invalid after this, since `next` grows.
        next.push_back(invalid);
      } else {
        normals[*side] += normal;
        corners_.push_back(*side);
      }
    }
  }
}

// Assigns materials: sorts the triangles into runs by kind, with vertices of their own. `numbers` are the materials by
// volume.
void Level::dress(const Program& program, const std::vector<std::uint8_t>& numbers) {
  std::array<std::size_t, 256> kind{};
  for (std::uint32_t number = 0; number < kind.size(); ++number)
    kind[number] = place_of(material_of(program, number).kind);
  std::array<std::vector<std::uint32_t>, material_kinds.size()> triangles;
  for (std::uint32_t t = 0; t < volumes_.size(); ++t) triangles[kind[numbers[volumes_[t]]]].push_back(t);
  runs_.clear();
  indices_.clear();
  drawn_.clear();
  number_.clear();
  // Linked lists of the vertices of each smooth vertex, one for each material.
  std::vector<std::uint32_t> first(smooth_.size(), invalid), next;
  for (std::size_t k = 0; k < material_kinds.size(); ++k) {
    if (triangles[k].empty()) continue;
    MeshRun run;
    run.name = material_kinds[k];
    run.first_vertex = static_cast<std::uint32_t>(drawn_.size());
    run.first_index = static_cast<std::uint32_t>(indices_.size());
    for (const std::uint32_t t : triangles[k])
      for (std::size_t i = 3 * std::size_t{t}; i < 3 * std::size_t{t} + 3; ++i) {
        const std::uint8_t number = numbers[volumes_[t]];
        std::uint32_t vertex = first[corners_[i]], last = invalid;
        while (vertex != invalid && number_[vertex] != number) vertex = next[last = vertex];
        if (vertex == invalid) {
          vertex = static_cast<std::uint32_t>(drawn_.size());
          (last == invalid ? first[corners_[i]] : next[last]) = vertex;
          next.push_back(invalid);
          drawn_.push_back(corners_[i]);
          number_.push_back(number);
        }
        indices_.push_back(vertex);
      }
    run.vertex_count = static_cast<std::uint32_t>(drawn_.size()) - run.first_vertex;
    run.index_count = static_cast<std::uint32_t>(indices_.size()) - run.first_index;
    runs_.push_back(std::move(run));
  }
}

// Widens organs that stand for several: moves their vertices away from the axis between foot and tip, by a factor for
// each organ.
void Level::widen(const OrganForms& organs, std::vector<glm::vec3>& places) const {
  for (const auto& [organ, times] : wide_) {
    const FormedOrgan& formed = organs.organs()[organ];
    const OrganForm& form = organs.form(formed);
    const std::uint32_t* const own_vertices = organs.vertices(formed);
    glm::vec3 foot(0);
    float foot_count = 0;
    for (std::size_t v = 0; v < form.is_foot.size(); ++v)
      if (form.is_foot[v] != 0) foot += places[own_vertices[v]], foot_count += 1;
    foot /= foot_count;
    const glm::vec3 axis = places[own_vertices[form.tip()]] - foot;
    const float square = glm::dot(axis, axis);
    if (!(square > 0)) continue;
    for (std::size_t v = 0; v < form.is_foot.size(); ++v) {
      if (form.is_foot[v] != 0) continue;
      glm::vec3& place = places[own_vertices[v]];
      const glm::vec3 foot_point = foot + glm::dot(place - foot, axis) / square * axis;
      place = foot_point + times * (place - foot_point);
    }
  }
}

// The mesh of the level, with the boundary's vertices at `places`.
PlantMesh Level::mesh(const std::vector<glm::vec3>& places) const {
  const std::vector<glm::vec3> normals =
      sum_normals(smooth_.size(), corners_, [&](std::uint32_t smooth) { return places[smooth_[smooth]]; });
  PlantMesh made;
  made.runs = runs_;
  made.mesh.indices = indices_;
  made.mesh.positions.resize(3 * drawn_.size());
  made.mesh.normals.resize(3 * drawn_.size());
  for (std::size_t v = 0; v < drawn_.size(); ++v) {
    put(metres * y_up(places[vertex(v)]), &made.mesh.positions[3 * v]);
    put(y_up(unit_normal(normals[drawn_[v]], 1e-20f)), &made.mesh.normals[3 * v]);
  }
  return made;
}

// The memory that it holds, roughly.
std::uint64_t Level::bytes() const {
  return bytes_of(corners_) + bytes_of(volumes_) + bytes_of(smooth_) + bytes_of(wide_) + bytes_of(indices_) +
         bytes_of(drawn_) + bytes_of(number_);
}

}  // namespace panicle::flower
