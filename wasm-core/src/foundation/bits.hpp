// std::bit_cast, which Emscripten 3.1.6's library does not have yet though its compiler does.
#pragma once

namespace panicle {

// The value of type `To` with the same bits: std::bit_cast, which some compilers lack.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace panicle
