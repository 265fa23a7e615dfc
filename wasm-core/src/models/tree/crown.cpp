#include "models/tree/crown.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"

namespace panicle::particles::tree {
namespace {

constexpr int probes = 24;
constexpr float dark = 1e-6f;  // of all light: below it no particle starts
// Sizes of the noise on a crown's surface, in sizes of the crown: billows, and sprays on them.
constexpr float billow = 0.24f, spray = 0.09f;

}  // namespace

// The crowns of a row of trees: outer and inner boundaries, the feet of the stems, and noise for a ragged surface.
Crowns make_crowns(const CrownHabit& habit, std::span<const glm::vec2> profile, const Surface& mesh,
                   const Surface& hollow, const std::shared_ptr<QueryBudget>& budget) {
  const auto crowns = static_cast<float>(habit.crowns), stems = static_cast<float>(habit.stems);
  const glm::vec3 half = 0.5f * habit.growth * habit.size;
  const float lowest = habit.growth * habit.trunk;
  const float shoots = habit.inner + (1 - habit.inner) * habit.shoots;
  Surface outer, inner;
  Crowns made{Solid({}), Solid({}), {}, 2 * half.y, lowest + (1 + shoots) * half.y, 0, 0, {}, habit.ragged, {}, {}};
  made.across = cube_root(8 * half.x * half.y * half.z);
  for (float i = 0; i < crowns; ++i) {
    const float x = (i - 0.5f * (crowns - 1)) * habit.distance;
    const glm::vec3 middle(x, lowest + half.y, 0);
    made.middles.push_back(middle);
    const Surface whole = form_between(habit.form, profile, mesh, middle - half, middle + half);
    append(outer, scaled(whole, middle, shoots));
    append(inner, inner_boundary(whole, hollow, middle - half, middle + half, middle, habit.inner));
    for (float k = 0; k < stems; ++k) made.feet.emplace_back(x + 2 * half.x * ((k + 0.5f) / stems - 0.5f), 0, 0);
  }
  made.outer = Solid(std::move(outer), budget);
  made.inner = Solid(std::move(inner), budget);
  const glm::vec3 row = made.outer.high() - made.outer.low();
  made.longest = std::max({row.x - (crowns - 1) * habit.distance, row.y, row.z});
  if (habit.ragged > 0) {
    made.lumps = ValueNoise(made.outer.low(), made.outer.high(), billow * made.across, habit.seed);
    made.tufts = ValueNoise(made.outer.low(), made.outer.high(), spray * made.across, habit.seed + 1);
  }
  return made;
}

// The middle of the crown nearest to a point, along the row.
glm::vec3 Crowns::middle_of(const glm::vec3& p) const {
  return *std::min_element(middles.begin(), middles.end(), [&](const glm::vec3& one, const glm::vec3& other) {
    return std::fabs(p.x - one.x) < std::fabs(p.x - other.x);
  });
}

// The region in which particles start; finds the brightest light in it. Without `light` all of it is alike.
Foliage::Foliage(const Crowns& crowns, const VoxelLight* light, float light_exponent, const Hormone& hormone)
    : crowns_(&crowns), light_(light), hormone_(&hormone), light_exponent_(light_exponent) {
  if (light_ == nullptr) return;
  brightest_ = 0;
  const glm::vec3 size = high() - low();
  for (int z = 0; z <= probes; ++z)
    for (int y = 0; y <= probes; ++y)
      for (int x = 0; x <= probes; ++x)
        brightest_ = std::max(brightest_, light_->at(low() + size * (glm::vec3(x, y, z) / static_cast<float>(probes))));
}

// Whether a point is inside the outer boundary after noise has roughened it: the point, moved away from the crown's
// middle by noise, must still be inside.
bool Foliage::leafy(const glm::vec3& p) const {
  const Crowns& crowns = *crowns_;
  if (!(crowns.ragged > 0)) return true;
  const glm::vec3 middle = crowns.middle_of(p);
  const auto out = [&](float by) { return crowns.outer.contains(middle + (p - middle) / (1 - by)); };
  if (out(crowns.ragged)) return true;
  return out(crowns.ragged * std::min(0.7f * crowns.lumps.at(p) + 0.3f * crowns.tufts.at(p), 1.0f));
}

// Whether none, some or all of a box is in the foliage. A ragged crown contains all of it only if the box is still
// inside when it is scaled out from the crown's middle by the deepest notch.
Share Foliage::share_of(const glm::vec3& from, const glm::vec3& to) const {
  const Crowns& crowns = *crowns_;
  Share outer = crowns.outer.share_of(from, to);
  if (crowns.ragged > 0 && outer == Share::all) {
    const glm::vec3 middle = crowns.middle_of(from);
    const auto out = [&](const glm::vec3& p) { return middle + (p - middle) / (1 - crowns.ragged); };
    if (crowns.middle_of(to) != middle || crowns.outer.share_of(out(from), out(to)) != Share::all) outer = Share::some;
  }
  return share_between(outer, crowns.inner.share_of(from, to));
}

// The density of starting places at a point: the light there, as a power of its share of the brightest, times the share
// that the hormone leaves.
float Foliage::density(const glm::vec3& p) const {
  if (!(brightest_ > dark)) return 0;
  const float share = light_ ? std::min(light_->at(p) / brightest_, 1.0f) : 1;
  const float lit = light_exponent_ == 1 ? share : power(share, light_exponent_);
  return lit * hormone_->left(p);
}

}  // namespace panicle::particles::tree
