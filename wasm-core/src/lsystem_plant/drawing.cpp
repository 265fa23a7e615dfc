#include "lsystem_plant/drawing.hpp"

#include <string>
#include <utility>

#include "lsystem_plant/messages.generated.hpp"

namespace panicle {

// A lineage is the address of a module and the symbols of its ancestors; the turtle is the moving pen that draws a
// string.

// Adds a segment, within the limit.
void Drawing::line(std::int32_t, const lsystem::Turtle& before, const lsystem::Turtle& after, const lsystem::Lineage&) {
  if (!within(segments.size(), limits_.segments, messages::lsystem_plant::segment_limit)) return;
  const float radius = after.width * 0.5f;
  segments.push_back({segment_of(before), 0, before.position, after.position, radius, radius});
}

// Adds a ball, within the limit.
void Drawing::sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  if (!within(balls.size(), limits_.spheres, messages::lsystem_plant::sphere_limit)) return;
  balls.push_back({turtle.position, radius, turtle.heading, segment_of(turtle), lineage.address, lineage.module});
}

// Whether a count is below its limit; otherwise the error with the message `otherwise` is set.
bool Drawing::within(std::size_t count, std::uint32_t limit, const MessageCode<1>& otherwise) {
  if (count < limit) return true;
  if (trouble_.reason == Reason::none) fail({Reason::limit, message(otherwise, limit), 0, 0});
  return false;
}

// Stores the first error.
void Drawing::fail(Diagnostic trouble) {
  if (trouble_.reason == Reason::none) trouble_ = std::move(trouble);
}

}  // namespace panicle
