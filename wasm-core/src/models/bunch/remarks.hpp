// Notes about a request and its text, one sentence each: every ignored part gets a note.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/lsystem.hpp"
#include "models/bunch/values.hpp"

namespace panicle::bunch {

// Adds a note for each statement of the text without effect, and for each given parameter that `procedure` uses to
// replace a #define that the text does not have, so that it changes nothing; `besides` are those that the procedure
// itself uses.
void remark_text(const lsystem::BoundProgram& text, const Values& values, std::string_view procedure,
                 std::span<const Parameter> besides, std::vector<std::string>& notes);

// The result of drawing a text.
struct Drawn {
  std::size_t internodes = 0;
  std::size_t balls = 0;
  std::uint32_t loose_balls = 0;  // which hang on no line
  bool refused = false;           // whether anything found no room
};

// Adds notes about drawn parts that a bunch cannot grow, and about missing parts.
void remark_drawn(const Drawn& drawn, std::vector<std::string>& notes);

}  // namespace panicle::bunch
