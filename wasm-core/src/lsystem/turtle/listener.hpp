// The interface of objects that receive the events of the turtle.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lsystem/derivation/words.hpp"
#include "lsystem/turtle/turtle.hpp"

namespace panicle::lsystem {

// The lineage of a module: its ancestors in the derivation tree. Names are those of the text ("Ar1", "Ae"; "" for the
// axiom).
struct Lineage {
  std::string_view parent;                  // predecessor of the production that wrote the module
  std::string_view grandparent;             // and of the production that wrote that predecessor
  std::uint64_t address = 0;                // hash of the path from the axiom: stable when other branches change
  std::uint32_t parent_symbol = no_symbol;  // the same by number, as in Roles
  std::uint32_t grandparent_symbol = no_symbol;
  std::uint32_t module = 0;  // its place in the string, from 0
};

// Receives drawing events and responds to queries, in the order of the string. Modules drawn as the response to a ?E
// have the lineage of that ?E.
class Listener {
 public:
  virtual ~Listener() = default;
  // F drew line number `id` (0, 1, …; never with length 0). `before.line` is its parent. Width is the turtle's at the
  // end.
  virtual void line(std::int32_t id, const Turtle& before, const Turtle& after, const Lineage& lineage) = 0;
  // S drew a sphere about `turtle.position` (already moved ahead by the radius, never 0); its parent is `turtle.line`.
  virtual void sphere(const Turtle& turtle, float radius, const Lineage& lineage) = 0;
  // ?E is a query: change `parameters` into the response. The production that matches the response is applied at once,
  // in place.
  virtual void query(const Turtle& turtle, std::span<float> parameters, const Lineage& lineage) = 0;
  // Whether it needs to observe the whole string before it responds: then Derivation::query_environment walks the
  // string twice, and calls observation_begins and responses_begin before the walks.
  virtual bool observes_first() const { return false; }
  // Called where lines are only observed, before queries are answered, and where answering begins.
  virtual void observation_begins() {}
  virtual void responses_begin() {}
  // % cut the rest of a branch here.
  virtual void cut(const Turtle& turtle) = 0;
  // { … } closed a polygon: its corners in their order, and the turtle as it was at {. Polygons with fewer than three
  // corners, or with all on a line, are reported as well.
  virtual void polygon(const Turtle&, std::span<const glm::vec3>, const Lineage&) {}
  // The same of a polygon that has a thickness, above 0.
  virtual void plate(const Turtle& turtle, std::span<const glm::vec3> corners, float, const Lineage& lineage) {
    polygon(turtle, corners, lineage);
  }
  // ~name drew a surface at the turtle, along its heading, `size` times as large as it is.
  virtual void surface(const Turtle&, std::string_view, float, const Lineage&) {}
  // @O drew a sphere about the turtle, @o a disc across its heading.
  virtual void ball(const Turtle& turtle, float radius, const Lineage& lineage) { sphere(turtle, radius, lineage); }
  // Called for a disc of that radius at right angles to the heading.
  virtual void disc(const Turtle&, float, const Lineage&) {}
  // A part of the string that the walk ignores, in one sentence; each once.
  virtual void note(std::string_view) {}
};

}  // namespace panicle::lsystem
