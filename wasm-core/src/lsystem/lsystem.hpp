// Grammar text → program → derived string → turtle. The engine knows no symbol but the turtle's and ?E.
//
// Notation is cpfg's (Prusinkiewicz & Lindenmayer; Měch & Prusinkiewicz 1996 for ?E): see docs/grammar.md.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"

namespace panicle::lsystem {

// What a request gives to the text. A scalar with the name of a `#define` replaces it, one with the name of an
// `#input` provides it; names the text does not know are passed over. Arrays provide `#input n[]` and are read from index 1.
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

class Program;  // byte code; immutable, shared freely

Result<std::shared_ptr<const Program>> compile(std::string_view text, const Inputs& inputs, const Limits& limits);

// The value a program gives to a `#define` or scalar `#input`, or `otherwise`.
float constant(const Program& program, std::string_view name, float otherwise);

// A derived string: modules as 32-bit words (header, then parameters as float), with the lineage of each module
// where the program needs it.
class String;
struct Derived {
  std::shared_ptr<const String> string;
  std::uint32_t steps = 0;            // steps taken until nothing was rewritten (or `max_steps`)
  std::uint64_t modules_written = 0;  // sum of the lengths of the strings over all steps
};

// Rewrites the axiom until nothing rewrites any more or `max_steps` is reached. Random values are hashes of (seed, stream, address
// of the module in the derivation tree), `stream` being the call's own place in its production.
Result<Derived> derive(const Program& program, std::uint64_t seed, std::uint32_t max_steps, const Limits& limits);

// A string as text, `F(1)[+(60)A(2)]`, for tests and tools.
std::string to_text(const Program& program, const String& string);

// Where the turtle is. Heading, left and up are of unit length, heading × left = up.
struct Turtle {
  glm::vec3 position{0};
  glm::vec3 heading{0, -1, 0};
  glm::vec3 left{-1, 0, 0};
  glm::vec3 up{0, 0, -1};
  float width = 1;
  std::int32_t line = -1;  // the last line drawn on the way here, −1 at the root
};

// The turtle's turns, for those who must foresee where it will go: bit for bit what `+`, `&` and `/` do. Degrees,
// clockwise seen against the axis: +θ takes the heading towards −left, &φ towards +up, /ψ rolls about the heading.
void turn(Turtle& turtle, float theta);   // +(θ)
void pitch(Turtle& turtle, float phi);    // &(φ)
void roll(Turtle& turtle, float psi);     // /(ψ)
glm::vec3 ahead(const Turtle& turtle, float distance);  // where F(distance) or S(distance) ends

// Where a module comes from: who wrote it, in the derivation tree. Names are those of the text ("Ar1", "Ae"; "" for the axiom).
struct Lineage {
  std::string_view parent;       // predecessor of the production that wrote the module
  std::string_view grandparent;  // and of the production that wrote that predecessor
  std::uint64_t address = 0;     // hash of the path from the axiom: stable when other branches change
};

// Who draws, and who answers. Called in the order of the string.
class Listener {
 public:
  virtual ~Listener() = default;
  // F drew line number `id` (0, 1, …; never with length 0). `before.line` is its parent. Width is the turtle's at the end.
  virtual void line(std::int32_t id, const Turtle& before, const Turtle& after, const Lineage& lineage) = 0;
  // S drew a sphere about `turtle.position` (already moved ahead by the radius); its bearer is `turtle.line`.
  virtual void sphere(const Turtle& turtle, float radius, const Lineage& lineage) = 0;
  // ?E asks: change `parameters` into the answer. The production that matches the answer is applied at once, in place.
  virtual void ask(const Turtle& turtle, std::span<float> parameters, const Lineage& lineage) = 0;
  // % cut the rest of a branch here.
  virtual void cut(const Turtle& turtle) = 0;
};

Result<std::uint32_t> interpret(const Program& program, const String& string, const Turtle& start, Listener& listener,
                                std::uint64_t seed, const Limits& limits);

}  // namespace panicle::lsystem
