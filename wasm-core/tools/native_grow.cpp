// Grows a request (exports/panicle.h) from the standard input natively, and writes the response to the standard output.
// Tests compare it with the response of the wasm.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "exports/panicle.h"
#include "foundation/container.hpp"

int main() {
  std::vector<std::uint8_t> request;
  std::uint8_t block[4096];
  for (std::size_t got; (got = std::fread(block, 1, sizeof block, stdin)) > 0;)
    request.insert(request.end(), block, block + got);
  std::uint8_t* const answer = panicle_grow(request.data(), static_cast<std::uint32_t>(request.size()));
  if (!answer) return 1;
  std::fwrite(answer, 1, panicle::container_bytes(answer), stdout);
  panicle_release(answer);
  return 0;
}
