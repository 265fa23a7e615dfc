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
constexpr int most_strides = 100;
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
constexpr float arch_clear = 0.32f, least_clear = 0.014f, most_clear = 0.05f, turn = 2, most_turned = 16;
constexpr float foreseen = 2.5f;    // strides
constexpr float below_next = 0.7f;  // of that distance: nearer than this to the next vein they end

glm::vec2 turned(const glm::vec2& v, float degrees) {
  const auto [sine, cosine] = sincos_degrees(degrees);
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

// The places of secondaries, from 0 at the base to 1 at the tip: their distances change evenly from 1 to `ratio`.
std::vector<float> shares(std::uint32_t count, float ratio, float shift) {
  std::vector<float> all;
  float sum = 0;
  const auto n = static_cast<float>(count);
  const auto gap = [&](float k) { return 1 + (ratio - 1) * k / n; };
  for (float k = 0; k < n; ++k) {
    all.push_back(sum + shift * gap(k));
    sum += gap(k);
  }
  for (float& share : all) share /= sum;
  return all;
}

bool within(std::span<const glm::vec3> places, const glm::vec3& p, float reach) {
  return std::any_of(places.begin(), places.end(),
                     [&](const glm::vec3& place) { return glm::distance(place, p) < reach; });
}

// Assigns a tooth to each vein, −1 for none: in the same order, none twice, with the least total distance from the
// veins' own ends. Costs of the first i veins with the first k teeth, as in sequence alignment.
std::vector<std::int32_t> matched(std::span<const glm::vec3> ends, std::span<const glm::vec3> teeth, float farthest) {
  const std::size_t n = ends.size(), m = teeth.size();
  std::vector<float> cost((n + 1) * (m + 1), 0);
  const auto at = [&](std::size_t i, std::size_t k) -> float& { return cost[i * (m + 1) + k]; };
  const auto both = [&](std::size_t i, std::size_t k) {
    return at(i - 1, k - 1) + glm::distance(ends[i - 1], teeth[k - 1]);
  };
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t k = 0; k <= m; ++k) {
      at(i, k) = at(i - 1, k) + farthest;
      if (k > 0) at(i, k) = std::min({at(i, k), at(i, k - 1), both(i, k)});
    }
  std::vector<std::int32_t> tooth(n, -1);
  for (std::size_t i = n, k = m; i > 0 && k > 0;) {
    if (at(i, k) == at(i, k - 1)) {
      --k;
    } else if (at(i, k) == both(i, k)) {
      tooth[--i] = static_cast<std::int32_t>(--k);
    } else {
      --i;
    }
  }
  return tooth;
}

}  // namespace

bool Part::holds(const glm::vec3& p) const {
  if (mains.empty()) return true;
  const float from_own = mains[own].nearest(p).distance;
  for (std::size_t k = 0; k < mains.size(); ++k)
    if (k != own && mains[k].nearest(p).distance < from_own + before_margin) return false;
  return true;
}

SideVeins::SideVeins(const RibPlan& plan, const Margin& margin, const Outline& outline)
    : plan_(plan), margin_(margin), outline_(outline) {}

// The starts from the base up, first those that fan out below it.
std::vector<SideVeins::Start> SideVeins::starts(const Midrib& midrib, std::uint32_t count, float side, bool fan) const {
  std::vector<Start> all;
  if (fan)
    for (float angle = plan_.angle + fan_apart; angle <= fan_end; angle += fan_apart)
      all.insert(all.begin(), {0, angle, least_fan});
  for (const float share : shares(count, plan_.spacing, side > 0 ? plan_.offset : 0.0f)) {
    const float along = first_secondary + share * (last_secondary - first_secondary);
    if (along < last_secondary) all.push_back({midrib.at(along * midrib.length()), plan_.angle, least_secondary});
  }
  return all;
}

