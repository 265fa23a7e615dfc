// Who hears what the turtle does.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lsystem/turtle.hpp"
#include "lsystem/words.hpp"

namespace panicle::lsystem {

// Where a module comes from: who wrote it, in the derivation tree. Names are those of the text ("Ar1", "Ae"; "" for the
// axiom).
struct Lineage {
  std::string_view parent;                  // predecessor of the production that wrote the module
  std::string_view grandparent;             // and of the production that wrote that predecessor
  std::uint64_t address = 0;                // hash of the path from the axiom: stable when other branches change
  std::uint32_t parent_symbol = no_symbol;  // the same by number, as in Roles
  std::uint32_t grandparent_symbol = no_symbol;
};

// Who draws, and who answers. Called in the order of the string. What an answer of ?E draws has the lineage of that ?E.
class Listener {
 public:
  virtual ~Listener() = default;
  // F drew line number `id` (0, 1, …; never with length 0). `before.line` is its parent. Width is the turtle's at the
  // end.
  virtual void line(std::int32_t id, const Turtle& before, const Turtle& after, const Lineage& lineage) = 0;
  // S drew a sphere about `turtle.position` (already moved ahead by the radius, never 0); its bearer is `turtle.line`.
  virtual void sphere(const Turtle& turtle, float radius, const Lineage& lineage) = 0;
  // ?E asks: change `parameters` into the answer. The production that matches the answer is applied at once, in place.
  virtual void ask(const Turtle& turtle, std::span<float> parameters, const Lineage& lineage) = 0;
  // % cut the rest of a branch here.
  virtual void cut(const Turtle& turtle) = 0;
};

}  // namespace panicle::lsystem
