// Measures of a grown bunch: the numbers that a viticulturist reads, and how well the bunch follows its outline.
#pragma once

#include <span>
#include <vector>

#include "models/bunch/grown.hpp"
#include "models/bunch/paper/envelope.hpp"
#include "models/bunch/stance.hpp"

namespace panicle::bunch {

// An outline and its stance; millimetres.
struct HungEnvelope {
  Envelope envelope;
  Stance stance;
};

// All measures in the order of measures.generated.hpp; NaN where one does not apply. Reads internodes, berries and
// traits of `grown`, in metres.
std::vector<float> measure(const GrownBunch& grown, std::span<const HungEnvelope> envelopes);

}  // namespace panicle::bunch
