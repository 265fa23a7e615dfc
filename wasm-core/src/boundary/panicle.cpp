#include "boundary/panicle.h"

#include <cstdlib>
#include <new>
#include <utility>

#include "models/bunch/bunch.hpp"
#include "boundary/request.hpp"
#include "boundary/sections.hpp"

struct PanicleResult {
  panicle::boundary::Sections sections;
};

namespace {

constexpr std::uint32_t most_request_bytes = 16 * 1024 * 1024;

template <class Outcome>
PanicleResult* result_of(Outcome&& outcome) {
  return new (std::nothrow) PanicleResult{panicle::boundary::Sections(std::forward<Outcome>(outcome))};
}

}  // namespace

extern "C" {

std::uint32_t panicle_abi(void) { return 2; }

void* panicle_allocate(std::uint32_t bytes) {
  return bytes <= most_request_bytes ? std::malloc(bytes ? bytes : 1) : nullptr;
}

void panicle_release(void* memory) { std::free(memory); }

PanicleResult* panicle_grow(const std::uint8_t* bytes, std::uint32_t length) {
  const auto request = panicle::boundary::read_request({bytes, length});
  if (!request) return result_of(request.error());
  auto grown = panicle::bunch::grow(request.value());
  if (!grown) return result_of(grown.error());
  return result_of(std::move(grown.value()));
}

const void* panicle_section(const PanicleResult* result, std::uint32_t section) {
  return result ? result->sections.section(section).data() : nullptr;
}

std::uint32_t panicle_section_bytes(const PanicleResult* result, std::uint32_t section) {
  return result ? static_cast<std::uint32_t>(result->sections.section(section).size()) : 0;
}

void panicle_free(PanicleResult* result) { delete result; }

}  // extern "C"
