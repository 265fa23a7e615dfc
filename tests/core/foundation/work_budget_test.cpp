#include "foundation/work_budget.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace panicle;

namespace {

// The clock of these tests.
double passed = 0;
int looks = 0;
double time_passed() {
  ++looks;
  return passed;
}

}  // namespace

TEST_CASE("work can be spent up to the last unit, and no further") {
  WorkBudget budget(10, 0);
  CHECK(budget.spend(7));
  CHECK(budget.left() == 3);
  CHECK(budget.spend(3));
  CHECK(budget.left() == 0);
  CHECK_FALSE(budget.spend(1));
  CHECK_FALSE(budget.spend(0));
  CHECK(budget.left() == 0);
}

TEST_CASE("hold takes bytes up to the limit, and none beyond it") {
  WorkBudget budget(0, 100);
  CHECK(budget.hold(60));
  CHECK_FALSE(budget.hold(41));
  CHECK(budget.held() == 60);
  CHECK(budget.hold(40));
  CHECK_FALSE(budget.hold(1));
  CHECK(budget.held() == budget.bytes());
  CHECK_FALSE(budget.hold(~std::uint64_t{0}));
}

TEST_CASE("a share reserves the rest of the work until it ends") {
  WorkBudget budget(100, 0);
  CHECK(budget.spend(20));
  {
    const WorkBudget::Share share(budget, 30);
    CHECK(budget.left() == 30);
    CHECK(budget.spend(30));
    CHECK_FALSE(budget.spend(500));
  }
  // Refused work is not counted as done.
  CHECK(budget.spent() == 50);
  CHECK(budget.left() == 50);
  {
    const WorkBudget::Share share(budget, 1000);  // no more than there is
    CHECK(budget.left() == 50);
    CHECK(budget.spend(10));
  }
  CHECK(budget.left() == 40);
}

TEST_CASE("a budget looks at the clock once in many units of work, and ends the work when the time is over") {
  passed = 0;
  looks = 0;
  WorkBudget budget(100 * WorkBudget::look_interval, 0, time_passed);
  for (std::uint64_t i = 0; i < 10 * WorkBudget::look_interval; ++i) REQUIRE(budget.spend(1));
  CHECK(looks == 10);
  passed = 1;
  CHECK_FALSE(budget.spend(1));
  CHECK(budget.time_is_over());
  CHECK_FALSE(budget.spend(0));
  CHECK(budget.time_has_ended_work());
}

TEST_CASE("time is divided as the work is: a share of the work has the same share of the time") {
  passed = 0.7;
  WorkBudget budget(100, 0, time_passed);
  {
    const WorkBudget::Share share(budget, 75);
    CHECK(budget.spend(10));
    CHECK_FALSE(budget.look_at_clock());
    passed = 0.8;
    CHECK(budget.look_at_clock());
    CHECK_FALSE(budget.spend(1));
  }
  // The rest of the time is for the rest of the work.
  CHECK(budget.left() == 25);
  CHECK_FALSE(budget.time_is_over());
  CHECK(budget.spend(10));
  passed = 1;
  CHECK(budget.look_at_clock());
  CHECK_FALSE(budget.spend(1));
}

TEST_CASE("a clock changes nothing before its time is over, and a budget without a clock has no time limit") {
  passed = 0.5;
  WorkBudget timed(100, 0, time_passed), untimed(100, 0);
  for (WorkBudget* const budget : {&timed, &untimed}) {
    {
      const WorkBudget::Share share(*budget, 75);
      CHECK(budget->spend(70));
    }
    CHECK(budget->spend(30));
    CHECK_FALSE(budget->spend(1));
    CHECK_FALSE(budget->look_at_clock());
    CHECK_FALSE(budget->time_has_ended_work());
  }
  CHECK(timed.spent() == untimed.spent());
}
