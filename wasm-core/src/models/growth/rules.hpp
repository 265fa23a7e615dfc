// A growth grammar after reading (docs/models/growth/language.md): byte code for its numbers, without its text.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/divisors.hpp"
#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "lsystem/derivation/program.hpp"

namespace panicle::growth {

// Names in expressions, in registers of the byte code from 0 on.
enum class Word : std::uint8_t {
  k,    // a shoot's age in steps
  n,    // N: k < N − 1 of a branch, k = N − 1 of its trunk
  gs,   // the growth step
  ndv,  // difference of divisor functions
  nbr,  // number of branches that it makes
  nlf,  // number of leaves
  b,    // B(x, y)
  l,    // L(x, y)
  order,
  phototropism,
  gravitropism,
  neighbours,
  length,
  count,  // of the growth volume, from here on
  id,
  base,
  height,
  top,
  gradient,
  one,  // the constant 1, which no grammar can name
};
inline constexpr std::size_t words = 20;
inline constexpr std::array<std::string_view, words> word_names = {
    "k",          "N",          "gs",           "ndv",          "nbr",          "nlf",    "B",
    "L",          "order",      "phototropism", "gravitropism", "neighbours",   "length", "GrowVol.cnt",
    "GrowVol.id", "GrowVol.wb", "GrowVol.h",    "GrowVol.wt",   "GrowVol.grad", "1"};

// The bit of a word in a set of words.
constexpr std::uint32_t bit(Word word) { return 1u << static_cast<std::uint32_t>(word); }

// An expression of the grammar.
struct Number {
  expression::Value value;
  std::uint32_t uses = 0;  // bits of words
  bool draws = false;
};

// `name(values)` or `name.rand(values)` of a growth volume.
struct Attribute {
  enum class Kind : std::uint8_t { count, id, base, height, top, gradient, towards, at, middle };
  Kind kind = Kind::count;
  bool drawn = false;           // drawn between the values
  std::array<Number, 2> range;  // the first alone where it is not drawn, except for `at`: x and z
};

struct VolumeRule {
  std::vector<Attribute> attributes;  // later ones win
  expression::SourceLocation place;
};

// `DivFunc(type, parameters){branches}`, or `{leaves}`
struct DivisorFunction {
  enum class Of : std::uint8_t { branches, leaves };
  Of of = Of::branches;
  bool argument = false;  // exp: B(x, y) or L(x, y), parameters x and y
  DivisorRule::Kind kind = DivisorRule::Kind::all;
  std::uint32_t power = 0;  // where the name has it
  bool powered = false;
  std::vector<Number> parameters;  // a where the name has no power, then b and m of a residue
  expression::SourceLocation place;
};

struct TreeRule {
  std::vector<DivisorFunction> functions;
  Number weight;  // where given, one of all rules with a weight is drawn
  expression::SourceLocation place;
};

struct Consequence {
  enum class Kind : std::uint8_t { set, leaf, falling_leaf, child_trunk, buds, foliage };
  Kind kind = Kind::set;
  Word word = Word::ndv;  // the word to set
  Number number;
  Number steps;  // of foliage, where given: the steps that it lasts
};

// `condition -> consequences : probability`
struct Rule {
  Number condition;  // where given
  std::vector<Consequence> consequences;
  Number probability;  // where given; of `bud(…) -> branch`, each bud's
  std::uint64_t stream = 0;
  expression::SourceLocation place;
};

struct Rules {
  std::vector<VolumeRule> footprint;
  std::vector<TreeRule> tree;
  std::vector<Rule> of_volumes;  // evaluated once a volume, before anything grows
  std::vector<Rule> of_shoots;   // evaluated for each shoot at every step
  Number steps_from, steps_to;   // gs, where given; the second where it is drawn
  bool repeatable =
      true;  // whether shoots of one volume and age do the same, except for random values of buds and child trunks
  bool uses_branch_function = false, uses_leaf_function = false;
  expression::Code code;
  std::vector<std::string> notes;  // on parts of the grammar without effect
};

// Reads a growth grammar. Errors: syntax, undefined and limit, with line and column.
Result<Rules> read_rules(std::string_view text, const Limits& limits = {});

// The number of steps that the grammar sets (`gs = 8`), or `otherwise`. Error: evaluation.
Result<std::uint16_t> steps_of(const Rules& rules, std::uint64_t seed, std::uint16_t otherwise);

}  // namespace panicle::growth
