// A value, or the reason why there is none. The core has no exceptions: every failure travels as one of these.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace panicle {

// The reasons, by name. Numbers cross the border (boundary/panicle.h): they are only ever added to.
enum class Reason : std::uint32_t {
  none = 0,
  bad_request = 1,  // the bytes of the request are not in the agreed form
  bad_input = 2,    // a value that the grammar or the model cannot use
  syntax = 3,       // the grammar's text cannot be read
  undefined = 4,    // the grammar uses a name that nothing defines
  evaluation = 5,   // an expression went wrong while the grammar ran (index out of range, not a number)
  limit = 6,        // a work limit was reached (foundation/limits.hpp)
};

// What went wrong and where. Line and column count from 1 and are 0 where no text is concerned.
struct Diagnostic {
  Reason reason = Reason::none;
  std::string message;  // one plain sentence that says what to do
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

template <class Value>
class Result {
 public:
  Result(Value value) : state_(std::move(value)) {}
  Result(Diagnostic diagnostic) : state_(std::move(diagnostic)) {}

  explicit operator bool() const { return state_.index() == 0; }
  Value& value() { return *std::get_if<0>(&state_); }
  const Value& value() const { return *std::get_if<0>(&state_); }
  Value* operator->() { return std::get_if<0>(&state_); }
  const Value* operator->() const { return std::get_if<0>(&state_); }
  const Diagnostic& error() const { return *std::get_if<1>(&state_); }

 private:
  std::variant<Value, Diagnostic> state_;
};

}  // namespace panicle
