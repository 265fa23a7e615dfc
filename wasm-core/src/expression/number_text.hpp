// Numbers as text and back, without the C library's locale and its long doubles (which would double the .wasm).
#pragma once

#include <string>
#include <string_view>

namespace panicle::expression {

// The float nearest to a decimal such as `12`, `.5`, `1.5e-3` (digits, point, exponent; no sign). ∞ when it is too
// large.
float number_from(std::string_view decimal);
// The same as a double: the nearest where the decimal has at most 15 digits and an exponent within 22.
double double_from(std::string_view decimal);

// The fewest digits that number_from turns back into `value`.
std::string number_text(float value);

}  // namespace panicle::expression
