// What is held, counted in bytes.
#pragma once

#include <cstdint>

namespace panicle {

// What a vector or a string has taken.
template <class Values>
std::uint64_t bytes_of(const Values& values) {
  return values.capacity() * std::uint64_t{sizeof(typename Values::value_type)};
}

}  // namespace panicle
