// The share of the outline's space to fill for a requested density (OIV 204). The same share packs differently with
// every size of berry and form of outline; the density note follows from the space that others take about each berry,
// if all were to hang before any has swollen.
#pragma once

#include <span>

#include "models/bunch/natural/settling/fruit_set.hpp"

namespace panicle::bunch {

// The size and the proportions of ripe berries.
struct BerrySize {
  float size = 0;        // mean width of a ripe one, millimetres
  float elongation = 1;  // length over width
};

// The share of space that other berries fill within two widths of a berry, near ones counting for more: over all
// berries by volume, the harmonic mean of that share and a middling one together, less the middling one. `volumes` are
// choose_set's; 0 where none sets.
float crowding(std::span<const Bud> buds, std::span<const float> volumes, const BerrySize& berry);

// The crowding of bunches of a density, 1 … 9.
float crowding_at(float density, float elongation);

// The fill for choose_set with which flowers of these ranks are as crowded as the density requires; the greatest fill
// where there are too few. Smooth in the buds' places.
float fill_for(std::span<const Bud> buds, std::span<const float> ranks, float density, const BerrySize& berry);

}  // namespace panicle::bunch
