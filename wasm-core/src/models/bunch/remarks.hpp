// What there is to say about a request and its text, one sentence each: nothing is passed over in silence.
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

// A note for each thing that the text says and nothing heeds, and for each parameter that was given, is heeded by
// `procedure` and replaces a #define that the text does not have, so that it changes nothing; `besides` are those that
// the procedure itself heeds.
void remark_text(const lsystem::BoundProgram& text, const Values& values, std::string_view procedure,
                 std::span<const Parameter> besides, std::vector<std::string>& notes);

// What came of a text.
struct Drawn {
  std::size_t internodes = 0;
  std::size_t balls = 0;
  std::uint32_t loose_balls = 0;  // which hang on no line
  bool refused = false;           // whether anything found no room
};

// What a text drew that a bunch cannot grow, or did not draw.
void remark_drawn(const Drawn& drawn, std::vector<std::string>& notes);

}  // namespace panicle::bunch
