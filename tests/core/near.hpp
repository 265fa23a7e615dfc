// Comparing what is small.
#pragma once

#include <doctest/doctest.h>

namespace panicle {

// What differs from a value by less than a share of the larger of the two. (That of doctest::Approx's epsilon is of one
// more than that: of a radius in metres anything would do.) Nothing is near to 0.
inline doctest::Approx near(double value, double share) { return doctest::Approx(value).epsilon(share).scale(0); }

}  // namespace panicle
