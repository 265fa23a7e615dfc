// The basic listener: turns any interpreted grammar into segments and balls, one for each module that draws, in the
// order of the string. Models that respond to queries or draw more derive from it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/message.hpp"
#include "foundation/result.hpp"
#include "lsystem/lsystem.hpp"
#include "stems/segment.hpp"

namespace panicle {

// A sphere drawn by S.
struct Ball {
  glm::vec3 centre{0};
  float radius = 0;
  glm::vec3 heading{0, -1, 0};  // of the turtle that drew it, unit
  std::int32_t segment = -1;    // parent; −1 for none
  std::uint64_t address = 0;    // of its module in the derivation tree
  std::uint32_t module = 0;     // that, by its place in the string
};

// Lengths stay in the grammar's unit. Several interpretations may follow one another; begin() starts each, and parents
// are found within it.
class Drawing : public lsystem::Listener {
 public:
  explicit Drawing(const Limits& limits) : limits_(limits) {}

  // Begins a new drawing: earlier segments stay, and lines of the turtle are numbered from here.
  void begin() { first_ = static_cast<std::int32_t>(segments.size()); }

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;
  void sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override;
  // No response: a query keeps the parameters of the text.
  void query(const lsystem::Turtle&, std::span<float>, const lsystem::Lineage&) override {}
  void cut(const lsystem::Turtle&) override {}

  // The first error (a limit); reason none without one.
  const Diagnostic& trouble() const { return trouble_; }

  std::vector<Segment> segments;  // parents first
  std::vector<Ball> balls;

 protected:
  // Index of the segment that the turtle stands on, −1 at the root.
  std::int32_t segment_of(const lsystem::Turtle& turtle) const { return turtle.line < 0 ? -1 : first_ + turtle.line; }
  // Whether there is room for one more; if not, `trouble` is set.
  bool within(std::size_t count, std::uint32_t limit, const MessageCode<1>& otherwise);
  // Stores the first error.
  void fail(Diagnostic trouble);

  const Limits& limits() const { return limits_; }

 private:
  Limits limits_;
  Diagnostic trouble_;
  std::int32_t first_ = 0;  // segment of this interpretation
};

}  // namespace panicle
