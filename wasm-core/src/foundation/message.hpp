// Messages as codes with arguments. The core holds no sentences: a message is a code ("growth.no_rules") and its
// arguments in one string, and the page puts the sentence together from the catalogue of its room
// (messages.json), in the user's language. Codes come from the rooms' messages.generated.hpp, so that a wrong code does
// not compile.
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace panicle {

// The code of a message and the number of its arguments.
template <std::size_t argument_count>
struct MessageCode {
  const char* code;
};

// A message in the form in which it crosses the boundary: start, code, each argument behind a separator, end. Converts
// to a string where an error or a note takes it; as an argument of another message it stays a message.
class Message {
 public:
  static constexpr char start = '\x02';
  static constexpr char separator = '\x1f';
  static constexpr char end = '\x03';

  // A message of that code, without arguments yet.
  explicit Message(const char* code) : text_(1, start) { text_.append(code).push_back(end); }

  operator const std::string&() const { return text_; }
  // The code and the arguments as one text with control characters between them.
  const std::string& encoded() const { return text_; }

  // Adds an argument. Control characters of texts, which would end the argument or the line, become spaces.
  void add(std::string_view argument);
  void add(const char* argument) { add(std::string_view(argument)); }
  void add(const Message& argument);
  void add(std::integral auto argument) { add(std::string_view(std::to_string(argument))); }

 private:
  std::string text_;
};

// Makes a message: `message(messages::growth::too_many_plants, count, limit)`. Arguments are texts, whole numbers and
// other messages, in the order in which the English text first uses them; write fractions with number_text.
template <std::size_t count, class... Arguments>
Message message(const MessageCode<count>& code, const Arguments&... arguments) {
  static_assert(sizeof...(Arguments) == count, "a message needs as many arguments as its text uses");
  Message made(code.code);
  (made.add(arguments), ...);
  return made;
}

// Whether an encoded text begins with a message of this code.
template <std::size_t count>
bool is_message(std::string_view text, const MessageCode<count>& code) {
  const std::string_view name = code.code;
  if (text.size() < name.size() + 2 || text.front() != Message::start || text.substr(1, name.size()) != name)
    return false;
  const char next = text[name.size() + 1];
  return next == Message::separator || next == Message::end;
}

}  // namespace panicle
