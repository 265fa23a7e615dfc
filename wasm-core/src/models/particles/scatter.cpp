#include "models/particles/scatter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::particles {
namespace {

constexpr std::uint64_t stream_x = 0x70617274, stream_y = stream_x + 1, stream_z = stream_x + 2,
                        stream_keep = stream_x + 3, stream_place = stream_x + 4;
constexpr float jitter = 0.8f;
// Least distance of blue noise in spacings, so that about the requested number of points fit (measured).
constexpr float apart_flat = 0.79f, apart_deep = 0.86f;
constexpr std::uint64_t blue_rounds = 6, edge_rounds = 2;
// More than a hundred for each of the largest number of points: where a region fills hardly any of its box, there are
// fewer points instead.
constexpr std::uint64_t max_cells = 12'000'000;
// Of a jittered lattice, whose cells hold one point each and are not stored.
constexpr std::uint64_t max_jittered = 100'000'000;
// Number of tries for each uniform point.
constexpr std::uint64_t max_darts = 1000;
// The number of spacings tried until the requested number of points fits in, or few more.
constexpr int tries = 8;
constexpr float few_more = 0.04f;
// Number of points of a sample, from which follows how many more fit in than the spacing predicts.
constexpr std::uint32_t sample = 400;

// The cells of a lattice about the origin that a region's box meets, and two more on every side.
class Lattice {
 public:
  // `edge` is the width of a cell.
  Lattice(const Region& region, float edge) : edge_(edge), flat_(region.flat()) {
    const glm::vec3 low = region.low(), high = region.high();
    for (int k = 0; k < 3; ++k) {
      const bool deep = k < 2 || !flat_;
      first_[k] = deep ? whole(low[k]) - margin : 0;
      count_[k] = deep ? whole(high[k]) + 1 + margin - first_[k] : 1;
    }
  }

