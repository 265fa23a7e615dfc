// Pieces of messages.
#pragma once

#include <string>
#include <string_view>

namespace panicle::lsystem {

inline std::string quoted(std::string_view text) {
  std::string result(1, '\'');
  result.append(text);
  return result.append(1, '\'');
}

}  // namespace panicle::lsystem
