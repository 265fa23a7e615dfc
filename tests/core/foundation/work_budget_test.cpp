#include "foundation/work_budget.hpp"

#include <doctest/doctest.h>

using namespace panicle;

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

TEST_CASE("bytes can be held up to the last one, and a request beyond that takes none") {
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
  // What was refused has not been done.
  CHECK(budget.spent() == 50);
  CHECK(budget.left() == 50);
  {
    const WorkBudget::Share share(budget, 1000);  // no more than there is
    CHECK(budget.left() == 50);
    CHECK(budget.spend(10));
  }
  CHECK(budget.left() == 40);
}
