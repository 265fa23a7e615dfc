// Who hears what the turtle does.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lsystem/derivation/words.hpp"
#include "lsystem/turtle/turtle.hpp"

namespace panicle::lsystem {

// Where a module comes from: who wrote it, in the derivation tree. Names are those of the text ("Ar1", "Ae"; "" for the
// axiom).
struct Lineage {
  std::string_view parent;                  // predecessor of the production that wrote the module
  std::string_view grandparent;             // and of the production that wrote that predecessor
  std::uint64_t address = 0;                // hash of the path from the axiom: stable when other branches change
  std::uint32_t parent_symbol = no_symbol;  // the same by number, as in Roles
  std::uint32_t grandparent_symbol = no_symbol;
  std::uint32_t module = 0;  // its place in the string, from 0
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
  virtual void query(const Turtle& turtle, std::span<float> parameters, const Lineage& lineage) = 0;
  // Whether it wants to observe the whole string before it answers any of it: then Derivation::query_environment walks it twice, and
  // tells when it is to be heard and when answers begin.
  virtual bool observes_first() const { return false; }
  virtual void observation_begins() {}
  virtual void responses_begin() {}
  // % cut the rest of a branch here.
  virtual void cut(const Turtle& turtle) = 0;
  // { … } closed a polygon: its corners in their order, and the turtle as it was at {. Fewer than three, or all on a
  // line, are told as well.
  virtual void polygon(const Turtle&, std::span<const glm::vec3>, const Lineage&) {}
  // The same of a polygon that has a thickness, above 0.
  virtual void plate(const Turtle& turtle, std::span<const glm::vec3> corners, float, const Lineage& lineage) {
    polygon(turtle, corners, lineage);
  }
  // ~name drew a surface at the turtle, along its heading, `size` times as large as it is.
  virtual void surface(const Turtle&, std::string_view, float, const Lineage&) {}
  // @O drew a sphere about the turtle, @o a disc across its heading.
  virtual void ball(const Turtle& turtle, float radius, const Lineage& lineage) { sphere(turtle, radius, lineage); }
  virtual void disc(const Turtle&, float, const Lineage&) {}
  // What the walk passes over, in one sentence; each once.
  virtual void note(std::string_view) {}
};

}  // namespace panicle::lsystem
