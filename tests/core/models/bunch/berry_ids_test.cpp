#include "models/bunch/berry_ids.hpp"

#include <doctest/doctest.h>

#include <set>

#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

TEST_CASE("berries of one module have addresses of their own, and the first has the module's") {
  const std::vector<std::uint64_t> module_addresses{7, 7, 7, 9, 7};
  const std::vector<std::uint64_t> own = own_addresses(module_addresses);
  CHECK(own[0] == 7);
  CHECK(own[3] == 9);
  CHECK(std::set<std::uint64_t>(own.begin(), own.begin() + 4).size() == 4);
}

TEST_CASE("an id is the upper thirty bits of the address, and unique") {
  const std::uint64_t address = 0xfedcba9876543210;
  CHECK(berry_ids(std::vector<std::uint64_t>{address}, 1)[0] == (address >> 34));
  std::vector<std::uint64_t> addresses;
  for (std::uint64_t i = 0; i < 50; ++i) addresses.push_back(address + i);  // equal in those bits
  for (const std::size_t second_from : {50u, 20u}) {
    const std::vector<std::uint32_t> ids = berry_ids(addresses, second_from);
    CHECK(std::set<std::uint32_t>(ids.begin(), ids.end()).size() == 50);
    for (const std::uint32_t id : ids) CHECK(id < (1u << 30));
  }
}

TEST_CASE("the second bunch's berries have other ids than the first's, and unique ones") {
  const std::vector<std::uint64_t> twice{5ull << 40, 6ull << 40, 5ull << 40, 6ull << 40};
  const std::vector<std::uint32_t> ids = berry_ids(twice, 2);
  CHECK(ids[0] != ids[2]);
  const std::vector<std::uint64_t> alone{6ull << 40};
  CHECK(berry_ids(alone, 0)[0] == ids[3]);
}
