#include "expression/names.hpp"

#include <doctest/doctest.h>

#include <string>

using panicle::expression::Names;

TEST_CASE("names are numbered in the order in which they are added") {
  Names names;
  CHECK(names.find("A") == Names::none);
  CHECK(names.add("A") == 0);
  CHECK(names.add("δ") == 1);
  CHECK(names.add("A") == 0);
  CHECK(names.size() == 2);
  CHECK(names.find("δ") == 1);
  CHECK(names.find("AB") == Names::none);
}

TEST_CASE("names are copied, may be empty and hold any bytes") {
  Names names;
  {
    std::string passing = "passing";
    names.add(passing);
    passing.assign(passing.size(), 'x');
  }
  CHECK(names.find("passing") == 0);
  CHECK(names.add("") == 1);
  CHECK(names.add(std::string_view("\0\0", 2)) == 2);
  CHECK(names.add(std::string_view("\0", 1)) == 3);
  CHECK(names.find(std::string_view("\0\0", 2)) == 2);
  CHECK(names.find("") == 1);
}

TEST_CASE("a hundred thousand names have different numbers") {
  Names names;
  for (std::uint32_t i = 0; i < 100'000; ++i) REQUIRE(names.add("A" + std::to_string(i)) == i);
  for (std::uint32_t i = 0; i < 100'000; ++i) REQUIRE(names.find("A" + std::to_string(i)) == i);
  CHECK(names.find("A100000") == Names::none);
}
