#include "models/grammar/outlines.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "grammar_files.hpp"
#include "growing.hpp"
#include "models/grammar/surfaces.hpp"

namespace panicle::grammar {
namespace {

std::string leaf() {
  std::ifstream file(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar/leaf.lsys");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// Extent and area of a blade, seen from above.
struct Shape {
  float left = 0, right = 0, bottom = 0, top = 0, area = 0;
};

Shape shape_of(const Mesh& mesh, float scale) {
  Shape shape;
  const auto at = [&](std::uint32_t v) { return scale * glm::vec2(mesh.positions[3 * v], mesh.positions[3 * v + 1]); };
  for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::vec2 a = at(mesh.indices[k]), b = at(mesh.indices[k + 1]) - a, c = at(mesh.indices[k + 2]) - a;
    shape.area += 0.5f * std::fabs(b.x * c.y - b.y * c.x);
    for (const glm::vec2& p : {a, a + b, a + c}) {
      shape.left = std::min(shape.left, p.x);
      shape.right = std::max(shape.right, p.x);
      shape.bottom = std::min(shape.bottom, p.y);
      shape.top = std::max(shape.top, p.y);
    }
  }
  return shape;
}

}  // namespace

TEST_CASE("a surface with an outline's name equals the leaf that the grammar of Table 2 grows") {
  const std::string text = leaf();
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Outline& outline = outlines[i];
    CAPTURE(outline.name);
    REQUIRE(surfaces[first_outline_surface + i].name == outline.name);
    GrammarRequest request{.text = text, .parameters = {{"unit", 1000}}, .outputs = "meshes"};
    request.constants = {{"stalk", 0},
                         {"thick", 0},
                         {"beta", 0},
                         {"veins", 0},
                         {"n", 2.0f * static_cast<float>(outline.rays) + 1},
                         {"theta", outline.theta},
                         {"offset", outline.offset},
                         {"fall", outline.fall},
                         {"bow", outline.bow},
                         {"slim", outline.slim},
                         {"lobe", outline.lobe},
                         {"turns", outline.turns},
                         {"round", outline.round},
                         {"teeth", outline.teeth}};
    const Plant grown = grow(request);
    const PlantMesh* blade = mesh_of(grown, "blades");
    REQUIRE(blade != nullptr);
    // The grammar's midrib has the length of its formula; the surface's is 1.
    const float length = shape_of(blade->mesh, 1).top;
    const Shape expected = shape_of(blade->mesh, 1 / length);
    const Shape shape = shape_of(make_surface(first_outline_surface + static_cast<std::uint32_t>(i)), 1);
    CHECK(shape.top == doctest::Approx(1).epsilon(1e-4));
    CHECK(shape.left == doctest::Approx(expected.left).epsilon(1e-3));
    CHECK(shape.right == doctest::Approx(expected.right).epsilon(1e-3));
    CHECK(shape.bottom == doctest::Approx(expected.bottom).epsilon(1e-3));
    CHECK(shape.area == doctest::Approx(expected.area).epsilon(2e-3));
    // A sheet hides half of its area.
    CHECK(surfaces[first_outline_surface + i].area == doctest::Approx(0.5 * expected.area).epsilon(0.1));
  }
}

}  // namespace panicle::grammar
