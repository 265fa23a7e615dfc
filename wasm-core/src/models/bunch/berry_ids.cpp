#include "models/bunch/berry_ids.hpp"

#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

constexpr int bits_dropped = 34;  // of an address's 64

// The id of an address, its topmost 30 bits.
std::uint32_t id_of(std::uint64_t address) { return static_cast<std::uint32_t>(address >> bits_dropped); }

// The set of ids in use, in a hash table that is at least twice as large.
class IdSet {
 public:
  // A table for so many ids; its size is a power of two.
  explicit IdSet(std::size_t ids) {
    std::size_t size = 16;
    while (size < 2 * ids) size *= 2;
    slots_.assign(size, free_slot);
  }

  // Returns false if the id is in use.
  bool insert(std::uint32_t id) {
    std::size_t slot = id & (slots_.size() - 1);
    for (; slots_[slot] != free_slot; slot = (slot + 1) & (slots_.size() - 1))
      if (slots_[slot] == id) return false;
    slots_[slot] = id;
    return true;
  }

 private:
  static constexpr std::uint32_t free_slot = 0xffffffff;  // ids are below 2^30
  std::vector<std::uint32_t> slots_;
};

}  // namespace

// An address for each ball: that of the module that drew it, and a different one for each further ball of one module.
std::vector<std::uint64_t> own_addresses(std::span<const std::uint64_t> module_addresses) {
  std::vector<std::uint64_t> own;
  own.reserve(module_addresses.size());
  std::uint64_t repeats = 0;
  for (std::size_t i = 0; i < module_addresses.size(); ++i) {
    repeats = i > 0 && module_addresses[i] == module_addresses[i - 1] ? repeats + 1 : 0;
    own.push_back(repeats == 0 ? module_addresses[i] : hash_combine(module_addresses[i], repeats));
  }
  return own;
}

// An id, unique in the plant, for each ball's address; those from the index `second_from` on are of the second bunch.
std::vector<std::uint32_t> berry_ids(std::span<const std::uint64_t> addresses, std::size_t second_from) {
  std::vector<std::uint32_t> ids;
  ids.reserve(addresses.size());
  IdSet used_ids(addresses.size());
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    std::uint64_t address = i < second_from ? addresses[i] : hash_combine(addresses[i], 2);
    while (!used_ids.insert(id_of(address))) address = hash_combine(address, 1);
    ids.push_back(id_of(address));
  }
  return ids;
}

}  // namespace panicle::bunch
