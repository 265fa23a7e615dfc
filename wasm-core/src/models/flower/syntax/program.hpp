// A flower's grammar as it is read (Petrenko 2014, section 2.2.1 and Table 3; docs/models/flower/language.md): volumes,
// variables, productions and modules, with byte code for their numbers and nothing of their text.
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

// What a volume's numbers say, in the order of Table 4. The thesis's text has them without the translation.
enum class Field : std::uint8_t {
  order,        // of the prism
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

// What expressions call by name besides variables and the predecessor's fields, in registers of the byte code behind
// those.
enum class Word : std::uint8_t {
  step = fields,  // of the grammar that the volume is of, from 0 on
  final_step,
  face,    // the side's number that it grows on, 0 on O and E
  age,     // of the flower: 0 a bud, 1 open, 2 wilted
  along,   // where the volume stands that it grows from: how many volumes along the axis of its organ,
  beside,  // and how many beside that
};
inline constexpr std::size_t words = 6;
inline constexpr std::array<std::string_view, words> word_names = {"step", "finalStep", "face",
                                                                   "age",  "along",     "beside"};
// Of these, the first, whose names nothing else may have; the others are hidden by variables, as a volume's numbers
// are.
inline constexpr std::size_t reserved_words = 4;
inline bool is_reserved(std::string_view name) {
  return std::find(word_names.begin(), word_names.begin() + reserved_words, name) !=
         word_names.begin() + reserved_words;
}

// An expression of the text, with code of its own.
struct Number {
  expression::Value value;
  bool draws = false;
};

// What a list of numbers says of a volume; what it leaves empty is inherited. One code for all.
struct Description {
  expression::Range code;
  std::array<std::uint32_t, fields> sources{};  // registers
  std::uint16_t given = 0;                      // bits of fields
  expression::Place place;
  std::array<expression::Place, fields> places{};  // of what is given

  bool has(Field field) const { return (given >> static_cast<std::uint32_t>(field) & 1) != 0; }
};

struct Label {
  std::string name;
  std::uint32_t grammar = 0;
  Description description;
  expression::Range productions;  // in Program::productions
  expression::Place place;
};

// `E`, `O`, `C4`, or `C(expression)`.
struct FaceOf {
  Face face = generalized_map::base_face;
  bool worked_out = false;  // a side, whose number is that of a register
  std::uint32_t source = 0;
  expression::Place place;
};

// What a call gives one of a module's variables instead of its own value: `&PETAL{len=60}`.
struct Setting {
  std::uint32_t variable = 0;
  expression::Value value;
};

// `[NEW(…)]_{faces}`, or with & a module.
struct GrowAction {
  bool module = false;
  std::uint32_t target = 0;  // a label, or a grammar
  std::vector<FaceOf> faces;
  expression::Range blocks;  // what the production works out before, and the faces
  Description arguments;
  std::vector<Setting> settings;  // of a module
  std::uint32_t number = 0;       // among all of the program, for notes
};

// `predecessor {before} {condition} {after} -> successor`
struct Production {
  enum class Kind : std::uint8_t { grow, glue, split };
  Kind kind = Kind::grow;
  std::uint32_t predecessor = 0;  // a label
  expression::Place place;
  Number condition;      // where given
  bool by_step = false;  // whether that asks for steps and nothing else
  // grow
  std::uint32_t becomes = invalid;  // another label, where the successor begins with one
  std::vector<GrowAction> growths;
  // glue: own face, and whose other one; split: where
  Face face = generalized_map::base_face, other_face = generalized_map::base_face;
  std::uint32_t other = 0;
  std::uint32_t rest = 0, part = 0;
  Description rest_description, part_description;
  expression::Range blocks;
  std::uint32_t number = 0;  // among all of the program
};

// `#define name=expression`
struct Variable {
  std::string name;
  std::uint32_t grammar = 0;
  std::uint32_t to = 0;  // register
  Number number;
  std::uint32_t needs = 0;  // to where of its grammar's once_bound it has to be worked out before
  bool rebuilds = false;    // whether the map depends on it, and not only where its corners are
};

// Where an organ begins and where it ends: red, green and blue, 8 bits each, as sRGB.
struct Colours {
  std::uint32_t base = 0, tip = 0;
};

// `#material 4 petal "c8102e" "f6d55c" foot 0.4 margin "ffffff" 0.2 veins "8a1030" 9 0.5 light 0.6 bud "5d8250"`: what
// a volume's m means. What is said besides kind and colours may be missing.
// What an organ is made of, in the order in which a level has them.
inline constexpr std::array<std::string_view, 7> material_kinds{"petal",  "sepal",  "leaf", "stem",
                                                                "stamen", "pistil", "seed"};

struct Material {
  std::uint32_t number = 0;
  std::string kind;  // of `material_kinds`
  std::string name;  // of what is made of it; empty: its kind's
  Colours open;
  Colours bud, wilted;                      // at an age of 0 and of 2; mixed between
  float foot = 0.6f;                        // over how much of an organ's length the first colour goes into the second
  std::uint32_t margin = 0, veins = 0;      // colours
  float margin_width = 0;                   // as a share of half the width
  float vein_count = 0, vein_strength = 0;  // a side; 0 … 1
  bool feathered = false;                   // veins leave one in the middle, and do not spread from the foot
  float light = 0;                          // that comes through from behind, as a share
  expression::Place place;
};

// How much light comes through what is of a kind, where nobody says otherwise.
float light_through(std::string_view kind);

// The text itself, or one of its modules.
struct Grammar {
  std::string name;
  std::uint32_t axiom = invalid;  // a label
  Description axiom_arguments;
  expression::Range variables;  // in Program::variables
  // What follows from its variables, and those of the text, alone: code that runs where they have their values.
  expression::Range once_bound;
  Number final_step;   // where given
  bool draws = false;  // whether a variable does, or a call gives one, so that each instance has its own
  expression::Place place;
};

struct Program {
  std::vector<Grammar> grammars;  // the text itself first
  std::vector<Label> labels;
  std::vector<Variable> variables;
  std::vector<Production> productions;  // those of a label together, in the order of the text
  std::vector<Material> materials;
  std::uint32_t growths = 0;
  bool age_rebuilds = false, values_rebuild = false;  // whether the map depends on `age`, or on volumes' own numbers
  bool draws_rebuild = false;                         // or on what is drawn but in variables of the text
  // The text less all that only places the map: materials, and the figures of numbers that no order, face, condition or
  // number of steps depends on.
  std::string structure_key;
  expression::Code code;
  std::vector<std::string> notes;

  std::uint64_t bytes() const;  // that it holds, but for names
};

// Errors: syntax, undefined and limit, with line and column.
Result<Program> read_program(std::string_view text, const Limits& limits = {});

}  // namespace panicle::flower
