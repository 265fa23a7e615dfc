// The operations of the byte code, and the functions of the language that compile to one of them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::expression {

enum class Op : std::uint8_t {
  // The most frequent operations.
  add,
  subtract,
  multiply,
  divide,
  equal,
  not_equal,
  less,
  less_equal,
  greater,
  greater_equal,
  negate,
  truth,
  jump_if_false,
  jump_if_true,
  // Functions of one or two numbers.
  remainder,
  power,
  minimum,
  maximum,
  invert,
  floor,
  ceiling,
  nearest,
  absolute,
  square_root,
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  arc_tangent_of,
  exponential,
  logarithm,
  // A function of three numbers, compiled to two instructions.
  clamp,
  // Operations that can fail or draw random values.
  element,
  curve,
  // Queries of the space; several arguments are handed over one by one.
  hand_over,
  bound,
  reach,
  random_whole,
  random_real,
  random_normal,
};

// Draws depend on the module they are made for: they are never shared or computed beforehand.
constexpr bool is_random(Op op) { return op >= Op::random_whole; }
// Nor are queries of the space.
constexpr bool is_space_query(Op op) { return op >= Op::hand_over && op < Op::random_whole; }
inline constexpr std::uint32_t max_handed_over = 8;

// The cost of an operation, in 32nds of a unit of work.
constexpr std::uint32_t cost_of(Op op) {
  if (op < Op::remainder || op == Op::hand_over) return 1;
  if (op == Op::reach) return 512;
  if (op == Op::random_normal) return 72;
  if (op == Op::bound || op == Op::tangent) return 48;
  if (op == Op::sine || op == Op::cosine || op == Op::remainder) return 24;
  return op >= Op::minimum && op <= Op::square_root ? 4 : 16;
}

struct Function {
  std::string_view name;
  Op op;
  std::uint32_t arguments;
};

// Angles are in degrees, as the turtle's are.
inline constexpr std::array<Function, 23> functions = {{
    {"RND", Op::random_whole, 2}, {"ran", Op::random_real, 1},  {"nran", Op::random_normal, 2},
    {"floor", Op::floor, 1},      {"ceil", Op::ceiling, 1},     {"nearest", Op::nearest, 1},
    {"abs", Op::absolute, 1},     {"min", Op::minimum, 2},      {"max", Op::maximum, 2},
    {"clamp", Op::clamp, 3},      {"sqrt", Op::square_root, 1}, {"pow", Op::power, 2},
    {"exp", Op::exponential, 1},  {"log", Op::logarithm, 1},    {"sin", Op::sine, 1},
    {"cos", Op::cosine, 1},       {"tan", Op::tangent, 1},      {"asin", Op::arc_sine, 1},
    {"acos", Op::arc_cosine, 1},  {"atan", Op::arc_tangent, 1}, {"atan2", Op::arc_tangent_of, 2},
    {"bound", Op::bound, 4},      {"reach", Op::reach, 8},
}};

}  // namespace panicle::expression
