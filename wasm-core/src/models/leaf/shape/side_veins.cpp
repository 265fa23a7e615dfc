#include "models/leaf/shape/side_veins.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "foundation/mathematics.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float first_secondary = 0.04f, last_secondary = 0.94f;  // along the midrib
constexpr float least_secondary = 0.03f;
constexpr int max_strides = 100;
// Below the petiole veins fan out: spacing, greatest angle, and least length.
constexpr float fan_apart = 32, fan_end = 165, least_fan = 0.1f;  // degrees, leaf lengths
constexpr float near_root = 0.4f;                                 // of its length: distance of a vein from the margin
constexpr float near_tip = 0.3f, near_tooth = 0.08f;              // of the distance to its end: the same there
constexpr float lobe_reach = 0.94f;                               // of the way into a lobe
// Distances of a lobe's vein from the bays beside it, in the order of preference; and the deviation of its angle that
// each is worth.
constexpr float clear_of_bays[] = {0.022f, 0.011f, 0}, worth[] = {0, 8, 16};
// An arch of 1 has turned a vein along the main one after 5/6 of the way ahead: the main vein's to its tip, or the
// least.
constexpr float turns_by = 2.2f, least_ahead = 0.15f;  // leaf lengths
constexpr float bow = 0.35f;                           // of an arch of 1, over the way ahead
constexpr float before_tooth = 4e-3f;                  // leaf lengths
// A vein ends in no tooth that is farther than this from its own end, over the main vein's length.
constexpr float farthest_tooth = 0.18f;
// Distance of arches from the margin, in the spacing of side veins, and in leaf lengths; and their turn at a stride, in
// degrees.
constexpr float arch_clear = 0.32f, least_clear = 0.014f, max_clear = 0.05f, turn = 2, max_turned = 16;
constexpr float foreseen = 2.5f;    // strides
constexpr float below_next = 0.7f;  // of that distance: nearer than this to the next vein they end

// Rotates a vector counter-clockwise.
glm::vec2 rotated(const glm::vec2& v, float degrees) {
  const auto [sine, cosine] = sincos_degrees(degrees);
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

// The places of secondary veins along the midrib, from 0 at the base to 1 at the tip. Their distances change evenly
// from 1 to `ratio`; `shift` moves each by that share of its distance.
std::vector<float> secondary_shares(std::uint32_t count, float ratio, float shift) {
  std::vector<float> places;
  float sum = 0;
  const auto n = static_cast<float>(count);
  const auto gap = [&](float k) { return 1 + (ratio - 1) * k / n; };
  for (float k = 0; k < n; ++k) {
    places.push_back(sum + shift * gap(k));
    sum += gap(k);
  }
  for (float& share : places) share /= sum;
  return places;
}

// Whether any of the places is nearer to p than `reach`.
bool any_within(std::span<const glm::vec3> places, const glm::vec3& p, float reach) {
  return std::any_of(places.begin(), places.end(),
                     [&](const glm::vec3& place) { return glm::distance(place, p) < reach; });
}

// Assigns a tooth to each vein, −1 for none: in the same order, none twice, with the least total distance from the
// veins' ends; a vein without a tooth costs `farthest`. Dynamic programming over the first i veins and the first k
// teeth, as in sequence alignment.
std::vector<std::int32_t> match_teeth(std::span<const glm::vec3> ends, std::span<const glm::vec3> teeth,
                                      float farthest) {
  const std::size_t n = ends.size(), m = teeth.size();
  std::vector<float> cost((n + 1) * (m + 1), 0);
  const auto cost_at = [&](std::size_t i, std::size_t k) -> float& { return cost[i * (m + 1) + k]; };
  const auto match_cost = [&](std::size_t i, std::size_t k) {
    return cost_at(i - 1, k - 1) + glm::distance(ends[i - 1], teeth[k - 1]);
  };
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t k = 0; k <= m; ++k) {
      cost_at(i, k) = cost_at(i - 1, k) + farthest;
      if (k > 0) cost_at(i, k) = std::min({cost_at(i, k), cost_at(i, k - 1), match_cost(i, k)});
    }
  std::vector<std::int32_t> tooth(n, -1);
  for (std::size_t i = n, k = m; i > 0 && k > 0;) {
    if (cost_at(i, k) == cost_at(i, k - 1)) {
      --k;
    } else if (cost_at(i, k) == match_cost(i, k)) {
      tooth[--i] = static_cast<std::int32_t>(--k);
    } else {
      --i;
    }
  }
  return tooth;
}

}  // namespace

// Whether a place belongs to this part of the leaf: its own main vein is the nearest by more than a margin.
bool Part::holds(const glm::vec3& p) const {
  if (mains.empty()) return true;
  const float from_own = mains[own].nearest(p).distance;
  for (std::size_t k = 0; k < mains.size(); ++k)
    if (k != own && mains[k].nearest(p).distance < from_own + before_margin) return false;
  return true;
}

SideVeins::SideVeins(const RibPlan& plan, const Margin& margin, const Outline& outline)
    : plan_(plan), margin_(margin), outline_(outline) {}

