#include "expression/names.hpp"

#include "foundation/random.hpp"

namespace panicle::expression {

// The number of a name, which is added if it is new. Names are numbered in the order of adding.
std::uint32_t Names::add(std::string_view name) {
  if (2 * ends_.size() >= slots_.size()) grow();
  std::uint32_t& number = slots_[slot_of(name)];
  if (number == none) {
    number = size();
    bytes_.append(name);
    ends_.push_back(static_cast<std::uint32_t>(bytes_.size()));
  }
  return number;
}

// The number of a name; `none` if it was not added.
std::uint32_t Names::find(std::string_view name) const { return slots_.empty() ? none : slots_[slot_of(name)]; }

// The slot of a name in the hash table, or the free one where it belongs (linear probing).
std::size_t Names::slot_of(std::string_view name) const {
  const std::size_t last = slots_.size() - 1;
  std::size_t slot = hash_text(name) & last;
  while (slots_[slot] != none && this->name(slots_[slot]) != name) slot = (slot + 1) & last;
  return slot;
}

// The name of a number.
std::string_view Names::name(std::uint32_t number) const {
  const std::uint32_t begin = number == 0 ? 0 : ends_[number - 1];
  return std::string_view(bytes_).substr(begin, ends_[number] - begin);
}

// Doubles the hash table.
void Names::grow() {
  slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), none);
  for (std::uint32_t number = 0; number < size(); ++number) slots_[slot_of(name(number))] = number;
}

}  // namespace panicle::expression
