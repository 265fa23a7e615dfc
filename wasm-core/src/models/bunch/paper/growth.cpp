#include "models/bunch/paper/growth.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "expression/number_text.hpp"
#include "foundation/random.hpp"
#include "lsystem_plant/messages.generated.hpp"
#include "models/bunch/messages.generated.hpp"

namespace panicle::bunch {

// The rachis is the main axis of the bunch; a pedicel is the stalk of one flower or berry.

// Prepares to draw the paper's bunch: parts query for room among the spheres of those that are there. `largest`: the
// greatest radius of a berry.
PaperGrowth::PaperGrowth(const InteractionOptions& options, const Limits& limits, float largest)
    : SkeletonDrawing(limits), options_(options), structure_(largest) {}

// Begins to draw a text, whose constants are read by name; the second bunch has axes from the number `first_axis` on.
void PaperGrowth::begin(const lsystem::BoundProgram& text, const SymbolRoles& roles, bool second, std::uint64_t seed,
                        std::int32_t first_axis) {
  SkeletonDrawing::begin(text, roles, second, first_axis);
  constants_.narrowing = lsystem::constant(text, "r_w", 1);
  constants_.withered_length = lsystem::constant(text, "l_w", 10);
  constants_.berry_radius = lsystem::constant(text, "b_r", 0);
  seed_ = seed;
}

// Describes the organ for which a module queries room: a pedicel probes with its berry, another internode with half its
// width after narrowing. `address` determines the random direction in which it evades a push of 0.
Newborn PaperGrowth::newborn(const Question& question, const lsystem::Turtle& turtle, std::span<const float> parameters,
                             std::uint64_t address) const {
  const ParameterSlots& slots = question.slots;
  Newborn newborn;
  newborn.pedicel = question.pedicel;
  newborn.flat = slots.phi == 0;
  newborn.length = parameters[slots.length];
  newborn.radius = !question.pedicel ? question.width * constants_.narrowing * 0.5f
                   : slots.berry     ? parameters[slots.berry]
                                     : constants_.berry_radius;
  const auto parent = static_cast<std::size_t>(segment_of(turtle));
  if (turtle.line >= 0 && parent < tips_.size()) newborn.parent = tips_[parent];
  newborn.tie = random_direction(seed_, hash_text("tie"), address);
  return newborn;
}

// Answers a query of the text for room: looks for a free direction and sets the angles; without room a pedicel withers
// and an axis ends.
SkeletonDrawing::Answer PaperGrowth::answer(const Question& question, const lsystem::Turtle& turtle,
                                            std::span<float> parameters, const lsystem::Lineage& lineage) {
  const ReservedRoom* const reserved = find_reserved(lineage.address);
  const bool rachis = is_rachis(lineage.parent_symbol);
  Room room;
  std::string why;
  if (reserved) {
    room = reserved->room;
  } else if ((!in_rachis_pass_ || rachis) &&
             within(structure_.spheres().size(), limits().spheres, messages::lsystem_plant::sphere_limit)) {
    const Newborn newcomer = newborn(question, turtle, parameters, lineage.address);
    room = find_room(structure_, turtle, newcomer, options_);
    if (is_traced(lineage)) why = describe_room(room, newcomer);
  }
  parameters[question.slots.theta] = room.theta;
  if (question.slots.phi) parameters[question.slots.phi] = room.phi;
  tip_of_ = lineage.address;
  tip_ = SphereGrid::no_sphere;
  if (!in_rachis_pass_ && !room.found) refused_ = true;
  if (room.found) {
    const std::uint32_t sphere = reserved ? reserved->tip : structure_.add(room.sphere);
    if (!reserved && sphere != SphereGrid::no_sphere) owners_.push_back({lineage.module, question.pedicel, second()});
    if (!question.pedicel) tip_ = sphere;
    if (in_rachis_pass_) reserved_.push_back({seed_, lineage.address, room, sphere});
  } else if (question.pedicel) {
    parameters[question.slots.length] = constants_.withered_length;
  } else {
    parameters[question.slots.length] = 0;
    if (!in_rachis_pass_) ++cuts;
    rachis_cut |= rachis;
  }
  return {question.pedicel, question.pedicel && !room.found, question.width, std::move(why)};
}

namespace {

// Share of the radii of two spheres: spheres as near as this touch (spatial/sphere_grid.hpp), rounding included.
constexpr float touching = 2e-5f;

// A number rounded to two decimals.
std::string in_hundredths(float value) { return expression::number_text(std::floor(value * 100 + 0.5f) / 100); }

}  // namespace

// Describes the sphere that overlaps a probe most: "It still overlaps the berry of module #12 by 3.2."; empty without
// an overlap. `turned`: whether the probe was turned.
std::string PaperGrowth::describe_obstacle(const Sphere& probe, std::uint32_t except, bool turned) const {
  const std::span<const Sphere> spheres = structure_.spheres();
  std::uint32_t nearest = SphereGrid::no_sphere;
  float depth = 0, most = 0;
  for (std::uint32_t i = 0; i < spheres.size(); ++i) {
    const float sum = probe.radius + spheres[i].radius;
    const float overlap = sum - glm::distance(probe.centre, spheres[i].centre);
    if (i == except || !(overlap + touching * sum > most)) continue;
    most = overlap + touching * sum;
    depth = overlap;
    nearest = i;
  }
  if (nearest == SphereGrid::no_sphere) return {};
  const Owner& owner = owners_[nearest];
  const char* const is_turned = turned ? "yes" : "no";
  const char* const part = owner.berry ? "berry" : "internode";
  const std::string module = "#" + std::to_string(owner.module);
  const bool touches = depth < 0.005f;
  if (touches && owner.second) return message(messages::bunch::trace_touches_second, is_turned, part);
  if (touches) return message(messages::bunch::trace_touches, is_turned, part, module);
  const std::string by = in_hundredths(depth);
  if (owner.second) return message(messages::bunch::trace_overlaps_second, is_turned, part, by);
  return message(messages::bunch::trace_overlaps, is_turned, part, module, by);
}

// Describes the result of the search for the trace: how far the part was turned, how often, and the part that it
// touched.
std::string PaperGrowth::describe_room(const Room& room, const Newborn& newborn) const {
  if (room.found && room.adjustments == 0) return message(messages::bunch::trace_room);
  const MessageCode<2>& code = room.found        ? messages::bunch::trace_room_after_turns
                               : newborn.pedicel ? messages::bunch::trace_no_room_pedicel
                                                 : messages::bunch::trace_no_room_internode;
  const std::string outcome = message(code, in_hundredths(room.turned), room.adjustments);
  const std::string obstacle = describe_obstacle(room.found ? room.unturned : room.sphere, newborn.parent, !room.found);
  return obstacle.empty() ? outcome : outcome + " " + obstacle;
}

// Ends the pass that only places the second bunch's rachis: its drawing goes, its reserved room stays.
void PaperGrowth::end_rachis_pass() {
  in_rachis_pass_ = false;
  erase();
  tips_.resize(segments.size());
}

// The room that the rachis pass reserved for the module of that address; null if there is none.
const PaperGrowth::ReservedRoom* PaperGrowth::find_reserved(std::uint64_t address) const {
  for (const ReservedRoom& reserved : reserved_)
    if (reserved.seed == seed_ && reserved.address == address) return &reserved;
  return nullptr;
}

// Draws a segment, and stores the sphere at its tip.
void PaperGrowth::line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
                       const lsystem::Lineage& lineage) {
  SkeletonDrawing::line(id, before, after, lineage);
  if (tips_.size() < segments.size()) tips_.push_back(lineage.address == tip_of_ ? tip_ : SphereGrid::no_sphere);
}

}  // namespace panicle::bunch
