#include "lsystem/derivation/string_text.hpp"

#include "expression/number_text.hpp"

namespace panicle::lsystem {
namespace {

// Whether a byte may be part of a name; those of non-ASCII letters may.
bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || (c & 0x80) != 0;
}

}  // namespace

// A module as text, such as `F(1,2)`.
std::string module_text(const Program& program, const std::uint32_t* module) {
  std::string text = program.symbols[symbol_of(*module)];
  const std::uint32_t count = parameters_of(*module);
  for (std::uint32_t i = 0; i < count; ++i) {
    float value = 0;
    std::memcpy(&value, module + 1 + i, sizeof value);
    text += i == 0 ? '(' : ',';
    text += number_text(value);
  }
  if (count > 0) text += ')';
  return text;
}

// A string as text; spaces separate modules that would otherwise be read as one.
std::string to_text(const Program& program, const String& string) {
  std::string text;
  for (const std::uint32_t* module = string.begin(); module < string.end(); module += words_of(*module)) {
    const std::string& name = program.symbols[symbol_of(*module)];
    const bool one_word = !text.empty() && is_letter_or_digit(text.back()) && is_letter_or_digit(name[0]);
    const bool arrow = !text.empty() && text.back() == '-' && name == ">";
    if (one_word || arrow) text += ' ';
    text += module_text(program, module);
  }
  return text;
}

}  // namespace panicle::lsystem
