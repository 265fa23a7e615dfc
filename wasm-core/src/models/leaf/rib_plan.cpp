#include "models/leaf/rib_plan.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "models/leaf/messages.generated.hpp"
#include "models/leaf/midrib.hpp"
#include "models/leaf/shape/side_veins.hpp"
#include "models/leaf/sides.hpp"

namespace panicle::particles::leaf {
namespace {

// Builder of a leaf's ribs: the lines of main veins, which guide the particles of the finer ones.
class Planner {
 public:
  Planner(const RibPlan& plan, const Margin& margin, const Outline& outline, const glm::vec3& base)
      : plan_(plan),
        margin_(margin),
        outline_(outline),
        base_(base),
        sides_(margin),
        side_veins_(plan, margin, outline) {}

  // Ribs with the base alone.
  Ribs empty() const { return {{base_}, {-1}}; }
  // The place of a point of the margin.
  glm::vec3 tip_at(std::size_t point) const { return deep(margin_.points[point]); }

  // Plans the veins of a pinnate leaf: a midrib with a side vein to each lobe's tip, or the given number if there are
  // no lobes.
  std::vector<Ribs> pinnate(std::vector<std::string>& notes) const {
    std::vector<Ribs> all{empty()};
    const Midrib midrib = build_midrib(all[0], midline());
    std::uint32_t lobes = 0, hidden = 0;
    for (const std::size_t tip : margin_.tips) {
      if (tip == margin_.tip) continue;
      ++lobes;
      if (!side_veins_.to_lobe(all[0], midrib, tip_at(tip))) ++hidden;
    }
    if (hidden > 0) notes.push_back(message(messages::leaf::lobes_without_rib, hidden));
    if (lobes == 0 && plan_.secondaries > 0)
      side_veins_.add_veins(all[0], midrib, plan_.secondaries,
                            {.tip = margin_.tip, .last = margin_.points.size(), .fan = true});
    return all;
  }

  // Plans the veins of a palmate leaf: a main vein from the base to each lobe's tip, with side veins in its part.
  std::vector<Ribs> palmate(std::vector<std::string>& notes) const {
    std::vector<std::size_t> tips = margin_.tips;
    if (std::find(tips.begin(), tips.end(), margin_.tip) == tips.end()) tips.push_back(margin_.tip);
    if (tips.size() == 1) notes.push_back(message(messages::leaf::palmate_without_lobes));
    std::vector<Ribs> all;
    std::vector<Midrib> rays;
    float longest = 0;
    for (const std::size_t tip : tips) {
      all.push_back(empty());
      rays.push_back(build_midrib(all.back(), main_vein(base_, tip_at(tip), outline_)));
      longest = std::max(longest, rays.back().length());
    }
    const std::vector<Ribs> bare = all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const float count = std::floor(static_cast<float>(plan_.secondaries) * rays[i].length() / longest + 0.5f);
      Part part{.mains = bare, .own = i, .tip = tips[i], .last = margin_.points.size()};
      for (const std::size_t tip : tips) {
        if (tip < part.tip) part.first = std::max(part.first, tip);
        if (tip > part.tip) part.last = std::min(part.last, tip);
      }
      side_veins_.add_veins(all[i], rays[i], static_cast<std::uint32_t>(count), part);
    }
    return all;
  }

  // Plans the veins of a leaf with parallel venation: arcs from the base to the tip that divide the blade between the
  // midline and its sides evenly.
  std::vector<Ribs> parallel() const {
    const auto arcs = static_cast<std::int32_t>(plan_.secondaries);
    std::vector<Ribs> all;
    for (std::int32_t k = -arcs; k <= arcs; ++k) {
      Ribs ribs = empty();
      build_midrib(ribs, between_sides(static_cast<float>(k) / (static_cast<float>(arcs) + 0.7f)));
      all.push_back(std::move(ribs));
    }
    return all;
  }

  // A line from the base towards the tip at a `position` between the margin's sides: −1 on the left side, 0 in the
  // middle, 1 on the right; as far as the outline is open.
  std::vector<glm::vec3> between_sides(float position) const {
    constexpr float rows = 48;
    std::vector<glm::vec3> places{base_};
    for (float row = 1; row < rows; ++row) {
      const float share = before_tip * row / rows;
      const glm::vec3 next = 0.5f * ((1 + position) * sides_.right(share) + (1 - position) * sides_.left(share)),
                      from = places.back();
      if (places.size() == 1 ? !outline_.contains(next) : !outline_.holds(from, next)) break;
      places.push_back(next);
    }
    return places;
  }

  // The line of the midrib: straight to the tip where that is open, else midway between the sides.
  std::vector<glm::vec3> midline() const {
    const glm::vec3 tip = tip_at(margin_.tip), end = base_ + before_tip * (tip - base_);
    if (straight(base_, end, outline_)) return main_vein(base_, tip, outline_);
    // Steps across from side to side by the shorter way each time, so that both sides keep step round a bend.
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
        if (places.size() == 1) continue;  // the base is a corner: continue to where there is room
        break;
      }
      places.push_back(middle);
    }
    round_off(places, outline_, 20);
    return places;
  }

 private:
  const RibPlan& plan_;
  const Margin& margin_;
  const Outline& outline_;
  glm::vec3 base_;
  Sides sides_;
  SideVeins side_veins_;
};

}  // namespace

// Builds the ribs by the plan's kind of venation: one tree of ribs, or one for each main vein.
std::vector<Ribs> build_ribs(const RibPlan& plan, const Margin& margin, const Outline& outline, const glm::vec3& base,
                             std::vector<std::string>& notes) {
  const Planner planner(plan, margin, outline, base);
  if (plan.kind == RibKind::pinnate) return planner.pinnate(notes);
  if (plan.kind == RibKind::palmate) return planner.palmate(notes);
  if (plan.kind == RibKind::parallel) return planner.parallel();
  return {planner.empty()};
}

}  // namespace panicle::particles::leaf
