// Shoulders branch again: the lower end structures of long axes go on as axes of second order.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "models/bunch/natural/natural_plan.hpp"
#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

GrownBunch in_flower(const Profile& profile, float lateral = 0, float wing = 0) {
  BunchRequest request = natural_request(profile);
  set(request, Parameter::age, 0);
  set(request, Parameter::wing, wing);
  const std::string unbranched = edited(4, "#define lateral 0.6", "#define lateral 0");
  REQUIRE(!unbranched.empty());
  if (lateral == 0) request.grammar = unbranched;
  return grown(request);
}

GrownBunch branched(const Profile& profile, float wing = 0) { return in_flower(profile, 1, wing); }

bool goes_on(const GrownBunch& bunch, std::size_t i) {
  const Internode& one = bunch.internodes[i];
  return one.kind == Kind::axis && one.parent >= 0 &&
         bunch.internodes[static_cast<std::size_t>(one.parent)].kind == Kind::end;
}

// Number of axes of second order on each first-order axis, by its number.
std::vector<int> laterals(const GrownBunch& bunch) {
  std::vector<int> counts;
  for (std::size_t i = 0; i < bunch.internodes.size(); ++i) {
    const auto axis = static_cast<std::size_t>(std::max(0, bunch.internodes[i].axis));
    counts.resize(std::max(counts.size(), axis + 1));
    counts[axis] += goes_on(bunch, i);
  }
  return counts;
}

int sum(const std::vector<int>& counts, std::size_t from, std::size_t to) {
  int all = 0;
  for (std::size_t i = from; i < std::min(to, counts.size()); ++i) all += counts[i];
  return all;
}

}  // namespace

TEST_CASE("axes at the shoulders have axes of second order with end structures, axes at the tip none") {
  const std::vector<int> counts = laterals(branched(table3[7].profile()));
  CHECK(sum(counts, 0, 4) >= 4);
  CHECK(sum(counts, counts.size() / 2, counts.size()) == 0);
  CHECK(sum(laterals(branched(table3[5].profile())), 0, 100) <= 2);  // a small one
  CHECK(sum(laterals(branched(table3[3].profile())), 0, 100) == 0);  // and one without shoulders
}

TEST_CASE("a wing is a bunch of its own, with shoulders that branch again") {
  const GrownBunch bunch = branched(table3[7].profile(), 0.8f);
  int on_wing = 0;
  for (std::size_t i = 0; i < bunch.internodes.size(); ++i)
    on_wing += goes_on(bunch, i) && static_cast<std::int32_t>(i) > bunch.second_root;
  REQUIRE(bunch.second_root > 0);
  CHECK(on_wing >= 2);
}

TEST_CASE("every flower of a bunch whose axes are not branched is one of the branched bunch's, with the same id") {
  const Profile profile = table3[7].profile();
  const GrownBunch plain = in_flower(profile), more = branched(profile);
  CHECK(sum(laterals(plain), 0, 100) == 0);
  CHECK(more.berries.size() > plain.berries.size() + 20);
  std::set<std::uint32_t> ids;
  for (const Berry& berry : more.berries) ids.insert(berry.id);
  for (const Berry& berry : plain.berries) CHECK(ids.count(berry.id) == 1);
}

TEST_CASE("axes of second order get shorter along their parent, and stay in the outline") {
  const Profile profile = table3[7].profile();
  const BunchRequest request = natural_request(profile);
  std::vector<std::string> notes;
  const NaturalPlan plan = make_natural_plan(profile, Values(request.parameters, notes), 3000);
  REQUIRE(plan.node.size() == plan.arm.size());
  int found = 0;
  for (std::size_t k = 0; k < plan.arm.size(); ++k) {
    const auto first = static_cast<std::size_t>(plan.node[k]) - 1;
    REQUIRE(first < plan.beyond.size());
    for (std::size_t j = 0;
         first + j < plan.beyond.size() && static_cast<float>(j) * plan.first_order_spacing < plan.arm[k]; ++j) {
      const float left = plan.arm[k] - static_cast<float>(j + 1) * plan.first_order_spacing,
                  beyond = plan.beyond[first + j];
      CHECK(beyond >= 0);
      CHECK(beyond <= std::max(0.0f, 0.6f * left - plan.second_order_spacing) + 1e-4f);
      found += beyond > 0;
    }
  }
  CHECK(found >= 5);
}

TEST_CASE("a text with longer axes than the plan's has lengths for all nodes") {
  BunchRequest request = natural_request(table3[7].profile());
  const std::string longer = edited(4, "Af(node[k], arm[k],", "Af(node[k], 3*arm[k],");
  REQUIRE(!longer.empty());
  request.grammar = longer;
  CHECK(grown(request).berries.size() > 40);
}
