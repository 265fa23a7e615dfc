#include "models/bunch/foliage/leaf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

constexpr float farthest = 4;  // a flat leaf reaches no farther, in midribs

// How one leaf differs from the flat one; lengths in midribs.
struct Relief {
  float side, breadth;  // −1: the flat leaf's mirror image; its breadth against that
  float pucker;         // of the blade between veins
  float wave;           // of the margin: height
  glm::vec2 waves[2];   // how it runs across the blade: waves a midrib, and where they begin (radians)
  SinCos fold;          // of the two halves, up along the midrib
  float droop, curl;    // radians a midrib: down towards the tip, down towards either side
};

Relief relief_of(const LeafOptions& options) {
  const auto between = [&](std::uint64_t address, float low, float high) {
    return low + (high - low) * random_unit(options.seed, hash_text("leaf relief"), address);
  };
  const float opening = options.opening >= 0 ? std::min(options.opening, 1.0f) : 0;
  const float wilting = options.wilting >= 0 ? std::min(options.wilting, 1.0f) : 0;
  Relief relief;
  relief.side = between(6, 0, 1) < 0.5f ? -1.0f : 1.0f;
  relief.breadth = between(7, 0.92f, 1.06f);
  relief.pucker = between(0, 0.03f, 0.05f);
  relief.wave = between(1, 0.08f, 0.15f) * (1 + wilting);
  relief.waves[0] = {between(2, 4, 6.5f), between(8, -pi, pi)};
  relief.waves[1] = {between(9, 4, 6.5f), between(10, -pi, pi)};
  relief.fold = sincos_degrees(between(3, 4, 14) + 48 * (1 - opening) * (1 - opening));
  relief.droop = between(4, 0.45f, 0.95f) + 0.7f * wilting;
  relief.curl = between(5, 0.25f, 0.75f) * opening + 0.5f * wilting;
  return relief;
}

// Bends the line along `at` into an arc, downwards: what stood on it still does.
void bend(float& along, float& height, float radians) {
  const float angle = along * radians;
  const float radius = 1 / radians + height;
  along = radius * sine(angle);
  height = radius * cosine(angle) - 1 / radians;
}

glm::vec3 raise(const Relief& relief, const glm::vec2& flat, float between) {
  const float away = std::min(glm::length(flat), 1.5f);
  glm::vec3 point(relief.side * relief.breadth * flat.x, flat.y, 0);
  point.z += relief.pucker * between * (2 - between) * std::min(1.0f, 4 * away);
  const auto [across, along] = relief.waves;
  point.z += relief.wave * away * away * sine(across.x * flat.x + across.y) * sine(along.x * flat.y + along.y);
  const float off = std::sqrt(point.x * point.x + 0.0025f) - 0.05f;  // a rounded fold
  point.x *= relief.fold.cosine;
  point.z += off * relief.fold.sine;
  bend(point.x, point.z, std::max(relief.curl, 0.05f));
  bend(point.y, point.z, relief.droop);
  return point;
}

glm::vec3 position(const Mesh& mesh, std::uint32_t i) {
  return {mesh.positions[3 * i], mesh.positions[3 * i + 1], mesh.positions[3 * i + 2]};
}

// Normals: the mean of the triangles' by area.
void shade(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const std::uint32_t* corner = &mesh.indices[t];
    const glm::vec3 a = position(mesh, corner[0]);
    const glm::vec3 face = glm::cross(position(mesh, corner[1]) - a, position(mesh, corner[2]) - a);
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) mesh.normals[3 * corner[k] + axis] += face[axis];
    }
  }
  for (std::size_t i = 0; i < mesh.normals.size(); i += 3) {
    float* normal = &mesh.normals[i];
    const float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (length > 0)
      for (int axis = 0; axis < 3; ++axis) normal[axis] /= length;
    else
      normal[2] = 1;  // of no triangle with an area
  }
}

}  // namespace

Diagnostic check(const FlatLeaf& leaf) {
  const auto refused = [](const char* why) { return Diagnostic{Reason::bad_request, why, 0, 0}; };
  const std::size_t points = leaf.points.size() / 2;
  if (leaf.points.size() % 2 != 0 || leaf.between.size() != points || leaf.uvs.size() != 2 * points ||
      leaf.triangles.size() % 3 != 0)
    return refused("The request's leaf has blocks of different lengths.");
  const auto within = [](std::span<const float> values, float low, float high) {
    return std::all_of(values.begin(), values.end(), [&](float value) { return value >= low && value <= high; });
  };
  if (!within(leaf.points, -farthest, farthest) || !within(leaf.between, 0, 1) || !within(leaf.uvs, 0, 1))
    return refused("The request's leaf has points that no leaf has.");
  if (std::any_of(leaf.triangles.begin(), leaf.triangles.end(), [&](std::uint32_t i) { return i >= points; }))
    return refused("The request's leaf has triangles of points that it has not.");
  return {};
}

Mesh make_leaf(const FlatLeaf& flat, const LeafOptions& options) {
  const Relief relief = relief_of(options);
  Mesh mesh;
  mesh.positions.reserve(3 * flat.between.size());
  for (std::size_t i = 0; i < flat.between.size(); ++i) {
    const glm::vec3 point = raise(relief, {flat.points[2 * i], flat.points[2 * i + 1]}, flat.between[i]);
    for (int axis = 0; axis < 3; ++axis) mesh.positions.push_back(point[axis]);
  }
  mesh.uvs.assign(flat.uvs.begin(), flat.uvs.end());
  mesh.indices.assign(flat.triangles.begin(), flat.triangles.end());
  if (relief.side < 0)
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
  shade(mesh);
  return mesh;
}

}  // namespace panicle::bunch
