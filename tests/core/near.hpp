// Relative comparison of small numbers.
#pragma once

#include <doctest/doctest.h>

namespace panicle {

// A range of numbers that differ from a value by less than a share of the larger of the two. (doctest::Approx adds 1 to
// the value, so that for a radius in metres any number would do.) Nothing is near to 0.
inline doctest::Approx near(double value, double share) { return doctest::Approx(value).epsilon(share).scale(0); }

}  // namespace panicle
