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
  line_apart,
  move_apart,
  ball,
  disc,
  circle,
  level,
  go_to,
  head_for,
  begin_polygon,
  corner,
  end_polygon,
  surface,
  widen,
  next_colour,
  last_colour,
  size,
  enlarge,
  reduce,
  elasticity,
  nothing,
  ask_position,
  ask_heading,
  ask_left,
  ask_up,
};

// What a text says once for all its modules, in a line such as angle increment: 25.
enum class Setting : std::uint8_t { none, angle_increment, line_length, line_width, line_width_increment };

inline constexpr std::uint32_t any_number = 0xffffffffu;

struct TurtleSymbol {
  std::string_view symbol;
  std::string_view name;
  Action action;
  std::uint32_t most_arguments;
  float standard;     // stands in for an argument that is left out
  float sign;         // which way the action goes
  bool non_negative;  // the argument may not be below 0
  Setting setting;    // the line of the text that says what stands in for it
  bool cpfg_only;     // a symbol of the text's own in the other notation
  bool yields;        // a symbol of the text's own where a text of cpfg's notation rewrites it
};

// A turtle symbol's number in a derived string is its place here.
// clang-format off
inline constexpr std::array<TurtleSymbol, 45> turtle_symbols = {{
    {"F",   "line",          Action::line, 1, 1.0f, 1.0f, false, Setting::line_length, false, false},
    {"f",   "move",          Action::move, 1, 1.0f, 1.0f, false, Setting::line_length, false, false},
    {"S",   "sphere",        Action::sphere, 1, 1.0f, 1.0f, true, Setting::none, false, true},
    {"+",   "turn",          Action::turn, 1, 90.0f, 1.0f, false, Setting::angle_increment, false, false},
    {"-",   "turn back",     Action::turn, 1, 90.0f, -1.0f, false, Setting::angle_increment, false, false},
    {"&",   "pitch",         Action::pitch, 1, 90.0f, 1.0f, false, Setting::angle_increment, false, false},
    {"^",   "pitch back",    Action::pitch, 1, 90.0f, -1.0f, false, Setting::angle_increment, false, false},
    {"/",   "roll",          Action::roll, 1, 90.0f, 1.0f, false, Setting::angle_increment, false, false},
    {"\\",  "roll back",     Action::roll, 1, 90.0f, -1.0f, false, Setting::angle_increment, false, false},
    {"|",   "turn around",   Action::turn, 0, 180.0f, 1.0f, false, Setting::none, false, false},
    {"!",   "width",         Action::width, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"[",   "push",          Action::push, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"]",   "pop",           Action::pop, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"%",   "cut",           Action::cut, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"?E",  "ask",           Action::ask, any_number, 0.0f, 1.0f, false, Setting::none, false, false},
    {"G",   "line beside",   Action::line_apart, 1, 1.0f, 1.0f, false, Setting::line_length, true, false},
    {"g",   "move beside",   Action::move_apart, 1, 1.0f, 1.0f, false, Setting::line_length, true, false},
    {"@O",  "ball",          Action::ball, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"@o",  "disc",          Action::disc, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"@c",  "circle",        Action::circle, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"<",   "roll",          Action::roll, 1, 90.0f, -1.0f, false, Setting::angle_increment, false, false},
    {">",   "roll back",     Action::roll, 1, 90.0f, 1.0f, false, Setting::angle_increment, false, false},
    {"$",   "level",         Action::level, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"@v",  "level",         Action::level, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"@M",  "go to",         Action::go_to, 3, 0.0f, 1.0f, false, Setting::none, false, false},
    {"@R",  "head for",      Action::head_for, 6, 0.0f, 1.0f, false, Setting::none, false, false},
    {"{",   "begin polygon", Action::begin_polygon, 1, 0.0f, 1.0f, true, Setting::none, false, false},
    {".",   "corner",        Action::corner, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"}",   "end polygon",   Action::end_polygon, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"~",   "surface",       Action::surface, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"#",   "widen",         Action::widen, 1, 0.0f, 1.0f, true, Setting::none, false, false},
    {"'",   "next colour",   Action::next_colour, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {";",   "next colour",   Action::next_colour, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {",",   "last colour",   Action::last_colour, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"@D",  "size",          Action::size, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"@Di", "enlarge",       Action::enlarge, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"@Dd", "reduce",        Action::reduce, 1, 1.0f, 1.0f, true, Setting::none, false, false},
    {"@Ts", "elasticity",    Action::elasticity, 2, 0.0f, 1.0f, false, Setting::none, false, false},
    {"@Gs", "tube",          Action::nothing, 0, 0.0f, 1.0f, false, Setting::none, false, false},
    {"@Gc", "tube",          Action::nothing, 1, 0.0f, 1.0f, false, Setting::none, false, false},
    {"@Ge", "tube",          Action::nothing, 1, 0.0f, 1.0f, false, Setting::none, false, false},
    {"?P",  "position",      Action::ask_position, any_number, 0.0f, 1.0f, false, Setting::none, false, false},
    {"?H",  "heading",       Action::ask_heading, any_number, 0.0f, 1.0f, false, Setting::none, false, false},
    {"?L",  "left",          Action::ask_left, any_number, 0.0f, 1.0f, false, Setting::none, false, false},
    {"?U",  "up",            Action::ask_up, any_number, 0.0f, 1.0f, false, Setting::none, false, false},
}};
// clang-format on

}  // namespace panicle::lsystem
