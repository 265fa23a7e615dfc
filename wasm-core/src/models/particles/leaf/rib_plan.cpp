#include "models/particles/leaf/rib_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "models/particles/leaf/sides.hpp"
#include "models/particles/waypoints.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float before_tip = 0.985f;  // where a main vein ends, of its length
constexpr float stride = 0.02f;       // of a rib's pieces, leaf lengths
constexpr float before_margin = 0.012f;
constexpr float first_secondary = 0.04f, last_secondary = 0.94f;  // along the midrib
constexpr float lobe_reach = 0.94f;                               // of the way into a lobe
constexpr float least_secondary = 0.03f;
// Where the blade reaches below the petiole, veins fan out from there: so far apart, to this angle, and no shorter than
// this.
constexpr float fan = 32, fan_end = 165, least_fan = 0.1f;  // degrees, leaf lengths
constexpr float detour_cell = 0.04f;                        // of the waypoints that a bent main vein follows

glm::vec2 flat(const glm::vec3& p) { return {p.x, p.y}; }
glm::vec3 deep(const glm::vec2& p) { return {p.x, p.y, 0}; }

glm::vec2 turned(const glm::vec2& v, float degrees) {
  const auto [sine, cosine] = sincos_degrees(degrees);
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

std::int32_t add(Ribs& ribs, std::int32_t at, const glm::vec3& place) {
  ribs.places.push_back(place);
  ribs.next.push_back(at);
  return static_cast<std::int32_t>(ribs.places.size()) - 1;
}

// Whether the straight way from the base, which is on the margin itself, lies in the blade.
bool straight(const glm::vec3& base, const glm::vec3& end, const Outline& outline) {
  const glm::vec3 start = base + 1e-3f * (end - base);
  return outline.contains(start) && outline.contains(end) && outline.holds(start, end);
}

// From the base to a tip, in pieces: straight where that is open, else round the corners.
std::vector<glm::vec3> main_vein(const glm::vec3& base, const glm::vec3& tip, const Outline& outline) {
  std::vector<glm::vec3> corners{base};
  const glm::vec3 end = base + before_tip * (tip - base);
  if (!straight(base, end, outline)) {
    Waypoints ways(outline, {tip}, detour_cell);
    glm::vec3 at = base;
    for (int k = 0; k < 64 && glm::distance(at, tip) > stride; ++k) {
      const glm::vec3 next = ways.next(at);
      if (next == tip || next == at) break;
      corners.push_back(at = next);
    }
    const glm::vec3 last = at + before_tip * (tip - at);
    if (outline.holds(at, last)) corners.push_back(last);
  } else {
    corners.push_back(end);
  }
  std::vector<glm::vec3> places{base};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const float count = std::max(1.0f, std::ceil(glm::distance(corners[i - 1], corners[i]) / stride));
    for (float k = 1; k <= count; ++k) places.push_back(corners[i - 1] + (k / count) * (corners[i] - corners[i - 1]));
  }
  // Round corners gently, where there is room.
  for (int pass = 0; corners.size() > 2 && pass < 40; ++pass)
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
      const glm::vec3 drawn = 0.5f * places[i] + 0.25f * (places[i - 1] + places[i + 1]);
      if (outline.distance(drawn) >= before_margin && outline.contains(drawn)) places[i] = drawn;
    }
  return places;
}

// A main vein among the places of its ribs.
struct Midrib {
  std::vector<glm::vec3> places;
  std::vector<std::int32_t> numbers;  // in the ribs
  std::vector<float> lengths;         // from the base

  float length() const { return lengths.back(); }
  std::size_t at(float length) const {
    const auto after = std::lower_bound(lengths.begin(), lengths.end(), length);
    return std::min<std::size_t>(static_cast<std::size_t>(after - lengths.begin()), places.size() - 1);
  }
  glm::vec2 heading(std::size_t i) const {
    const glm::vec3 way = places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0];
    const float size = glm::length(way);
    return size > 0 ? flat(way) / size : glm::vec2(0, 1);
  }
};

Midrib lay_midrib(Ribs& ribs, std::vector<glm::vec3> places) {
  Midrib midrib{std::move(places), {0}, {0}};
  for (std::size_t i = 1; i < midrib.places.size(); ++i) {
    midrib.numbers.push_back(add(ribs, midrib.numbers.back(), midrib.places[i]));
    midrib.lengths.push_back(midrib.lengths.back() + glm::distance(midrib.places[i - 1], midrib.places[i]));
  }
  return midrib;
}

// Where secondaries leave, from 0 at the base to 1 at the tip: their distances change evenly from 1 to `ratio`.
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

class Planner {
 public:
  Planner(const RibPlan& plan, const Margin& margin, const Outline& outline, const glm::vec3& base)
      : plan_(plan), margin_(margin), outline_(outline), base_(base), sides_(margin) {}

