// A value or an error. The core has no exceptions: functions return errors as values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace panicle {

// Reasons of errors. The numbers cross the boundary (exports/panicle.h): existing ones never change.
enum class Reason : std::uint32_t {
  none = 0,
  bad_request = 1,  // the bytes of the request are not in the agreed form
  bad_input = 2,    // a value that the grammar or the model cannot use
  syntax = 3,       // the grammar's text cannot be read
  undefined = 4,    // the grammar uses a name that nothing defines
  evaluation = 5,   // an expression went wrong while the grammar ran (index out of range, not a number)
  limit = 6,        // a work limit was reached (foundation/limits.hpp)
};

// An error and its place. Line and column count from 1 and are 0 for errors that concern no text.
struct Diagnostic {
  Reason reason = Reason::none;
  std::string message;  // one plain sentence with advice
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

// Errors of a request that concern no text.
inline Diagnostic bad_request(std::string message) { return {Reason::bad_request, std::move(message), 0, 0}; }
// The error for wrong input, without a place in a text.
inline Diagnostic bad_input(std::string message) { return {Reason::bad_input, std::move(message), 0, 0}; }

template <class Value>
class Result {
 public:
  // A result is a value or an error; `value` must only be called where there is one.
  Result(Value value) : value_(std::move(value)) {}
  Result(Diagnostic diagnostic) : error_(std::move(diagnostic)) {}

  explicit operator bool() const { return value_.has_value(); }
  Value& value() { return *value_; }
  const Value& value() const { return *value_; }
  Value* operator->() { return &*value_; }
  const Value* operator->() const { return &*value_; }
  const Diagnostic& error() const { return error_; }

 private:
  std::optional<Value> value_;
  Diagnostic error_;  // where there is no value
};

}  // namespace panicle
