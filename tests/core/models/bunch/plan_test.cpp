#include "models/bunch/plan.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "models/bunch/table3.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

std::int32_t end_structures(const Plan& plan) { return std::accumulate(plan.axes.begin(), plan.axes.end(), 1); }

}  // namespace

TEST_CASE("the profile gives all 126 derived values of Table 3") {
  int right = 0, values = 0;
  for (const tests::Table3Row& row : tests::table3) {
    const Plan plan = make_plan(row.profile());
    const auto check = [&](std::int32_t derived, std::int32_t printed) {
      ++values;
      right += derived == printed;
    };
    check(plan.m, row.m);
    for (std::size_t i = 0; i < 4; ++i) {
      check(plan.sides[i].n, row.sides[i].n);
      check(plan.sides[i].rd, row.sides[i].rd);
    }
  }
  CHECK(values == 126);
  CHECK(right == 126);
}

TEST_CASE("axes shrink linearly from a side's first to one end structure at rd") {
  const Plan plan = make_plan(tests::table3[1].profile());  // shouldered conical
  CHECK(plan.axes == std::vector<std::int32_t>{8, 4, 6, 6, 3, 2, 3, 3, 1, 1, 1, 1});
  CHECK(end_structures(plan) == 40);
  CHECK(end_structures(make_plan(tests::table3[6].profile())) == 40);
  CHECK(end_structures(make_plan(tests::table3[7].profile())) == 40);
}

TEST_CASE("a side without width is a raceme of single pedicels") {
  const Plan plan = make_plan(tests::table3[9].profile());  // redcurrant
  CHECK(plan.axes == std::vector<std::int32_t>(17, 0));
}

TEST_CASE("the smallest profile is one rachis segment without axes") {
  const Plan plan = make_plan({29, {}});
  CHECK(plan.m == 1);
  CHECK(plan.axes.empty());
}

TEST_CASE("fit makes lengths follow the profile and is 1 for the paper's exact method") {
  const Profile profile = tests::table3[1].profile();
  const Plan plan = make_plan(profile);
  const Fit none = make_fit(profile, plan, 0);
  CHECK(none.rachis == 1.0f);
  CHECK(none.sides == std::array<float, 4>{1, 1, 1, 1});
  const Fit whole = make_fit(profile, plan, 1);
  CHECK(whole.rachis == doctest::Approx(377.0 / (29 * 13)));
  CHECK(whole.sides[0] == doctest::Approx(190.0 / (25 * 8)));
}

TEST_CASE("the reach of rachis and axes is continuous where a count steps") {
  Profile profile = tests::table3[2].profile();
  for (float l = 60; l < 580; ++l) {
    profile.length = l;
    const Plan plan = make_plan(profile);
    CHECK(make_fit(profile, plan, 1).rachis * static_cast<float>(plan.m) * 29 == doctest::Approx(l));
  }
}
