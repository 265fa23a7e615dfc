// Made from wasm-core/parameters/turtle.json by wasm-core/tools/generate.mjs; edit the table, not this.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::lsystem {

enum class Action : std::uint8_t {
  line,
  move,
  sphere,
  turn,
  pitch,
  roll,
  width,
  push,
  pop,
  cut,
  ask,
};

inline constexpr std::uint32_t any_number = 0xffffffffu;

struct TurtleSymbol {
  std::string_view symbol;
  std::string_view name;
  Action action;
  std::uint32_t most_arguments;
  float standard;     // stands in for an argument that is left out
  float sign;         // which way the action goes
  bool non_negative;  // the argument may not be below 0
};

// A turtle symbol's number in a derived string is its place here.
// clang-format off
inline constexpr std::array<TurtleSymbol, 15> turtle_symbols = {{
    {"F",  "line",        Action::line, 1, 1.0f, 1.0f, false},
    {"f",  "move",        Action::move, 1, 1.0f, 1.0f, false},
    {"S",  "sphere",      Action::sphere, 1, 1.0f, 1.0f, true},
    {"+",  "turn right",  Action::turn, 1, 90.0f, 1.0f, false},
    {"-",  "turn left",   Action::turn, 1, 90.0f, -1.0f, false},
    {"&",  "pitch up",    Action::pitch, 1, 90.0f, 1.0f, false},
    {"^",  "pitch down",  Action::pitch, 1, 90.0f, -1.0f, false},
    {"/",  "roll right",  Action::roll, 1, 90.0f, 1.0f, false},
    {"\\", "roll left",   Action::roll, 1, 90.0f, -1.0f, false},
    {"|",  "turn around", Action::turn, 0, 180.0f, 1.0f, false},
    {"!",  "width",       Action::width, 1, 1.0f, 1.0f, true},
    {"[",  "push",        Action::push, 0, 0.0f, 1.0f, false},
    {"]",  "pop",         Action::pop, 0, 0.0f, 1.0f, false},
    {"%",  "cut",         Action::cut, 0, 0.0f, 1.0f, false},
    {"?E", "ask",         Action::ask, any_number, 0.0f, 1.0f, false},
}};
// clang-format on

}  // namespace panicle::lsystem
