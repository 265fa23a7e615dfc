// A flower at one distance: triangles among the vertices of its boundary, with runs of materials, placed anew for each
// flower of one map.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "models/flower/organ_forms.hpp"
#include "plant/plant.hpp"

namespace panicle::flower {

class Level {
 public:
  // An organ that is widened by a factor.
  struct Wide {
    std::uint32_t organ = 0;
    float times = 1;
  };
  // The remaining triangles: three vertices of the boundary and the volume of each.
  struct RemainingTriangles {
    std::vector<std::uint32_t> vertices, volumes;
    std::vector<Wide> wide;
  };

  // Vertices are duplicated at sharp edges of the surface. `places`: of the boundary's vertices.
  Level(RemainingTriangles remains, const std::vector<glm::vec3>& places);

  // Builds a run for each kind of material, and a vertex for each material at a smooth vertex. `numbers`: of materials,
  // by volume.
  void dress(const Program& program, const std::vector<std::uint8_t>& numbers);
  // Widens organs across the direction from their foot to their tip. `places`: of the boundary's vertices.
  void widen(const OrganForms& organs, std::vector<glm::vec3>& places) const;
  // The mesh of the runs, without texture coordinates; `places` in millimetres with +Z up.
  PlantMesh mesh(const std::vector<glm::vec3>& places) const;

  // Triangles, three vertices of the boundary each.
  std::size_t triangles() const { return corners_.size() / 3; }
  // The vertices of triangle `t`, with one number for all that share their normal.
  std::array<std::uint32_t, 3> triangle(std::size_t t) const {
    return {smooth_[corners_[3 * t]], smooth_[corners_[3 * t + 1]], smooth_[corners_[3 * t + 2]]};
  }
  // Vertices of the mesh: the boundary's vertex of each, and the number of its material.
  std::uint32_t vertex(std::size_t drawn) const { return smooth_[drawn_[drawn]]; }
  const std::vector<std::uint8_t>& numbers() const { return number_; }
  std::uint64_t bytes() const;  // memory that it holds, roughly

 private:
  void split_at_edges(const std::vector<std::uint32_t>& vertices, const std::vector<glm::vec3>& places);

  std::vector<std::uint32_t> corners_;  // of triangles, indices of `smooth_`
  std::vector<std::uint32_t> volumes_;  // of triangles
  std::vector<std::uint32_t> smooth_;   // vertices with one normal: the boundary's vertex of each
  std::vector<Wide> wide_;
  // The runs of `dress`.
  std::vector<MeshRun> runs_;
  std::vector<std::uint32_t> indices_, drawn_;  // by vertex of the mesh, its index in `smooth_`
  std::vector<std::uint8_t> number_;            // of its material
};

}  // namespace panicle::flower
