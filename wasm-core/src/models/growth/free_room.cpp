#include "models/growth/free_room.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/golden_spiral.hpp"
#include "foundation/lane_vectors.hpp"
#include "foundation/mathematics.hpp"

namespace panicle::growth {
namespace {

// Distance of a free place from other nodes, over the radius; cosine of the cone of places; weight of a place outside
// the volume, and additional weight of one in the light.
constexpr float apart = 0.55f, ahead = 0.3f;
constexpr float outside = 0.05f, lightwards = 0.5f;
constexpr float at_tip = 1e-8f;  // squared distance below which nodes are the tip itself
constexpr float far_away = 1e6f;
constexpr std::size_t lanes = 4, looks = 40, groups = looks / lanes;

// Directions near each other, so that some groups are wholly behind most tips.
struct Group {
  std::array<float, lanes> x, y, z;
  std::array<float, lanes> turn;  // offset of the depth of each place, added to the noise and wrapped at 1
};

// Directions evenly over the sphere, grouped by four that are near each other, so that groups that point backwards are
// skipped.
std::array<Group, groups> make_directions() {
  std::array<glm::vec3, looks> all{};
  std::array<float, looks> turns{};
  float turn = 0;
  for (std::size_t i = 0; i < looks; ++i) {
    all[i] = golden_sphere_point(i, looks);
    turn += golden_ratio;
    turns[i] = turn -= turn >= 1 ? 1.0f : 0.0f;
  }
  std::array<Group, groups> made{};
  std::array<bool, looks> taken{};
  for (Group& group : made) {
    const std::size_t first = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      std::size_t next = looks;
      for (std::size_t i = 0; i < looks; ++i)
        if (!taken[i] && (next == looks || glm::dot(all[i], all[first]) > glm::dot(all[next], all[first]))) next = i;
      taken[next] = true;
      group.x[lane] = all[next].x;
      group.y[lane] = all[next].y;
      group.z[lane] = all[next].z;
      group.turn[lane] = turns[next];
    }
  }
  return made;
}

// The groups of directions, made once.
const std::array<Group, groups>& directions() {
  static const std::array<Group, groups> all = make_directions();
  return all;
}

}  // namespace

// Sets the nodes that take room. Their coordinates are stored in the order of a grid with cells of width `edge`; four
// more at the end are far away.
void FreeRoom::set_nodes(std::span<const glm::vec3> nodes, float edge) {
  grid_.build(nodes, edge);
  const std::size_t count = grid_.ids().size(), room = count + lanes;
  x_.assign(room, far_away);
  y_.assign(room, far_away);
  z_.assign(room, far_away);
  for (std::size_t slot = 0; slot < count; ++slot) {
    const glm::vec3& node = nodes[grid_.ids()[slot]];
    x_[slot] = node.x;
    y_[slot] = node.y;
    z_[slot] = node.z;
  }
  near_.resize(3 * count);
}

// Collects the nodes near enough to take room in any direction ahead, relative to the tip; the tip itself is left out.
void FreeRoom::find_near(const Query& query) {
  const float far = (1 + apart) * query.radius, behind = (0.5f * ahead - apart) * query.radius;
  const glm::vec3 &tip = query.tip, &forward = query.forward;
  float* next = near_.data();
  grid_.within(tip - far, tip + far, [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t slot = first; slot < end; slot += lanes) {
      const Four x = load(&x_[slot]) - tip.x, y = load(&y_[slot]) - tip.y, z = load(&z_[slot]) - tip.z;
      const Four square = x * x + y * y + z * z;
      std::uint32_t found = true_lanes((square < far * far) & (square > at_tip) &
                                       (x * forward.x + y * forward.y + z * forward.z > behind));
      if (end - slot < lanes) found &= (1u << (end - slot)) - 1;
      if (found == 0) continue;
      float places[3 * lanes];
      store(places, x);
      store(places + lanes, y);
      store(places + 2 * lanes, z);
      for (; found != 0; found &= found - 1, next += 3) {
        const float* const place = places + std::countr_zero(found);
        next[0] = place[0];
        next[1] = place[lanes];
        next[2] = place[2 * lanes];
      }
    }
  });
  near_count_ = static_cast<std::size_t>(next - near_.data()) / 3;
}

// Looks from a tip in all directions ahead, and returns the sum of those that are free, in the volume and towards
// light, and the sum of their weights.
FreeRoom::Found FreeRoom::find(const Query& query, const VolumeShape& volume, const Surroundings& about) {
  find_near(query);
  const float reach = query.radius, square = apart * apart * reach * reach;
  const bool walled = !about.contains_around(query.tip, reach);
  Four x(all_of(0)), y(x), z(x), sum(x);
  for (const Group& group : directions()) {
    const Four way_x = load(group.x.data()), way_y = load(group.y.data()), way_z = load(group.z.data());
    const auto seen = way_x * query.forward.x + way_y * query.forward.y + way_z * query.forward.z >= ahead;
    if (true_lanes(seen) == 0) continue;
    const Four turned = load(group.turn.data()) + query.noise, deep = turned - (turned >= 1.0f ? all_of(1) : all_of(0));
    const Four out = (0.5f + 0.5f * deep) * reach;
    const Four off_x = out * way_x, off_y = out * way_y, off_z = out * way_z;
    const Four place_x = off_x + query.tip.x, place_y = off_y + query.tip.y, place_z = off_z + query.tip.z;
    // A place that is not a number is not free; a node that is not a number takes no room, since the grid omits it.
    const Four somewhere = place_x + place_y + place_z;
    auto taken = somewhere != somewhere;  // NOLINT(misc-redundant-expression)
    for (const float *node = near_.data(), *const end = node + 3 * near_count_; node < end; node += 3) {
      const Four to_x = off_x - node[0], to_y = off_y - node[1], to_z = off_z - node[2];
      taken |= to_x * to_x + to_y * to_y + to_z * to_z < square;
    }
    for (std::size_t lane = 0; walled && lane < lanes; ++lane)
      if (!about.contains({place_x[lane], place_y[lane], place_z[lane]})) taken[lane] = -1;
    const Four lit = way_x * query.light.x + way_y * query.light.y + way_z * query.light.z;
    const Four worth = (taken ? all_of(1 - query.regard) : all_of(1)) *
                       (volume.contains(place_x, place_y, place_z) ? all_of(1) : all_of(outside)) *
                       (1.0f + lightwards * (lit > 0.0f ? lit : all_of(0)));
    const Four weight = seen ? worth : all_of(0);
    x += weight * way_x;
    y += weight * way_y;
    z += weight * way_z;
    sum += weight;
  }
  return {{sum_of(x), sum_of(y), sum_of(z)}, sum_of(sum)};
}

}  // namespace panicle::growth