// The starts of side veins on one side (−1 right, 1 left), from the base up; with `fan` first those that fan out below
// the base.
std::vector<SideVeins::Start> SideVeins::starts(const Midrib& midrib, std::uint32_t count, float side, bool fan) const {
  std::vector<Start> found;
  if (fan)
    for (float angle = plan_.angle + fan_apart; angle <= fan_end; angle += fan_apart)
      found.insert(found.begin(), {0, angle, least_fan});
  for (const float share : secondary_shares(count, plan_.spacing, side > 0 ? plan_.offset : 0.0f)) {
    const float along = first_secondary + share * (last_secondary - first_secondary);
    if (along < last_secondary) found.push_back({midrib.at(along * midrib.length()), plan_.angle, least_secondary});
  }
  return found;
}

// Adds `count` side veins on each side of a midrib to the ribs, in the course that the plan requires.
void SideVeins::add_veins(Ribs& ribs, const Midrib& midrib, std::uint32_t count, const Part& part) const {
  const float spacing = midrib.length() / static_cast<float>(std::max(count, 1u));
  const float clearance = std::clamp(arch_clear * spacing, least_clear, max_clear);
  for (const float side : {-1.0f, 1.0f}) {
    const std::vector<Start> vein_starts = starts(midrib, count, side, part.fan);
    std::vector<Vein> veins(vein_starts.size());
    // From the tip down, so that each has the next above it.
    for (std::size_t i = vein_starts.size(); i-- > 0;) {
      const Vein* above = i + 1 < veins.size() ? &veins[i + 1] : nullptr;
      veins[i] = plan_.course == Course::arch ? arched(midrib, vein_starts[i], side, part, above, clearance)
                                              : walk(midrib, vein_starts[i], side, part);
    }
    if (plan_.course == Course::teeth) into_teeth(midrib, veins, teeth(side, part));
    for (const Vein& vein : veins) {
      std::int32_t last = midrib.numbers[vein.root];
      for (const glm::vec3& place : vein.places) last = add(ribs, last, place);
    }
  }
}

// The angle between a vein and its main vein after a length of `walked`. Half of the arch is behind when that is as
// long as the way ahead.
float SideVeins::angle_after(const Midrib& midrib, const Start& start, float walked) const {
  const float ahead = std::max(midrib.length() - midrib.lengths[start.root], least_ahead);
  return start.angle * std::max(1 - turns_by * (plan_.arch * walked / (walked + ahead)), 0.0f);
}

// Walks a vein from a start into the blade until it is near the margin, or near another main vein's part.
SideVeins::Vein SideVeins::walk(const Midrib& midrib, const Start& start, float side, const Part& part) const {
  const glm::vec2 heading = midrib.heading(start.root);
  Vein vein{start.root, {}};
  glm::vec3 at = midrib.places[start.root];
  float walked = 0;
  for (int k = 0; k < max_strides; ++k) {
    const glm::vec3 next = at + stride * deep(rotated(heading, side * angle_after(midrib, start, walked)));
    vein.at_margin =
        !outline_.contains(next) || !outline_.keeps_off(next, std::min(before_margin, near_root * (walked + stride)));
    if (vein.at_margin || !part.holds(next)) break;
    vein.places.push_back(at = next);
    walked += stride;
  }
  if (walked < start.least) vein.places.clear();
  return vein;
}

// Walks a vein to the distance `clearance` from the margin, then along the margin towards the tip, until just below the
// vein `above` (null: none).
SideVeins::Vein SideVeins::arched(const Midrib& midrib, const Start& start, float side, const Part& part,
                                  const Vein* above, float clearance) const {
  const glm::vec2 heading = midrib.heading(start.root);
  Vein vein{start.root, {}};
  glm::vec3 at = midrib.places[start.root];
  float walked = 0, angle = start.angle;
  for (int k = 0; k < max_strides; ++k) {
    const float margin_distance = std::min(clearance, near_root * (walked + stride));
    const auto ahead = [&](float strides) { return at + strides * stride * deep(rotated(heading, side * angle)); };
    const auto is_free = [&](const glm::vec3& p, float reach) {
      return outline_.contains(p) && outline_.keeps_off(p, reach);
    };
    angle = std::min(angle, angle_after(midrib, start, walked));
    for (float turned_by = 0;
         turned_by < max_turned && !(is_free(ahead(1), margin_distance) && is_free(ahead(foreseen), margin_distance));
         turned_by += turn)
      angle -= turn;
    const glm::vec3 next = ahead(1);
    if (!is_free(next, std::min(margin_distance, before_margin)) || !part.holds(next)) break;
    const float min_distance = below_next * clearance;
    if (above && any_within(above->places, next, min_distance)) break;
    if (angle < 0 && any_within(midrib.places, next, min_distance)) break;
    vein.places.push_back(at = next);
    walked += stride;
  }
  if (walked < start.least) vein.places.clear();
  return vein;
}