  // The number of cells.
  std::uint64_t cells() const {
    return static_cast<std::uint64_t>(count_[0]) * static_cast<std::uint64_t>(count_[1]) *
           static_cast<std::uint64_t>(count_[2]);
  }
  // The lattice coordinates of a cell from its index.
  glm::ivec3 cell(std::uint64_t index) const {
    // Below 2^32: 32-bit division takes a third of the time.
    const auto at = static_cast<std::uint32_t>(index), x = static_cast<std::uint32_t>(count_[0]), row = at / x,
               y = static_cast<std::uint32_t>(count_[1]), layer = row / y;
    return glm::ivec3(at - row * x, row - layer * y, layer) + first_;
  }
  // Whether all of a cell's neighbours are in the lattice.
  bool inner(std::uint64_t index) const {
    const glm::ivec3 at = cell(index) - first_;
    for (int k = 0; k < (flat_ ? 2 : 3); ++k)
      if (at[k] < margin || at[k] >= count_[k] - margin) return false;
    return true;
  }
  // Offsets from a cell's index to the first of each row of five cells about it, the nearest rows first. Together these
  // rows contain every cell that is nearer than a cell's diagonal.
  std::vector<std::int64_t> rows() const {
    std::vector<std::int64_t> found;
    for (std::int32_t shell = 0; shell <= 2 * margin * margin; ++shell)
      for (std::int32_t z = flat_ ? 0 : -margin; z <= (flat_ ? 0 : margin); ++z)
        for (std::int32_t y = -margin; y <= margin; ++y)
          if (y * y + z * z == shell)
            found.push_back((static_cast<std::int64_t>(z) * count_[1] + y) * count_[0] - margin);
    return found;
  }
  // The cell of a point.
  glm::ivec3 cell_of(const glm::vec3& p) const { return {whole(p.x), whole(p.y), flat_ ? 0 : whole(p.z)}; }
  // A random point of a cell: within `share` of its width about its middle. Each `round` gives another point.
  glm::vec3 point(const glm::ivec3& cell, float share, std::uint64_t seed, std::uint64_t round) const {
    const std::uint64_t bits = random_bits(seed, stream_place, address_of(cell, round));
    const auto along = [&](int k) {
      const auto unit = static_cast<float>(bits >> (21 * k) & 0x1fffff) * 0x1p-21f;
      return (static_cast<float>(cell[k]) + 0.5f + share * (unit - 0.5f)) * edge_;
    };
    return {along(0), along(1), flat_ ? 0 : along(2)};
  }
  // Whether all, some or none of a cell is inside the region, but for rounding.
  Share share_of(const glm::ivec3& cell, const Region& region) const { return share_of(cell, 1, region); }
  // The same for `count` cells in a row.
  Share share_of(const glm::ivec3& cell, std::int32_t count, const Region& region) const {
    const glm::vec3 low = (glm::vec3(cell) - 1e-3f) * edge_, size = glm::vec3(count, 1, 1) + 2e-3f;
    return flat_ ? Share::some : region.share_of(low, low + size * edge_);
  }
  // The number of cells from one on in its row, 16 at most.
  std::uint64_t run(std::uint64_t index) const {
    const auto row = static_cast<std::uint64_t>(count_[0]);
    return std::min<std::uint64_t>(16, row - index % row);
  }
  // Whether all of a cell is within `reach` of a point.
  bool covered(const glm::ivec3& cell, const glm::vec3& p, float reach) const {
    glm::vec3 farthest = glm::abs(p / edge_ - (glm::vec3(cell) + 0.5f)) + 0.5f;
    if (flat_) farthest.z = 0;
    return glm::dot(farthest, farthest) * edge_ * edge_ < reach * reach;
  }
  // The address of a cell's random values.
  static std::uint64_t address_of(const glm::ivec3& cell, std::uint64_t round) {
    const auto word = [](std::int32_t value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    return hash_combine(hash_combine(word(cell[0]) << 32 | word(cell[1]), word(cell[2])), round);
  }

 private:
  static constexpr std::int32_t margin = 2;

  // The lattice coordinate of the cell that a coordinate is in.
  std::int32_t whole(float v) const { return static_cast<std::int32_t>(std::floor(v / edge_)); }

  float edge_;
  bool flat_;
  glm::ivec3 first_{0}, count_{1};
};

// The edge of a square (flat) or cube of that area or volume.
float edge_of(float size, bool flat) { return flat ? std::sqrt(size) : cube_root(size); }

// Draws independent points in the region's box and keeps those inside, by the density; fewer than `count` where the
// region fills hardly any of its box.
std::vector<glm::vec3> uniform(const Region& region, std::uint32_t count, std::uint64_t seed) {
  std::vector<glm::vec3> points;
  points.reserve(count);
  const glm::vec3 low = region.low(), size = region.high() - low;
  for (std::uint64_t dart = 0; points.size() < count && dart < max_darts * count && !region.is_exhausted(); ++dart) {
    const glm::vec3 p = low + size * glm::vec3(random_unit(seed, stream_x, dart), random_unit(seed, stream_y, dart),
                                               random_unit(seed, stream_z, dart));
    if (region.contains(p) && random_unit(seed, stream_keep, dart) < region.density(p)) points.push_back(p);
  }
  return points;
}

// Points with ranks. A rank is a point's random value over the density there, below 1: where there are too many points,
// those with the lowest ranks stay.
struct RankedPoints {
  std::vector<glm::vec3> points;
  std::vector<float> ranks;
  bool coarse = false;  // whether the lattice would have had too many cells

