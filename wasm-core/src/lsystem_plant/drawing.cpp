#include "lsystem_plant/drawing.hpp"

#include <string>
#include <utility>

namespace panicle {

void Drawing::line(std::int32_t, const lsystem::Turtle& before, const lsystem::Turtle& after, const lsystem::Lineage&) {
  if (!within(segments.size(), limits_.segments, "segments")) return;
  const float radius = after.width * 0.5f;
  segments.push_back({segment_of(before), 0, before.position, after.position, radius, radius});
}

void Drawing::sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  if (!within(balls.size(), limits_.spheres, "spheres")) return;
  balls.push_back({turtle.position, radius, turtle.heading, segment_of(turtle), lineage.address, lineage.module});
}

bool Drawing::within(std::size_t count, std::uint32_t limit, std::string_view what) {
  if (count < limit) return true;
  if (trouble_.reason == Reason::none)
    fail({Reason::limit,
          "The plant has reached the limit of " + std::to_string(limit) + " " + std::string(what) +
              "; make what the grammar draws smaller.",
          0, 0});
  return false;
}

void Drawing::fail(Diagnostic trouble) {
  if (trouble_.reason == Reason::none) trouble_ = std::move(trouble);
}

}  // namespace panicle
