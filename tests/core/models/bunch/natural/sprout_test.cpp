#include "models/bunch/natural/sprout.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

Sprout sprouted(const BunchRequest& request) {
  std::vector<std::string> notes;
  auto result = sprout(request, Values(request.parameters, notes), {}, notes);
  REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
  return std::move(result.value());
}

// Lengths of the stems that hang from each root, in the order of the list.
std::vector<std::vector<float>> lengths(const Sprout& sprout) {
  std::vector<std::vector<float>> bunches;
  for (const Internode& one : sprout.internodes) {
    if (one.parent < 0) bunches.emplace_back();
    bunches.back().push_back(glm::length(one.end - one.start));
  }
  return bunches;
}

}  // namespace

TEST_CASE("a second bunch as large as the first is another bunch, not its twin") {
  BunchRequest request = natural_request(table3[2].profile());
  set(request, Parameter::wing, 1);
  const auto bunches = lengths(sprouted(request));
  REQUIRE(bunches.size() == 2);
  const std::size_t common = std::min(bunches[0].size(), bunches[1].size());
  std::size_t alike = 0;
  for (std::size_t i = 0; i < common; ++i) alike += std::abs(bunches[0][i] - bunches[1][i]) < 1e-3f;
  CHECK(alike < common / 2);
  const auto first = lengths(sprouted(natural_request(table3[2].profile())));
  CHECK(bunches[0] == first[0]);  // unchanged by the second bunch
}

TEST_CASE("stems are in millimetres at both their ends, at any scale") {
  for (const float unit : {0.1f, 0.25f, 1.0f}) {
    BunchRequest request = natural_request(table3[2].profile());
    set(request, Parameter::unit, unit);
    for (const Internode& one : sprouted(request).internodes) {
      CHECK(one.radius_end == doctest::Approx(one.radius).epsilon(0.5));
      CHECK(one.radius > 0.02f);
      CHECK(one.radius < 5);
    }
  }
}
