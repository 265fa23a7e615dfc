// The byte code of expressions: three-address instructions over one file of registers that the whole program shares.
// Registers 0 … 31 are the module's parameters. Constants of the text, and values that depend on the inputs alone, have
// permanent registers; each other result has its own.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expression/operations.hpp"
#include "expression/space.hpp"
#include "expression/tokens.hpp"
#include "foundation/result.hpp"

namespace panicle::expression {

inline constexpr std::size_t max_parameters = 32;  // of one module: the first registers

struct Instruction {
  Op op = Op::add;
  std::uint32_t out = 0;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;  // array of an element; stream of a draw; target of a jump

  bool operator==(const Instruction&) const = default;
};

struct Range {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t size() const { return end - begin; }
};

// An expression with code of its own and the register of its result.
struct Value {
  bool given = false;
  Range code;
  std::uint32_t source = 0;  // register
  SourceLocation place;
};

// A function of one number through given points: monotone cubic between two of them (Fritsch and Carlson 1980), so that
// it overshoots nowhere; constant beyond the ends.
struct Curve {
  explicit Curve(std::span<const float> points);
  float at(float x) const;

  std::vector<float> x, y, slope;
};

struct Code {
  std::vector<Instruction> instructions;
  std::vector<SourceLocation> places;  // of each instruction
  std::vector<float> registers;        // initial values: the numbers of the text
  bool doubles = false;                // whether expressions are worked out in double precision
  std::vector<double> precise;         // the same in double precision, where `doubles`
  std::vector<std::string> arrays;     // names
  std::vector<std::uint64_t> streams;
  std::vector<Curve> curves;
};

// The cost of running a range, in 32nds of a unit of work.
inline std::uint32_t cost_of(const Code& code, Range range) {
  std::uint32_t cost = 0;
  for (std::uint32_t at = range.begin; at < range.end; ++at) cost += cost_of(code.instructions[at].op);
  return cost;
}

// Data that instructions read besides registers: the arrays of the inputs, the seed and address of random values, and
// the space.
struct Sources {
  std::span<const std::vector<float>> arrays;
  std::uint64_t seed = 0;
  std::uint64_t address = 0;
  const Space* space = nullptr;
  mutable std::array<float, max_handed_over> handed_over{};
  mutable std::array<float, max_handed_over> reached_for{};  // arguments of the last query of reach()
  mutable std::optional<float> reached{};                    // and its answer
};

// Executes one of the rarer instructions, from Op::remainder on. False when it fails; `fault` describes the error.
bool execute_one(const Code& code, std::uint32_t at, float* registers, const Sources& sources, Diagnostic& fault);
// The same in double precision; sines, logarithms and the like, arrays, curves, random values and queries remain in
// single precision.
bool execute_one(const Code& code, std::uint32_t at, double* registers, const Sources& sources, Diagnostic& fault);

// Executes instructions from `begin` to before `end`, the most frequent ones without a call. False when one fails;
// `fault` describes the error. Number is float or double.
template <class Number>
inline bool execute(const Code& code, std::uint32_t begin, std::uint32_t end, Number* registers, const Sources& sources,
                    Diagnostic& fault) {
  const Instruction* const instructions = code.instructions.data();
  for (std::uint32_t at = begin; at < end; ++at) {
    const Instruction& step = instructions[at];
    const Number a = registers[step.a];
    const Number b = registers[step.b];
    Number& out = registers[step.out];
    switch (step.op) {
      case Op::add:
        out = a + b;
        break;
      case Op::subtract:
        out = a - b;
        break;
      case Op::multiply:
        out = a * b;
        break;
      case Op::divide:
        out = a / b;
        break;
      case Op::equal:
        out = a == b;
        break;
      case Op::not_equal:
        out = a != b;
        break;
      case Op::less:
        out = a < b;
        break;
      case Op::less_equal:
        out = a <= b;
        break;
      case Op::greater:
        out = a > b;
        break;
      case Op::greater_equal:
        out = a >= b;
        break;
      case Op::negate:
        out = -a;
        break;
      case Op::truth:
        out = a != 0;
        break;
      case Op::jump_if_false:
        if (a == 0) at = step.c - 1;
        break;
      case Op::jump_if_true:
        if (a != 0) at = step.c - 1;
        break;
      default:
        if (!execute_one(code, at, registers, sources, fault)) return false;
    }
  }
  return true;
}

}  // namespace panicle::expression
