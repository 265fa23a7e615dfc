// A request (boundary/panicle.h) from the standard input, grown natively; every section to the standard output as
// id, bytes (uint32 each) and contents. Tests compare it with what the wasm gives.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "boundary/panicle.h"

int main() {
  std::vector<std::uint8_t> request;
  std::uint8_t block[4096];
  for (std::size_t got; (got = std::fread(block, 1, sizeof block, stdin)) > 0;)
    request.insert(request.end(), block, block + got);
  PanicleResult* result = panicle_grow(request.data(), static_cast<std::uint32_t>(request.size()));
  if (!result) return 1;
  for (std::uint32_t section = 0; section < PANICLE_SECTION_COUNT; ++section) {
    const std::uint32_t header[2] = {section, panicle_section_bytes(result, section)};
    std::fwrite(header, 4, 2, stdout);
    if (header[1] > 0) std::fwrite(panicle_section(result, section), 1, header[1], stdout);
  }
  panicle_free(result);
  return 0;
}
