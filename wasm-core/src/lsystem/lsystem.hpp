// The L-system engine: grammar text → program → program with inputs → derived string → turtle. The engine knows no
// symbol but the turtle's and ?E.
//
// Notation is cpfg's (Prusinkiewicz & Lindenmayer; Měch & Prusinkiewicz 1996 for ?E): see docs/language.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/space.hpp"
#include "foundation/limits.hpp"
#include "foundation/message.hpp"
#include "foundation/result.hpp"
#include "lsystem/turtle/listener.hpp"
#include "lsystem/turtle/turtle.hpp"

namespace panicle::lsystem {

// Grammars are made of expressions, whose names are used as if they were declared here.
using namespace expression;

// Inputs of a request for a text. A scalar with the name of a `#define` replaces it, one with the name of an `#input`
// provides it; names the text does not know are ignored. Arrays provide `#input n[]` and are read from index 1.
struct Inputs {
  struct Scalar {
    std::string name;
    float value;
  };
  struct Array {
    std::string name;
    std::vector<float> values;  // values[0] is n[1]
  };
  std::vector<Scalar> scalars;
  std::vector<Array> arrays;
};

// Whether modules store their lineage. A program that draws random values or queries its environment always stores
// lineages; any other does without, and is faster, unless a listener needs them.
enum class Lineages { where_needed, always };

// The turtle's sense of rotation, and the meaning of some letters, where the text has no line `#turtle …`: Table 1 of
// Huang et al. (2013), or cpfg (docs/language.md).
enum class Notation : std::uint8_t { huang, cpfg };

class Watcher;
class Program;  // byte code; immutable, shared freely, independent of the text and of inputs

// Compiles a text. Errors: syntax, undefined, evaluation (a number for the turtle that is not finite) and limit; with
// line and column.
Result<std::shared_ptr<const Program>> compile(std::string_view text, const Limits& limits,
                                               Lineages lineages = Lineages::where_needed,
                                               Notation notation = Notation::huang);

class BoundProgram;  // a program with its inputs and all that follows from them alone; immutable, shared freely

// Binds inputs to a program, at a small part of the cost of compiling: every request may bind anew. Errors: bad_input
// (an input without a value, or one that is no finite number), evaluation (a #define or a number for the turtle that is
// none); with line and column.
Result<std::shared_ptr<const BoundProgram>> bind(std::shared_ptr<const Program> program, const Inputs& inputs,
                                                 const Limits& limits);

const Program& program_of(const BoundProgram& bound);

// The value of a `#define` or scalar `#input`, or `otherwise`.
float constant(const BoundProgram& bound, std::string_view name, float otherwise);

// A definition of the text with its values, for tools: in the order of the text.
struct Definition {
  enum class Kind : std::uint8_t { define, input, array };
  std::string name;
  Kind kind = Kind::define;
  std::vector<float> values;  // one, but for an array
};
std::span<const Definition> definitions(const BoundProgram& bound);
// Symbols that productions rewrite, without repetition, in the order of the text.
std::vector<std::string_view> predecessors(const Program& program);

// Roles that the text declares by `#role name symbol …`; only models know their meaning. Symbols are numbered as in
// Lineage.
struct Roles {
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::string> names;        // in the order of the text
  std::vector<std::uint32_t> of_symbol;  // by symbol: the place of its role among the names, or `none`