  // Adds the point p of a cell if it is inside and its random value is below the density. `known`: it is known to be
  // inside. The cheap test goes first: random value and density reject most places of a dark crown.
  void add_if_drawn(const Region& region, const glm::vec3& p, bool known, const glm::ivec3& cell, std::uint64_t seed) {
    if (!known && !region.has_room(p)) return;
    const float noise = random_unit(seed, stream_keep, Lattice::address_of(cell, 0)), density = region.density(p);
    if (!(noise < density) || !(known || region.contains(p))) return;
    points.push_back(p);
    ranks.push_back(noise / density);
  }
};

// Draws a point in each cell of a lattice over a region; widens the spacing until there are not too many cells.
RankedPoints jittered(const Region& region, float spacing, std::uint64_t seed) {
  RankedPoints ranked;
  while (Lattice(region, spacing).cells() > max_jittered) {
    spacing *= 1.1f;
    ranked.coarse = true;
  }
  const Lattice lattice(region, spacing);
  // By runs of cells: where crowns stand far apart, most of their box is air.
  for (std::uint64_t i = 0; i < lattice.cells() && !region.is_exhausted(); i += lattice.run(i)) {
    const glm::ivec3 cell = lattice.cell(i);
    const auto length = static_cast<std::int32_t>(lattice.run(i));
    if (lattice.share_of(cell, length, region) == Share::none) continue;
    for (std::int32_t k = 0; k < length; ++k) {
      const glm::ivec3 at = cell + glm::ivec3(k, 0, 0);
      ranked.add_if_drawn(region, lattice.point(at, jitter, seed, 0), false, at, seed);
    }
  }
  return ranked;
}

// Blue noise by darts at the cells of a lattice, small enough to hold one point at most: some rounds through those that
// are still empty leave hardly a gap, in time linear in their number. (Darts at the whole region need ever more to find
// the last gaps.) Where the density is lower, points are removed afterwards.
RankedPoints blue(const Region& region, float apart, std::uint64_t seed) {
  RankedPoints ranked;
  const bool flat = region.flat();
  const float diagonal = std::sqrt(flat ? 2.0f : 3.0f);
  while (Lattice(region, apart / diagonal).cells() > max_cells) {
    apart *= 1.1f;
    ranked.coarse = true;
  }
  const Lattice lattice(region, apart / diagonal);
  std::vector<std::uint8_t> taken(lattice.cells() + 3, 0);  // five of a row are read as eight
  std::vector<glm::vec3> points, by_cell(lattice.cells());
  const std::vector<std::int64_t> rows = lattice.rows();
  // The point near a cell that is closer than `apart` to p, or null. Reads eight bytes of `taken`, of which five are
  // the row's.
  const auto in_the_way = [&](std::uint64_t cell, const glm::vec3& p) -> const glm::vec3* {
    for (const std::int64_t offset : rows) {
      const auto first = static_cast<std::size_t>(static_cast<std::int64_t>(cell) + offset);
      std::uint64_t eight;
      std::memcpy(&eight, &taken[first], sizeof eight);
      for (std::uint64_t five = eight & 0xff'ffff'ffff; five; five &= five - 1) {
        const glm::vec3& other = by_cell[first + static_cast<std::size_t>(std::countr_zero(five)) / 8];
        const glm::vec3 way = other - p;
        if (glm::dot(way, way) < apart * apart) return &other;
      }
    }
    return nullptr;
  };
  std::vector<std::uint64_t> open, still_open;
  std::vector<std::uint8_t> whole(lattice.cells(), 0);  // of each cell: completely inside
  for (std::uint64_t i = 0; i < lattice.cells() && !region.is_exhausted(); ++i) {
    if (!lattice.inner(i)) continue;
    const Share share = lattice.share_of(lattice.cell(i), region);
    if (share == Share::none) continue;
    whole[i] = share == Share::all;
    open.push_back(i);
  }
  for (std::uint64_t round = 1; round <= blue_rounds && !open.empty() && !region.is_exhausted(); ++round) {
    still_open.clear();
    for (const std::uint64_t i : open) {
      const glm::ivec3 cell = lattice.cell(i);
      const glm::vec3 p = lattice.point(cell, 1, seed, round);
      if (const glm::vec3* other = in_the_way(i, p)) {
        if (!lattice.covered(cell, *other, apart)) still_open.push_back(i);
      } else if (!whole[i] && !region.contains(p)) {
        if (round <= edge_rounds) still_open.push_back(i);  // its cell may lie across the edge
      } else {
        taken[i] = 1;
        by_cell[i] = p;
        points.push_back(p);
      }
    }
    std::swap(open, still_open);
  }
  for (const glm::vec3& p : points) ranked.add_if_drawn(region, p, true, lattice.cell_of(p), seed);
  return ranked;
}

// Scatters points at a given spacing, in a jittered lattice or as blue noise.
RankedPoints scatter_at(const Region& region, Pattern pattern, float spacing, std::uint64_t seed) {
  if (pattern == Pattern::jittered) return jittered(region, spacing, seed);
  return blue(region, spacing * (region.flat() ? apart_flat : apart_deep), seed);
}

// The points with ranks below the limit.
std::vector<glm::vec3> below(const RankedPoints& ranked, float limit) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < ranked.points.size(); ++i)
    if (ranked.ranks[i] < limit) points.push_back(ranked.points[i]);
  return points;
}

