#include "foundation/english.hpp"

#include <cstdlib>
#include <vector>

#include "foundation/english.generated.hpp"
#include "foundation/message.hpp"

namespace panicle {
namespace {

// The arguments of a message by name.
struct Arguments {
  std::vector<std::string_view> names;
  std::vector<std::string> values;

  // The value of an argument; "?" if there is none of that name.
  std::string_view value(std::string_view name) const {
    for (std::size_t i = 0; i < names.size() && i < values.size(); ++i)
      if (names[i] == name) return values[i];
    return "?";
  }
};

// The parts of a text between separators.
std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return parts;
}

// A reader of the syntax of ICU MessageFormat that the catalogues use.
class Formatter {
 public:
  Formatter(std::string_view text, const Arguments& arguments) : text_(text), arguments_(arguments) {}

  // Formats the text up to the next closing brace that has no opening one. `counted` replaces "#" inside a plural.
  std::string format(std::string_view counted = {}) {
    std::string out;
    while (at_ < text_.size() && text_[at_] != '}') {
      const char next = text_[at_++];
      if (next == '{') {
        out += argument();
      } else if (next == '#' && !counted.empty()) {
        out += counted;
      } else {
        out += next;
      }
    }
    return out;
  }

 private:
  // Reads a word, up to a comma, brace or space.
  std::string_view word() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',')) ++at_;
    const std::size_t from = at_;
    while (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '{' && text_[at_] != '}' && text_[at_] != ' ')
      ++at_;
    const std::string_view found = text_.substr(from, at_ - from);
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return found;
  }

  // Reads an argument in braces after the opening one, plain or a choice by number (plural) or by text (select), and
  // returns its text.
  std::string argument() {
    const std::string_view value = arguments_.value(word());
    if (text_[at_] != ',') {
      ++at_;
      return std::string(value);
    }
    const bool is_plural = word() == "plural";
    std::string exact, named, other;
    while (at_ < text_.size() && (text_[at_] != '}')) {
      const std::string_view label = word();
      if (label.empty()) break;
      ++at_;
      const std::string text = format(is_plural ? value : std::string_view());
      ++at_;
      while (at_ < text_.size() && text_[at_] == ' ') ++at_;
      if (label == "other") other = text;
      if (label.front() == '=' && label.substr(1) == value) exact = text;
      if (is_plural ? label == "one" && value == "1" : label == value) named = text;
    }
    ++at_;
    if (!exact.empty()) return exact;
    return named.empty() ? (other.empty() ? std::string(value) : other) : named;
  }

  std::string_view text_;
  const Arguments& arguments_;
  std::size_t at_ = 0;
};

// The English text of a message; its code if there is none.
std::string sentence(std::string_view code, Arguments arguments) {
  for (const EnglishMessage& each : english_messages) {
    if (code != each.code) continue;
    arguments.names = split(each.arguments, ' ');
    return Formatter(each.text, arguments).format();
  }
  return std::string(code);
}

// Reads the message that starts at `at`, behind its start; moves `at` behind its end.
std::string read_message(std::string_view text, std::size_t& at) {
  std::vector<std::string> parts(1);
  while (at < text.size()) {
    const char next = text[at++];
    if (next == Message::end) break;
    if (next == Message::separator) {
      parts.emplace_back();
    } else if (next == Message::start) {
      parts.back() += read_message(text, at);
    } else {
      parts.back() += next;
    }
  }
  const std::string code = parts.front();
  parts.erase(parts.begin());
  return sentence(code, {{}, parts});
}

}  // namespace

// A text in which all encoded messages are replaced by English ones.
std::string english(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const char next = text[at++];
    out += next == Message::start ? read_message(text, at) : std::string(1, next);
  }
  return out;
}

}  // namespace panicle