  // Walks from a midrib into the blade until the margin, or a place that `own` refuses, is near.
  template <class Own>
  void secondary(Ribs& ribs, const Midrib& midrib, float along, float side, float angle, float least,
                 const Own& own) const {
    const std::size_t root = midrib.at(along);
    const glm::vec2 heading = midrib.heading(root);
    std::vector<glm::vec3> places;
    glm::vec3 at = midrib.places[root];
    float gone = 0;
    // Half of the arch is behind when the secondary is as long as the midrib's way to the tip.
    const float scale = std::max(midrib.length() - along, 0.15f);
    for (int k = 0; k < 100; ++k) {
      const float bend = plan_.arch * gone / (gone + scale);
      const glm::vec3 next = at + stride * deep(turned(heading, side * angle * std::max(1 - 2.2f * bend, 0.0f)));
      // The base is on the margin itself.
      const float room = std::min(before_margin, 0.4f * (gone + stride));
      if (!outline_.contains(next) || outline_.distance(next) < room || !own(next)) break;
      places.push_back(at = next);
      gone += stride;
    }
    if (gone < least) return;
    std::int32_t last = midrib.numbers[root];
    for (const glm::vec3& place : places) last = add(ribs, last, place);
  }

  template <class Own>
  void secondaries(Ribs& ribs, const Midrib& midrib, std::uint32_t count, const Own& own) const {
    for (const float side : {-1.0f, 1.0f})
      for (const float share : shares(count, plan_.spacing, side > 0 ? plan_.offset : 0.0f)) {
        const float along = first_secondary + share * (last_secondary - first_secondary);
        if (along < last_secondary)
          secondary(ribs, midrib, along * midrib.length(), side, plan_.angle, least_secondary, own);
      }
  }

  // Into what of the blade is below the base.
  void basal_fan(Ribs& ribs, const Midrib& midrib) const {
    for (const float side : {-1.0f, 1.0f})
      for (float angle = plan_.angle + fan; angle <= fan_end; angle += fan)
        secondary(ribs, midrib, 0, side, angle, least_fan, [](const glm::vec3&) { return true; });
  }

  // From where the midrib is seen at about the angle asked for, to a lobe's tip. False where no place sees it.
  bool to_lobe(Ribs& ribs, const Midrib& midrib, const glm::vec3& tip) const {
    std::size_t best = 0;
    float least = 1e9f;
    for (std::size_t i = 1; i + 2 < midrib.places.size(); ++i) {
      const glm::vec3 from = midrib.places[i];
      const glm::vec2 way = flat(tip - from), heading = midrib.heading(i);
      const float angle = arc_cosine(glm::dot(way, heading) / std::max(glm::length(way), 1e-6f)) * 180 / pi;
      const float off = std::fabs(angle - plan_.angle);
      if (!(off < least) || !outline_.holds(from, from + lobe_reach * (tip - from))) continue;
      best = i;
      least = off;
    }
    if (best == 0) return false;
    const glm::vec3 from = midrib.places[best], end = from + lobe_reach * (tip - from);
    // Steeper first, then along the lobe.
    const glm::vec2 heading = midrib.heading(best);
    const float ahead = glm::dot(flat(end - from), heading);
    const glm::vec3 corner = 0.5f * (from + end) - (0.35f * plan_.arch * ahead) * deep(heading);
    const bool bent = outline_.holds(from, corner) && outline_.holds(corner, end);
    const float count = std::max(2.0f, std::ceil(glm::distance(from, end) / stride));
    std::int32_t last = midrib.numbers[best];
    for (float k = 1; k <= count; ++k) {
      const float t = k / count;
      const glm::vec3 straight = from + t * (end - from);
      const glm::vec3 arc = (1 - t) * (1 - t) * from + 2 * t * (1 - t) * corner + t * t * end;
      last = add(ribs, last, bent ? arc : straight);
    }
    return true;
  }

  Ribs empty() const { return {{base_}, {-1}}; }
  glm::vec3 tip_at(std::size_t point) const { return deep(margin_.points[point]); }

  std::vector<Ribs> pinnate(std::vector<std::string>& notes) const {
    std::vector<Ribs> all{empty()};
    const Midrib midrib = lay_midrib(all[0], midline());
    std::uint32_t lobes = 0, hidden = 0;
    for (const std::size_t tip : margin_.tips) {
      if (tip == margin_.tip) continue;
      ++lobes;
      if (!to_lobe(all[0], midrib, tip_at(tip))) ++hidden;
    }
    if (hidden > 0)
      notes.push_back("The midrib sees " + std::to_string(hidden) + " lobe tips from nowhere: they have no rib.");
    if (lobes == 0 && plan_.secondaries > 0) {
      secondaries(all[0], midrib, plan_.secondaries, [](const glm::vec3&) { return true; });
      basal_fan(all[0], midrib);
    }
    return all;
  }

