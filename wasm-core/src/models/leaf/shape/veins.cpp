#include "models/leaf/shape/veins.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <span>
#include <utility>

#include "models/leaf/messages.generated.hpp"
#include "models/leaf/rib_plan.hpp"
#include "models/particles/particle_system.hpp"
#include "models/particles/polish.hpp"
#include "models/particles/refusals.hpp"
#include "models/particles/scatter.hpp"
#include "models/particles/venation.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr std::uint32_t draft_particles = 700;
// In spacings: the distance from a rib within which trails are moved onto it, and the tolerance of simplification.
constexpr float bedded = 1.5f, bedded_again = 1.2f, simplified_within = 0.05f;
constexpr float smoothed_again = 0.25f;  // share of smoothing that rounds the corners where side veins join
constexpr float on_margin = 1e-3f;

// The place where the petiole joins: the origin, or the margin's nearest place if that is outside.
glm::vec3 base_of(const Outline& outline, std::vector<std::string>& notes) {
  if (outline.contains({0, 0, 0}) || outline.distance({0, 0, 0}) <= on_margin) return {0, 0, 0};
  glm::vec2 nearest = outline.points()[0];
  for (const glm::vec2& p : outline.points())
    if (glm::length(p) < glm::length(nearest)) nearest = p;
  notes.push_back(message(messages::leaf::petiole_outside));
  return {nearest.x, nearest.y, 0};
}

// Collects the parameters of the teeth.
Teeth teeth_of(const Values& values) {
  using enum Parameter;
  return {.count = values.whole(teeth),
          .depth = 0.01f * values[tooth_depth],
          .shape = static_cast<ToothShape>(values.whole(tooth_shape)),
          .entire = 0.01f * values[entire]};
}

// Collects the parameters of the ribs.
RibPlan plan_of(const Values& values) {
  using enum Parameter;
  return {.kind = static_cast<RibKind>(values.whole(ribs)),
          .secondaries = values.whole(secondaries),
          .angle = values[angle],
          .spacing = values[spacing],
          .offset = values[offset],
          .arch = values[arch],
          .course = static_cast<Course>(values.whole(course))};
}

// The rules of the particles' motion; lengths are multiples of `apart`, the mean distance of starts.
Rules rules_of(const Values& values, float apart) {
  using enum Parameter;
  return {.step = values[step] * apart,
          .merge = values[merge] * apart,
          .neighbourhood = values[neighbourhood] * apart,
          .pull = values[pull],
          .printed = values[rule] == 1,
          .join = values[join] * apart};
}

// Assigns each start to the tree of ribs that is nearest to it; of equally near ones to the first. Returns the starts
// of each tree.
std::vector<std::vector<glm::vec3>> starts_by_tree(const std::vector<glm::vec3>& starts, std::span<const Ribs> trees,
                                                   const Outline& outline) {
  if (trees.size() == 1) return {starts};
  // One grid of all: all trees share their first place.
  Ribs all{{trees[0].places[0]}, {-1}};
  std::vector<std::size_t> tree_of{0};
  for (std::size_t tree = 0; tree < trees.size(); ++tree) {
    const auto before = static_cast<std::int32_t>(all.places.size()) - 1;
    for (std::size_t i = 1; i < trees[tree].places.size(); ++i) {
      const std::int32_t next = trees[tree].next[i];
      all.places.push_back(trees[tree].places[i]);
      all.next.push_back(next > 0 ? next + before : 0);
      tree_of.push_back(tree);
    }
  }
  const RibGrid grid(all, outline.low(), outline.high());
  std::vector<std::vector<glm::vec3>> shares(trees.size());
  for (const glm::vec3& start : starts) shares[tree_of[grid.nearest(start).at]].push_back(start);
  return shares;
}

}  // namespace

// Grows the veins in the flat outline: margin and teeth, ribs, then particles that run from scattered starts to the
// ribs and down to the petiole. Fails for outlines that are not valid and when the limits' moves are used up.
Result<Veins> grow_veins(const LeafRequest& leaf_request, const Limits& limits, std::vector<std::string>& notes) {
  using enum Parameter;
  const Values& values = leaf_request.values;
  auto spanned = spline(leaf_request.outline);
  if (!spanned) return spanned.error();
  Margin margin = toothed(spanned.value(), teeth_of(values), notes);
  Outline outline(margin.points);
  Veins veins{
      .margin = std::move(margin), .outline = std::move(outline), .crowds = {}, .all = {}, .tally = {}, .timeline = {}};
  // The ribs, and the places where particles start.
  std::uint32_t count = values.whole(particles);
  if (leaf_request.draft) count = std::min(count, draft_particles);
  veins.spacing = std::sqrt(veins.outline.area() / static_cast<float>(count));
  const Rules rules = rules_of(values, veins.spacing);
  veins.stride = rules.step;
  note_on(rules_of(values, 1), notes);
  const glm::vec3 base = base_of(veins.outline, notes);
  const std::vector<Ribs> trees = build_ribs(plan_of(values), veins.margin, veins.outline, base, notes);
  const auto starts =
      scatter_all(veins.outline, static_cast<Pattern>(values.whole(pattern)), count, leaf_request.seed).points;
  if (starts.empty()) notes.push_back(message(messages::leaf::no_particle_fits));

  std::vector<std::unique_ptr<const Venation>> guides;
  for (const Ribs& ribs_of_target : trees)
    guides.push_back(std::make_unique<const Venation>(veins.outline, ribs_of_target, values[slant], veins.spacing));
  const auto shares = starts_by_tree(starts, trees, veins.outline);
  const double all = static_cast<double>(values[energy]) * static_cast<double>(starts.size());
  std::uint64_t moves = 0;
  // Runs the particles of each target on their own, and smooths their trails.
  for (std::size_t k = 0; k < guides.size(); ++k) {
    const Venation& guide = *guides[k];
    ParticleSystem crowd(shares[k], static_cast<double>(values[energy]), guide, rules);
    if (!crowd.run(limits.moves - moves)) return still_running(limits);
    moves += crowd.moves();
    Trails trails = crowd.trails();
    if (values[smoothing] > 0) {
      const float share = values[smoothing];
      move_onto_ribs(trails, guide.ribs(), guide, share * bedded * veins.spacing);
      smooth(trails, guide, share);
      move_onto_ribs(trails, guide.ribs(), guide, share * bedded_again * veins.spacing);
      smooth(trails, guide, share * smoothed_again);
      trails = simplified(trails, share * simplified_within * veins.spacing);
    }
    veins.tally.particles += static_cast<std::uint32_t>(shares[k].size());
    veins.tally.merges += crowd.merges();
    veins.tally.energy += crowd.arrived();
    veins.tally.stragglers += crowd.stragglers();
    veins.crowds.push_back(std::move(trails));
    veins.all.push_back(all);
  }
  veins.timeline = Timeline(veins.crowds, veins.stride);
  veins.tally.steps = veins.timeline.steps();
  return veins;
}

}  // namespace panicle::particles::leaf
