#include "models/bunch/natural/peduncle.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::bunch {

// The peduncle is the stalk of the bunch.

namespace {

constexpr float shortest = 0.001f;                   // metres above p1, below which no peduncle is drawn
constexpr float least_bow = 0.04f, max_bow = 0.14f;  // sideways offset of its upper end, over its length
constexpr float least_node = 0.4f, max_node = 0.6f;  // height of its node, over its length from p1
constexpr float half_node = 0.0022f;                 // metres

constexpr float slim = 0.0013f;         // metres: radius from which a rachis is thick enough
constexpr std::int32_t node_piece = 2;  // the piece that ends at the node
constexpr float kink = 0.0006f;         // metres: offset of the node from the peduncle's line

// Heights over its length, from the upper end, and widths over the rachis's.
struct Ring {
  float height, width;
};

}  // namespace

// The length from the root to the first place at which an internode has more than one child, or none.
float length_to_first_branch(const std::vector<Internode>& internodes) {
  std::vector<std::uint32_t> children(internodes.size(), 0);
  std::vector<std::size_t> child(internodes.size(), 0);
  for (std::size_t i = 0; i < internodes.size(); ++i) {
    if (internodes[i].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(internodes[i].parent);
    ++children[parent];
    child[parent] = i;
  }
  float length = 0;
  for (std::size_t i = 0; i < internodes.size(); i = child[i]) {
    length += glm::length(internodes[i].end - internodes[i].start);
    if (children[i] != 1) break;
  }
  return length;
}

// Puts a peduncle, drawn as a few pieces between rings, above the root of the internodes, in metres; of `length` from
// its upper end to the first branch, or with a `fork` to the root. Returns by how many places the indices of the
// internodes have moved; 0 if there is nothing to add.
std::int32_t add_peduncle(std::vector<Internode>& internodes, float length, std::uint64_t seed, const Fork& fork) {
  // Length, bow, and the place of the node, where a second bunch forks off.
  const bool forks = fork.root >= 0;
  const float above = forks ? std::max(length, shortest) + fork.height : length - length_to_first_branch(internodes);
  if (internodes.empty() || above < shortest) return 0;
  const auto random_value = [seed](std::uint64_t which) { return random_unit(seed, hash_text("peduncle"), which); };
  const SinCos way = sincos_degrees(360 * random_value(0));
  const float bow = above * (least_bow + (max_bow - least_bow) * random_value(1));
  const float node = forks ? fork.height / above : least_node + (max_node - least_node) * random_value(2);
  const float half = std::min({half_node / above, 0.5f * node, 0.5f * (1 - node)});
  const SinCos off = sincos_degrees(360 * random_value(3));
  const Ring rings[] = {{1, 1.6f},    {1 - 0.3f * (1 - node), 1.35f}, {node + half, 1.28f},
                        {node, 1.6f}, {node - half, 1.25f},           {0.3f * node, 1.18f},
                        {0, 1}};
  const float girth = internodes[0].radius, swell = std::min(1.0f, slim / girth);
  const auto radius_at = [&](const Ring& ring) { return girth * (1 + swell * (ring.width - 1)); };
  std::vector<Internode> stalk;
  for (const Ring& ring : rings) {
    // Upright at p1, curving away from it.
    const float offset = bow * ring.height * ring.height, knee = ring.height == node ? kink : 0;
    const glm::vec3 at(offset * way.cosine + knee * off.cosine, above * ring.height,
                       offset * way.sine + knee * off.sine);
    if (!stalk.empty()) {
      stalk.back().end = at;
      stalk.back().radius_end = radius_at(ring);
    }
    if (ring.height > 0) {
      Internode piece;
      piece.parent = static_cast<std::int32_t>(stalk.size()) - 1;
      piece.start = at;
      piece.radius = radius_at(ring);
      piece.joint = !stalk.empty();
      stalk.push_back(piece);
    }
  }
  // The bunch's own internodes come behind the peduncle's: at its end, or a second bunch at its node.
  const auto moved = static_cast<std::int32_t>(stalk.size());
  if (forks) internodes[static_cast<std::size_t>(fork.root)].start = stalk[node_piece].end;
  for (std::size_t i = 0; i < internodes.size(); ++i) {
    std::int32_t& parent = internodes[i].parent;
    const bool at_node = forks && static_cast<std::int32_t>(i) == fork.root;
    parent = parent >= 0 ? parent + moved : at_node ? node_piece : moved - 1;
  }
  stalk.insert(stalk.end(), internodes.begin(), internodes.end());
  internodes = std::move(stalk);
  return moved;
}

}  // namespace panicle::bunch
