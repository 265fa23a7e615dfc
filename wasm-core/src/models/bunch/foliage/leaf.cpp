#include "models/bunch/foliage/leaf.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <iterator>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "geometry/ring_strips.hpp"
#include "models/bunch/foliage/leaf_outline.hpp"

namespace panicle::bunch {
namespace {

// Rows of vertices round the petiole's point: how far out, and in how many parts they cut a sector. The last is the
// margin, with a vertex at every tooth, at every notch and on the flank between.
struct Row {
  float reach;
  std::uint32_t parts;
};
constexpr Row rows[] = {{0.08f, 1},  {0.17f, 2},  {0.28f, 4},  {0.40f, 6}, {0.53f, 8},
                        {0.66f, 10}, {0.79f, 14}, {0.90f, 16}, {1, 32}};
static_assert(rows[std::size(rows) - 1].parts == 4 * leaf_teeth);

// The petiole's point and the rows; a fan within the first row, then as many triangles as both rows have parts.
constexpr std::uint32_t count_vertices() {
  std::uint32_t count = 1;
  for (const Row& row : rows) count += leaf_sectors * row.parts + 1;
  return count;
}
constexpr std::uint32_t count_triangles() {
  std::uint32_t count = 0;
  for (const Row& row : rows) count += 2 * leaf_sectors * row.parts;
  return count - leaf_sectors * rows[std::size(rows) - 1].parts;
}

// How one leaf differs from the flat blade; lengths in midribs.
struct Relief {
  float bulge;                   // of the blade between two veins
  float wave, waves, wave_turn;  // of the margin: height, number to the whole round, where they begin (degrees)
  SinCos fold;                   // of the two halves, up along the midrib
  float droop, curl;             // radians a midrib: down towards the tip, down towards either side
};

Relief relief_of(const LeafOptions& options) {
  const auto between = [&](std::uint64_t address, float low, float high) {
    return low + (high - low) * random_unit(options.seed, hash_text("leaf relief"), address);
  };
  const float opening = options.opening >= 0 ? std::min(options.opening, 1.0f) : 0;
  const float wilting = options.wilting >= 0 ? std::min(options.wilting, 1.0f) : 0;
  Relief relief;
  relief.bulge = between(0, 0.08f, 0.15f);
  relief.wave = between(1, 0.03f, 0.07f) * (1 + wilting);
  relief.waves = static_cast<float>(random_integer(options.seed, hash_text("leaf waves"), 0, 4, 7));
  relief.wave_turn = between(2, 0, 360);
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

glm::vec3 raise(const Relief& relief, const glm::vec2& flat, float degrees, float share) {
  const float away = glm::length(flat);
  glm::vec3 point(flat, 0);
  point.z += relief.bulge * away * (1.2f - 0.5f * away) * 4 * share * (1 - share);
  point.z += relief.wave * away * away * sincos_degrees(relief.waves * degrees + relief.wave_turn).sine;
  const float off = std::sqrt(flat.x * flat.x + 0.0025f) - 0.05f;  // a rounded fold
  point.x *= relief.fold.cosine;
  point.z += off * relief.fold.sine;
  bend(point.x, point.z, std::max(relief.curl, 0.05f));
  bend(point.y, point.z, relief.droop);
  return point;
}

class Blade {
 public:
  explicit Blade(const LeafOptions& options) : outline_(options.seed), relief_(relief_of(options)) {
    mesh_.positions.resize(3 * count_vertices());
    mesh_.normals.resize(3 * count_vertices());
    mesh_.uvs.resize(2 * count_vertices());
    mesh_.indices.resize(3 * count_triangles());
  }

  Mesh make() {
    vertex(glm::vec2(0), 0, 0);
    for (std::uint32_t i = 0; i < std::size(rows); ++i) row(rows[i], i + 1 == std::size(rows));
    std::uint32_t inner = 1;
    for (std::uint32_t k = 0; k < leaf_sectors * rows[0].parts; ++k) triangle(0, inner + k + 1, inner + k);
    for (std::size_t i = 1; i < std::size(rows); ++i) {
      const std::uint32_t outer = inner + leaf_sectors * rows[i - 1].parts + 1;
      strip_between(inner, leaf_sectors * rows[i - 1].parts, outer, leaf_sectors * rows[i].parts,
                    [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangle(a, b, c); });
      inner = outer;
    }
    shade();
    return std::move(mesh_);
  }

 private:
  void row(const Row& row, bool margin) {
    for (std::uint32_t k = 0; k <= leaf_sectors * row.parts; ++k) {
      const std::uint32_t sector = std::min(k / row.parts, leaf_sectors - 1);
      const std::uint32_t part = k - sector * row.parts;
      const float share = static_cast<float>(part) / static_cast<float>(row.parts);
      float away = row.reach * outline_.radius(sector, share);
      if (margin) away += outline_.jut(sector, share * leaf_teeth);
      const float degrees = outline_.angle(sector, share);
      const SinCos angle = sincos_degrees(degrees);
      vertex({away * angle.sine, away * angle.cosine}, degrees, share);
    }
  }

  void vertex(const glm::vec2& flat, float degrees, float share) {
    const glm::vec3 point = raise(relief_, flat, degrees, share);
    for (int axis = 0; axis < 3; ++axis) mesh_.positions[3 * vertices_ + axis] = point[axis];
    mesh_.uvs[2 * vertices_] = leaf_petiole_u + leaf_chart_scale * flat.x;
    mesh_.uvs[2 * vertices_ + 1] = leaf_petiole_v + leaf_chart_scale * flat.y;
    ++vertices_;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const std::uint32_t corner : {a, b, c}) mesh_.indices[indices_++] = corner;
  }

  glm::vec3 position(std::uint32_t i) const {
    return {mesh_.positions[3 * i], mesh_.positions[3 * i + 1], mesh_.positions[3 * i + 2]};
  }

  // Normals: the mean of the triangles' by area.
  void shade() {
    for (std::size_t t = 0; t < mesh_.indices.size(); t += 3) {
      const std::uint32_t* corner = &mesh_.indices[t];
      const glm::vec3 a = position(corner[0]);
      const glm::vec3 face = glm::cross(position(corner[1]) - a, position(corner[2]) - a);
      for (int k = 0; k < 3; ++k) {
        for (int axis = 0; axis < 3; ++axis) mesh_.normals[3 * corner[k] + axis] += face[axis];
      }
    }
    for (std::size_t i = 0; i < mesh_.normals.size(); i += 3) {
      float* normal = &mesh_.normals[i];
      const float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
      for (int axis = 0; axis < 3; ++axis) normal[axis] /= length;
    }
  }

  LeafOutline outline_;
  Relief relief_;
  Mesh mesh_;
  std::uint32_t vertices_ = 0, indices_ = 0;  // written so far
};

}  // namespace

Mesh make_leaf(const LeafOptions& options) { return Blade(options).make(); }

}  // namespace panicle::bunch
