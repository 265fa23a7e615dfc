#include "models/bunch/natural/hanging.hpp"

#include <glm/geometric.hpp>

namespace panicle::bunch {

// The rachis is the main axis of the bunch.

namespace {

// How far a branch's end moves under a push, as a share of the push, for the full `bend`: little for the rachis, more
// for its axes.
float flexibility_of(Kind kind) {
  constexpr float rachis = 0.1f, axis = 0.7f, end = 0.8f;
  return kind == Kind::rachis ? rachis : kind == Kind::axis ? axis : end;
}

// Per internode, 1 if it belongs to a stalk: a chain of internodes of pedicels that leads to flowers and has no
// branching part.
std::vector<std::uint8_t> stalks_of(std::span<const Internode> internodes, std::span<const Flower> flowers) {
  std::vector<std::uint8_t> leads(internodes.size(), 0), stalk(internodes.size(), 0);
  for (const Flower& flower : flowers) leads[static_cast<std::size_t>(flower.parent)] = 1;
  for (std::size_t i = 0; i < internodes.size(); ++i) stalk[i] = internodes[i].kind == Kind::pedicel;
  for (std::size_t i = internodes.size(); i-- > 0;) {
    if (!leads[i]) {
      stalk[i] = 0;
      continue;
    }
    if (internodes[i].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(internodes[i].parent);
    leads[parent] = 1;
    if (!internodes[i].joint || !stalk[i]) stalk[parent] = 0;
  }
  return stalk;
}

}  // namespace

// Divides the internodes into branches, which bend, and stalks, which hang from them. `bending`, 0 … 1: how readily
// branches give way.
Hanging hang(std::span<const Internode> internodes, std::span<const Flower> flowers, float bending) {
  const std::vector<std::uint8_t> stalk = stalks_of(internodes, flowers);
  Hanging hanging;
  hanging.branch_of.assign(internodes.size(), -1);
  hanging.stalk_from.assign(internodes.size(), -1);
  for (std::size_t i = 0; i < internodes.size(); ++i) {
    const Internode& internode = internodes[i];
    const auto parent = static_cast<std::size_t>(internode.parent);
    const bool of_stem = internode.parent < 0 || hanging.branch_of[parent] >= 0;
    if (stalk[i]) {
      const bool goes_on = internode.joint && hanging.stalk_from[parent] >= 0;
      hanging.stalk_from[i] = goes_on ? hanging.stalk_from[parent] : static_cast<std::int32_t>(i);
    } else if (of_stem) {
      hanging.branch_of[i] = static_cast<std::int32_t>(hanging.branches.size());
      const std::int32_t above = internode.parent < 0 ? -1 : hanging.branch_of[parent];
      hanging.branches.push_back({internode.start, internode.end, above, internode.radius,
                                  flexibility_of(internode.kind) * bending, internode.kind != Kind::rachis});
    }
  }
  return hanging;
}

// Makes a berry, ready to swell, of each fruitlet, on the branch from which its stalk grows. A stalk on no branch gets
// a branch of length 0, added to `branches`.
std::vector<Swelling> hang_berries(std::span<const Fruitlet> fruitlets, std::span<const Internode> internodes,
                                   std::span<const Flower> flowers, const Hanging& hanging,
                                   std::vector<Branch>& branches) {
  std::vector<Swelling> berries;
  berries.reserve(fruitlets.size());
  for (const Fruitlet& fruitlet : fruitlets) {
    const Flower& flower = flowers[fruitlet.flower];
    const auto parent = static_cast<std::size_t>(flower.parent);
    const std::int32_t from = hanging.stalk_from[parent];
    Swelling berry;
    if (from < 0) {  // sits on a stem
      berry.branch = static_cast<std::uint32_t>(hanging.branch_of[parent]);
    } else {
      const Internode& first = internodes[static_cast<std::size_t>(from)];
      berry.stalk = glm::length(internodes[parent].end - first.start);
      const std::int32_t stem = first.parent < 0 ? -1 : hanging.branch_of[static_cast<std::size_t>(first.parent)];
      berry.branch = static_cast<std::uint32_t>(stem < 0 ? static_cast<std::int32_t>(branches.size()) : stem);
      if (stem < 0) branches.push_back({first.start, first.start, -1, 0, 0, false});
    }
    berry.heading = flower.heading;
    berry.half_width = fruitlet.half_width;
    berry.half_length = fruitlet.half_length;
    berry.bunch = flower.bunch;
    berry.taken = fruitlet.taken;
    berries.push_back(berry);
  }
  return berries;
}

}  // namespace panicle::bunch
