// The bytes of a request (panicle.h) → a request. Lengths are checked before anything is read.
#pragma once

#include <cstdint>
#include <span>

#include "models/bunch/bunch.hpp"
#include "foundation/result.hpp"

namespace panicle::boundary {

// The grammar of the result views `bytes`, which must outlive it. `bytes` must be aligned to a word.
Result<bunch::Request> read_request(std::span<const std::uint8_t> bytes);

}  // namespace panicle::boundary
