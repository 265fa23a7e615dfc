// Data that a model may store from one growth for the next, for speed alone. The same request gives the same plant,
// byte by byte, with any cache (tests/golden/native_wasm.test.ts).
#pragma once

#include <cstddef>
#include <memory>

namespace panicle {

struct Cache {
  // For one model: a larger cache is evicted.
  static constexpr std::size_t most_bytes = 64 * 1024 * 1024;

  virtual ~Cache() = default;
};

using CacheSlot = std::unique_ptr<Cache>;

}  // namespace panicle
