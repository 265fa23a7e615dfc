// A model: a name and how it grows. Each is linked as a module of its own from the shared rooms.
#pragma once

#include <string_view>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "plant/plant.hpp"
#include "plant/request.hpp"

namespace panicle {

struct Model {
  std::string_view name;  // as requests and links have it
  // No files, no clock, no state but what makes it quicker (plant/kept.hpp): the same request gives the same plant.
  // What the request leaves out has its default; what is out of range is brought into it, with a note. Errors are
  // values, with line and column for a grammar.
  Result<Plant> (*grow)(Request& request, const Limits& limits);
  // That of texts which do not say theirs.
  lsystem::Notation notation = lsystem::Notation::huang;
  // Whether its listener wants to know where modules come from, whatever the text draws by chance.
  lsystem::Lineages lineages = lsystem::Lineages::always;
};

}  // namespace panicle
