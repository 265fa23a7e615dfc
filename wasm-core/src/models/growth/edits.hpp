// Edits of single branches by hand: a shoot is cut, broken or dead, or follows a drawn curve. The rules of the grammar
// decide which shoots there are; edits apply to the shoots that exist.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "foundation/result.hpp"
#include "models/growth/population.hpp"

namespace panicle::growth {

inline constexpr std::uint32_t max_edits = 256;        // of one plant
inline constexpr std::uint32_t max_curve_points = 16;  // of one drawn shoot
inline constexpr std::uint32_t words_per_edit = 5;     // in a request
inline constexpr float max_curve_reach = 300;  // of a point from the base of its shoot in each direction, metres

enum class EditKind : std::uint32_t {
  prune,  // cut at a share of its length, with all that grows beyond
  snap,   // the same, with a jagged stub that dies back to its last living branch
  dead,   // it and all that grows on it has no leaves, bark or fine twigs
  curve,  // its nodes follow a drawn curve
};

struct BranchEdit {
  std::uint64_t address = 0;  // of the shoot: Population::addresses
  EditKind kind = EditKind::prune;
  float at = 1;                  // where it is cut, as a share of its internodes, 0 … 1
  std::vector<glm::vec3> curve;  // points after the base, relative to it, metres
};

// Reads edits: `records` has for each edit the lower and the upper half of the address, the kind, the place of a cut in
// thousandths and the number of points; `points` all points, x, y, z. Errors: bad_request; limit (too many edits or
// points).
Result<std::vector<BranchEdit>> read_edits(std::span<const std::uint32_t> records, std::span<const float> points);

// The edits of one shoot together. Of two cuts, and of two curves, the later counts.
struct ShootEdit {
  float cut = 1;
  bool snapped = false, dead = false;
  std::vector<glm::vec3> curve;  // the smooth curve, densely sampled, from the base; empty: none
  std::vector<float> distances;  // along the curve up to each point, metres
};

// Edits by shoot of a population.
class ShootEdits {
 public:
  ShootEdits() = default;
  ShootEdits(const Population& population, std::span<const BranchEdit> edits);

  bool empty() const { return edits_.empty(); }
  // The edits of a shoot; null: none.
  const ShootEdit* of(std::uint32_t shoot) const {
    return numbers_.empty() || numbers_[shoot] == none ? nullptr : &edits_[numbers_[shoot]];
  }
  // The number of edits whose shoot the population does not have.
  std::uint32_t unknown() const { return unknown_; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<ShootEdit> edits_;
  std::vector<std::uint32_t> numbers_;  // one a shoot, an index of `edits_`; empty without edits
  std::uint32_t unknown_ = 0;
};

// The place at a share 0 … 1 of the length of an edit's curve, relative to its base.
glm::vec3 place_on_curve(const ShootEdit& edit, float share);

}  // namespace panicle::growth
