// What is seen of a flower: the boundary of its map, rounded, a mesh a material.
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

// What volumes with a number as m are made of: as the text says, or by a list of ours (docs/models/flower/language.md).
Material material_of(const Program& program, std::uint32_t number);
// Its colours at an age of the flower.
Colours colours_at(const Material& material, float age);

// How a skin hangs together is laid once a map; where it is, it is placed as often as its volumes are.
//
// Meshes in metres, +Y up, by their materials' numbers. Columns of each:
//   volume   uint32 a triangle: the volume that it is of
//   face     uint16 as uint32 a triangle: which of its faces, 0 O, 1 E, from 2 on C1 …
//   sky      uint8 a vertex, where it is asked for
//   uvs      u how far along its organ, v how far beside the middle, both 0 … 1
class Skin {
 public:
  // Of a map that `embedding` has laid. `rounds`: how often it is subdivided, 0 to 3.
  Skin(const Derived& derived, const generalized_map::Embedding& embedding, std::uint32_t rounds);

  // Of so many rounds that are asked for, how many there can be before there are more triangles than there may be.
  static std::uint32_t rounds_for(const Derived& derived, std::uint32_t requested);
  static constexpr std::uint32_t most_triangles = 4'000'000;

  // What the embedding is to place so that the skin is as thick as the text says: rounding draws tubes in, by a third
  // where they have four sides, so they are made wider before.
  std::vector<generalized_map::Shape> shapes(const Derived& derived) const;

  // Places it, by an embedding of `shapes`, and adds its meshes.
  void add_to(Plant& plant, const Program& program, const Derived& derived, const generalized_map::Embedding& embedding,
              bool sky);

  std::uint32_t rounds() const { return static_cast<std::uint32_t>(levels_.size() - 1); }
  std::uint64_t bytes() const;  // that it holds, about

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

  void part(const std::vector<std::uint8_t>& numbers);

  std::vector<ClosedSurface> levels_;        // each the one before refined
  std::optional<OrganCorners> corners_;      // of the first one
  std::vector<std::uint32_t> volume_;        // of the last one's faces, whose they are
  std::vector<generalized_map::Face> face_;  // and which
  std::vector<std::uint32_t> begin_;         // and where their half-edges begin; and the end
  std::vector<std::uint8_t> numbers_;        // of materials, by volume, that `parts_` are of
  std::vector<Part> parts_;
  std::vector<std::uint8_t> is_tube_;  // by volume
};

}  // namespace panicle::flower
