// The compactness of a bunch: gaps, contacts, and the density note that follows from them (OIV 204).
#pragma once

#include "models/bunch/measures/measures_subject.hpp"

namespace panicle::bunch {

struct Compactness {
  float gap = 0;       // mm, from a berry's skin to those of its three nearest; 0 where they touch
  float contacts = 0;  // berries that a berry touches
  float pressed = 0;   // how deep free forms would reach into their neighbours', over their diameter; mean of six
};

// Means over all berries; meaningless without any. A gap counts for one mean diameter at most.
Compactness measure_compactness(const Subject& subject);

// 1 (very loose) … 9 (very dense), not rounded. The descriptor's words go from berries that are apart and pedicels that
// are seen (1), over berries that touch and hide them (5) and that cannot be moved (7), to those pressed out of shape
// (9): four notes for closeness and hidden pedicels, two for contacts, two for pressure. `pedicels_seen` is a share.
float density_note(const Subject& subject, const Compactness& compactness, float pedicels_seen);

}  // namespace panicle::bunch
