#include "models/flower/level.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <string_view>
#include <utility>

#include "foundation/bytes.hpp"
#include "models/flower/skin.hpp"
#include "models/flower/units.hpp"

namespace panicle::flower {
namespace {

constexpr float crease = -0.25f;  // the cosine between two normals that are not smoothed into one

std::size_t place_of(std::string_view kind) {
  return static_cast<std::size_t>(std::find(material_kinds.begin(), material_kinds.end(), kind) -
                                  material_kinds.begin());
}

}  // namespace

Level::Level(RemainingTriangles remains, const std::vector<glm::vec3>& places)
    : volumes_(std::move(remains.volumes)), wide_(std::move(remains.wide)) {
  split_at_edges(remains.vertices, places);
}

void Level::split_at_edges(const std::vector<std::uint32_t>& vertices, const std::vector<glm::vec3>& places) {
  std::vector<glm::vec3> normals;  // of `smooth_`, sums
  // Linked lists of the smooth vertices at each vertex of the boundary.
  std::vector<std::uint32_t> first(places.size(), invalid), next;
  for (std::size_t t = 0; t < vertices.size(); t += 3) {
    const glm::vec3 &a = places[vertices[t]], &b = places[vertices[t + 1]], &c = places[vertices[t + 2]];
    const glm::vec3 normal = glm::cross(b - a, c - a);
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

void Level::widen(const OrganForms& organs, std::vector<glm::vec3>& places) const {
  for (const auto& [organ, times] : wide_) {
    const FormedOrgan& of = organs.organs()[organ];
    const OrganForm& form = organs.form(of);
    const std::uint32_t* const own = organs.vertices(of);
    glm::vec3 foot(0);
    float feet = 0;
    for (std::size_t v = 0; v < form.is_foot.size(); ++v)
      if (form.is_foot[v] != 0) foot += places[own[v]], feet += 1;
    foot /= feet;
    const glm::vec3 way = places[own[form.tip()]] - foot;
    const float square = glm::dot(way, way);
    if (!(square > 0)) continue;
    for (std::size_t v = 0; v < form.is_foot.size(); ++v) {
      if (form.is_foot[v] != 0) continue;
      glm::vec3& place = places[own[v]];
      const glm::vec3 on = foot + glm::dot(place - foot, way) / square * way;
      place = on + times * (place - on);
    }
  }
}

PlantMesh Level::mesh(const std::vector<glm::vec3>& places) const {
  std::vector<glm::vec3> normals(smooth_.size(), glm::vec3(0));
  for (std::size_t t = 0; t < triangles(); ++t) {
    const auto [a, b, c] = triangle(t);
    const glm::vec3 normal = glm::cross(places[b] - places[a], places[c] - places[a]);
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) normals[corners_[i]] += normal;
  }
  PlantMesh made;
  made.runs = runs_;
  made.mesh.indices = indices_;
  made.mesh.positions.resize(3 * drawn_.size());
  made.mesh.normals.resize(3 * drawn_.size());
  for (std::size_t v = 0; v < drawn_.size(); ++v) {
    const glm::vec3& normal = normals[drawn_[v]];
    const float length = glm::length(normal);
    put(metres * y_up(places[vertex(v)]), &made.mesh.positions[3 * v]);
    put(y_up(length > 1e-20f ? normal / length : glm::vec3(0, 0, 1)), &made.mesh.normals[3 * v]);
  }
  return made;
}

std::uint64_t Level::bytes() const {
  return bytes_of(corners_) + bytes_of(volumes_) + bytes_of(smooth_) + bytes_of(wide_) + bytes_of(indices_) +
         bytes_of(drawn_) + bytes_of(number_);
}

}  // namespace panicle::flower
