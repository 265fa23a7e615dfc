#include "models/grammar/measures/axes.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lsystem/derivation/program.hpp"
#include "lsystem/derivation/words.hpp"

namespace panicle::grammar {

// The number of axes, branches with at least one line, and their highest order; 0 for the main axis. `lines` are in the
// order of the string's modules.
Axes axes_of(const lsystem::String& string, std::span<const Mark> lines) {
  Axes found;
  // Whether each open axis has a line.
  std::vector<bool> drawn{false};
  std::size_t line = 0;
  std::uint32_t place = 0;
  for (const std::uint32_t* module = string.begin(); module < string.end(); module += lsystem::words_of(*module)) {
    const std::uint32_t symbol = lsystem::symbol_of(*module);
    if (symbol == lsystem::push_symbol) drawn.push_back(false);
    if (symbol == lsystem::pop_symbol && drawn.size() > 1) drawn.pop_back();
    const std::size_t before = line;
    while (line < lines.size() && lines[line].module <= place) ++line;
    if (line > before && !drawn.back()) {
      drawn.back() = true;
      ++found.count;
      found.highest = std::max(found.highest, static_cast<std::uint32_t>(drawn.size() - 1));
    }
    ++place;
  }
  return found;
}

}  // namespace panicle::grammar
