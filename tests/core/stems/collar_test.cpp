// Branch collars, and the scale of bark on tubes.
#include "stems/collar.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"
#include "stems/tubes.hpp"

namespace panicle {
namespace {

constexpr BarkScale bark{.width = 0.5f, .height = 1};

// An upright trunk in pieces, with a branch at an angle from the vertical, in degrees.
std::vector<Segment> forked(float angle, float branch_radius = 0.1f) {
  std::vector<Segment> segments;
  for (int i = 0; i < 10; ++i) {
    const float y = 0.4f * static_cast<float>(i);
    segments.push_back({i - 1, 0, {0, y, 0}, {0, y + 0.4f, 0}, 0.3f, 0.3f});
  }
  const SinCos way = sincos_degrees(angle);
  const glm::vec3 along(way.sine, way.cosine, 0);
  glm::vec3 from = segments[4].end;
  for (int i = 0; i < 8; ++i) {
    const std::int32_t parent = i == 0 ? 4 : static_cast<std::int32_t>(segments.size()) - 1;
    segments.push_back({parent, 0, from, from + 0.3f * along, branch_radius, branch_radius});
    from += 0.3f * along;
  }
  return segments;
}

constexpr std::size_t branch_piece = 10;  // index of the branch's first segment

StemMesh swept(const std::vector<Segment>& segments, bool collars) {
  std::vector<std::int32_t> groups(segments.size(), 0);
  for (std::size_t i = branch_piece; i < segments.size(); ++i) groups[i] = 1;
  return sweep_stems({.segments = segments, .groups = groups, .jointed = false, .tapering = true},
                     {.sides = 16, .collars = collars, .bark = bark}, 1);
}

TEST_CASE("a collar begins on its parent's surface with the parent's normals and segment") {
  for (const float angle : {35.0f, 60.0f, 90.0f}) {
    CAPTURE(angle);
    const StemMesh stems = swept(forked(angle), true);
    const StemPart& branch = stems.parts[1];
    const auto positions = vectors_of(stems.mesh.positions), normals = vectors_of(stems.mesh.normals);
    // The first vertex is the pole; then comes the first row.
    for (std::size_t v = branch.first_vertex + 1; v < branch.first_vertex + 17; ++v) {
      const glm::vec3 out(positions[v].x, 0, positions[v].z);
      CHECK(glm::length(out) == doctest::Approx(0.3f).epsilon(0.05));
      CHECK(glm::dot(normals[v], glm::normalize(out)) > 0.98f);
      CHECK(stems.segment[v] == 4);
    }
    // And the branch's part outside of the parent is not longer than with plain tubes.
    CHECK(branch.vertex_count < swept(forked(angle), false).parts[1].vertex_count + 6 * 17);
  }
}

TEST_CASE("a collar makes the branch wider towards its parent, and leaves it as it is farther out") {
  const StemMesh stems = swept(forked(90), true);
  const StemPart& branch = stems.parts[1];
  const glm::vec3 fork(0, 2, 0);
  float at_base = 0, outside = 0;
  for (std::size_t v = branch.first_vertex; v < branch.first_vertex + branch.vertex_count; ++v) {
    const glm::vec3 at = vector_at(stems.mesh.positions, v) - fork;
    const float off = std::hypot(at.y, at.z);
    if (at.x < 0.31f) at_base = std::max(at_base, off);
    if (at.x > 0.45f) outside = std::max(outside, off);
  }
  CHECK(at_base > 0.16f);
  CHECK(outside == doctest::Approx(0.1f).epsilon(0.01));
}

TEST_CASE("tubes with collars are closed, and their normals look out") {
  for (const float angle : {25.0f, 50.0f, 80.0f, 110.0f}) {
    CAPTURE(angle);
    const StemMesh stems = swept(forked(angle), true);
    const Mesh& mesh = stems.mesh;
    // Vertices at one place count as one: seams of the texture are no edges.
    std::map<std::tuple<float, float, float>, std::uint32_t> places;
    std::vector<std::uint32_t> welded;
    for (const glm::vec3& at : vectors_of(mesh.positions))
      welded.push_back(places.try_emplace({at.x, at.y, at.z}, places.size()).first->second);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::size_t opposed = 0;
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      const std::uint32_t* corners = &mesh.indices[t];
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = welded[corners[k]], b = welded[corners[(k + 1) % 3]];
        if (a != b) edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
      const glm::vec3 face =
          triangle_normal(vector_at(mesh.positions, corners[0]), vector_at(mesh.positions, corners[1]),
                          vector_at(mesh.positions, corners[2]));
      glm::vec3 mean(0), middle(0);
      for (int k = 0; k < 3; ++k) {
        mean += vector_at(mesh.normals, corners[k]);
        middle += vector_at(mesh.positions, corners[k]) / 3.0f;
      }
      // Triangles within the trunk are hidden.
      if (std::hypot(middle.x, middle.z) < 0.29f) continue;
      opposed += glm::dot(face, mean) < 0;
    }
    for (const auto& [edge, balance] : edges) CHECK(balance == 0);
    CHECK(opposed <= 2);
  }
}

TEST_CASE("bark lies around a tube in whole quarters of its picture, within 10 % of its scale") {
  std::vector<Segment> segments;
  // A trunk that gets thinner by 12 mm a metre.
  for (int i = 0; i < 40; ++i) {
    const auto at = static_cast<float>(i);
    segments.push_back(
        {i - 1, 0, {0, 0.5f * at, 0}, {0, 0.5f * at + 0.5f, 0}, 0.4f - 0.006f * at, 0.394f - 0.006f * at});
  }
  const StemMesh stems =
      sweep_stems({.segments = segments, .jointed = false, .tapering = true}, {.sides = 16, .bark = bark}, 1);
  constexpr std::size_t line = 17;
  std::size_t whole = 0, rings = 0;
  float before = -1, last_turns = 10;
  // Without both poles, and the rings of the rounded ends.
  for (std::size_t v = 1 + 3 * line; v + 1 + 3 * line < stems.segment.size(); v += line) {
    const glm::vec3 first = vector_at(stems.mesh.positions, v), across = vector_at(stems.mesh.positions, v + 8);
    const float girth = pi * glm::distance(first, across), turns = stems.mesh.uvs[2 * (v + 16)];
    CHECK(stems.mesh.uvs[2 * v] == 0);
    CHECK(turns <= last_turns);
    last_turns = turns;
    ++rings;
    whole += std::fabs(4 * turns - std::round(4 * turns)) < 1e-4f;
    // At the foot it spreads.
    if (first.y > 1) CHECK(turns * bark.width / girth > 0.9f);
    CHECK(turns * bark.width / girth < 1.1f);
    // v keeps the proportions: as many metres a picture along as across.
    const float along = stems.mesh.uvs[2 * v + 1];
    if (before >= 0 && first.y > 1) {
      const float step = glm::distance(first, vector_at(stems.mesh.positions, v - line));
      CHECK((along - before) * bark.height / step == doctest::Approx(turns * bark.width / girth).epsilon(0.03));
    }
    before = along;
  }
  CHECK(rings > 60);
  CHECK(whole > rings / 2);
}

TEST_CASE("thin tubes have a quarter of the picture around them") {
  const std::vector<Segment> twig{{-1, 0, {0, 0, 0}, {0, 1, 0}, 0.005f, 0.004f}};
  const StemMesh stems = sweep_stems({.segments = twig}, {.sides = 6, .bark = bark}, 1);
  for (std::size_t v = 7; v < stems.segment.size(); v += 7)
    if (v + 1 < stems.segment.size()) CHECK(stems.mesh.uvs[2 * v] == doctest::Approx(0.25f));
}

}  // namespace
}  // namespace panicle
