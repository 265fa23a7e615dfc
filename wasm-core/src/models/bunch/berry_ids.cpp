#include "models/bunch/berry_ids.hpp"

#include <unordered_set>

#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

constexpr int bits_dropped = 34;  // of an address's 64

std::uint32_t id_of(std::uint64_t address) { return static_cast<std::uint32_t>(address >> bits_dropped); }

}  // namespace

std::vector<std::uint64_t> own_addresses(std::span<const std::uint64_t> bearers) {
  std::vector<std::uint64_t> own;
  own.reserve(bearers.size());
  std::uint64_t borne = 0;
  for (std::size_t i = 0; i < bearers.size(); ++i) {
    borne = i > 0 && bearers[i] == bearers[i - 1] ? borne + 1 : 0;
    own.push_back(borne == 0 ? bearers[i] : hash_combine(bearers[i], borne));
  }
  return own;
}

std::vector<std::uint32_t> berry_ids(std::span<const std::uint64_t> addresses, std::size_t second_from) {
  std::vector<std::uint32_t> ids;
  ids.reserve(addresses.size());
  std::unordered_set<std::uint32_t> taken;
  taken.reserve(addresses.size());
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    std::uint64_t address = i < second_from ? addresses[i] : hash_combine(addresses[i], 2);
    while (!taken.insert(id_of(address)).second) address = hash_combine(address, 1);
    ids.push_back(id_of(address));
  }
  return ids;
}

}  // namespace panicle::bunch
