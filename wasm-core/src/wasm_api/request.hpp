// The bytes of a request (panicle.h) → a request. Lengths are checked before anything is read.
#pragma once

#include <cstdint>
#include <span>

#include "bunch/bunch.hpp"
#include "foundation/result.hpp"

namespace panicle::wasm_api {

// The grammar of the result views `bytes`, which must outlive it. `bytes` must be aligned to a word.
Result<bunch::Request> read_request(std::span<const std::uint8_t> bytes);

}  // namespace panicle::wasm_api
