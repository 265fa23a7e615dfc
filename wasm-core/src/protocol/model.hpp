// A model: its name and its functions. Each is linked as a module of its own with the shared folders.
#pragma once

#include <string_view>

#include "foundation/limits.hpp"
#include "foundation/result.hpp"
#include "plant/plant.hpp"
#include "protocol/compiled_texts.hpp"
#include "protocol/request.hpp"

namespace panicle {

struct Model {
  std::string_view name;  // as requests and links have it
  // Grows the plant of a request. It reads no files and no clock, and has no state but caches (protocol/cache.hpp): the
  // same request gives the same plant. A parameter that the request leaves out has its default; one that is out of
  // range is clamped, with a note. Errors are values, with line and column for a grammar.
  Result<Plant> (*grow)(Request& request, const Limits& limits);
  // Compiles a text for requests that name it by handle; null for a model without such requests. Errors: with line and
  // column.
  Result<CompiledText> (*compile_text)(std::string_view text, const Limits& limits) = nullptr;
};

}  // namespace panicle