void SideVeins::add_veins(Ribs& ribs, const Midrib& midrib, std::uint32_t count, const Part& part) const {
  const float apart = midrib.length() / static_cast<float>(std::max(count, 1u));
  const float clear = std::clamp(arch_clear * apart, least_clear, most_clear);
  for (const float side : {-1.0f, 1.0f}) {
    const std::vector<Start> from = starts(midrib, count, side, part.fan);
    std::vector<Vein> veins(from.size());
    // From the tip down, so that each has the next above it.
    for (std::size_t i = from.size(); i-- > 0;) {
      const Vein* above = i + 1 < veins.size() ? &veins[i + 1] : nullptr;
      veins[i] = plan_.course == Course::arch ? arched(midrib, from[i], side, part, above, clear)
                                              : walk(midrib, from[i], side, part);
    }
    if (plan_.course == Course::teeth) into_teeth(midrib, veins, teeth(side, part));
    for (const Vein& vein : veins) {
      std::int32_t last = midrib.numbers[vein.root];
      for (const glm::vec3& place : vein.places) last = add(ribs, last, place);
    }
  }
}

// The angle of a vein to its main vein after a length of `gone`. Half of the arch is behind when it is as long as the
// way ahead.
float SideVeins::bent(const Midrib& midrib, const Start& start, float gone) const {
  const float ahead = std::max(midrib.length() - midrib.lengths[start.root], least_ahead);
  return start.angle * std::max(1 - turns_by * (plan_.arch * gone / (gone + ahead)), 0.0f);
}

// Walks from a start into the blade until it is near the margin, or near another main vein's part.
SideVeins::Vein SideVeins::walk(const Midrib& midrib, const Start& start, float side, const Part& part) const {
  const glm::vec2 heading = midrib.heading(start.root);
  Vein vein{start.root, {}};
  glm::vec3 at = midrib.places[start.root];
  float gone = 0;
  for (int k = 0; k < most_strides; ++k) {
    const glm::vec3 next = at + stride * deep(turned(heading, side * bent(midrib, start, gone)));
    vein.at_margin =
        !outline_.contains(next) || !outline_.keeps_off(next, std::min(before_margin, near_root * (gone + stride)));
    if (vein.at_margin || !part.holds(next)) break;
    vein.places.push_back(at = next);
    gone += stride;
  }
  if (gone < start.least) vein.places.clear();
  return vein;
}

// Walks to the requested distance from the margin, then along the margin towards the tip, until just below the next
// vein.
SideVeins::Vein SideVeins::arched(const Midrib& midrib, const Start& start, float side, const Part& part,
                                  const Vein* above, float clear) const {
  const glm::vec2 heading = midrib.heading(start.root);
  Vein vein{start.root, {}};
  glm::vec3 at = midrib.places[start.root];
  float gone = 0, angle = start.angle;
  for (int k = 0; k < most_strides; ++k) {
    const float room = std::min(clear, near_root * (gone + stride));
    const auto ahead = [&](float strides) { return at + strides * stride * deep(turned(heading, side * angle)); };
    const auto free = [&](const glm::vec3& p, float reach) {
      return outline_.contains(p) && outline_.keeps_off(p, reach);
    };
    angle = std::min(angle, bent(midrib, start, gone));
    for (float by = 0; by < most_turned && !(free(ahead(1), room) && free(ahead(foreseen), room)); by += turn)
      angle -= turn;
    const glm::vec3 next = ahead(1);
    if (!free(next, std::min(room, before_margin)) || !part.holds(next)) break;
    const float near = below_next * clear;
    if (above && within(above->places, next, near)) break;
    if (angle < 0 && within(midrib.places, next, near)) break;
    vein.places.push_back(at = next);
    gone += stride;
  }
  if (gone < start.least) vein.places.clear();
  return vein;
}

// The tips of the teeth on one side of a part, from its base up.
std::vector<glm::vec3> SideVeins::teeth(float side, const Part& part) const {
  std::vector<glm::vec3> all;
  for (const std::size_t tooth : margin_.teeth) {
    const bool right = part.first < tooth && tooth < part.tip, left = part.tip < tooth && tooth < part.last;
    const glm::vec3 place = deep(margin_.points[tooth]);
    if ((side < 0 ? right : left) && part.holds(place)) all.push_back(place);
  }
  if (side > 0) std::reverse(all.begin(), all.end());
  return all;
}

