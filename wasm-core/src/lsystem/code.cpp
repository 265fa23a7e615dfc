#include "lsystem/code.hpp"

#include <algorithm>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "lsystem/number_text.hpp"

namespace panicle::lsystem {
namespace {

constexpr float degrees = 180 / pi;

float tangent(float angle) {
  const auto [sine, cosine] = sincos_degrees(angle);
  return sine / cosine;
}

// Every whole number from a to b, whichever is larger, equally likely.
bool draw_whole(float a, float b, const Draw& draw, std::uint64_t stream, float& out, std::string& wrong) {
  const float low = std::ceil(std::min(a, b));
  const float high = std::floor(std::max(a, b));
  if (!(std::fabs(low) <= 1e9f && std::fabs(high) <= 1e9f) || std::isnan(a) || std::isnan(b)) {
    wrong = joined({"RND needs two numbers from -1e9 to 1e9, not ", number_text(a), " and ", number_text(b), "."});
    return false;
  }
  if (low > high) {
    wrong = joined({"There is no whole number from ", number_text(a), " to ", number_text(b), " for RND to draw."});
    return false;
  }
  out = static_cast<float>(
      random_integer(draw.seed, stream, draw.address, static_cast<std::int32_t>(low), static_cast<std::int32_t>(high)));
  return true;
}

// Box and Muller's way from two uniform values to a normal one.
float draw_normal(float mean, float deviation, const Draw& draw, std::uint64_t stream) {
  const float radius = random_unit(draw.seed, hash_combine(stream, 1), draw.address);
  const float angle = random_unit(draw.seed, hash_combine(stream, 2), draw.address);
  return mean + deviation * std::sqrt(-2 * logarithm(1 - radius)) * sincos_degrees(360 * angle).cosine;
}

bool read_element(const Code::Array& array, float index, float& out, std::string& wrong) {
  const std::size_t size = array.values.size();
  if (index >= 1 && index <= static_cast<float>(size) && std::floor(index) == index) {
    const std::size_t place = static_cast<std::size_t>(index);
    if (place <= size) {
      out = array.values[place - 1];
      return true;
    }
  }
  wrong = joined({"There is no ", array.name, "[", number_text(index), "]; ", array.name});
  wrong += size == 0 ? " has no values." : joined({" goes from 1 to ", std::to_string(size), "."});
  return false;
}

}  // namespace

bool execute_one(const Code& code, std::uint32_t at, float* registers, const Draw& draw, Diagnostic& fault) {
  const Instruction& step = code.instructions[at];
  const float a = registers[step.a];
  const float b = registers[step.b];
  float& out = registers[step.out];
  std::string wrong;
  bool fine = true;
  switch (step.op) {
    case Op::remainder:
      out = std::fmod(a, b);
      break;
    case Op::power:
      out = power(a, b);
      break;
    case Op::minimum:
      out = b < a ? b : a;
      break;
    case Op::maximum:
      out = b > a ? b : a;
      break;
    case Op::clamp: {
      const float high = registers[step.c];
      const float raised = a < b ? b : a;
      out = raised > high ? high : raised;
      break;
    }
    case Op::invert:
      out = a == 0;
      break;
    case Op::floor:
      out = std::floor(a);
      break;
    case Op::ceiling:
      out = std::ceil(a);
      break;
    case Op::nearest:
      out = static_cast<float>(std::floor(static_cast<double>(a) + 0.5));
      break;
    case Op::absolute:
      out = std::fabs(a);
      break;
    case Op::square_root:
      out = std::sqrt(a);
      break;
    case Op::sine:
      out = sincos_degrees(a).sine;
      break;
    case Op::cosine:
      out = sincos_degrees(a).cosine;
      break;
    case Op::tangent:
      out = tangent(a);
      break;
    case Op::arc_sine:
      out = arc_sine(a) * degrees;
      break;
    case Op::arc_cosine:
      out = arc_cosine(a) * degrees;
      break;
    case Op::arc_tangent:
      out = arc_tangent(a, 1) * degrees;
      break;
    case Op::arc_tangent_of:
      out = arc_tangent(a, b) * degrees;
      break;
    case Op::exponential:
      out = exponential(a);
      break;
    case Op::logarithm:
      out = logarithm(a);
      break;
    case Op::element:
      fine = read_element(code.arrays[step.c], a, out, wrong);
      break;
    case Op::random_whole:
      fine = draw_whole(a, b, draw, code.streams[step.c], out, wrong);
      break;
    case Op::random_real:
      out = a * random_unit(draw.seed, code.streams[step.c], draw.address);
      break;
    case Op::random_normal:
      out = draw_normal(a, b, draw, code.streams[step.c]);
      break;
    default:
      return execute(code, at, at + 1, registers, draw, fault);
  }
  if (!fine) fault = error_at(Reason::evaluation, code.places[at], {wrong});
  return fine;
}

}  // namespace panicle::lsystem
