// A flower at four distances, for beds and meadows: what is seen of hundreds, few of which are near.
//
// Its levels are its own skin, unrounded but with vertices where rounding would put them, less what its size in the
// view cannot show. What that is follows from the map, and from the text's sizes as an open flower of seed 1 would have
// them: so it is found once for all plants that have one map, and each level of each is only placed. Organs that hang
// together alike and are about as large are thinned by one list; of a crowd of those only some are left from afar,
// wider.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "generalized_map/boundary.hpp"
#include "generalized_map/embedding.hpp"
#include "geometry/thinning.hpp"
#include "models/flower/derivation.hpp"
#include "plant/plant.hpp"

namespace panicle::flower {

inline constexpr std::size_t level_count = 4;

class Levels {
 public:
  // Of a map that `embedding` has laid, and which it places anew. What `derived` has stays as it is.
  Levels(const Program& program, const Given& given, const Limits& limits, Derived& derived,
         generalized_map::Embedding& embedding);

  // Whether another flower with the same map has the same levels, placed anew.
  bool lasting() const { return lasting_; }
  // Places all levels, which places `embedding`, and adds their meshes `level0` … from near to far, of material
  // `level`: a run for each kind of material. `numbers`: of materials, to which those are added that are not there.
  void add_to(Plant& plant, const Program& program, const Derived& derived, generalized_map::Embedding& embedding,
              std::vector<std::uint32_t>& numbers);
  std::uint64_t bytes() const;  // that it holds, about

 private:
  // Organs that hang together alike.
  struct Form {
    std::vector<std::array<std::uint32_t, 3>> triangles;  // of the first one's, by its own vertices
    std::vector<std::uint32_t> faces;                     // of triangles: which of its faces
    std::vector<Collapse> thinning;
    std::vector<std::uint8_t> is_foot;  // by vertex: 1 those of what bears it, 2 of a base of its own
    std::uint32_t organs = 0;
    // What is left of one that bears nothing where it is thinned no further: a kite with two sides. Its corners are a
    // vertex of the foot, one at a side, the one farthest from the foot, and one at the other side.
    std::array<std::uint32_t, 4> kite{};
    std::array<std::uint32_t, 2> kite_faces{};  // whose materials its two sides have
    float kite_error = 0;
    bool bears = false, rooted = false;

    std::uint32_t tip() const { return kite[2]; }
    bool is_kite(float error) const { return rooted && !bears && error >= kite_error; }
  };
  struct Organ {
    std::uint32_t form = 0, number = 0;     // the how manieth of its form
    std::uint32_t maker = 0;                // another organ
    std::uint32_t vertices = 0, faces = 0;  // where its own begin
  };
  // An organ that is drawn wider.
  struct Wide {
    std::uint32_t organ = 0;
    float times = 1;
  };
  struct Level {
    std::vector<std::uint32_t> corners;  // of triangles, by `smooth`
    std::vector<std::uint32_t> volumes;  // of triangles
    std::vector<std::uint32_t> smooth;   // what has one normal: of each its vertex
    std::vector<Wide> wide;
    // As materials have it: what is drawn.
    std::vector<MeshRun> runs;
    std::vector<std::uint32_t> indices, drawn;  // by vertex of the mesh, which of `smooth`
    std::vector<std::uint8_t> number;           // of its material
  };

  void find_organs(const Derived& derived);
  std::vector<std::uint32_t> number_vertices(std::uint32_t organ, const std::vector<std::uint32_t>& owner);
  void find_form(const Derived& derived, std::uint32_t organ, const std::vector<glm::vec3>& places,
                 const std::vector<std::uint32_t>& owner);
  // `labels`: of the organ's faces, what their volumes are called.
  static void find_kite(Form& form, const std::vector<glm::vec3>& places, const std::vector<std::uint32_t>& labels);
  // One in so many of what stands close together is left: of each form that is a crowd, and of all together.
  struct Sparse {
    std::uint32_t of_form = 1, of_all = 1;
  };
  std::uint32_t stride(const Organ& organ, std::uint32_t thin) const;
  std::uint32_t stride_of_all(const Organ& organ, std::uint32_t thin) const;
  std::vector<std::uint8_t> kept(const Sparse& sparse) const;
  std::size_t triangles(const std::vector<std::uint8_t>& kept, float error) const;
  void choose(Level& level, std::size_t most, const std::vector<glm::vec3>& places);
  void smoothen(Level& level, const std::vector<std::uint32_t>& vertices, const std::vector<glm::vec3>& places);
  void dress(Level& level, const Program& program);
  void widen(const Level& level, std::vector<glm::vec3>& places) const;
  std::vector<glm::vec3> rounded(const Derived& derived, generalized_map::Embedding& embedding);

  generalized_map::Boundary boundary_;
  std::vector<std::uint32_t> begin_;  // of faces, their half-edges; and the end
  std::vector<std::uint8_t> is_tube_;
  std::vector<Organ> organs_;
  std::vector<std::uint32_t> own_vertices_, own_faces_;  // of organs, one after the other
  std::vector<Form> forms_;
  // While forms are found: what tells each, and by vertex the number that it has in an organ.
  std::map<std::vector<std::uint32_t>, std::uint32_t> known_;
  std::vector<std::uint32_t> local_;
  std::vector<Level> levels_;
  std::vector<std::uint8_t> numbers_;  // of materials, by volume, that levels are dressed by
  bool lasting_ = true;
};

}  // namespace panicle::flower
