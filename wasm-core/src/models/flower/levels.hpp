// A flower at four distances, for beds and meadows: what is seen of hundreds, few of which are near.
//
// Its levels are its own skin, unrounded but with vertices where rounding would put them, less what its size in the
// view cannot show. What that is follows from the map, and from the text's sizes as an open flower of seed 1 would have
// them: so it is found once for all plants that have one map, and each level of each is only placed. Organs that hang
// together alike and are about as large are thinned by one list (organ_forms.hpp); of a crowd of those only some are
// left from afar, wider.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generalized_map/boundary.hpp"
#include "generalized_map/embedding.hpp"
#include "models/flower/derivation.hpp"
#include "models/flower/level.hpp"
#include "models/flower/organ_corners.hpp"
#include "models/flower/organ_forms.hpp"
#include "plant/plant.hpp"

namespace panicle::flower {

inline constexpr std::size_t level_count = 4;

class FlowerLevels {
 public:
  // Of a map that `embedding` has laid, and which it places anew. What `derived` has stays as it is.
  FlowerLevels(const Program& program, const Given& given, const Limits& limits, Derived& derived,
         generalized_map::Embedding& embedding);

  // Whether another flower with the same map has the same levels, placed anew.
  bool lasting() const { return lasting_; }
  // Places all levels, which places `embedding`, and adds their meshes `level0` … from near to far, of material
  // `level`: a run for each kind of material. `numbers`: of materials, to which those are added that are not there.
  void add_to(Plant& plant, const Program& program, const Derived& derived, generalized_map::Embedding& embedding,
              std::vector<std::uint32_t>& numbers);
  std::uint64_t bytes() const;  // that it holds, about

 private:
  // One in so many of what stands close together is left: of each form that is a crowd, and of all together.
  struct Sparse {
    std::uint32_t of_form = 1, of_all = 1;
  };
  // What is left of a flower: which organs, and how far these are thinned.
  struct Choice {
    Sparse sparse;
    std::vector<std::uint8_t> organs;
    float error = 0;
  };

  static std::uint32_t stride(const OrganForm& form, const Sparse& sparse);
  static std::uint32_t stride_of_all(const OrganForm& form, const Sparse& sparse);
  std::vector<std::uint8_t> retained_organs(const Sparse& sparse) const;
  std::size_t triangles(const std::vector<std::uint8_t>& retained, float error) const;
  Choice choose(std::size_t most) const;
  // Of each form, how much wider what is left of an organ must be to be as large as it was.
  std::vector<float> fuller(float error, const std::vector<glm::vec3>& places) const;
  Level::Remains remains(const Choice& choice, const std::vector<glm::vec3>& places) const;
  std::vector<glm::vec3> rounded(const Derived& derived, generalized_map::Embedding& embedding);

  generalized_map::Boundary boundary_;
  std::vector<std::uint8_t> is_tube_;
  OrganCorners corners_;
  std::optional<OrganForms> organs_;
  std::vector<Level> levels_;
  std::vector<std::uint8_t> numbers_;  // of materials, by volume, that levels are dressed by
  bool lasting_ = true;
};

}  // namespace panicle::flower
