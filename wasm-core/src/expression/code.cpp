#include "expression/code.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::expression {
namespace {

constexpr float degrees = 180 / pi;

// Functions of one or two numbers, from Op::remainder on, in the order of Op.
using Pure = float (*)(float a, float b);
constexpr Pure pure_functions[] = {
    [](float a, float b) { return std::fmod(a, b); },
    [](float a, float b) { return power(a, b); },
    [](float a, float b) { return b < a ? b : a; },
    [](float a, float b) { return b > a ? b : a; },
    [](float a, float) { return a == 0 ? 1.0f : 0.0f; },
    [](float a, float) { return std::floor(a); },
    [](float a, float) { return std::ceil(a); },
    [](float a, float) { return static_cast<float>(std::floor(static_cast<double>(a) + 0.5)); },
    [](float a, float) { return std::fabs(a); },
    [](float a, float) { return std::sqrt(a); },
    [](float a, float) { return sincos_degrees(a).sine; },
    [](float a, float) { return sincos_degrees(a).cosine; },
    [](float a, float) { return sincos_degrees(a).sine / sincos_degrees(a).cosine; },
    [](float a, float) { return arc_sine(a) * degrees; },
    [](float a, float) { return arc_cosine(a) * degrees; },
    [](float a, float) { return arc_tangent(a, 1) * degrees; },
    [](float a, float b) { return arc_tangent(a, b) * degrees; },
    [](float a, float) { return exponential(a); },
    [](float a, float) { return logarithm(a); },
};
constexpr std::size_t first_pure = static_cast<std::size_t>(Op::remainder);
static_assert(std::size(pure_functions) == static_cast<std::size_t>(Op::clamp) - first_pure);

// Returns a random whole number from a to b in either order, all equally likely. `wrong` describes the error if there
// is none.
void draw_whole(float a, float b, const Sources& sources, std::uint64_t stream, float& out, std::string& wrong) {
  const float low = std::ceil(std::min(a, b));
  const float high = std::floor(std::max(a, b));
  if (!(std::fabs(low) <= 1e9f && std::fabs(high) <= 1e9f) || std::isnan(a) || std::isnan(b)) {
    wrong = message(messages::expression::rnd_out_of_range, number_text(a), number_text(b));
  } else if (low > high) {
    wrong = message(messages::expression::rnd_no_whole_number, number_text(a), number_text(b));
  } else {
    out = static_cast<float>(random_integer(sources.seed, stream, sources.address, static_cast<std::int32_t>(low),
                                            static_cast<std::int32_t>(high)));
  }
}

// A normally distributed value from two uniform ones (Box and Muller).
float draw_normal(float mean, float deviation, const Sources& sources, std::uint64_t stream) {
  const float radius = random_unit(sources.seed, hash_combine(stream, 1), sources.address);
  const float angle = random_unit(sources.seed, hash_combine(stream, 2), sources.address);
  return mean + deviation * std::sqrt(-2 * logarithm(1 - radius)) * sincos_degrees(360 * angle).cosine;
}

// Queries the space; without a space every place is outside. Competing productions often repeat a query: the last
// response of reach() is cached.
float query_space(const Sources& sources, Op op) {
  const std::array<float, max_handed_over>& of = sources.handed_over;
  if (sources.space == nullptr) return 0;
  const glm::vec3 place(of[0], of[1], of[2]);
  if (op == Op::bound) return sources.space->bound(place, of[3]) ? 1.0f : 0.0f;
  if (!sources.reached || std::memcmp(&of, &sources.reached_for, sizeof of) != 0) {
    sources.reached = sources.space->reach(place, {of[3], of[4], of[5]}, of[6], of[7]);
    sources.reached_for = of;
  }
  return *sources.reached;
}

// Reads element `index` of the array `name` into `out`; indices count from 1. `wrong` describes the error where the
// index is not whole or outside the array.
void read_element(const std::string& name, const std::vector<float>& array, float index, float& out,
                  std::string& wrong) {
  const std::size_t size = array.size();
  const bool within = index >= 1 && index <= static_cast<float>(size) && std::floor(index) == index;
  const std::size_t place = within ? static_cast<std::size_t>(index) : 0;
  if (place >= 1 && place <= size) {
    out = array[place - 1];
    return;
  }
  wrong = size == 0 ? message(messages::expression::array_empty, name, number_text(index))
                    : message(messages::expression::array_index, name, number_text(index), size);
}

// Executes Op::element or Op::random_whole, which can fail. A function of its own, so that other instructions need no
// stack space for errors.
[[gnu::noinline]] bool execute_fallible(const Code& code, std::uint32_t at, float a, float b, float& out,
                                        const Sources& sources, Diagnostic& fault) {
  const Instruction& step = code.instructions[at];
  std::string wrong;
  if (step.op == Op::element) {
    read_element(code.arrays[step.c], sources.arrays[step.c], a, out, wrong);
  } else {
    draw_whole(a, b, sources, code.streams[step.c], out, wrong);
  }
  if (wrong.empty()) return true;
  fault = {Reason::evaluation, wrong, code.places[at].line, code.places[at].column};
  return false;
}

// Powers with whole exponents in double precision; all others in single.
double precise_power(double base, double exponent) {
  constexpr double most = 64;
  if (!(std::fabs(exponent) <= most && std::floor(exponent) == exponent))
    return power(static_cast<float>(base), static_cast<float>(exponent));
  double product = 1;
  for (int i = 0; i < std::fabs(exponent); ++i) product *= base;
  return exponent < 0 ? 1 / product : product;
}

// Computes a pure function in single precision.
float execute_pure(Op op, float a, float b) { return pure_functions[static_cast<std::size_t>(op) - first_pure](a, b); }
// The same in double precision. Functions that are not listed are computed in single precision.
double execute_pure(Op op, double a, double b) {
  switch (op) {
    case Op::remainder:
      return std::fmod(a, b);
    case Op::power:
      return precise_power(a, b);
    case Op::minimum:
      return b < a ? b : a;
    case Op::maximum:
      return b > a ? b : a;
    case Op::invert:
      return a == 0 ? 1 : 0;
    case Op::floor:
      return std::floor(a);
    case Op::ceiling:
      return std::ceil(a);
    case Op::nearest:
      return std::floor(a + 0.5);
    case Op::absolute:
      return std::fabs(a);
    case Op::square_root:
      return std::sqrt(a);
    default:
      return execute_pure(op, static_cast<float>(a), static_cast<float>(b));
  }
}

// Executes the instruction at `at`, one of those from Op::remainder on, for execute_one. Arguments other than those of
// pure functions are rounded to floats. Returns false if it fails; `fault` describes the error.
template <class Number>
bool execute_rare(const Code& code, std::uint32_t at, Number* registers, const Sources& sources, Diagnostic& fault) {
  const Instruction& step = code.instructions[at];
  const auto a = static_cast<float>(registers[step.a]);
  const auto b = static_cast<float>(registers[step.b]);
  Number& out = registers[step.out];
  switch (step.op) {
    case Op::element:
    case Op::random_whole: {
      float result = 0;
      if (!execute_fallible(code, at, a, b, result, sources, fault)) return false;
      out = result;
      return true;
    }
    case Op::curve:
      out = code.curves[step.c].at(a);
      return true;
    case Op::hand_over:
      sources.handed_over[step.c] = a;
      return true;
    case Op::bound:
    case Op::reach:
      out = query_space(sources, step.op);
      return true;
    case Op::random_real:
      out = a * random_unit(sources.seed, code.streams[step.c], sources.address);
      return true;
    case Op::random_normal:
      out = draw_normal(a, b, sources, code.streams[step.c]);
      return true;
    default:
      out = execute_pure(step.op, registers[step.a], registers[step.b]);
      return true;
  }
}

}  // namespace

// Executes one instruction that the main loop does not treat, on floats or doubles; false if it fails.
bool execute_one(const Code& code, std::uint32_t at, float* registers, const Sources& sources, Diagnostic& fault) {
  return execute_rare(code, at, registers, sources, fault);
}

bool execute_one(const Code& code, std::uint32_t at, double* registers, const Sources& sources, Diagnostic& fault) {
  return execute_rare(code, at, registers, sources, fault);
}

}  // namespace panicle::expression
