// Derived strings in memory: 32-bit words, one header per module, then its parameters in single precision, then (where
// the program keeps lineages) three words of lineage: the address in two, and the symbols of parent and grandparent in
// one; then, where the text calculates in double precision, the parameters once more as doubles, two words each.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace panicle::lsystem {

// Header: symbol in bits 0–15, number of parameters in 16–22, whether they are doubles as well in 23, words of the
// whole module in 24–31.
constexpr std::uint32_t header_of(std::uint32_t symbol, std::uint32_t parameters, std::uint32_t words, bool doubles) {
  return symbol | parameters << 16 | (doubles ? 1u << 23 : 0u) | words << 24;
}
// The parts of a module's header: symbol, number of parameters, whether some are doubles, and its length in words.
constexpr std::uint32_t symbol_of(std::uint32_t header) { return header & 0xffff; }
constexpr std::uint32_t parameters_of(std::uint32_t header) { return header >> 16 & 0x7f; }
constexpr bool has_doubles(std::uint32_t header) { return (header >> 23 & 1) != 0; }
// Words of the doubles at a module's end.
constexpr std::uint32_t double_words(std::uint32_t header) {
  return has_doubles(header) ? 2 * parameters_of(header) : 0;
}

constexpr std::uint32_t words_of(std::uint32_t header) { return header >> 24; }

inline constexpr std::uint32_t lineage_words = 3;
inline constexpr std::uint32_t no_symbol = 0xffff;  // the parent of the axiom's modules

// The lineage of a module, as strings store it.
struct Origin {
  std::uint64_t address = 0;
  std::uint32_t ancestors = no_symbol << 16 | no_symbol;  // parent | grandparent << 16
};

// Whether the module's words end with its lineage: address and ancestors.
inline bool has_lineage(std::uint32_t header) {
  return words_of(header) > 1 + parameters_of(header) + double_words(header);
}

// Where the doubles of a module begin that has some.
inline const std::uint32_t* doubles_of(const std::uint32_t* module) {
  return module + words_of(*module) - double_words(*module);
}

// Writes a parameter, in both precisions where the module has both.
inline void set_parameter(std::uint32_t* module, std::uint32_t index, float value) {
  std::memcpy(module + 1 + index, &value, sizeof value);
  if (!has_doubles(*module)) return;
  const double precise = value;
  std::memcpy(module + words_of(*module) - double_words(*module) + 2 * index, &precise, sizeof precise);
}

// The address and ancestors of a module with a lineage.
inline Origin origin_of(const std::uint32_t* module) {
  Origin origin;
  const std::uint32_t* const lineage = module + 1 + parameters_of(*module);
  std::memcpy(&origin.address, lineage, sizeof origin.address);
  origin.ancestors = lineage[2];
  return origin;
}

// Copies are made in blocks of four words and may run up to three words over: sources and destinations need that much
// room behind them.
inline constexpr std::uint32_t block = 4;

// Copies words, in blocks if they are few: up to a block more than `count` is read and written.
inline void copy_words(std::uint32_t* to, const std::uint32_t* from, std::size_t count) {
  if (count > 64) {
    std::memcpy(to, from, count * sizeof *to);
    return;
  }
  for (std::size_t i = 0; i < count; i += block) std::memcpy(to + i, from + i, block * sizeof *to);
}

// A buffer that returns false when memory is out, where a vector would abort. New words are not initialised.
class Words {
 public:
  Words() = default;
  Words(Words&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), capacity_(std::exchange(other.capacity_, 0)) {}
  Words& operator=(Words&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~Words() { std::free(data_); }

  // Room for `words`, at least doubling but not beyond `most`, so that growing costs in proportion. False: no memory.
  bool reserve(std::uint64_t words, std::uint64_t most) {
    if (words <= capacity_) return true;
    std::uint64_t capacity = words > 2 * capacity_ ? words : 2 * capacity_;
    if (capacity < 1024) capacity = 1024;
    if (capacity > most && words <= most) capacity = most;
    const std::uint64_t bytes = (capacity + block) * sizeof *data_;
    if (bytes > SIZE_MAX / 2) return false;
    void* const data = std::realloc(data_, static_cast<std::size_t>(bytes));
    if (data == nullptr) return false;
    data_ = static_cast<std::uint32_t*>(data);
    capacity_ = capacity;
    return true;
  }

  // Reserves `words`, and half as many more but not beyond `most`, if memory allows. The content is lost: cheaper than
  // `reserve`, which may have to move it. A string that grows a little each step does not allocate in each.
  void empty_for(std::uint64_t words, std::uint64_t most) {
    if (words <= capacity_) return;
    std::free(data_);
    data_ = nullptr;
    capacity_ = 0;
    const std::uint64_t ample = words + words / 2 < most ? words + words / 2 : most;
    reserve(ample > words ? ample : words, words);
  }

  std::uint32_t* data() { return data_; }
  const std::uint32_t* data() const { return data_; }
  std::uint64_t capacity() const { return capacity_; }

 private:
  std::uint32_t* data_ = nullptr;
  std::uint64_t capacity_ = 0;
};

class String {
 public:
  const std::uint32_t* begin() const { return words.data(); }
  const std::uint32_t* end() const { return words.data() + used; }

  Words words;
  std::uint64_t used = 0;  // of them
  std::uint64_t modules = 0;
};

}  // namespace panicle::lsystem
