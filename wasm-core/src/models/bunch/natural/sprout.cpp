#include "models/bunch/natural/sprout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/random.hpp"
#include "models/bunch/derived_bunch.hpp"
#include "models/bunch/grammars.hpp"
#include "models/bunch/messages.generated.hpp"
#include "models/bunch/natural/individual.hpp"
#include "models/bunch/natural/ripening.hpp"
#include "models/bunch/natural/wing.hpp"
#include "models/bunch/paper/skeleton_drawing.hpp"
#include "models/bunch/remarks.hpp"
#include "models/bunch/roles.hpp"

namespace panicle::bunch {

// The rachis is the main axis of the bunch.

namespace {

constexpr float wider_by = 1.15f, max_wider = 2;  // factor for nodes' distances, where the plan has too many flowers
constexpr float farthest = 1e5f;                  // limit of coordinates, millimetres from p1
constexpr Parameter used_by_plan[] = {Parameter::wi};

// A drawing that stops at the limit of flowers.
class Inflorescence final : public SkeletonDrawing {
 public:
  using SkeletonDrawing::SkeletonDrawing;
  // Called by the turtle, the drawing pen of the L-system, for each flower.
  void sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) override {
    if (within(balls.size(), limits().organs, messages::bunch::flower_limit))
      SkeletonDrawing::sphere(turtle, radius, lineage);
  }
};

// The width of a wing's rachis (the wing is the second bunch) over the first bunch's, for a wing of that size.
float rachis_factor_for(float wing) { return 0.5f + 0.5f * wing; }

// A planned bunch with its bound text, not drawn yet.
struct PlannedBunch {
  NaturalPlan plan;
  std::shared_ptr<const lsystem::BoundProgram> text;
};

// Plans and draws bunches with corrected assumptions about the text, until the plan agrees with the drawing.
class SproutBuilder {
 public:
  SproutBuilder(const BunchRequest& request, const Values& values, const Limits& limits,
                std::shared_ptr<const lsystem::Program> program)
      : request_(request), values_(values), limits_(limits), program_(std::move(program)) {}

  // Plans a bunch for a profile, its outline; again with the text's own constants if those differ from the assumed
  // ones. `slender`: the width of its rachis over the width that the berries require.
  Result<PlannedBunch> plan_bunch(const Profile& profile, std::uint64_t seed, float slender) {
    auto planned = plan_once(profile, seed, slender);
    if (!planned) return planned;
    const TextConstants found = constants_of(*planned->text, constants_);
    if (found == constants_) return planned;
    constants_ = found;
    return plan_once(profile, seed, slender);
  }

  // Draws the bunch and the second where there is one.
  Result<Sprout> draw(SkeletonDrawing& drawing, std::vector<std::string>& notes) {
    const Profile profile =
        individual(values_.profile(), request_.seed, values_[Parameter::variability], values_[Parameter::count] > 0);
    Sprout sprout;
    sprout.profile = profile;
    if (const Diagnostic error = draw_one(profile, request_.seed, 1, drawing, sprout, notes);
        error.reason != Reason::none)
      return error;
    const std::size_t second_from = drawing.attached_balls();
    if (values_[Parameter::wing] > 0) {
      sprout.second_root = static_cast<std::int32_t>(drawing.segments.size());
      const float wing = values_[Parameter::wing] * wing_share(request_.seed, values_[Parameter::variability]);
      const Diagnostic error =
          draw_one(scaled(profile, wing), second_seed(request_.seed), rachis_factor_for(wing), drawing, sprout, notes);
      if (error.reason != Reason::none) return error;
    }
    loose_balls_ = drawing.finish();
    sprout.internodes = std::move(drawing.internodes);
    if (sprout.second_root >= static_cast<std::int32_t>(sprout.internodes.size())) sprout.second_root = -1;
    if (sprout.second_root >= 0) insert_wing_stalk(sprout, drawing.balls);
    sprout.flowers = flowers_of(sprout.internodes, drawing.balls, second_from);
    return sprout;
  }

  // Corrects the number of flowers that the plan assumes, if it was wrong. Returns whether the plan changes.
  bool correct_flower_count(const Sprout& sprout) {
    const bool counts =
        values_[Parameter::count] > 0 ||
        std::any_of(sprout.plans.begin(), sprout.plans.end(), [](const NaturalPlan& plan) { return plan.overfull; });
    const float found = flowers_per_end(sprout.internodes, sprout.flowers);
    if (!counts || found == 0 || found == constants_.flowers_per_end) return false;
    constants_.flowers_per_end = found;
    return true;
  }

  // Puts nodes farther apart, for plans that drew more flowers than allowed. Returns false after a few times: a text
  // need not use the plan.
  bool widen_spacing() {
    if (constants_.wider >= max_wider) return false;
    constants_.wider *= wider_by;
    return true;
  }

  // The number of balls of the last drawing that hang on nothing.
  std::uint32_t loose_balls() const { return loose_balls_; }

 private:
  // Plans a bunch with the assumed constants, and binds the text to the plan's values.
  Result<PlannedBunch> plan_once(const Profile& profile, std::uint64_t seed, float slender) const {
    const float start = 360 * random_unit(seed, hash_text("first axis"), 0);
    NaturalPlan plan = make_natural_plan(profile, values_, static_cast<float>(limits_.bodies), constants_, start);
    plan.rachis_width *= slender;
    auto text = lsystem::bind(program_, inputs_for(plan, profile, values_), limits_);
    if (!text) return text.error();
    return PlannedBunch{std::move(plan), std::move(text.value())};
  }

