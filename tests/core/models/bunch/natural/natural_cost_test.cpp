// The cost of a natural bunch as its berries get more and smaller, counted as work: no test here measures a time.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "models/bunch/specimens.hpp"

using namespace panicle;
using namespace panicle::bunch;
using namespace panicle::tests;

namespace {

constexpr float counts[] = {250, 500, 1000, 2000, 3000};

// The outline of the long conical bunch, filled alike by `count` berries, as `npm run bench -- core` has it.
GrownBunch bunch_of(float count) {
  const float share = std::cbrt(125 / count);
  BunchRequest request = natural_request(table3[2].profile());
  set(request, Parameter::count, count);
  set(request, Parameter::size, 18 * share);
  set(request, Parameter::pedicel, 8 * share);
  return grown(request);
}

// By which power of `size` a `cost` rises from the first of two to the second.
double exponent(std::uint64_t cost, std::uint64_t cost_then, double size, double size_then) {
  return std::log(static_cast<double>(cost_then) / static_cast<double>(cost)) / std::log(size_then / size);
}

}  // namespace

TEST_CASE("the work of swelling rises with the contacts of berries and stems, from 250 berries to 3,000") {
  std::vector<SwellingWork> works;
  for (const float count : counts) {
    const GrownBunch bunch = bunch_of(count);
    works.push_back(bunch.swelling);
    const auto& [steps, looks, contacts, thinning] = bunch.swelling;
    MESSAGE(count << " berries wanted, " << bunch.counts.berries << " grown, " << bunch.counts.internodes
                  << " internodes: " << steps << " steps, " << looks << " looks, " << contacts << " contacts, "
                  << thinning << " looks in thinning");
    CHECK(steps <= 64);
    CHECK(looks <= 10 * contacts);
    // However many rounds it takes, thinning measures once how deep berries press.
    CHECK(thinning <= looks / 20);
  }
  const auto power = [&](std::uint64_t SwellingWork::* part) {
    return exponent(works.front().*part, works.back().*part, counts[0], 3000);
  };
  MESSAGE("exponents from 250 to 3,000 berries: steps "
          << power(&SwellingWork::steps) << ", looks " << power(&SwellingWork::looks) << ", contacts "
          << power(&SwellingWork::contacts) << ", thinning " << power(&SwellingWork::thinning_looks));
  CHECK(power(&SwellingWork::steps) <= 0.1);
}

TEST_CASE("a count whose usual plan would exceed the limit of flowers gets a plan with fewer") {
  const GrownBunch bunch = bunch_of(3000);
  CHECK(bunch.counts.berries > 1500);
}
