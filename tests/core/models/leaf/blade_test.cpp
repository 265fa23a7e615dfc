#include "models/leaf/shape/blade.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "foundation/mathematics.hpp"
#include "models/leaf/outlines.hpp"
#include "models/leaf/petiole.hpp"
#include "near.hpp"

using namespace panicle;
using namespace panicle::particles;
using namespace panicle::particles::leaf;

namespace {

glm::vec3 vector_at(const std::vector<float>& values, std::size_t row) {
  return {values[3 * row], values[3 * row + 1], values[3 * row + 2]};
}

std::span<const float> column_at(const Columns& columns, std::string_view name) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return columns[i].as<float>();
  return {};
}

Margin margin_of(const std::vector<float>& rows, std::uint32_t teeth) {
  std::vector<std::string> notes;
  const auto points = read_outline(rows, notes);
  REQUIRE(points);
  const auto margin = spline(points.value());
  REQUIRE(margin);
  return toothed(margin.value(), {.count = teeth}, notes);
}

const std::vector<VeinPiece> midrib{{{0, 0}, {0, 0.5f}, 0.01f, 0.01f}, {{0, 0.5f}, {0, 0.9f}, 0.008f, 0.004f}};

}  // namespace

TEST_CASE("both faces and the rim close the blade of every outline, at any detail, toothed or not") {
  for (const NamedOutline& named : leaf_outlines())
    for (const float detail : {0.02f, 0.25f, 1.0f}) {
      CAPTURE(std::string(named.name));
      CAPTURE(detail);
      const Margin margin = margin_of(named.rows, detail == 0.25f ? 24 : 0);
      const Outline outline(margin.points);
      const Bending bending{.scale = 0.1f, .half_width = 0.4f, .fold = 20, .curl = 60, .undulation = 0.1f};
      const auto faces = make_blade(margin, outline, midrib, bending, {.detail = detail});
      REQUIRE(faces.size() == 2);
      // Every edge is used as often in one direction as in the other.
      std::map<std::array<float, 6>, int> edges;
      for (const PlantMesh& face : faces) {
        const Mesh& mesh = face.mesh;
        const std::size_t vertices = mesh.positions.size() / 3;
        REQUIRE(mesh.normals.size() == 3 * vertices);
        REQUIRE(mesh.uvs.size() == 2 * vertices);
        REQUIRE(column_at(face.columns, "edge").size() == vertices);
        for (std::size_t i = 0; i < vertices; ++i) CHECK(glm::length(vector_at(mesh.normals, i)) == doctest::Approx(1));
        for (const float share : mesh.uvs) CHECK((share >= -1e-5f && share <= 1 + 1e-5f));
        for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
          const std::size_t i = mesh.indices[k], next = mesh.indices[k % 3 == 2 ? k - 2 : k + 1];
          REQUIRE(i < vertices);
          const glm::vec3 a = vector_at(mesh.positions, i), b = vector_at(mesh.positions, next);
          ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
          --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
        }
      }
      bool closed = true;
      for (const auto& [edge, count] : edges) closed = closed && count == 0;
      CHECK(closed);
    }
}

TEST_CASE("flat, the upper face looks up, fills the outline and shows its chart") {
  const Margin margin = margin_of({}, 30);
  const Outline outline(margin.points);
  const Bending flat{.scale = 0.1f, .half_width = 0.3f};
  const auto faces = make_blade(margin, outline, {}, flat, {.thickness = 0.0004f, .relief = 1, .detail = 1});
  const Mesh& upper = faces[0].mesh;
  const ChartSquare square = chart_square(outline);
  double area = 0;
  for (std::size_t k = 0; k < upper.indices.size(); k += 3) {
    const glm::vec3 a = vector_at(upper.positions, upper.indices[k]),
                    b = vector_at(upper.positions, upper.indices[k + 1]),
                    c = vector_at(upper.positions, upper.indices[k + 2]);
    const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    CHECK(twice > 0);
    area += static_cast<double>(twice) / 2;
  }
  CHECK(area == near(static_cast<double>(outline.area()) * 0.01, 0.002));
  for (std::size_t i = 0; i < upper.positions.size() / 3; ++i) {
    const glm::vec3 p = vector_at(upper.positions, i);
    CHECK(p.x == doctest::Approx(0.1f * (square.low.x + square.size * upper.uvs[2 * i])));
    CHECK(p.y == doctest::Approx(0.1f * (square.low.y + square.size * upper.uvs[2 * i + 1])));
    CHECK(p.z <= 0.0002f + 1e-7f);
    CHECK(p.z >= 0.0001f - 1e-7f);
    CHECK(vector_at(upper.normals, i).z > 0.9f);
  }
  // Teeth are complete: every protruding corner of the margin is a corner of the mesh.
  for (const glm::vec2& corner : margin.points) {
    float nearest = 1;
    for (std::size_t i = 0; i < upper.positions.size() / 3; ++i)
      nearest = std::min(nearest,
                         glm::distance(10.0f * vector_at(upper.positions, i), glm::vec3(corner.x, corner.y, 0.001f)));
    CHECK(nearest < 0.012f);
  }
}

