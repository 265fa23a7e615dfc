#include "lsystem/code.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "lsystem/number_text.hpp"

namespace panicle::lsystem {
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

// Every whole number from a to b, whichever is larger, equally likely. `wrong` says why there is none.
void draw_whole(float a, float b, const Sources& sources, std::uint64_t stream, float& out, std::string& wrong) {
  const float low = std::ceil(std::min(a, b));
  const float high = std::floor(std::max(a, b));
  if (!(std::fabs(low) <= 1e9f && std::fabs(high) <= 1e9f) || std::isnan(a) || std::isnan(b)) {
    wrong = sentence("RND needs two numbers from -1e9 to 1e9, not % and %.", {number_text(a), number_text(b)});
  } else if (low > high) {
    wrong = sentence("There is no whole number from % to % for RND to draw.", {number_text(a), number_text(b)});
  } else {
    out = static_cast<float>(random_integer(sources.seed, stream, sources.address, static_cast<std::int32_t>(low),
                                            static_cast<std::int32_t>(high)));
  }
}

// Box and Muller's way from two uniform values to a normal one.
float draw_normal(float mean, float deviation, const Sources& sources, std::uint64_t stream) {
  const float radius = random_unit(sources.seed, hash_combine(stream, 1), sources.address);
  const float angle = random_unit(sources.seed, hash_combine(stream, 2), sources.address);
  return mean + deviation * std::sqrt(-2 * logarithm(1 - radius)) * sincos_degrees(360 * angle).cosine;
}

// Without a space everything is outside. Productions that compete ask the same, one after the other: the last answer of
// reach() is kept.
float ask(const Sources& sources, Op op) {
  const std::array<float, most_handed_over>& of = sources.handed_over;
  if (sources.space == nullptr) return 0;
  const glm::vec3 place(of[0], of[1], of[2]);
  if (op == Op::bound) return sources.space->bound(place, of[3]) ? 1.0f : 0.0f;
  if (!sources.reached || std::memcmp(&of, &sources.reached_for, sizeof of) != 0) {
    sources.reached = sources.space->reach(place, {of[3], of[4], of[5]}, of[6], of[7]);
    sources.reached_for = of;
  }
  return *sources.reached;
}

void read_element(const std::string& name, const std::vector<float>& array, float index, float& out,
                  std::string& wrong) {
  const std::size_t size = array.size();
  const bool within = index >= 1 && index <= static_cast<float>(size) && std::floor(index) == index;
  const std::size_t place = within ? static_cast<std::size_t>(index) : 0;
  if (place >= 1 && place <= size) {
    out = array[place - 1];
    return;
  }
  wrong = sentence("There is no %[%]; %", {name, number_text(index), name});
  wrong += size == 0 ? " has no values." : sentence(" goes from 1 to %.", {std::to_string(size)});
}

// What can go wrong, apart from the rest: that would make room for what went wrong as well.
[[gnu::noinline]] bool execute_fallible(const Code& code, std::uint32_t at, float* registers, const Sources& sources,
                                        Diagnostic& fault) {
  const Instruction& step = code.instructions[at];
  const float a = registers[step.a];
  float& out = registers[step.out];
  std::string wrong;
  if (step.op == Op::element) {
    read_element(code.arrays[step.c], sources.arrays[step.c], a, out, wrong);
  } else {
    draw_whole(a, registers[step.b], sources, code.streams[step.c], out, wrong);
  }
  if (wrong.empty()) return true;
  fault = error_at(Reason::evaluation, code.places[at], "%", {wrong});
  return false;
}

}  // namespace

bool execute_one(const Code& code, std::uint32_t at, float* registers, const Sources& sources, Diagnostic& fault) {
  const Instruction& step = code.instructions[at];
  const float a = registers[step.a];
  const float b = registers[step.b];
  float& out = registers[step.out];
  switch (step.op) {
    case Op::element:
    case Op::random_whole:
      return execute_fallible(code, at, registers, sources, fault);
    case Op::curve:
      out = code.curves[step.c].at(a);
      return true;
    case Op::hand_over:
      sources.handed_over[step.c] = a;
      return true;
    case Op::bound:
    case Op::reach:
      out = ask(sources, step.op);
      return true;
    case Op::random_real:
      out = a * random_unit(sources.seed, code.streams[step.c], sources.address);
      return true;
    case Op::random_normal:
      out = draw_normal(a, b, sources, code.streams[step.c]);
      return true;
    default:
      out = pure_functions[static_cast<std::size_t>(step.op) - first_pure](a, b);
      return true;
  }
}

}  // namespace panicle::lsystem
