// A stand's plan as it is read (docs/models/stand/language.md): numbers, nothing of its text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expression/diagnostics.hpp"
#include "foundation/limits.hpp"
#include "foundation/result.hpp"

namespace panicle::stand {

inline constexpr std::uint32_t most_plants = 5000, most_kinds = 64, most_settings = 16, most_wires = 12;

// Both ends included; what is drawn between them is drawn for each plant.
struct ValueRange {
  float from = 0, to = 0;
};

// `key 5 to 7` or `key word` behind a kind's colon: what its plants are told of their own model's parameters.
struct Setting {
  std::string key;
  std::string word;  // where it is no number
  ValueRange range;
  expression::Place place;
};

// What can grow: a model's preset, and how.
struct Kind {
  std::string name;  // model/preset
  expression::Place place;
  float share = 1;
  float width = 4, height = 8;  // of the crown at scale 1, metres: what neighbours know of it
  ValueRange scale{1, 1};
  std::uint32_t seeds = 0;  // how many different ones there are; 0: as many as plants
  bool attached = false;       // by the plants of the line above that is not
  ValueRange each{1, 1};         // of those, how many on each
  ValueRange high{1, 1};         // above the bearer's foot, metres at its scale 1
  float reach = 0.5f;       // along the bearer, metres each way
  std::string spot;         // which of the bearer's organs it hangs at, in place of these two; empty: they say
  std::vector<Setting> settings;
};

// A wire over the ground, metres; a pair of them runs to both sides of the posts.
struct Wire {
  float high = 0;
  bool pair = false;
};

// `trellis …`: posts between a layer's rows' plants, and wires from end to end.
struct Trellis {
  float high = 2;   // posts over the ground, metres
  float posts = 6;  // from post to post at the most, metres
  std::vector<Wire> wires;
};

enum class Spacing : std::uint8_t { chance, strata, blue, rows };

// `plants …` and the kinds below it.
struct Layer {
  expression::Place place;
  std::uint32_t count = 0;  // 0: as many as rows have room for
  Spacing spacing = Spacing::strata;
  float apart = 0;    // blue: the least distance, 0 for what suits; rows: from row to row
  float along = 0;    // in a row
  float towards = 0;  // where rows run, degrees from +x to +z
  float jitter = 0;   // off a row's place, metres each way
  ValueRange depth{0, 1};  // the strip of the ground, from its back (−z) to its front
  std::optional<Trellis> trellis;
  std::vector<Kind> kinds;
};

struct Ground {
  float width = 40, depth = 40;  // along x and z, metres
  float relief = 0;              // from the lowest to the highest place at the most
  float hills = 0;               // from one rise to the next, metres; 0: half the ground
};

struct Plan {
  Ground ground;
  std::vector<Layer> layers;
};

// Errors: syntax, undefined, evaluation and limit, with line and column.
Result<Plan> read_plan(std::string_view text, const Limits& limits = {});

}  // namespace panicle::stand