TEST_CASE("veins are ridges below and grooves above; without relief they are colour alone") {
  const Margin margin = margin_of({}, 0);
  const Outline outline(margin.points);
  const Bending flat{.scale = 0.1f, .half_width = 0.3f};
  const auto faces = make_blade(margin, outline, midrib, flat, {.thickness = 0.001f, .relief = 1, .detail = 1});
  const auto plain = make_blade(margin, outline, midrib, flat, {.thickness = 0.001f, .relief = 0, .detail = 1});
  float deepest = 0, lowest = 0;
  const auto edge = column_at(faces[0].columns, "edge");
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const glm::vec3 above = vector_at(faces[0].mesh.positions, i), below = vector_at(faces[1].mesh.positions, i);
    const bool on_margin = edge[i] == 0;
    if (std::fabs(above.x) > 0.00101f && !on_margin) {
      CHECK(above.z == doctest::Approx(0.0005f));
      CHECK(below.z == doctest::Approx(-0.0005f));
    }
    if (!on_margin) {
      CHECK(vector_at(plain[0].mesh.positions, i).z == doctest::Approx(0.0005f));
      CHECK(edge[i] == near(outline.distance({above.x * 10, above.y * 10, 0}), 0.35));
    }
    deepest = std::max(deepest, 0.0005f - above.z);
    lowest = std::min(lowest, below.z);
  }
  // The ridge is half the vein's width high: its radius, a millimetre.
  CHECK(lowest == near(-0.0015f, 0.03));
  CHECK(deepest > 0.0003f);
}

TEST_CASE("bending folds, waves and curls, and flat is flat") {
  const Bending flat{.scale = 0.1f, .half_width = 0.5f};
  CHECK(flat({0.3f, 0.7f}).x == doctest::Approx(0.03));
  CHECK(flat({0.3f, 0.7f}).y == doctest::Approx(0.07));
  CHECK(flat({0.3f, 0.7f}).z == 0);
  CHECK(flat({0.3f, 0.7f}, 0.002f).z == doctest::Approx(0.002));
  CHECK(flat.normal({0.1f, 0.1f}).z == doctest::Approx(1));
  const Bending folded{.scale = 1, .half_width = 0.5f, .fold = 30};
  CHECK(folded({0.4f, 0.5f}).z == doctest::Approx(folded({-0.4f, 0.5f}).z));
  CHECK(folded({0.4f, 0.5f}).z == near(0.5 * 0.4, 0.15));
  CHECK(folded({0, 0.5f}).z == 0);
  // Curled by 90° the tip looks straight away from the base's upper side, at an arc's radius ahead and below.
  const Bending curled{.scale = 1, .half_width = 0.5f, .curl = 90};
  CHECK(curled({0, 1}).y == doctest::Approx(2 / 3.14159265));
  CHECK(curled({0, 1}).z == doctest::Approx(-2 / 3.14159265));
  CHECK(curled.normal({0, 1}).y == doctest::Approx(1).epsilon(1e-3));
  // Lengths along the midrib are preserved.
  float length = 0;
  for (int k = 0; k < 100; ++k)
    length += glm::distance(curled({0, 0.01f * static_cast<float>(k)}), curled({0, 0.01f * static_cast<float>(k + 1)}));
  CHECK(length == doctest::Approx(1).epsilon(1e-3));
  const Bending waved{.scale = 1, .half_width = 0.5f, .undulation = 0.2f, .waves = 2};
  CHECK(waved({0.5f, 0.125f}).z == doctest::Approx(0.1));
  CHECK(waved({0.5f, 0.375f}).z == doctest::Approx(-0.1));
  CHECK(waved({0, 0.125f}).z == 0);
}

TEST_CASE("normals are those of the bent blade, without its veins") {
  const Margin margin = margin_of({}, 0);
  const Outline outline(margin.points);
  const Bending bending{.scale = 0.1f, .half_width = 0.3f, .fold = 20, .curl = 60, .undulation = 0.1f};
  const auto faces = make_blade(margin, outline, midrib, bending, {.thickness = 0.002f, .relief = 2, .detail = 1});
  const ChartSquare square = chart_square(outline);
  const std::size_t count = faces[0].mesh.positions.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 uv(faces[0].mesh.uvs[2 * i], faces[0].mesh.uvs[2 * i + 1]);
    const glm::vec3 normal = bending.normal(square.low + square.size * uv);
    CHECK(glm::distance(vector_at(faces[0].mesh.normals, i), normal) < 1e-3f);
    CHECK(vector_at(faces[1].mesh.normals, i) == -vector_at(faces[0].mesh.normals, i));
  }
}

TEST_CASE("the petiole begins under the blade, has the requested length and widens to its foot") {
  const Bending bending{.scale = 0.1f, .half_width = 0.3f, .curl = 40};
  const auto segments = make_petiole(bending, 0.05f, 0.001f);
  REQUIRE(segments.size() > 2);
  float length = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    CHECK(segments[i].parent == static_cast<std::int32_t>(i) - 1);
    if (i > 0) CHECK(segments[i].start == segments[i - 1].end);
    if (i > 0) length += glm::distance(segments[i].start, segments[i].end);
  }
  CHECK(length == near(0.05, 0.01));
  CHECK(segments[0].end == bending({0, 0}));
  CHECK(segments[0].start.y > 0);
  CHECK(segments.back().end.y < -0.03f);
  CHECK(segments.back().radius_end > segments[1].radius);
  CHECK(make_petiole(bending, 0, 0.001f).empty());
}
