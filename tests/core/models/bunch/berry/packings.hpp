// Bunches of berries for tests without growing a bunch: dense heaps, and checks of their surfaces.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "foundation/random.hpp"
#include "mesh/surface.hpp"
#include "models/bunch/berry/berry_meridian.hpp"
#include "models/bunch/berry/pressing/berry_surfaces.hpp"

namespace panicle::test {

using namespace panicle::bunch;

struct Heap {
  std::uint64_t seed = 1;
  std::uint32_t count = 40;
  float aspect = 1;       // length over width
  float spread = 0.15f;   // of sizes, to either side
  float overlap = 0.15f;  // at most, over the mean of the two radii
  float radius = 8;       // millimetres, of the ball of like volume
};

// The way between the cores of two capsules, the shortest there is.
inline glm::vec3 between_cores(const BerryBody& a, const BerryBody& b) {
  const glm::vec3 d = b.centre - a.centre;
  const glm::vec3 u = a.direction * std::max(0.0f, a.half_length - a.half_width);
  const glm::vec3 v = b.direction * std::max(0.0f, b.half_length - b.half_width);
  glm::vec3 best = d;
  constexpr int steps = 8;  // accurate enough for a heap
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const glm::vec3 way = d + v * (static_cast<float>(j) / steps) - u * (static_cast<float>(i) / steps);
      if (glm::dot(way, way) < glm::dot(best, best)) best = way;
    }
  }
  return best;
}

// Moves two bodies apart until they overlap by no more than allowed; returns by how much they were too near.
inline float part(BerryBody& a, BerryBody& b, float overlap) {
  const float most = a.half_width + b.half_width + std::max(0.0f, a.half_length - a.half_width) +
                     std::max(0.0f, b.half_length - b.half_width);
  const glm::vec3 d = b.centre - a.centre;
  if (glm::dot(d, d) > most * most) return 0;
  const glm::vec3 way = between_cores(a, b);
  const float distance = std::max(glm::length(way), 1e-3f);
  const float wanted = (a.half_width + b.half_width) * (1 - overlap / 2);
  if (distance >= wanted) return 0;
  const glm::vec3 move = way * ((wanted - distance) / distance / 2);
  a.centre -= move;
  b.centre += move;
  return wanted - distance;
}

// Bodies drawn together until they are as dense as their overlap allows.
inline std::vector<BerryBody> heap_of(const Heap& heap) {
  std::vector<BerryBody> bodies(heap.count);
  const float side = 1.6f * heap.radius * std::cbrt(static_cast<float>(heap.count));
  for (std::uint32_t i = 0; i < heap.count; ++i) {
    const auto unit = [&](std::uint64_t stream) { return random_unit(heap.seed, stream, i) - 0.5f; };
    BerryBody& body = bodies[i];
    body.centre = glm::vec3(unit(1), unit(2), unit(3)) * side;
    body.direction = glm::normalize(random_direction(heap.seed, 4, i) + glm::vec3(0, -0.7f, 0));
    body.half_width = heap.radius * (1 + 2 * heap.spread * unit(5)) / std::cbrt(heap.aspect);
    body.half_length = body.half_width * heap.aspect;
    body.id = i;
  }
  float worst = 1;
  for (int round = 0; round < 600 && (round < 150 || worst > 0.01f * heap.radius); ++round) {
    worst = 0;
    for (BerryBody& body : bodies) body.centre *= round < 120 ? 0.985f : 1.0f;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < bodies.size(); ++j) {
        worst = std::max(worst, part(bodies[i], bodies[j], heap.overlap * 0.98f));
      }
    }
  }
  CHECK(worst < 0.02f * heap.radius * heap.overlap);
  return bodies;
}

// The surface of one berry as a mesh of its own.
inline Mesh mesh_of(const BerrySurfaces& surfaces, std::size_t berry) {
  const auto each = static_cast<std::ptrdiff_t>(surfaces.uvs.size() / 2 * 3);
  const auto first = static_cast<std::ptrdiff_t>(berry) * each;
  Mesh mesh;
  mesh.positions.assign(surfaces.positions.begin() + first, surfaces.positions.begin() + first + each);
  mesh.normals.assign(surfaces.normals.begin() + first, surfaces.normals.begin() + first + each);
  mesh.uvs = surfaces.uvs;
  mesh.indices = surfaces.indices;
  return mesh;
}

// A mesh that is star-shaped about a centre, for measuring how deep a point lies in it.
class Star {
 public:
  Star(const Mesh& mesh, const glm::vec3& centre) : mesh_(mesh), centre_(centre) {
    for (std::uint32_t i = 0; i < mesh.positions.size() / 3; ++i) {
      furthest_ = std::max(furthest_, glm::length(position_of(mesh, i) - centre_));
    }
  }

  // Depth of a point below the surface along its ray from the centre; not above 0 outside.
  double depth(const glm::dvec3& point) const {
    const glm::dvec3 ray = point - centre_;
    const double distance = glm::length(ray);
    if (distance >= furthest_) return 0;
    for (std::size_t t = 0; t < mesh_.indices.size(); t += 3) {
      const glm::dvec3 a = corner(t), b = corner(t + 1), c = corner(t + 2);
      const double u = glm::dot(ray, glm::cross(b, c)), v = glm::dot(ray, glm::cross(c, a));
      const double w = glm::dot(ray, glm::cross(a, b));
      if (u < 0 || v < 0 || w < 0 || u + v + w <= 0) continue;
      return distance * (glm::dot(a, glm::cross(b, c)) / (u + v + w) - 1);
    }
    return 0;
  }

  glm::dvec3 corner(std::size_t index) const { return position_of(mesh_, mesh_.indices[index]) - centre_; }
  double furthest() const { return furthest_; }

 private:
  const Mesh& mesh_;
  glm::dvec3 centre_;
  double furthest_ = 0;
};

// Greatest depth of corners, middles of edges and of triangles of one mesh within the other.
inline double penetration(const Mesh& mesh, const Star& other) {
  double deepest = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const glm::dvec3 a = position_of(mesh, mesh.indices[t]), b = position_of(mesh, mesh.indices[t + 1]);
    const glm::dvec3 c = position_of(mesh, mesh.indices[t + 2]);
    for (const glm::dvec3& p : {a, (a + b) * 0.5, (a + b + c) * (1 / 3.0)}) {
      deepest = std::max(deepest, other.depth(p));
    }
  }
  return deepest;
}

}  // namespace panicle::test
