// What a model may keep from one growth for the next: to be quicker, and for nothing else. The same request gives the
// same plant, byte by byte, whatever is kept (tests/golden/native_wasm.test.ts).
#pragma once

#include <cstddef>
#include <memory>

namespace panicle {

struct Cache {
  // In all, of one model: what is larger is let go.
  static constexpr std::size_t most_bytes = 64 * 1024 * 1024;

  virtual ~Cache() = default;
};

using CacheSlot = std::unique_ptr<Cache>;

}  // namespace panicle
