// The value of a result that must have one.
#pragma once

#include <doctest/doctest.h>

#include <utility>

#include "foundation/english.hpp"
#include "foundation/result.hpp"

namespace panicle::tests {

template <class Value>
Value sound(Result<Value> result) {
  if (!result) FAIL(result.error().line << ":" << result.error().column << " " << english(result.error().message));
  return std::move(result.value());
}

}  // namespace panicle::tests
