// How much of the outline's space is to be filled for a bunch to be as dense as was asked for (OIV 204). The same share
// packs otherwise with every size of berry and form of outline; the space that others take about each berry, where all
// would hang before any has swollen, tells the note.
#pragma once

#include <span>

#include "models/bunch/natural/settling/fruit_set.hpp"

namespace panicle::bunch {

// Of what make berries are.
struct BerrySize {
  float size = 0;        // mean width of a ripe one, millimetres
  float elongation = 1;  // length over width
};

// The share of space that others fill within two widths of a berry, near ones counting for more: over all berries by
// volume, the harmonic mean of that share and a middling one together, less the middling one. `volumes` are
// choose_set's; 0 where none sets.
float crowding(std::span<const Bud> buds, std::span<const float> volumes, const BerrySize& berry);

// The crowding of bunches of a density, 1 … 9.
float crowding_at(float density, float elongation);

// The fill for choose_set with which flowers of these ranks are as crowded as the density says; as many as there are
// where they are too few. Smooth in the buds' places.
float fill_for(std::span<const Bud> buds, std::span<const float> ranks, float density, const BerrySize& berry);

}  // namespace panicle::bunch
