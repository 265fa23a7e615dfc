// The pieces of work that the bench times, natively and as wasm alike. None of them reads a clock: the caller does.
#pragma once

#include <cstdint>

namespace panicle::bench {

enum class Kernel : std::uint32_t {
  derive = 0,  // the rule A(s) → F(s)[+A(s/1.456)][−A(s/1.456)], `size` steps; work: modules written
  plan = 1,    // shouldered conical with `size` times its axes on a longer rachis, no meshes; work: pedicels
  probe = 2,   // `size` berries looking for room one after another; work: berries probed
  tubes = 3,   // stems of `size` internodes, 12 sides; work: vertices
  // Of `size` particles or points (particles.hpp), flat and in space.
  crowd_flat = 4,
  crowd_space = 5,
  brute_flat = 6,
  brute_space = 7,
  colonise_flat = 8,
  colonise_space = 9,
  // Rules that choose by chance, and rules that see their neighbours; `size` steps; work: modules written.
  derive_chance = 10,
  derive_context = 11,
  // Generalized maps of `size` darts (maps.hpp).
  map_build = 12,
  map_check = 13,
  map_embed = 14,
  map_place = 15,
  // Trees by divisor functions of `size` steps, each round another, to a stage (growth.hpp).
  growth_text = 16,
  growth_population = 17,
  growth_form = 18,
  growth_moment = 19,
  growth_leaves = 20,
  growth_levels = 21,
};

// Does the work `rounds` times over and returns how much one round was; negative if it failed.
double run(Kernel kernel, std::uint32_t size, std::uint32_t rounds);

}  // namespace panicle::bench