  // The stalk of a wing under the greatest load that has hung from it so far: the load does not rise as berries dry. A
  // requested count is shared by both bunches, in proportion to their room.
  WingStalk stalk_of(const NaturalPlan& wing, const NaturalPlan& bunch) const {
    constexpr float grams = 1.05e-3f;  // a cubic millimetre of berries
    const float now = size_at(std::min(values_[Parameter::age], 100.0f));
    const bool counted = values_[Parameter::count] > 0;
    const float share = counted ? wing.envelope.volume() / (wing.envelope.volume() + bunch.envelope.volume()) : 1;
    const float load = grams * wing.berry * std::min(share * wing.berries, wing.room) * now * now * now;
    return {fork_height(values_[Parameter::size]), values_[Parameter::wing_angle],
            static_cast<std::size_t>(values_[Parameter::wing_side]), load};
  }

  // Inserts the stalk between the peduncle and the second bunch.
  void insert_wing_stalk(Sprout& sprout, std::vector<Ball>& balls) const {
    const NaturalPlan &bunch = sprout.plans[0], &wing = sprout.plans[1];
    std::vector<Internode> stalk =
        wing_stalk(stalk_of(wing, bunch), sprout.bounds[1].stance, bunch.rachis_width, wing.rachis_width);
    const auto count = static_cast<std::int32_t>(stalk.size()), root = sprout.second_root;
    const float units = 1 / values_[Parameter::unit];
    for (Internode& piece : stalk) {
      scale(piece, units);
      if (piece.parent >= 0) piece.parent += root;
    }
    std::vector<Internode>& all = sprout.internodes;
    for (std::size_t i = static_cast<std::size_t>(root); i < all.size(); ++i)
      all[i].parent = all[i].parent < 0 ? root + count - 1 : all[i].parent + count;
    all.insert(all.begin() + root, stalk.begin(), stalk.end());
    for (Ball& ball : balls)
      if (ball.segment >= root) ball.segment += count;
  }

  // Plans, derives and draws one bunch of the plant: the main bunch first, then the wing on its stalk. The trace is
  // that of the main bunch.
  Diagnostic draw_one(const Profile& profile, std::uint64_t seed, float slender, SkeletonDrawing& drawing,
                      Sprout& sprout, std::vector<std::string>& notes) {
    auto planned = plan_bunch(profile, seed, slender);
    if (!planned) return planned.error();
    auto derived_bunch = derive_bunch(std::move(planned->text), seed, request_.steps, limits_);
    if (!derived_bunch) return derived_bunch.error();
    const bool first = sprout.plans.empty();
    derived_bunch->first_axis = first ? 0 : static_cast<std::int32_t>(sprout.plans[0].arm.size());
    const Stance stance = first ? Stance{}
                                : wing_stance(stalk_of(planned->plan, sprout.plans[0]), sprout.bounds[0].envelope,
                                              planned->plan.envelope);
    derived_bunch->stance = {stance.lean, stance.side, stance.foot / values_[Parameter::unit]};
    if (first) remark_text(*derived_bunch->bound, values_, "natural", used_by_plan, notes);
    std::vector<std::string> repeated_notes;
    drawing.begin(*derived_bunch->bound, roles_of(*program_, first ? notes : repeated_notes), !first,
                  derived_bunch->first_axis);
    sprout.bounds.push_back({planned->plan.envelope, stance});
    sprout.plans.push_back(std::move(planned->plan));
    if (first) {
      auto trace = trace_derivation(derived_bunch.value(), request_, limits_);
      if (!trace) return trace.error();
      sprout.trace = std::move(trace.value());
    }
    lsystem::DerivationTrace* const trace = first && sprout.trace ? &*sprout.trace : nullptr;
    drawing.set_trace(trace);
    const Diagnostic error = interpret(derived_bunch.value(), limits_, drawing, trace);
    return error.reason == Reason::none ? drawing.trouble() : error;
  }

  const BunchRequest& request_;
  const Values& values_;
  const Limits& limits_;
  std::shared_ptr<const lsystem::Program> program_;
  TextConstants constants_;
  std::uint32_t loose_balls_ = 0;
};

// Converts internodes from the paper's unit, `unit` millimetres; an error if one is too far away.
Diagnostic to_millimetres(std::vector<Internode>& internodes, float unit) {
  for (Internode& internode : internodes) {
    scale(internode, unit);
    const glm::vec3& end = internode.end;
    if (!(std::abs(end.x) < farthest && std::abs(end.y) < farthest && std::abs(end.z) < farthest))
      return {Reason::limit, message(messages::bunch::too_far)};
  }
  return {};
}

}  // namespace

// Draws the skeleton and flowers of all bunches of the plant. Draws again with wider spacing if there are too many
// flowers, and once with the number of flowers that the first drawing had.
Result<Sprout> sprout(const BunchRequest& request, const Values& values, const Limits& limits,
                      std::vector<std::string>& notes) {
  auto program = program_for(request, grammars::grape_bunch_4, limits);
  if (!program) return program.error();
  SproutBuilder builder(request, values, limits, std::move(program.value()));
  for (bool is_corrected = false;;) {
    Inflorescence drawing(limits);
    std::vector<std::string> drawing_notes;
    auto drawn = builder.draw(drawing, drawing_notes);
    if (!drawn && drawing.balls.size() >= limits.organs && builder.widen_spacing()) continue;
    if (!drawn) return drawn.error();
    if (!std::exchange(is_corrected, true) && builder.correct_flower_count(drawn.value())) continue;
    remark_drawn({drawn->internodes.size(), drawn->flowers.size(), builder.loose_balls(), false}, drawing_notes);
    notes.insert(notes.end(), drawing_notes.begin(), drawing_notes.end());
    const Diagnostic astray = to_millimetres(drawn->internodes, values[Parameter::unit]);
    if (astray.reason != Reason::none) return astray;
    return drawn;
  }
}

}  // namespace panicle::bunch
