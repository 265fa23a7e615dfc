#include <doctest/doctest.h>

#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "models/bunch/parameters.generated.hpp"
#include "foundation/random.hpp"
#include "foundation/result.hpp"
#include "boundary/panicle.h"

namespace {

using Words = std::vector<std::uint32_t>;

Words small_request(std::uint32_t outputs = 0) { return {0x4c434e50, 2, 1, outputs, 1, 0, 0, 0, 0, 0, 0, 0}; }

struct Answer {
  explicit Answer(const Words& request)
      : result(panicle_grow(reinterpret_cast<const std::uint8_t*>(request.data()),
                            static_cast<std::uint32_t>(request.size() * 4))) {}
  ~Answer() { panicle_free(result); }
  std::uint32_t bytes(std::uint32_t section) const { return panicle_section_bytes(result, section); }
  std::uint32_t word(std::uint32_t section, std::size_t index) const {
    REQUIRE(bytes(section) >= (index + 1) * 4);
    std::uint32_t value;
    std::memcpy(&value, static_cast<const char*>(panicle_section(result, section)) + index * 4, 4);
    return value;
  }
  panicle::Reason reason() const { return static_cast<panicle::Reason>(word(PANICLE_SECTION_STATUS, 0)); }
  std::string message() const {
    return {static_cast<const char*>(panicle_section(result, PANICLE_SECTION_MESSAGE)), bytes(PANICLE_SECTION_MESSAGE)};
  }
  PanicleResult* result;
};

}  // namespace

TEST_CASE("the smallest request grows the default bunch, section by section") {
  const Answer answer(small_request(1));
  REQUIRE(answer.reason() == panicle::Reason::none);
  const std::uint32_t internodes = answer.word(PANICLE_SECTION_COUNTS, 1),
                      berries = answer.word(PANICLE_SECTION_COUNTS, 3);
  CHECK(answer.word(PANICLE_SECTION_PLAN, 16) == 18);
  CHECK(answer.bytes(PANICLE_SECTION_PLAN) == (16 + 1 + 17) * 4);
  CHECK(answer.bytes(PANICLE_SECTION_SECOND) == 0);
  CHECK(answer.bytes(PANICLE_SECTION_INTERNODES) == internodes * 16);
  CHECK(answer.bytes(PANICLE_SECTION_INTERNODE_ENDS) == internodes * 24);
  CHECK(answer.bytes(PANICLE_SECTION_INTERNODE_RADII) == internodes * 8);
  CHECK(answer.bytes(PANICLE_SECTION_BERRIES) == berries * 16);
  CHECK(answer.bytes(PANICLE_SECTION_BERRY_DIRECTIONS) == berries * 12);
  CHECK(answer.bytes(PANICLE_SECTION_BERRY_PARENTS) == berries * 4);
  const std::uint32_t vertices = answer.bytes(PANICLE_SECTION_STEM_INTERNODES) / 4;
  CHECK(vertices > 0);
  CHECK(answer.bytes(PANICLE_SECTION_STEM_POSITIONS) == vertices * 12);
  CHECK(answer.bytes(PANICLE_SECTION_STEM_NORMALS) == vertices * 12);
  CHECK(answer.bytes(PANICLE_SECTION_STEM_UVS) == vertices * 8);
  CHECK(answer.bytes(PANICLE_SECTION_STEM_PARTS) > 0);
  CHECK(answer.word(PANICLE_SECTION_PROCEDURE, 0) == 1);
  CHECK(answer.bytes(PANICLE_SECTION_BERRY_IDS) == berries * 4);
  CHECK(answer.bytes(PANICLE_SECTION_BERRY_TRAITS) == berries * 32);
  CHECK(answer.bytes(PANICLE_SECTION_THINNED) % 20 == 0);
  const std::uint32_t pattern = answer.bytes(PANICLE_SECTION_SURFACE_UVS) / 8;
  CHECK(pattern > 0);
  CHECK(answer.bytes(PANICLE_SECTION_SURFACE_POSITIONS) == berries * pattern * 12);
  CHECK(answer.bytes(PANICLE_SECTION_SURFACE_NORMALS) == berries * pattern * 12);
  CHECK(answer.bytes(PANICLE_SECTION_SURFACE_PRESSED) == berries * pattern);
  CHECK(answer.bytes(PANICLE_SECTION_BERRY_POSITIONS) == 0);
  CHECK(answer.bytes(PANICLE_SECTION_MEASURES) == 0);
  CHECK(Answer(small_request(2)).bytes(PANICLE_SECTION_MEASURES) > 0);
  CHECK(panicle_section(answer.result, PANICLE_SECTION_COUNT) == nullptr);
}

TEST_CASE("a berry thinned by hand is told by its id") {
  const Answer whole(small_request());
  Words request = small_request();
  request[11] = 1;
  request.push_back(whole.word(PANICLE_SECTION_BERRY_IDS, 5));
  const Answer less(request);
  REQUIRE(less.reason() == panicle::Reason::none);
  CHECK(less.word(PANICLE_SECTION_COUNTS, 3) == whole.word(PANICLE_SECTION_COUNTS, 3) - 1);
}

TEST_CASE("meshes come only when asked for and change no skeleton") {
  const Answer bare(small_request(0)), whole(small_request(1));
  CHECK(bare.bytes(PANICLE_SECTION_STEM_POSITIONS) == 0);
  CHECK(bare.word(PANICLE_SECTION_FINGERPRINTS, 0) == whole.word(PANICLE_SECTION_FINGERPRINTS, 0));
  CHECK(bare.word(PANICLE_SECTION_FINGERPRINTS, 1) == whole.word(PANICLE_SECTION_FINGERPRINTS, 1));
  CHECK(bare.word(PANICLE_SECTION_FINGERPRINTS, 2) == 0);
  CHECK(whole.word(PANICLE_SECTION_FINGERPRINTS, 2) != 0);
}

TEST_CASE("a request that is not in the agreed form is refused in words") {
  const auto refused = [](const Words& request) {
    const Answer answer(request);
    CHECK(answer.reason() == panicle::Reason::bad_request);
    CHECK(answer.message().size() > 20);
  };
  refused({});
  refused(Words(10, 0));
  for (const std::size_t word : {0, 1, 2}) {
    Words request = small_request();
    request[word] += 7;
    refused(request);
  }
  for (const std::size_t count : {7, 9, 10, 11}) {
    Words request = small_request();
    for (const std::uint32_t many : {1u, 5u, 0x40000000u, 0xffffffffu}) {
      request[count] = many;
      refused(request);
    }
  }
  Words longer = small_request();
  longer.push_back(0);
  refused(longer);
}

TEST_CASE("no bytes of a request can do harm") {
  for (std::uint64_t round = 0; round < 300; ++round) {
    Words request = small_request(0);
    request[7] = panicle::bunch::parameter_count;
    request[10] = 8 * 4;
    for (std::uint64_t i = 0; i < panicle::bunch::parameter_count + 8; ++i)
      request.push_back(static_cast<std::uint32_t>(panicle::random_bits(round, 1, i)));
    const auto at = panicle::random_bits(round, 2, 0) % request.size();
    if (round % 2) request[10] = 0, request.resize(12 + panicle::bunch::parameter_count);
    if (at != 8 && at < request.size()) request[at] = static_cast<std::uint32_t>(panicle::random_bits(round, 3, 0));
    const Answer answer(request);
    CHECK(answer.bytes(PANICLE_SECTION_STATUS) == 12);
  }
}
