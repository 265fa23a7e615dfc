// A flower's grammar after reading (Petrenko 2014, section 2.2.1 and Table 3; docs/models/flower/language.md): volumes,
// variables, productions and modules, with byte code for their numbers and without their text.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "generalized_map/prism.hpp"
#include "lsystem/derivation/program.hpp"

namespace panicle::flower {

using generalized_map::Face;

inline constexpr std::uint32_t invalid = ~0u;

// The numbers of a volume, in the order of Table 4. The thesis's text has them without the translation.
enum class Field : std::uint8_t {
  order,        // sides of the prism
  translation,  // how far the end lies from the base, in heights
  turn_x,       // degrees
  turn_y,
  turn_z,
  height,  // lengths in millimetres
  length,
  width,
  material,
};
inline constexpr std::size_t fields = 9;
inline constexpr std::array<std::string_view, fields> field_names = {"N", "T", "atx", "aty", "atz", "H", "L", "W", "m"};
using VolumeValues = std::array<float, fields>;

// Names in expressions besides variables and the predecessor's fields, in registers of the byte code after those.
enum class Word : std::uint8_t {
  step = fields,  // of the volume's grammar, from 0 on
  final_step,
  face,    // the number of the side that it grows on, 0 on O and E
  age,     // of the flower: 0 a bud, 1 open, 2 wilted
  along,   // rank of the volume that it grows from: number of volumes along the axis of its organ,
  beside,  // and number beside the axis
};
inline constexpr std::size_t words = 6;
inline constexpr std::array<std::string_view, words> word_names = {"step", "finalStep", "face",
                                                                   "age",  "along",     "beside"};
// The first of these words are reserved; the others are hidden by variables of the same name, as a volume's numbers
// are.
inline constexpr std::size_t reserved_words = 4;
// Whether a name is a word of the language.
inline bool is_reserved(std::string_view name) {
  return std::find(word_names.begin(), word_names.begin() + reserved_words, name) !=
         word_names.begin() + reserved_words;
}

// An expression of the text, with code of its own.
struct Number {
  expression::Value value;
  bool draws = false;
};

// A list of a volume's numbers; omitted numbers are inherited. One range of code for all.
struct Description {
  expression::Range code;
  std::array<std::uint32_t, fields> sources{};  // registers
  std::uint16_t given = 0;                      // bits of fields
  expression::SourceLocation place;
  std::array<expression::SourceLocation, fields> places{};  // of given fields

  // Whether a field was given.
  bool has(Field field) const { return (given >> static_cast<std::uint32_t>(field) & 1) != 0; }
};

struct Label {
  std::string name;
  std::uint32_t grammar = 0;
  Description description;
  expression::Range productions;  // in Program::productions
  expression::SourceLocation place;
};

// `E`, `O`, `C4`, or `C(expression)`.
struct FaceOf {
  Face face = generalized_map::base_face;
  bool worked_out = false;  // a side whose number is in the register `source`
  std::uint32_t source = 0;
  expression::SourceLocation place;
};

// A value that a call gives one of a module's variables in place of its own: `&PETAL{len=60}`.
struct Setting {
  std::uint32_t variable = 0;
  expression::Value value;
};

// `[NEW(…)]_{faces}`, or with & a module.
struct GrowAction {
  bool module = false;
  std::uint32_t target = 0;  // a label, or a grammar
  std::vector<FaceOf> faces;
  expression::Range blocks;  // code of the production's blocks and of the faces
  Description arguments;
  std::vector<Setting> settings;  // of a module
  std::uint32_t number = 0;       // index in the whole program, for notes
};

// `predecessor {before} {condition} {after} -> successor`
struct Production {
  enum class Kind : std::uint8_t { grow, glue, split };
  Kind kind = Kind::grow;
  std::uint32_t predecessor = 0;  // a label
  expression::SourceLocation place;
  Number condition;      // where given
  bool by_step = false;  // whether the condition depends on steps alone
  // grow
  std::uint32_t becomes = invalid;  // another label, where the successor begins with one
  std::vector<GrowAction> growths;
  // glue: own face, and the other label's; split: the face to split at
  Face face = generalized_map::base_face, other_face = generalized_map::base_face;
  std::uint32_t other = 0;
  std::uint32_t rest = 0, part = 0;
  Description rest_description, part_description;
  expression::Range blocks;
  std::uint32_t number = 0;  // index in the whole program
};

// `#define name=expression`
struct Variable {
  std::string name;
  std::uint32_t grammar = 0;
  std::uint32_t to = 0;  // register
  Number number;
  std::uint32_t needs = 0;  // end of the part of its grammar's once_bound that it uses
  bool rebuilds = false;    // whether the map depends on it, and not only its vertices' places
};

// Where an organ begins and where it ends: red, green and blue, 8 bits each, as sRGB.
struct Colours {
  std::uint32_t base = 0, tip = 0;
};

// Kinds of material, in the order of their runs in a level.
inline constexpr std::array<std::string_view, 7> material_kinds{"petal",  "sepal",  "leaf", "stem",
                                                                "stamen", "pistil", "seed"};

// The material of the volumes whose m is its number, as in `#material 4 petal "c8102e" "f6d55c" foot 0.4
// margin "ffffff" 0.2 veins "8a1030" 9 0.5 light 0.6 bud "5d8250"`. Settings after kind and colours are optional.
struct Material {
  std::uint32_t number = 0;
  std::string kind;  // of `material_kinds`
  std::string name;  // of organs of the material; empty: its kind's
  Colours open;
  Colours bud, wilted;  // at an age of 0 and of 2; mixed between
  // share of an organ's length over which the first colour blends into the second
  float foot = 0.6f;
  std::uint32_t margin = 0, veins = 0;      // colours
  float margin_width = 0;                   // as a share of half the width
  float vein_count = 0, vein_strength = 0;  // a side; 0 … 1
  bool feathered = false;                   // veins branch off one in the middle instead of spreading from the foot
  float light = 0;                          // share of light that comes through from behind
  expression::SourceLocation place;
};

// The share of light that comes through a kind of material, by default.
float light_through(std::string_view kind);

// The text itself, or one of its modules.
struct Grammar {
  std::string name;
  std::uint32_t axiom = invalid;  // a label
  Description axiom_arguments;
  expression::Range variables;  // in Program::variables
  // Code that depends on its variables and those of the text alone; it runs when they are bound.
  expression::Range once_bound;
  Number final_step;   // where given
  bool draws = false;  // whether a variable is drawn or given by a call, so that each instance has its own
  expression::SourceLocation place;
};

struct Program {
  std::vector<Grammar> grammars;  // the text itself first
  std::vector<Label> labels;
  std::vector<Variable> variables;
  std::vector<Production> productions;  // those of a label together, in the order of the text
  std::vector<Material> materials;
  std::uint32_t growths = 0;
  bool age_rebuilds = false, values_rebuild = false;  // whether the map depends on `age`, or on volumes' own numbers
  bool draws_rebuild = false;                         // or on draws other than in variables of the text
  // The text without the parts that only place the map: materials, and the figures of numbers that no order, face,
  // condition or number of steps depends on.
  std::string structure_key;
  expression::Code code;
  std::vector<std::string> notes;

  std::uint64_t bytes() const;  // memory that it holds, without names
};

// Reads a flower's grammar. Errors: syntax, undefined and limit, with line and column.
Result<Program> read_program(std::string_view text, const Limits& limits = {});

}  // namespace panicle::flower
