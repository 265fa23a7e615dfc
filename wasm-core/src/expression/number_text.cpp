#include "expression/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace panicle::expression {
namespace {

// Multiplies by a power of ten. Powers up to 10^22 are doubles without error, so most numbers are rounded once to
// double and once to float.
double times_power_of_ten(double value, int exponent) {
  static constexpr double exact[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  for (; exponent > 22; exponent -= 22) value *= exact[22];
  for (; exponent < -22; exponent += 22) value /= exact[22];
  return exponent < 0 ? value / exact[-exponent] : value * exact[exponent];
}

bool is_digit(char character) { return character >= '0' && character <= '9'; }

// Writes decimal digits with a point after the first `whole` of them, or with an exponent if that is shorter.
std::string with_point(std::string digits, int whole) {
  const int count = static_cast<int>(digits.size());
  if (whole > 9 || whole < -4) {
    if (count > 1) digits.insert(digits.begin() + 1, '.');
    return digits.append("e").append(std::to_string(whole - 1));
  }
  if (whole <= 0) return std::string("0.").append(-whole, '0').append(digits);
  return whole >= count ? digits.append(whole - count, '0') : digits.substr(0, whole).append(".").append(digits, whole);
}

}  // namespace

// The double of a decimal number such as 12.5e-3.
double double_from(std::string_view decimal) {
  constexpr std::uint64_t most = 100'000'000'000'000'000;  // digits beyond 18 cannot change a float
  std::uint64_t digits = 0;
  int exponent = 0;
  bool point = false;
  std::size_t i = 0;
  for (; i < decimal.size() && (is_digit(decimal[i]) || decimal[i] == '.'); ++i) {
    if (decimal[i] == '.') {
      point = true;
    } else if (digits < most) {
      digits = digits * 10 + (decimal[i] - '0');
      exponent -= point;
    } else {
      exponent += !point;
    }
  }
  if (i < decimal.size()) {
    const bool negative = decimal[++i] == '-';
    if (negative || decimal[i] == '+') ++i;
    int written = 0;
    for (; i < decimal.size(); ++i) written = std::min(written * 10 + (decimal[i] - '0'), 1'000'000);
    exponent += negative ? -written : written;
  }
  if (digits == 0) return 0;
  return times_power_of_ten(static_cast<double>(digits), std::clamp(exponent, -400, 400));
}

// The float nearest to a decimal number.
float number_from(std::string_view decimal) { return static_cast<float>(double_from(decimal)); }

// The shortest decimal that is read as the same float.
std::string number_text(float value) {
  if (std::isnan(value)) return "NaN";
  if (std::signbit(value)) return std::string("-").append(number_text(-value));
  if (std::isinf(value)) return "∞";
  if (value == 0) return "0";
  int whole = 0;  // value < 10^whole
  while (times_power_of_ten(1, whole) <= value) ++whole;
  while (times_power_of_ten(1, whole - 1) > value) --whole;
  std::string text;
  for (int count = 1; count <= 9; ++count) {
    const double scaled = times_power_of_ten(value, count - whole);
    std::string digits = std::to_string(static_cast<std::uint64_t>(scaled + 0.5));
    const int carried = static_cast<int>(digits.size()) - count;  // 99.7 in two digits is 100
    while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
    text = with_point(digits, whole + carried);
    if (number_from(text) == value) break;
  }
  return text;
}

}  // namespace panicle::expression
