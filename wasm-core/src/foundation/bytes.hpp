// Memory use in bytes.
#pragma once

#include <cstdint>

namespace panicle {

// The bytes that a vector or a string has allocated.
template <class Values>
std::uint64_t bytes_of(const Values& values) {
  return values.capacity() * std::uint64_t{sizeof(typename Values::value_type)};
}

}  // namespace panicle
