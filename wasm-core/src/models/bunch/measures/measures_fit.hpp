// The fit of a bunch to its outline, on its silhouettes from the front (x, y) and from the side (z, y).
#pragma once

#include <span>

#include "models/bunch/measures/measures.hpp"
#include "models/bunch/measures/measures_subject.hpp"

namespace panicle::bunch {

// Areas of one view, in mm².
struct ViewFit {
  float outline = 0;     // the outline's
  float covered = 0;     // of which within the silhouette, closed by one mean berry radius
  float silhouette = 0;  // the silhouette's, not closed
  float spilled = 0;     // of which outside the outline grown by one mean berry radius
};

struct Fitted {
  ViewFit front, side;
  float hull = 0;  // mm³: the volume of the closed silhouettes
};

// Measures the fit. The silhouette is that of all berries, as ellipsoids, and of the stems at the outline's height.
// Without envelopes the outline's areas are 0. Returns false if there is nothing to measure: no berry of any size, or
// coordinates that are not finite.
bool fit(const Subject& subject, std::span<const HungEnvelope> envelopes, Fitted& fitted);

}  // namespace panicle::bunch
