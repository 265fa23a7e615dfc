// Ids of berries that stay the same while handles move.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace panicle::bunch {

// Makes a unique address for every berry from the addresses of the modules that draw them, in the order of the text:
// berries of one module share its address, and the second and later ones get addresses of their own.
std::vector<std::uint64_t> own_addresses(std::span<const std::uint64_t> module_addresses);

// Makes the ids of berries: below 2^30, so that links hold one in six letters; those from `second_from` on are of the
// second bunch, whose addresses repeat the first's. An id that an earlier berry has is drawn anew.
std::vector<std::uint32_t> berry_ids(std::span<const std::uint64_t> addresses, std::size_t second_from);

}  // namespace panicle::bunch
