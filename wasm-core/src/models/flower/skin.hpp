// The visible surface of a flower: the boundary of its map, rounded, with a mesh for each material.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generalized_map/boundary.hpp"
#include "generalized_map/embedding.hpp"
#include "models/flower/derivation.hpp"
#include "models/flower/organ_corners.hpp"
#include "plant/plant.hpp"

namespace panicle::flower {

// The material of volumes with a number as m: by the text, or a default (docs/models/flower/language.md).
Material material_of(const Program& program, std::uint32_t number);
// Its colours at an age of the flower.
Colours colours_at(const Material& material, float age);

// A skin's topology is computed once for a map; its vertices are placed whenever volumes are.
//
// Meshes in metres, +Y up, named by their materials' numbers. Columns of each:
//   volume   uint32 a triangle: its volume
//   face     uint16 as uint32 a triangle: the volume's face, 0 O, 1 E, from 2 on C1 …
//   sky      uint8 a vertex, where requested
//   uvs      u along its organ, v beside the middle, both 0 … 1
class Skin {
 public:
  // Of a map in `embedding`. `rounds`: number of subdivisions, 0 to 3.
  Skin(const Derived& derived, const generalized_map::Embedding& embedding, std::uint32_t rounds);

  // The number of rounds up to `requested` that keeps the triangles within their limit.
  static std::uint32_t rounds_for(const Derived& derived, std::uint32_t requested);
  static constexpr std::uint32_t max_triangles = 4'000'000;

  // Shapes for the embedding with which the skin is as thick as the text sets: rounding shrinks tubes, by a third where
  // they have four sides, so they are widened before.
  std::vector<generalized_map::Shape> shapes(const Derived& derived) const;

  // Places the skin by an embedding of `shapes`, and adds its meshes. Returns the material's number of each.
  std::vector<std::uint32_t> add_to(Plant& plant, const Program& program, const Derived& derived,
                                    const generalized_map::Embedding& embedding, bool sky);

  std::uint32_t rounds() const { return static_cast<std::uint32_t>(levels_.size() - 1); }
  std::uint64_t bytes() const;  // memory that it holds, roughly

 private:
  // Faces of one material.
  struct Part {
    std::uint32_t number = 0;
    std::vector<std::uint32_t> vertices;  // of the surface, by those of the mesh
    std::vector<std::uint32_t> corners;   // of faces, each by a vertex of the mesh
    std::vector<std::uint32_t> halves;    // and the surface's half-edges that leave there
    std::vector<std::uint32_t> begins;    // where those of each face begin; and the end
    std::vector<std::uint32_t> indices;
    std::shared_ptr<const std::vector<std::uint32_t>> volumes, faces;  // of triangles
  };

  void build_parts(const std::vector<std::uint8_t>& numbers);

  std::vector<ClosedSurface> levels_;        // each the one before refined
  std::optional<OrganCorners> corners_;      // of the first one
  std::vector<std::uint32_t> volume_;        // by face of the last one
  std::vector<generalized_map::Face> face_;  // by face of the last one
  std::vector<std::uint32_t> begin_;         // first half-edge of each face; and the end
  std::vector<std::uint8_t> numbers_;        // of materials, by volume, that `parts_` are of
  std::vector<Part> parts_;
  std::vector<std::uint8_t> is_tube_;  // by volume
};

}  // namespace panicle::flower
