// Messages in English, for native programs and tests. Modules of the page do not link this.
#pragma once

#include <string>
#include <string_view>

namespace panicle {

// Replaces each message (foundation/message.hpp) in a text by its English sentence; other text stays as it is.
std::string english(std::string_view text);

}  // namespace panicle
