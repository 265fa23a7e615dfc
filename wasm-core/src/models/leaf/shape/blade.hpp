// The blade as a mesh: a triangulation of the outline, fine along margin and veins, with both faces and a rim.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "models/leaf/shape/bending.hpp"
#include "models/leaf/shape/margin.hpp"
#include "models/particles/outline.hpp"
#include "plant/plant.hpp"

namespace panicle::particles::leaf {

// A piece of a vein in the chart: leaf lengths.
struct VeinPiece {
  glm::vec2 from, to;
  float radius_from, radius_to;
};

struct BladeForm {
  float thickness = 0.00025f;  // metres
  float relief = 1;            // height of ridges below, over half a vein's width
  float detail = 1;            // triangles, against the default
};

// The square of the chart that textures show: uv 0, 0 is `low`, 1, 1 is `size` further along both axes; leaf lengths.
struct ChartSquare {
  glm::vec2 low{0};
  float size = 1;
};
ChartSquare chart_square(const Outline& outline);

// Two meshes of the material `blade`, together closed: `upper`, the face that looks to +Z while flat; `lower`, the
// other and the rim around. Veins raise the lower face, and sink the upper by less. Normals ignore this relief: the
// normal map shows it, with finer veins than the mesh has. Both have the chart as texture coordinates, and the column
// of their vertices `edge` (float32: approximate distance from the margin, leaf lengths). Empty where the outline
// cannot be triangulated.
std::vector<PlantMesh> make_blade(const Margin& margin, const Outline& outline, std::span<const VeinPiece> veins,
                                  const Bending& bending, const BladeForm& form);

}  // namespace panicle::particles::leaf
