// A plant's shoots and leaves in the order of their steps, with their parents, without shape: the counts never depend
// on free room (Kim, Kim and Cho 2013, section 3.3).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "models/growth/rules.hpp"

namespace panicle::growth {

struct Shoot {
  std::int32_t parent = -1;  // index of the parent shoot; −1: rises from the ground
  std::uint32_t volume = 0;  // index of the growth volume that shapes its tree (Population::volumes)
  std::uint16_t born = 0;    // step of its first internode
  std::uint16_t node = 0;    // the parent's internode that it is attached to: that of the parent's age `node`
  std::uint8_t order = 0;    // 0 a trunk or child trunk, 1 a branch of a trunk, …
  bool trunk = false;
};

// A change of one shoot by the grammar's conditions ("ndv < 0 -> …"), valid from a step on.
struct Deformation {
  std::uint32_t shoot = 0;
  std::uint16_t step = 0;
  float gravitropism = 0;  // added
  float length = 1;        // factor
};

struct Leaf {
  static constexpr std::uint16_t never = 0xffff;

  std::uint32_t shoot = 0;
  std::uint16_t born = 0;
  std::uint16_t falls = never;  // step at which it becomes a falling leaf; of foliage in that step's autumn
  std::uint16_t gone = never;   // step during which it goes, as the foliage of an earlier year

  bool operator==(const Leaf&) const = default;
};

// A growth volume: wb, h, wt of section 3.3 in metres, gradient in radians.
struct GrowthVolume {
  std::uint32_t id = 0;
  float base = 0, height = 0, top = 0, gradient = 0;
  glm::vec3 at{0};
  float size = 1;
  float towards = 0;  // azimuth that it leans to, in radians from +X to +Z
  float middle = 0;   // width halfway up, metres
};

// The environment of a volume, after the grammar's conditions.
struct Environment {
  float phototropism = 0.1f, gravitropism = 0, neighbours = 1;
};

struct Population {
  std::vector<Shoot> shoots;  // parents first, by step
  // One a shoot, by which edits name it: the same for any seed, number of steps and number of other shoots.
  std::vector<std::uint64_t> addresses;
  std::vector<Deformation> deformations;
  std::vector<Leaf> leaves;
  std::vector<GrowthVolume> volumes;
  std::vector<Environment> environments;  // one a volume
  std::uint16_t steps = 0;
  std::uint32_t branches = 0;  // without trunks, as Table 1 counts them
  bool has_foliage = false;    // some leaves are renewed with the year, so that leaves fall in autumn alone
};

// The population of a grammar after `steps` steps. Pure: the same rules, seed and steps give the same. A later step
// only adds to an earlier one (populate(s) is a prefix of populate(s+1) per shoot), so that age can be continuous.
// Errors: evaluation, with line and column (an expression without a usable number); bad_input (sums of divisors beyond
// exact floats, before anything grows); limit.
Result<Population> populate(const Rules& rules, std::uint64_t seed, std::uint16_t steps, const Limits& limits,
                            std::vector<std::string>& notes);

}  // namespace panicle::growth
