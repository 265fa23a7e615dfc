#include "models/grammar/sketch.hpp"

namespace panicle::grammar {
namespace {

// What things are by nature, where the text sets no colour: as the table of parameters names them.
constexpr std::uint8_t of_lines = 1, of_spheres = 7;

Mark mark_of(const lsystem::Turtle&, const lsystem::Lineage& lineage, std::uint8_t natural) {
  return {lineage.module, natural};
}

}  // namespace

void Sketch::line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
                  const lsystem::Lineage& lineage) {
  Drawing::line(id, before, after, lineage);
  if (lines.size() < segments.size()) lines.push_back(mark_of(after, lineage, of_lines));
}

void Sketch::sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  Drawing::sphere(turtle, radius, lineage);
  if (spheres.size() < balls.size()) spheres.push_back(mark_of(turtle, lineage, of_spheres));
}

}  // namespace panicle::grammar
