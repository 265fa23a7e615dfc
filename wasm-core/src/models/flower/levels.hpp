// A flower at four distances, for beds and meadows of hundreds of flowers, few of which are near.
//
// Levels are the flower's own skin, with unrounded faces but rounded vertices, without details too small for the view.
// The choice of details follows from the map, and from the sizes that the text gives an open flower of seed 1: it is
// made once for all plants of one map, and each level of each plant is only placed. Organs with the same topology and
// similar size are thinned by one list (organ_forms.hpp); of a crowd of those only some remain from afar, wider.
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
  // Of a map in `embedding`, which is placed anew. `derived` is unchanged after the call.
  FlowerLevels(const Program& program, const Given& given, const Limits& limits, Derived& derived,
               generalized_map::Embedding& embedding);

  // Whether another flower with the same map has the same levels, placed anew.
  bool lasting() const { return lasting_; }
  // Places all levels, which places `embedding`, and adds their meshes `level0` … from near to far, of material
  // `level`: a run for each kind of material. `numbers`: of materials; missing ones are added.
  void add_to(Plant& plant, const Program& program, const Derived& derived, generalized_map::Embedding& embedding,
              std::vector<std::uint32_t>& numbers);
  std::uint64_t bytes() const;  // memory that it holds, roughly

 private:
  // Of organs close together one in this number remains: of each form that is a crowd, and of all together.
  struct Sparse {
    std::uint32_t of_form = 1, of_all = 1;
  };
  // The organs that remain, and the error that they are thinned to.
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
  // By form, the factor of an organ's width after thinning that restores its area.
  std::vector<float> width_factors(float error, const std::vector<glm::vec3>& places) const;
  Level::RemainingTriangles remains(const Choice& choice, const std::vector<glm::vec3>& places) const;
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
