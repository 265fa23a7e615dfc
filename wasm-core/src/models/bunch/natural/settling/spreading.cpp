#include "models/bunch/natural/settling/spreading.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/bunch/natural/settling/sagging.hpp"
#include "models/bunch/natural/swollen_size.hpp"
#include "spatial/sphere_overlaps.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

// Found by trial: the smallest movement of berries by a pixel of the profile (docs/natural.md).
constexpr int rounds = 2;
constexpr float on_one_axis = 0.5f;    // share of the overlap, by which two berries of one axis move apart, a round
constexpr float on_two_axes = 0.05f;   // the same for two axes, whose distance changes with every pixel of the profile
constexpr float weight = 0.05f;        // of a radius: how much lower all come to hang, a round
constexpr float least_length = 1e-4f;  // millimetres, of a pedicel with its berry

// A ripe berry as it hangs: the foot of its pedicel, the pedicel's direction (unit), its centre and size, its mass (up
// to a factor), and the first branch of its axis.
struct Hung {
  glm::vec3 foot, heading, centre;
  SwollenSize size;
  float mass;
  std::size_t axis;
};

// Per branch, the index of the first branch of its axis. An axis is a chain of sagging branches, each the child of the
// last.
std::vector<std::size_t> first_branches(std::span<const Branch> branches) {
  std::vector<std::size_t> axes(branches.size());
  for (std::size_t k = 0; k < branches.size(); ++k) {
    const auto parent = static_cast<std::size_t>(branches[k].parent);
    const bool goes_on = branches[k].parent >= 0 && branches[k].sags && branches[parent].sags;
    axes[k] = goes_on ? axes[parent] : k;
  }
  return axes;
}

// Places each berry as it hangs from its bent branch without neighbours.
std::vector<Hung> hung_alone(std::span<const Branch> branches, std::span<const Swelling> berries,
                             std::span<const glm::quat> turned) {
  std::vector<glm::vec3> ends(branches.size());
  for (std::size_t k = 0; k < branches.size(); ++k) {
    const Branch& branch = branches[k];
    const glm::vec3 start = branch.parent < 0 ? branch.start : ends[static_cast<std::size_t>(branch.parent)];
    ends[k] = start + turned[k] * (branch.end - branch.start);
  }
  const std::vector<std::size_t> axes = first_branches(branches);
  std::vector<Hung> all;
  all.reserve(berries.size());
  for (const Swelling& berry : berries) {
    const SwollenSize size = swollen_size(berry, 1);
    const glm::vec3 foot = ends[berry.branch], heading = drooping(turned[berry.branch] * berry.heading, 1);
    const glm::vec3 centre = foot + heading * (size.stalk + size.half_length);
    all.push_back({foot, heading, centre, size, size.ball * size.ball * size.ball, axes[berry.branch]});
  }
  return all;
}

// The pairs of berries that overlap or nearly do; late ones have none.
std::vector<SpherePair> neighbours(std::span<const Hung> all, std::span<const Swelling> berries) {
  std::vector<Sphere> spheres;
  spheres.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    spheres.push_back({all[i].centre, berries[i].late ? -1 : all[i].size.ball + all[i].size.core});
  std::vector<SpherePair> pairs;
  SphereOverlapQuery(spheres).pairs(pairs, max_pairs * all.size());
  return pairs;
}

// Half the vector by which two overlapping berries are pushed apart; smooth where they begin to overlap.
glm::vec3 push_between(const Hung& a, const Hung& b) {
  const glm::vec3 between = between_segments(b.centre - a.centre, {a.heading, a.size.core}, {b.heading, b.size.core});
  const float reach = a.size.ball + b.size.ball;
  const float near = 1 - glm::dot(between, between) / (reach * reach);
  if (!(near > 0)) return glm::vec3(0);
  return between * ((a.axis == b.axis ? on_one_axis : on_two_axes) * near * near);
}

// Leans a berry's pedicel sideways and a little down, never up, so that no berry lifts another; the pedicel's length is
// preserved.
void lean(Hung& berry, const glm::vec3& sideways) {
  const glm::vec3 way = berry.centre + glm::vec3(sideways.x, -weight * berry.size.ball, sideways.z) - berry.foot;
  const float far = glm::length(way);
  if (!(far > least_length)) return;
  berry.heading = way / far;
  berry.centre = berry.foot + berry.heading * (berry.size.stalk + berry.size.half_length);
}

}  // namespace

// Leans pedicels away from overlapping neighbours in a few soft rounds, before anything swells. Returns by how much to
// change each berry's direction; 0 for late ones.
std::vector<glm::vec3> spread(std::span<const Branch> branches, std::span<const Swelling> berries,
                              std::span<const glm::quat> turned) {
  const std::vector<Hung> alone = hung_alone(branches, berries, turned);
  const std::vector<SpherePair> pairs = neighbours(alone, berries);
  std::vector<Hung> all = alone;
  std::vector<glm::vec3> sideways(all.size());
  for (int round = 0; round < rounds; ++round) {
    std::fill(sideways.begin(), sideways.end(), glm::vec3(0));
    for (const auto [i, j] : pairs) {
      const glm::vec3 push = push_between(all[i], all[j]);
      if (push == glm::vec3(0)) continue;
      const float heavier = 2 * all[i].mass / (all[i].mass + all[j].mass);  // a shot berry displaces no other
      sideways[i] -= push * (2 - heavier);
      sideways[j] += push * heavier;
    }
    for (std::size_t i = 0; i < all.size(); ++i) lean(all[i], sideways[i]);
  }
  std::vector<glm::vec3> leans(all.size(), glm::vec3(0));
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!berries[i].late) leans[i] = all[i].heading - alone[i].heading;
  return leans;
}

}  // namespace panicle::bunch
