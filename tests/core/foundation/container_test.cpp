#include "foundation/container.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "foundation/random.hpp"

using namespace panicle;

namespace {

struct Block {
  explicit Block(const ContainerWriter& writer) : bytes(writer.write()) { REQUIRE(bytes != nullptr); }
  ~Block() { std::free(bytes); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  std::span<const std::uint8_t> view() const { return {bytes, container_bytes(bytes)}; }
  std::uint8_t* bytes;
};

}  // namespace

TEST_CASE("read_container returns the written columns") {
  const std::vector<float> places{1, 2, 3, 4, 5, 6};
  const std::vector<std::int32_t> parents{-1, 0};
  const std::vector<std::uint8_t> octets{7, 8, 9};
  ContainerWriter writer;
  writer.add("places", places, 3);
  writer.add("parents", parents);
  writer.add("octets", octets);
  writer.add("word", "grün");
  writer.add("none", std::vector<std::uint32_t>{});
  const Block block(writer);
  const auto read = read_container(block.view());
  REQUIRE(read);
  REQUIRE(read->size() == 5);
  const auto& columns = read.value();
  CHECK(columns[0].name == "places");
  CHECK(columns[0].width == 3);
  CHECK(columns[0].rows == 2);
  CHECK(std::vector<float>(columns[0].as<float>().begin(), columns[0].as<float>().end()) == places);
  CHECK(columns[0].as<std::int32_t>().empty());  // of another kind
  CHECK(columns[1].as<std::int32_t>()[0] == -1);
  CHECK(columns[2].as<std::uint8_t>()[2] == 9);
  CHECK(columns[3].text() == "grün");
  CHECK(columns[4].rows == 0);
  for (const ColumnView& column : columns) CHECK((column.data - block.bytes) % 4 == 0);
}

TEST_CASE("read_container never reads outside the bytes, for random bytes") {
  ContainerWriter writer;
  const std::vector<float> values(9, 0.5f);
  writer.add("values", values, 3);
  writer.add("text", "one two");
  const Block block(writer);
  const std::uint32_t whole = container_bytes(block.bytes);
  int good = 0, refused = 0;
  for (std::uint64_t round = 0; round < 4000; ++round) {
    // On the heap and exactly as long, so that the sanitizer sees the first byte beyond.
    const auto length = static_cast<std::uint32_t>(round % 4 ? whole : random_bits(round, 5, 0) % whole);
    std::vector<std::uint32_t> words(length / 4);
    if (!words.empty()) {
      std::memcpy(words.data(), block.bytes, words.size() * 4);
      words[random_bits(round, 1, 0) % words.size()] = static_cast<std::uint32_t>(
          round % 3 ? random_bits(round, 2, 0) : random_bits(round, 2, 0) % (2 * std::uint64_t{whole}));
    }
    const auto read = read_container({reinterpret_cast<const std::uint8_t*>(words.data()), words.size() * 4});
    ++(read ? good : refused);
    if (!read) continue;
    std::uint64_t sum = 0;
    for (const ColumnView& column : read.value()) {
      for (std::uint64_t i = 0; i < column.bytes(); ++i) sum += column.data[i];
      for (const char letter : column.name) sum += static_cast<std::uint8_t>(letter);
    }
    CHECK(sum < 1'000'000);
  }
  CHECK(good > 100);
  CHECK(refused > 100);
}

TEST_CASE("copied columns are written into the block at any size, and their source may be freed before") {
  ContainerWriter writer;
  const std::vector<float> viewed(5000, 2.0f);
  writer.add("viewed", viewed);
  {
    const std::vector<std::uint32_t> words(5000, 7);
    writer.copy("words", words, 2);
    writer.copy("text", std::string(20'000, 'x'));
    writer.copy("none", std::string_view());
  }
  const std::vector<std::uint8_t> later(200'000, 0xff);  // which may reuse the freed memory
  std::uint8_t* const block = writer.write(1);
  REQUIRE(block != nullptr);
  CHECK(container_bytes(block) > 40'000);
  CHECK(container_bytes(block) < 41'000);
  // Where the second, third and fourth begin, all of them in the block.
  const auto* const directory = reinterpret_cast<const std::uint32_t*>(block) + 4;
  const std::uint8_t* const words = block + directory[6 + 5];
  REQUIRE(directory[6 + 5] < container_bytes(block));
  REQUIRE(directory[12 + 5] < container_bytes(block));
  CHECK(directory[6 + 3] == 2);
  CHECK(directory[6 + 4] == 2500);
  CHECK(std::all_of(words, words + 20'000, [](std::uint8_t byte) { return byte == 7 || byte == 0; }));
  const std::uint8_t* const text = block + directory[12 + 5];
  CHECK(std::all_of(text, text + 20'000, [](std::uint8_t byte) { return byte == 'x'; }));
  CHECK(directory[18 + 4] == 0);
  std::free(block);
}

TEST_CASE("padding up to the next word is zero, also in reused memory") {
  ContainerWriter writer;
  const std::vector<std::uint8_t> octets{1, 2, 3, 4, 5};
  writer.add("odd", octets);
  for (int round = 0; round < 4; ++round) {
    std::uint8_t* const block = writer.write();
    REQUIRE(block != nullptr);
    const std::uint32_t whole = container_bytes(block);
    // Behind the header of 4 words and the one entry of 6: "odd" and its fill, then the octets and theirs.
    REQUIRE(whole == 4 * 10 + 4 + 8);
    CHECK(block[43] == 0);
    for (std::uint32_t at = 49; at < whole; ++at) CHECK(block[at] == 0);
    std::memset(block, 0xff, whole);  // which the next one is likely to get
    std::free(block);
  }
}
