#include "models/grammar/surfaces.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "foundation/mathematics.hpp"
#include "mesh/normals.hpp"
#include "mesh/uv_sphere.hpp"
#include "models/grammar/outlines.hpp"

namespace panicle::grammar {
namespace {

constexpr std::uint32_t round_sides = 14, plain_sides = 8;  // sides of surfaces of revolution

// Half of a blade's outline, from its base (0) to its tip (1), and its curvature.
struct BladeShape {
  float width = 0.4f;   // greatest width
  float widest = 0.4f;  // position of the greatest width, 0 … 1
  float fold = 0.2f;    // height of the margins above the midrib, over their distance
  float droop = 0.15f;  // how far the tip lies below the base's plane
  std::uint32_t rows = 8;
  std::uint32_t across = 5;  // vertices of a row: 3 are the margins and the midrib alone
};

// A blade with about half the rows, and with margins and midrib alone.
BladeShape simplified(BladeShape blade) {
  blade.rows = (blade.rows + 1) / 2;
  blade.across = 3;
  return blade;
}

// Half the width: it rises smoothly from 0 at the base to the widest place and falls to a pointed tip.
float half_width(const BladeShape& blade, float t) {
  const float rise = t < blade.widest ? t / blade.widest : (1 - t) / (1 - blade.widest);
  return 0.5f * blade.width * std::sqrt(rise * (2 - rise));
}

// Builds the mesh of a blade. A row has the margins, the midrib and vertices between them.
Mesh make_blade(const BladeShape& blade) {
  const std::uint32_t across = blade.across, middle = across / 2;
  Mesh mesh;
  for (std::uint32_t row = 0; row <= blade.rows; ++row) {
    const float t = static_cast<float>(row) / static_cast<float>(blade.rows);
    const float half = half_width(blade, t);
    for (std::uint32_t k = 0; k < across; ++k) {
      const float s = static_cast<float>(k) / static_cast<float>(middle) - 1;
      put(mesh.positions, glm::vec3(s * half, t, blade.fold * std::fabs(s) * half - blade.droop * t * t));
      put(mesh.uvs, glm::vec2(0.5f + s * half / blade.width, 1 - t));
    }
  }
  for (std::uint32_t row = 0; row < blade.rows; ++row) {
    for (std::uint32_t k = 0; k + 1 < across; ++k) {
      const std::uint32_t a = row * across + k, b = a + across;
      // At base and tip the row is one point.
      if (row > 0) put(mesh.indices, a, a + 1, b + 1);
      if (row + 1 < blade.rows) put(mesh.indices, a, b + 1, b);
    }
  }
  set_normals(mesh);
  // Where a row is one point, half of its corners have no triangle of their own.
  for (const std::uint32_t row : {0u, blade.rows}) {
    const std::uint32_t inner = row == 0 ? 1 : row - 1;
    for (std::uint32_t k = 0; k < 3 * across; ++k)
      mesh.normals[3 * across * row + k] = mesh.normals[3 * across * inner + k];
  }
  return mesh;
}

// Adds a mesh tilted about its base towards the turtle's back, then turned about the heading.
void add_turned(Mesh& all, const Mesh& one, float tilt, float about) {
  const auto base = static_cast<std::uint32_t>(all.positions.size() / 3);
  const SinCos tilted = sincos_degrees(tilt), round_about = sincos_degrees(about);
  const auto turned = [&](const std::vector<float>& from, std::size_t i, float scale) {
    const glm::vec3 p(from[i], from[i + 1], from[i + 2]);
    // y out, z in: the upper side comes to look up the heading.
    const float out = scale * (p.y * tilted.sine - p.z * tilted.cosine), x = scale * p.x;
    const float y = scale * (p.y * tilted.cosine + p.z * tilted.sine);
    return glm::vec3(out * round_about.sine - x * round_about.cosine, y,
                     out * round_about.cosine + x * round_about.sine);
  };
  for (std::size_t i = 0; i < one.positions.size(); i += 3) {
    put(all.positions, turned(one.positions, i, 0.55f));
    put(all.normals, turned(one.normals, i, 1));
  }
  all.uvs.insert(all.uvs.end(), one.uvs.begin(), one.uvs.end());
  for (const std::uint32_t index : one.indices) all.indices.push_back(base + index);
}

// Five petals round the heading.
Mesh flower(const Mesh& petal) {
  constexpr std::uint32_t petals = 5;
  Mesh all;
  for (std::uint32_t k = 0; k < petals; ++k) add_turned(all, petal, 66, 72.0f * static_cast<float>(k));
  return all;
}

// A point of the profile of a surface of revolution about the heading.
struct ProfilePoint {
  float radius, height;
};

// A surface of revolution, smooth except at repeated points, which are sharp edges, and at its ends, which may be
// points.
Mesh surface_of_revolution(std::span<const ProfilePoint> outline, std::uint32_t sides) {
  Mesh mesh;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ProfilePoint& before = outline[i > 0 ? i - 1 : 0];
    const ProfilePoint& after = outline[i + 1 < outline.size() ? i + 1 : i];
    const float dr = after.radius - before.radius, dy = after.height - before.height;
    const float length = std::sqrt(dr * dr + dy * dy);
    for (std::uint32_t k = 0; k <= sides; ++k) {
      const auto [sine, cosine] = sincos_degrees(360.0f * static_cast<float>(k % sides) / static_cast<float>(sides));
      put(mesh.positions, glm::vec3(outline[i].radius * sine, outline[i].height, outline[i].radius * cosine));
      put(mesh.normals, glm::vec3(dy * sine, -dr, dy * cosine) / length);
      put(mesh.uvs, glm::vec2(static_cast<float>(k) / static_cast<float>(sides),
                              1 - static_cast<float>(i) / static_cast<float>(outline.size() - 1)));
    }
  }
  for (std::uint32_t row = 0; row + 1 < outline.size(); ++row) {
    const ProfilePoint &one = outline[row], &next = outline[row + 1];
    if (one.radius == next.radius && one.height == next.height) continue;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = row * (sides + 1) + k, b = a + sides + 1;
      if (one.radius > 0) put(mesh.indices, a, a + 1, b + 1);
      if (next.radius > 0) put(mesh.indices, a, b + 1, b);
    }
  }
  return mesh;
}

