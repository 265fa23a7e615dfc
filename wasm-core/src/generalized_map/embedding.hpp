// The positions of a map's vertices. Topology and shape are apart (Petrenko 2014, section 2.2.1: a map has no geometry
// of its own, and any number of embeddings): `build` depends on the map and is needed again only when that has changed,
// `place` depends on the shapes.
//
// A volume that has grown on a face has that face for its base, for any length and width of its own: it *proposes*
// places for the corners of its end alone. One that is planted, or attached to a face of another order, does so for
// those of its base, too. A vertex in the ends of several volumes is placed at the mean of their proposals: so glued
// lobes run into each other. A vertex without proposals was made by a cut, and lies midway on the edge that was cut.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "generalized_map/frame.hpp"
#include "generalized_map/map.hpp"

namespace panicle::generalized_map {

class Embedding {
 public:
  // Numbers the vertices, and finds the supporting face of each volume and the order of placing: each after its parent,
  // else as they were made.
  void build(const Map& map);

  // Places all vertices, by a shape for each volume of the map that was built. Planted volumes stand at the origin.
  void place(std::span<const Shape> shapes);

  std::span<const std::uint32_t> vertex_of() const { return vertex_of_; }  // by dart
  std::uint32_t vertices() const { return static_cast<std::uint32_t>(places_.size()); }
  std::span<const glm::vec3> positions() const { return places_; }  // by vertex
  std::span<const Frame> frames() const { return frames_; }         // by volume, after its own turns
  std::uint64_t bytes() const;                                      // that it holds

 private:
  // The topology that the placement of one volume needs.
  struct Placement {
    std::uint32_t volume, parent, order, parent_order;
    Face parent_face;
    bool proposes_base;
    std::uint32_t corners;  // where its base's vertices begin, its end's after them
    std::uint32_t support,
        support_count;  // range in `supports_`: for an attached volume, the vertices of its parent's face
  };
  struct Ends {
    std::uint32_t vertex, from, to;
  };

  void add_placement(const Map& map, std::uint32_t v);
  void place(const Placement& placement, const Shape& shape);
  void propose(std::span<const std::uint32_t> vertices, const Frame& frame, const Shape& shape,
               const glm::vec3& centre);
  void propose_rest(const Placement& placement, const Shape& shape);
  glm::vec3 centre(std::span<const std::uint32_t> vertices, const glm::vec3& otherwise);
  // Whether a volume has proposed a place for the vertex.
  bool is_proposed(std::uint32_t vertex) const { return proposals_[vertex] > 0; }
  void settle(std::uint32_t vertex);
  void settle_cut(std::uint32_t cut);

  std::vector<std::uint32_t> vertex_of_;
  std::vector<Placement> placements_;  // in the order of placing
  std::vector<std::uint32_t> corners_, supports_;
  std::vector<std::vector<glm::vec2>> polygons_;  // by order, those that are used
  std::vector<Ends> cuts_;                        // of each vertex the first
  std::vector<std::uint32_t> cut_of_;             // by vertex, where there are cuts
  std::vector<glm::vec3> places_;                 // while proposals come in, their sums
  std::vector<std::uint32_t> proposals_;          // by vertex
  std::vector<glm::vec3> settled_;                // by cut
  std::vector<std::uint8_t> is_settled_;
  std::vector<Frame> frames_;
  std::vector<glm::vec3> base_centres_;  // by volume, the middles of bases
  std::vector<std::uint32_t> waiting_, needed_;
};

}  // namespace panicle::generalized_map