  // The role's index for a symbol; `none` if it has none.
  std::uint32_t of(std::uint32_t symbol) const { return symbol < of_symbol.size() ? of_symbol[symbol] : none; }
};
const Roles& roles(const Program& program);
// Whether the axiom or a production writes ?E.
bool has_queries(const Program& program);
// The names of symbols, by number: the turtle's and those of the text.
std::span<const std::string> symbols(const Program& program);

// A part of a text that the engine ignores, in one sentence with advice. Line and column are 0 for remarks that concern
// no text.
struct Remark {
  Message message;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};
// Returns the remarks on a program. `requested`: constants of the request; those that the text does not know get a
// remark. `steps` as for `develop`.
std::vector<Remark> remarks(const Program& program, std::span<const Inputs::Scalar> requested = {},
                            std::optional<std::uint32_t> steps = {});
// The remark with its place before it, for a list of notes.
std::string to_text(const Remark& remark);

// Options of a derivation: the turtle at the start, for ?P and the like; the space of bound() and reach(); the
// environment that responds to ?E between steps, or null; the watcher, or null (watcher.hpp).
struct DerivationOptions {
  Turtle start;
  const Space* space = nullptr;
  Listener* environment = nullptr;
  Watcher* watcher = nullptr;
};

// A derived string: modules as 32-bit words (header, then parameters as float), with the lineage of each module
// where the program needs it, and the parameters as doubles too where the text calculates in double precision.
class String;
struct Derived {
  std::shared_ptr<const String> string;
  std::uint32_t steps = 0;            // the last step that rewrote anything
  std::uint64_t modules_written = 0;  // sum of the lengths of the strings over all steps
  Diagnostic stopped;                 // of develop_so_far: the error that ended it early
};

// The derivation length that the text sets, if any.
std::optional<std::uint32_t> derivation_length(const BoundProgram& bound);

// Derives the string of a grammar: after `steps` steps where they are given, else after as many as the text sets, else
// until nothing is rewritten any more (`unfold`). Random values are hashes of (seed, stream, address of the module in
// the derivation tree), `stream` being the call's own place in its production; with steps those of conditions and
// weights depend on the step as well (docs/language.md). Errors: evaluation, with line and column; limit, also for more
// than `limits.steps` steps. For strings between steps, or responses to ?E: derivation.hpp.
Result<Derived> develop(const BoundProgram& bound, std::uint64_t seed, std::optional<std::uint32_t> steps,
                        const Limits& limits, const DerivationOptions& options = {});

// The same, but where a limit ends it, the result is the string after the last whole step, with the error in `stopped`.
// Such a text is derived by steps, also where it sets none.
Result<Derived> develop_so_far(const BoundProgram& bound, std::uint64_t seed, std::optional<std::uint32_t> steps,
                               const Limits& limits, const DerivationOptions& options = {});

// Derives the string that steps without end would lead to, without the strings between: each module is rewritten to its
// end before the next, so that the cost grows with the result and not with the steps as well. Productions without
// context depend on nothing but a module's own parameters and address, so the order makes no difference; where any has
// a context, steps are taken, as by `develop`. A random condition draws once. `steps` is the deepest module's
// generation, `modules_written` the length. Errors: evaluation, with line and column; limit, also where there is no
// end.
Result<Derived> unfold(const BoundProgram& bound, std::uint64_t seed, const Limits& limits,
                       const DerivationOptions& options = {});

// How many modules a string has.
std::uint64_t length(const String& string);

// A string as text, `F(1)[+(60)A(2)]`, for tests and tools. Numbers have the fewest digits that give the same float
// back.
std::string to_text(const Program& program, const String& string);

// Interprets the string from left to right and sends the listener its events. Returns how many lines were drawn.
// Errors: evaluation (a response or a position that is no number), limit (brackets, responses), syntax (a response that
// cannot be drawn). `watcher` is notified of the productions that are applied to responses.
Result<std::uint32_t> interpret(const BoundProgram& bound, const String& string, const Turtle& start,
                                Listener& listener, std::uint64_t seed, const Limits& limits,
                                const Space* space = nullptr, Watcher* watcher = nullptr);

// The same, but ?E is neither sent nor drawn: for strings whose queries have their responses between steps
// (derivation.hpp).
Result<std::uint32_t> interpret_without_queries(const BoundProgram& bound, const String& string, const Turtle& start,
                                                Listener& listener, std::uint64_t seed, const Limits& limits,
                                                const Space* space = nullptr);

}  // namespace panicle::lsystem