// The rank below which there are `count` points; 1 where there are no more than that.
float limit_of(const RankedPoints& ranked, std::uint32_t count) {
  if (ranked.ranks.size() <= count) return 1;
  std::vector<float> ranks = ranked.ranks;
  std::nth_element(ranks.begin(), ranks.begin() + count, ranks.end());
  return ranks[count];
}

// The spacing of `count` points in the filled area or volume.
float spacing_in(float filled, std::uint32_t count, bool flat) {
  return count > 0 ? edge_of(filled / static_cast<float>(count), flat) : 0;
}

}  // namespace

// The spacing at which `count` points fill the region.
float spacing_of(const Region& region, std::uint32_t count) {
  return spacing_in(extent_of(region).filled, count, region.flat());
}

// Scatters about `count` points in a pattern: uniform ones by their count, the others by their spacing.
std::vector<glm::vec3> scatter(const Region& region, Pattern pattern, std::uint32_t count, float spacing,
                               std::uint64_t seed) {
  if (!(spacing > 0)) return {};
  if (pattern == Pattern::uniform) return uniform(region, count, seed);
  return scatter_at(region, pattern, spacing, seed).points;
}

// Scatters exactly `count` points where the pattern allows: tries spacings until enough points fit, then drops those
// with the highest ranks. A `growth` below 1, the size of a young plant, widens the spacing and so reduces the count.
Scattered scatter_all(const Region& region, Pattern pattern, std::uint32_t count, std::uint64_t seed, float growth) {
  const bool flat = region.flat();
  const Extent extent = extent_of(region);
  const float nominal = spacing_in(extent.filled, count, flat);
  if (!(nominal > 0)) return {{}, 0, extent};
  if (pattern == Pattern::uniform) {
    const float share = growth * growth * (flat ? 1 : growth);
    return {uniform(region, static_cast<std::uint32_t>(static_cast<float>(count) * share + 0.5f), seed),
            nominal / growth, extent};
  }
  const auto wanted = static_cast<float>(count);
  float spacing = nominal;
  // Points near the edge have less room of their own, and more than the spacing predicts fit in: the more, the fewer
  // they are.
  if (count > sample) {
    const float wider = edge_of(wanted / sample, flat);
    const auto found = static_cast<float>(scatter_at(region, pattern, wider * nominal, seed).points.size());
    spacing *= edge_of((1 + (found / sample - 1) / wider) / (1 + 0.5f * few_more), flat);
  }
  RankedPoints best;
  float of_best = spacing;
  for (int k = 0; k < tries && !region.is_exhausted(); ++k) {
    RankedPoints ranked = scatter_at(region, pattern, spacing, seed);
    const std::size_t found = ranked.points.size(), before = best.points.size();
    const bool coarse = ranked.coarse;
    if (found >= count ? before < count || found < before : found > before) {
      best = std::move(ranked);
      of_best = spacing;
    }
    if (coarse || (found >= count && static_cast<float>(found) <= (1 + few_more) * wanted)) break;
    spacing *= edge_of(std::max(static_cast<float>(found), 0.5f) / ((1 + 0.5f * few_more) * wanted), flat);
  }
  const float limit = limit_of(best, count);
  if (growth < 1) best = scatter_at(region, pattern, of_best / growth, seed);
  return {below(best, limit), nominal / growth, extent};
}

}  // namespace panicle::particles
