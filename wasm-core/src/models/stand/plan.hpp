// A stand's plan after reading (docs/models/stand/language.md), independent of its text.
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

// A range with both ends included; a value in it is drawn for each plant.
struct ValueRange {
  float from = 0, to = 0;
};

// `key 5 to 7` or `key word` behind a kind's colon: a parameter of the kind's own model.
struct Setting {
  std::string key;
  std::string word;  // set where the value is not a number
  ValueRange range;
  expression::SourceLocation place;
};

// A line of the plan: a model's preset, and how its plants are placed.
struct Kind {
  std::string name;  // model/preset
  expression::SourceLocation place;
  float share = 1;
  float width = 4, height = 8;  // of the crown at scale 1, metres; used for the surroundings of neighbours
  ValueRange scale{1, 1};
  std::uint32_t seeds = 0;  // number of different plants; 0: as many as plants
  bool attached = false;    // to the plants of the nearest line above that is not attached
  ValueRange each{1, 1};    // number on each parent
  ValueRange high{1, 1};    // above the parent's foot, metres at its scale 1
  float reach = 0.5f;       // along the parent, metres each way
  std::string spot;         // kind of the parent's organs that it hangs at, in place of height and reach; empty: none
  std::vector<Setting> settings;
};

// A wire above the ground, metres; a pair runs on both sides of the posts.
struct Wire {
  float high = 0;
  bool pair = false;
};

// `trellis …`: posts between the plants of a layer's rows, and wires from end to end.
struct Trellis {
  float high = 2;   // height of posts above the ground, metres
  float posts = 6;  // greatest distance from post to post, metres
  std::vector<Wire> wires;
};

enum class Spacing : std::uint8_t { chance, strata, blue, rows };

// `plants …` and the kinds below it.
struct Layer {
  expression::SourceLocation place;
  std::uint32_t count = 0;  // 0: as many as rows have room for
  Spacing spacing = Spacing::strata;
  float apart = 0;         // blue: the least distance, 0: chosen by the count; rows: from row to row
  float along = 0;         // distance in a row
  float towards = 0;       // direction of rows, degrees from +x to +z
  float jitter = 0;        // greatest offset from a row's place, metres each way
  ValueRange depth{0, 1};  // the strip of the ground, from its back (−z) to its front
  std::optional<Trellis> trellis;
  std::vector<Kind> kinds;
};

struct Ground {
  float width = 40, depth = 40;  // along x and z, metres
  float relief = 0;              // greatest difference in height
  float hills = 0;               // distance from one rise to the next, metres; 0: half the ground
};

struct Plan {
  Ground ground;
  std::vector<Layer> layers;
};

// Reads a plan. Errors: syntax, undefined, evaluation and limit, with line and column.
Result<Plan> read_plan(std::string_view text, const Limits& limits = {});

}  // namespace panicle::stand
