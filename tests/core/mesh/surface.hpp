// Invariants of every mesh, measured in double from the floats that leave the core.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace panicle::test {

inline glm::dvec3 position_of(const Mesh& mesh, std::uint32_t vertex) {
  return {mesh.positions[3 * vertex], mesh.positions[3 * vertex + 1], mesh.positions[3 * vertex + 2]};
}

inline glm::dvec3 normal_of(const Mesh& mesh, std::uint32_t vertex) {
  return {mesh.normals[3 * vertex], mesh.normals[3 * vertex + 1], mesh.normals[3 * vertex + 2]};
}

// Arrays of matching lengths, finite numbers, unit normals, indices in range and distinct, no flat triangle.
inline void check_sound(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size() / 3;
  REQUIRE(mesh.positions.size() == vertices * 3);
  REQUIRE(mesh.normals.size() == vertices * 3);
  REQUIRE(mesh.uvs.size() == vertices * 2);
  REQUIRE(mesh.indices.size() % 3 == 0);
  for (const auto* values : {&mesh.positions, &mesh.normals, &mesh.uvs}) {
    REQUIRE(std::all_of(values->begin(), values->end(), [](float value) { return std::isfinite(value); }));
  }
  double worst_length = 0;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    worst_length = std::max(worst_length, std::fabs(glm::length(normal_of(mesh, i)) - 1));
  }
  CHECK(worst_length < 1e-5);
  std::size_t degenerate = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
    REQUIRE(std::max({a, b, c}) < vertices);
    const auto p = [&](std::uint32_t i) {
      return glm::vec3(mesh.positions[3 * i], mesh.positions[3 * i + 1], mesh.positions[3 * i + 2]);
    };
    const bool flat = !(glm::length(glm::cross(p(b) - p(a), p(c) - p(a))) > 0);  // in float, as a reader would
    if (a == b || b == c || c == a || flat) ++degenerate;
  }
  CHECK(degenerate == 0);
}

// The part of a mesh between two indices as a surface: its edges by the positions they join, its volume.
struct Surface {
  std::size_t open_edges = 0;  // directed edges without exactly one partner the other way round
  double volume = 0;           // signed: positive where triangles are counter-clockwise from without
};

inline Surface surface_of(const Mesh& mesh, std::size_t first_index, std::size_t count) {
  using Place = std::array<float, 3>;
  std::map<Place, std::uint32_t> places;
  const auto weld = [&](std::uint32_t i) {
    const Place place{mesh.positions[3 * i] + 0.0f, mesh.positions[3 * i + 1] + 0.0f, mesh.positions[3 * i + 2] + 0.0f};
    return places.emplace(place, static_cast<std::uint32_t>(places.size())).first->second;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  Surface surface;
  const glm::dvec3 origin = count > 0 ? position_of(mesh, mesh.indices[first_index]) : glm::dvec3(0);
  for (std::size_t t = first_index; t < first_index + count; t += 3) {
    std::array<std::uint32_t, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) corner[k] = weld(mesh.indices[t + k]);
    for (std::size_t k = 0; k < 3; ++k) ++edges[{corner[k], corner[(k + 1) % 3]}];
    const glm::dvec3 a = position_of(mesh, mesh.indices[t]) - origin;
    const glm::dvec3 b = position_of(mesh, mesh.indices[t + 1]) - origin;
    const glm::dvec3 c = position_of(mesh, mesh.indices[t + 2]) - origin;
    surface.volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  for (const auto& [edge, uses] : edges) {
    const auto partner = edges.find({edge.second, edge.first});
    if (uses != 1 || partner == edges.end() || partner->second != 1) ++surface.open_edges;
  }
  return surface;
}

// Share of triangles whose normals' mean looks to the other side than their winding.
inline double share_turned(const Mesh& mesh) {
  std::size_t turned = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t a = mesh.indices[t], b = mesh.indices[t + 1], c = mesh.indices[t + 2];
    const glm::dvec3 face =
        glm::cross(position_of(mesh, b) - position_of(mesh, a), position_of(mesh, c) - position_of(mesh, a));
    if (glm::dot(face, normal_of(mesh, a) + normal_of(mesh, b) + normal_of(mesh, c)) <= 0) ++turned;
  }
  return mesh.indices.empty() ? 0 : static_cast<double>(turned) / (static_cast<double>(mesh.indices.size()) / 3);
}

}  // namespace panicle::test