// The tips of the teeth on one side of a part, from its base up.
std::vector<glm::vec3> SideVeins::teeth(float side, const Part& part) const {
  std::vector<glm::vec3> tips;
  for (const std::size_t tooth : margin_.teeth) {
    const bool right = part.first < tooth && tooth < part.tip, left = part.tip < tooth && tooth < part.last;
    const glm::vec3 place = deep(margin_.points[tooth]);
    if ((side < 0 ? right : left) && part.holds(place)) tips.push_back(place);
  }
  if (side > 0) std::reverse(tips.begin(), tips.end());
  return tips;
}

// Leads veins that reach the margin into the nearest teeth, where the way is free.
void SideVeins::into_teeth(const Midrib& midrib, std::span<Vein> veins, std::span<const glm::vec3> teeth) const {
  std::vector<std::size_t> reaching;
  std::vector<glm::vec3> ends;
  for (std::size_t i = 0; i < veins.size(); ++i)
    if (veins[i].at_margin && !veins[i].places.empty()) {
      reaching.push_back(i);
      ends.push_back(veins[i].places.back());
    }
  const std::vector<std::int32_t> tooth = match_teeth(ends, teeth, farthest_tooth * midrib.length());
  for (std::size_t i = 0; i < reaching.size(); ++i) {
    if (tooth[i] < 0) continue;
    Vein& vein = veins[reaching[i]];
    const glm::vec3 root = midrib.places[vein.root], tip = teeth[static_cast<std::size_t>(tooth[i])];
    const glm::vec3 end = tip + std::min(before_tooth / glm::distance(root, tip), 1.0f) * (root - tip);
    for (const float bend : {plan_.arch, 0.0f}) {
      std::vector<glm::vec3> places = curve_to(midrib, vein.root, end, bend);
      if (!is_clear(root, places, before_margin, near_tooth)) continue;
      vein.places = std::move(places);
      break;
    }
  }
}

// A line from the place `root` of the main vein to an end: a quadratic Bézier curve, steeper first for a `bend` above
// 0, then along the lobe.
std::vector<glm::vec3> SideVeins::curve_to(const Midrib& midrib, std::size_t root, const glm::vec3& end,
                                           float bend) const {
  const glm::vec3 start = midrib.places[root];
  const glm::vec2 heading = midrib.heading(root);
  const float ahead = glm::dot(flat(end - start), heading);
  const glm::vec3 corner = 0.5f * (start + end) - (bow * bend * ahead) * deep(heading);
  const float count = std::max(2.0f, std::ceil(glm::distance(start, end) / stride));
  std::vector<glm::vec3> places;
  for (float k = 1; k <= count; ++k) {
    const float t = k / count;
    places.push_back((1 - t) * (1 - t) * start + 2 * t * (1 - t) * corner + t * t * end);
  }
  return places;
}

// Whether a line lies in the blade and at least `clearance` off its margin. Less is enough near its root, and near its
// end `near_end` times the distance to it.
bool SideVeins::is_clear(const glm::vec3& start, std::span<const glm::vec3> places, float clearance,
                         float near_end) const {
  glm::vec3 before = start;
  for (const glm::vec3& place : places) {
    const float margin_distance =
        std::min({clearance, near_root * glm::distance(start, place), near_end * glm::distance(place, places.back())});
    if (!outline_.contains(place) || !outline_.holds(before, place) || !outline_.keeps_off(place, margin_distance))
      return false;
    before = place;
  }
  return true;
}

// Adds a side vein from the midrib to a lobe's tip: from the place where its angle is nearest to the plan's. Returns
// false if no straight way leads there.
bool SideVeins::to_lobe(Ribs& ribs, const Midrib& midrib, const glm::vec3& tip) const {
  std::size_t best = 0, clearance_index = 0;
  float least_deviation = std::numeric_limits<float>::max();
  for (std::size_t i = 1; i + 2 < midrib.places.size(); ++i) {
    const glm::vec3 start = midrib.places[i], end = start + lobe_reach * (tip - start);
    const glm::vec2 direction = flat(tip - start);
    const float angle =
        arc_cosine(glm::dot(direction, midrib.heading(i)) / std::max(glm::length(direction), 1e-6f)) * 180 / pi;
    if (!outline_.holds(start, end)) continue;
    const std::vector<glm::vec3> straight = curve_to(midrib, i, end, 0);
    for (std::size_t k = 0; k < std::size(clear_of_bays); ++k) {
      const float deviation = std::fabs(angle - plan_.angle) + worth[k];
      if (!(deviation < least_deviation) || !is_clear(start, straight, clear_of_bays[k], near_tip)) continue;
      best = i;
      clearance_index = k;
      least_deviation = deviation;
      break;
    }
  }
  if (best == 0) return false;
  const glm::vec3 start = midrib.places[best], end = start + lobe_reach * (tip - start);
  std::vector<glm::vec3> places = curve_to(midrib, best, end, plan_.arch);
  if (!is_clear(start, places, clear_of_bays[clearance_index], near_tip)) places = curve_to(midrib, best, end, 0);
  std::int32_t last = midrib.numbers[best];
  for (const glm::vec3& place : places) last = add(ribs, last, place);
  return true;
}

}  // namespace panicle::particles::leaf
