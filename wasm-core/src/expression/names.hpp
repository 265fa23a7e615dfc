// Names → dense numbers, which index vectors.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace panicle::expression {

// One hash table with open addressing, for all parts of the front end: the cost is linear in the text for every input.
// Names are any bytes and are copied.
class Names {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  // Returns the name's number; a new name gets the next number.
  std::uint32_t add(std::string_view name);
  // `none` for a name that was never added.
  std::uint32_t find(std::string_view name) const;
  std::uint32_t size() const { return static_cast<std::uint32_t>(ends_.size()); }

 private:
  // The slot that holds the name, or the free one where it belongs.
  std::size_t slot_of(std::string_view name) const;
  std::string_view name(std::uint32_t number) const;
  void grow();

  std::string bytes_;                 // of all names
  std::vector<std::uint32_t> ends_;   // of each among the bytes
  std::vector<std::uint32_t> slots_;  // numbers or `none`; a power of two, at most half of them taken
};

}  // namespace panicle::expression