void SideVeins::into_teeth(const Midrib& midrib, std::span<Vein> veins, std::span<const glm::vec3> teeth) const {
  std::vector<std::size_t> reaching;
  std::vector<glm::vec3> ends;
  for (std::size_t i = 0; i < veins.size(); ++i)
    if (veins[i].at_margin && !veins[i].places.empty()) {
      reaching.push_back(i);
      ends.push_back(veins[i].places.back());
    }
  const std::vector<std::int32_t> tooth = matched(ends, teeth, farthest_tooth * midrib.length());
  for (std::size_t i = 0; i < reaching.size(); ++i) {
    if (tooth[i] < 0) continue;
    Vein& vein = veins[reaching[i]];
    const glm::vec3 from = midrib.places[vein.root], tip = teeth[static_cast<std::size_t>(tooth[i])];
    const glm::vec3 end = tip + std::min(before_tooth / glm::distance(from, tip), 1.0f) * (from - tip);
    for (const float bend : {plan_.arch, 0.0f}) {
      std::vector<glm::vec3> places = way(midrib, vein.root, end, bend);
      if (!open(from, places, before_margin, near_tooth)) continue;
      vein.places = std::move(places);
      break;
    }
  }
}

// A line from the main vein to a place: steeper first, then along the lobe.
std::vector<glm::vec3> SideVeins::way(const Midrib& midrib, std::size_t root, const glm::vec3& end, float bend) const {
  const glm::vec3 from = midrib.places[root];
  const glm::vec2 heading = midrib.heading(root);
  const float ahead = glm::dot(flat(end - from), heading);
  const glm::vec3 corner = 0.5f * (from + end) - (bow * bend * ahead) * deep(heading);
  const float count = std::max(2.0f, std::ceil(glm::distance(from, end) / stride));
  std::vector<glm::vec3> places;
  for (float k = 1; k <= count; ++k) {
    const float t = k / count;
    places.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * corner + t * t * end);
  }
  return places;
}

// Whether a line lies in the blade and that far off its margin, less near its root and, as a share of the distance,
// near its end.
bool SideVeins::open(const glm::vec3& from, std::span<const glm::vec3> places, float clear, float near_end) const {
  glm::vec3 before = from;
  for (const glm::vec3& place : places) {
    const float room =
        std::min({clear, near_root * glm::distance(from, place), near_end * glm::distance(place, places.back())});
    if (!outline_.contains(place) || !outline_.holds(before, place) || !outline_.keeps_off(place, room)) return false;
    before = place;
  }
  return true;
}

bool SideVeins::to_lobe(Ribs& ribs, const Midrib& midrib, const glm::vec3& tip) const {
  std::size_t best = 0, level = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 1; i + 2 < midrib.places.size(); ++i) {
    const glm::vec3 from = midrib.places[i], end = from + lobe_reach * (tip - from);
    const glm::vec2 along = flat(tip - from);
    const float angle = arc_cosine(glm::dot(along, midrib.heading(i)) / std::max(glm::length(along), 1e-6f)) * 180 / pi;
    if (!outline_.holds(from, end)) continue;
    const std::vector<glm::vec3> straight = way(midrib, i, end, 0);
    for (std::size_t k = 0; k < std::size(clear_of_bays); ++k) {
      const float off = std::fabs(angle - plan_.angle) + worth[k];
      if (!(off < least) || !open(from, straight, clear_of_bays[k], near_tip)) continue;
      best = i;
      level = k;
      least = off;
      break;
    }
  }
  if (best == 0) return false;
  const glm::vec3 from = midrib.places[best], end = from + lobe_reach * (tip - from);
  std::vector<glm::vec3> places = way(midrib, best, end, plan_.arch);
  if (!open(from, places, clear_of_bays[level], near_tip)) places = way(midrib, best, end, 0);
  std::int32_t last = midrib.numbers[best];
  for (const glm::vec3& place : places) last = add(ribs, last, place);
  return true;
}

}  // namespace panicle::particles::leaf
