// A flower at one distance: triangles among the vertices of its boundary, dressed by what its volumes are made of, and
// placed.
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
  // An organ that is drawn wider.
  struct Wide {
    std::uint32_t organ = 0;
    float times = 1;
  };
  // What is left: of each triangle three vertices of the boundary and the volume that it is of.
  struct Remains {
    std::vector<std::uint32_t> vertices, volumes;
    std::vector<Wide> wide;
  };

  // Vertices are parted where the surface has an edge, by `places` of the boundary's vertices.
  Level(Remains remains, const std::vector<glm::vec3>& places);

  // A run for each kind of material, and a vertex for each material that meets in it. `numbers`: of materials, by
  // volume.
  void dress(const Program& program, const std::vector<std::uint8_t>& numbers);
  // Of the boundary's vertices: across the way from an organ's foot to its tip, what is drawn wider.
  void widen(const OrganForms& organs, std::vector<glm::vec3>& places) const;
  // What was dressed, without texture coordinates; `places` in millimetres as texts have them.
  PlantMesh mesh(const std::vector<glm::vec3>& places) const;

  // Triangles, three vertices of the boundary each.
  std::size_t triangles() const { return corners_.size() / 3; }
  std::array<std::uint32_t, 3> triangle(std::size_t t) const {
    return {smooth_[corners_[3 * t]], smooth_[corners_[3 * t + 1]], smooth_[corners_[3 * t + 2]]};
  }
  // Vertices of the mesh: which of the boundary each is, and the number of its material.
  std::uint32_t vertex(std::size_t drawn) const { return smooth_[drawn_[drawn]]; }
  const std::vector<std::uint8_t>& numbers() const { return number_; }
  std::uint64_t bytes() const;  // that it holds, about

 private:
  void part(const std::vector<std::uint32_t>& vertices, const std::vector<glm::vec3>& places);

  std::vector<std::uint32_t> corners_;  // of triangles, by `smooth_`
  std::vector<std::uint32_t> volumes_;  // of triangles
  std::vector<std::uint32_t> smooth_;   // what has one normal: of each its vertex
  std::vector<Wide> wide_;
  // As materials have it: what is drawn.
  std::vector<MeshRun> runs_;
  std::vector<std::uint32_t> indices_, drawn_;  // by vertex of the mesh, which of `smooth_`
  std::vector<std::uint8_t> number_;            // of its material
};

}  // namespace panicle::flower
