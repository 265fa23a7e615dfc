// What a text draws, with what the model knows of it besides: which module drew it, and in which colour.
#pragma once

#include <cstdint>
#include <vector>

#include "plant/drawing.hpp"

namespace panicle::grammar {

// A width that no text sets: with it the turtle begins, and what is still as wide has the model's own (girth.hpp).
inline constexpr float no_width = 1e-30f;
// Of the palette; a document has as many.
inline constexpr std::uint8_t colours = 8;

// What of a thing is not its shape.
struct Mark {
  std::uint32_t module = 0;  // its place in the last string
  std::uint8_t colour = 1;   // 1 … colours
};

class Sketch final : public Drawing {
 public:
  explicit Sketch(const Limits& limits) : Drawing(limits) {}

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;
  void sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override;

  std::vector<Mark> lines;    // of each segment
  std::vector<Mark> spheres;  // of each ball
};

}  // namespace panicle::grammar
