#include "models/flower/text.hpp"

#include "expression/diagnostics.hpp"
#include "models/flower/messages.generated.hpp"

namespace panicle::flower {
namespace {

// Whether a byte of UTF-8 begins a character.
bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }

}  // namespace

// Replaces comments between two @ by spaces, so that lines and columns stay the same, and the _ between ] and the faces
// of a growth. An error if a comment is never closed.
Result<std::string> without_comments(std::string_view text) {
  std::string cleaned;
  cleaned.reserve(text.size());
  expression::SourceLocation place{1, 1}, opened;
  bool comment = false, bracket = false, other_comment = false;
  char before = 0;
  for (const char c : text) {
    if (!comment && before == '/' && c == '*') other_comment = true;
    if (other_comment && before == '*' && c == '/') other_comment = false;
    before = c;
    if (c == '@' && !other_comment) {
      comment = !comment;
      opened = place;
      cleaned += ' ';
    } else if (comment && c != '\n' && c != '\r') {
      if (begins_character(c)) cleaned += ' ';
    } else {
      const bool of_bracket = c == '_' && bracket;
      cleaned += of_bracket ? ' ' : c;
      bracket = c == ']' || (bracket && (c == ' ' || c == '\t' || c == '\r' || c == '\n'));
    }
    if (c == '\n') {
      ++place.line;
      place.column = 1;
    } else if (begins_character(c)) {
      ++place.column;
    }
  }
  if (comment) return expression::error_at(Reason::syntax, opened, message(messages::flower::comment_never_closed));
  return cleaned;
}

}  // namespace panicle::flower