  std::vector<Ribs> palmate(std::vector<std::string>& notes) const {
    std::vector<std::size_t> tips = margin_.tips;
    if (std::find(tips.begin(), tips.end(), margin_.tip) == tips.end()) tips.push_back(margin_.tip);
    if (tips.size() == 1)
      notes.push_back(
          "A palmate leaf has a main vein to each lobe tip, and this outline marks none but the leaf's own.");
    std::vector<Ribs> all;
    std::vector<Midrib> rays;
    float longest = 0;
    for (const std::size_t tip : tips) {
      all.push_back(empty());
      rays.push_back(lay_midrib(all.back(), main_vein(base_, tip_at(tip), outline_)));
      longest = std::max(longest, rays.back().length());
    }
    const std::vector<Ribs> bare = all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto own = [&](const glm::vec3& p) {
        const float from_own = bare[i].nearest(p).distance;
        for (std::size_t k = 0; k < bare.size(); ++k)
          if (k != i && bare[k].nearest(p).distance < from_own + before_margin) return false;
        return true;
      };
      const float count = std::floor(static_cast<float>(plan_.secondaries) * rays[i].length() / longest + 0.5f);
      secondaries(all[i], rays[i], static_cast<std::uint32_t>(count), own);
    }
    return all;
  }

  // Arcs that share the blade between the midline and its sides evenly.
  std::vector<Ribs> parallel() const {
    const auto arcs = static_cast<std::int32_t>(plan_.secondaries);
    std::vector<Ribs> all;
    for (std::int32_t k = -arcs; k <= arcs; ++k) {
      Ribs ribs = empty();
      lay_midrib(ribs, between_sides(static_cast<float>(k) / (static_cast<float>(arcs) + 0.7f)));
      all.push_back(std::move(ribs));
    }
    return all;
  }

  // From the base towards the tip between the margin's sides, −1 on the left one, 1 on the right; as far as that is
  // open.
  std::vector<glm::vec3> between_sides(float aside) const {
    constexpr float rows = 48;
    std::vector<glm::vec3> places{base_};
    for (float row = 1; row < rows; ++row) {
      const float share = before_tip * row / rows;
      const glm::vec3 next = 0.5f * ((1 + aside) * sides_.right(share) + (1 - aside) * sides_.left(share)),
                      from = places.back();
      if (places.size() == 1 ? !outline_.contains(next) : !outline_.holds(from, next)) break;
      places.push_back(next);
    }
    return places;
  }

  // Straight to the tip where that is open, else midway between the sides.
  std::vector<glm::vec3> midline() const {
    const glm::vec3 tip = tip_at(margin_.tip), end = base_ + before_tip * (tip - base_);
    if (straight(base_, end, outline_)) return main_vein(base_, tip, outline_);
    // Across from side to side by the shorter way each time, so that both keep step round a bend.
    constexpr float rows = 96;
    std::vector<glm::vec3> places{base_};
    for (float right = 0, left = 0; right + left < 2 * before_tip * rows;) {
      const glm::vec3 one = sides_.right(right / rows), other = sides_.left(left / rows);
      const glm::vec3 on = sides_.right(std::min(right + 1, rows) / rows),
                      beyond = sides_.left(std::min(left + 1, rows) / rows);
      const bool first = left >= rows || (right < rows && glm::distance(on, other) <= glm::distance(one, beyond));
      (first ? right : left) += 1;
      const glm::vec3 middle = first ? 0.5f * (on + other) : 0.5f * (one + beyond);
      if (glm::distance(middle, places.back()) < stride) continue;
      if (places.size() == 1 ? !outline_.contains(middle) : !outline_.holds(places.back(), middle)) {
        if (places.size() == 1) continue;  // the base is a corner: on to where there is room
        break;
      }
      places.push_back(middle);
    }
    for (int pass = 0; pass < 20; ++pass)
      for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        const glm::vec3 drawn = 0.5f * places[i] + 0.25f * (places[i - 1] + places[i + 1]);
        if (outline_.contains(drawn) && outline_.distance(drawn) >= before_margin) places[i] = drawn;
      }
    return places;
  }

 private:
  const RibPlan& plan_;
  const Margin& margin_;
  const Outline& outline_;
  glm::vec3 base_;
  Sides sides_;
};

}  // namespace

std::vector<Ribs> lay_ribs(const RibPlan& plan, const Margin& margin, const Outline& outline, const glm::vec3& base,
                           std::vector<std::string>& notes) {
  const Planner planner(plan, margin, outline, base);
  if (plan.kind == RibKind::pinnate) return planner.pinnate(notes);
  if (plan.kind == RibKind::palmate) return planner.palmate(notes);
  if (plan.kind == RibKind::parallel) return planner.parallel();
  return {planner.empty()};
}

}  // namespace panicle::particles::leaf
