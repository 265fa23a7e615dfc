#include "foundation/message.hpp"

namespace panicle {

// Adds an argument of text; control characters become spaces.
void Message::add(std::string_view argument) {
  text_.back() = separator;
  for (const char byte : argument) {
    const auto code = static_cast<unsigned char>(byte);
    text_.push_back(code < 0x20 || code == 0x7f ? ' ' : byte);
  }
  text_.push_back(end);
}

// Adds an argument that is a message itself.
void Message::add(const Message& argument) {
  text_.back() = separator;
  text_.append(argument.text_).push_back(end);
}

}  // namespace panicle