// A ball that begins at the turtle.
Mesh berry(std::uint32_t sides) {
  Mesh mesh = make_uv_sphere(sides);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] = 0.5f * mesh.positions[i] + (i % 3 == 1 ? 0.5f : 0);
  return mesh;
}

}  // namespace

// The index of a built-in surface by its name; none for an unknown name.
std::optional<std::uint32_t> surface_named(std::string_view name) {
  for (std::uint32_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return i;
  return {};
}

// The mesh of built-in surface `which`, of size 1, with its base at the origin; `plain`: fewer triangles.
Mesh make_surface(std::uint32_t which, bool plain) {
  constexpr ProfilePoint disc[] = {{0.5f, 0}, {0, 0.02f}};
  constexpr ProfilePoint cone[] = {{0, 0}, {0.25f, 0}, {0.25f, 0}, {0, 1}};
  constexpr ProfilePoint bud[] = {{0, 0},         {0.1f, 0.04f}, {0.2f, 0.18f},  {0.23f, 0.36f},
                                  {0.19f, 0.58f}, {0.1f, 0.82f}, {0.04f, 0.95f}, {0, 1}};
  const std::uint32_t sides = plain ? plain_sides : round_sides;
  const auto blade = [plain](const BladeShape& whole) { return make_blade(plain ? simplified(whole) : whole); };
  switch (which) {
    case 0:
      return blade({.width = 0.46f, .widest = 0.38f, .fold = 0.25f, .droop = 0.16f, .rows = 8});
    case 1:
      return blade({.width = 0.7f, .widest = 0.62f, .fold = 0.22f, .droop = 0.14f, .rows = 7});
    case 2:
      return blade({.width = 0.28f, .widest = 0.35f, .fold = 0.3f, .droop = 0.08f, .rows = 6});
    case 3:
      return flower(blade({.width = 0.75f, .widest = 0.62f, .fold = 0.25f, .droop = 0.12f, .rows = 6}));
    case 4:
      return surface_of_revolution(disc, sides);
    case 5:
      return surface_of_revolution(cone, sides);
    case 6:
      return surface_of_revolution(bud, sides);
    case 7:
      return berry(sides);
    default:
      return blade_within(outlines[which - first_outline_surface], plain);
  }
}

}  // namespace panicle::grammar
