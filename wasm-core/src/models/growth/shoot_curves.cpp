#include "models/growth/shoot_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/random.hpp"

namespace panicle::growth {
namespace {

constexpr std::uint64_t stream_wander = 0x63757276, stream_sway = stream_wander + 1;
constexpr float trunk_wander = 0.3f;  // of trunks against branches
// The length of an internode that is drawn with all pieces, as a share of its volume's height; and the share of pieces
// by order, from 0 on.
constexpr float full_share = 0.06f;
constexpr float low_share = 0.25f;  // of its height, below which branches are near the ground
constexpr std::array<float, 4> order_share{1, 1, 0.7f, 0.5f};
// How far the base of a branch points along its parent: the direction turns out within the first internode.
constexpr float along_parent = 0.45f;
// The highest values over 0 … 1 of t²(1 − t)² and of t²(1 − t)²(1 − 2t) are 1/16 and about 1/36.
constexpr float wander_peak = 16, sway_peak = 36;

// The vector with length 1, or `otherwise` where it has none.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-6f ? v / length : otherwise;
}

}  // namespace

void ShootCurve::set(const Population& population, const Form& form, const CurveHabit& habit, std::uint32_t q) {
  const Shoot& shoot = population.shoots[q];
  const ShootPath& path = form.paths[q];
  const glm::vec3* const nodes = &form.nodes[path.first];
  internodes_.assign(path.count, {});
  full_length_ = full_share * population.volumes[shoot.volume].height;
  pieces_ = std::max<std::uint32_t>(
      habit.pieces == 0 ? 1
                        : static_cast<std::uint32_t>(
                              std::lround(static_cast<float>(habit.pieces) *
                                          order_share[std::min<std::size_t>(shoot.order, order_share.size() - 1)])),
      1);
  // A drawn shoot keeps to its curve.
  const bool drawn = !form.edited.empty() && form.edited[q].drawn;
  const float amount = drawn ? 0 : shoot.trunk ? trunk_wander * habit.gnarl : habit.gnarl;
  // Branches near the ground sag less, so that they stay above it.
  const float sag =
      habit.sag * std::clamp(nodes[0].y / (low_share * population.volumes[shoot.volume].height), 0.0f, 1.0f);
  const RandomStream wanders(habit.seed, stream_wander), sways(habit.seed, stream_sway);
  for (std::uint32_t i = 0; i < path.count; ++i) {
    glm::vec3 whole = nodes[i + 1] - nodes[i];
    const float length = glm::length(whole);
    if (!shoot.trunk && !drawn && length > 0) {
      const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(path.count);
      const float level = std::sqrt(whole.x * whole.x + whole.z * whole.z);
      whole.y += level * (habit.rise * share * share - sag * (1 - share));
      whole *= length / std::max(glm::length(whole), 1e-6f);
    }
    internodes_[i].whole = whole;
    if (amount <= 0 || length <= 0) continue;
    const glm::vec3 along = whole / length;
    const auto sideways = [&](const RandomStream& stream) {
      const glm::vec3 noise = stream.direction(hash_combine(q, i));
      return amount * length * (noise - glm::dot(noise, along) * along);
    };
    internodes_[i].wander = sideways(wanders);
    internodes_[i].sway = sideways(sways);
  }
  glm::vec3 tangent(0, 1, 0);
  for (std::uint32_t i = 0; i < path.count; ++i) {
    Internode& here = internodes_[i];
    const float length = glm::length(here.whole);
    const glm::vec3 along = unit_or(here.whole, tangent);
    if (i == 0) {
      tangent = along;
      if (!shoot.trunk && shoot.parent >= 0) {
        const ShootPath& parent = form.paths[static_cast<std::size_t>(shoot.parent)];
        const glm::vec3 beside =
            form.nodes[parent.first + path.internode + 1] - form.nodes[parent.first + path.internode];
        tangent = unit_or(along + along_parent * unit_or(beside, along), along);
      }
    }
    here.start_tangent = length * tangent;
    tangent = i + 1 < path.count ? unit_or(along + unit_or(internodes_[i + 1].whole, along), along) : along;
    here.end_tangent = length * tangent;
  }
}

glm::vec3 ShootCurve::at(std::uint32_t internode, float share) const {
  const Internode& here = internodes_[internode];
  const float t = share, rest = 1 - t, bump = t * t * rest * rest;
  return t * rest * rest * here.start_tangent + t * t * (3 - 2 * t) * here.whole - t * t * rest * here.end_tangent +
         wander_peak * bump * here.wander + sway_peak * bump * (1 - 2 * t) * here.sway;
}

std::uint32_t ShootCurve::pieces(std::uint32_t internode) const {
  const float share = std::min(glm::length(internodes_[internode].whole) / full_length_, 1.0f);
  return std::clamp<std::uint32_t>(static_cast<std::uint32_t>(std::ceil(share * static_cast<float>(pieces_))), 1,
                                   pieces_);
}

}  // namespace panicle::growth
