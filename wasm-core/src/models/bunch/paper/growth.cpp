#include "models/bunch/paper/growth.hpp"

#include <string_view>

#include "foundation/random.hpp"
#include "models/bunch/communication.hpp"

namespace panicle::bunch {

Growth::Growth(const InteractionOptions& options, const Limits& limits, float largest)
    : options_(options), limits_(limits), structure_(largest) {}

void Growth::begin(const lsystem::Bound& bound, std::uint64_t seed, std::int32_t first_axis) {
  constants_.width = lsystem::constant(bound, "w", 1);
  constants_.narrowing = lsystem::constant(bound, "r_w", 1);
  constants_.withered_length = lsystem::constant(bound, "l_w", 10);
  constants_.berry_radius = lsystem::constant(bound, "b_r", 0);
  seed_ = seed;
  first_internode_ = static_cast<std::int32_t>(internodes.size());
  first_axis_ = first_axis;
  answered_ = {};
}

void Growth::ask(const lsystem::Turtle& turtle, std::span<float> parameters, const lsystem::Lineage& lineage) {
  answered_ = {};
  Slots slots;
  if (!slots_for(parameters.size(), slots)) {
    if (trouble_.reason == Reason::none) trouble_ = wrong_arity();
    return;
  }
  const bool pedicel = parameters[0] == 1;
  const float width = slots.width ? parameters[slots.width] : constants_.width;
  float& length = parameters[slots.length];

  Newborn newborn;
  newborn.pedicel = pedicel;
  newborn.flat = slots.phi == 0;
  newborn.length = length;
  newborn.radius =
      pedicel ? (slots.berry ? parameters[slots.berry] : constants_.berry_radius) : width * constants_.narrowing * 0.5f;
  if (turtle.line >= 0) newborn.parent = tips_[first_internode_ + turtle.line];
  newborn.tie = random_direction(seed_, hash_text("tie"), lineage.address);

  const Laid* const laid = find_laid(lineage.address);
  Room room;
  if (laid)
    room = laid->room;
  else if ((!laying_ || is_rachis(lineage.parent)) && within(structure_.spheres().size(), limits_.spheres, "spheres"))
    room = find_room(structure_, turtle, newborn, options_);
  parameters[slots.theta] = room.theta;
  if (slots.phi) parameters[slots.phi] = room.phi;
  answered_ = {true, pedicel, !room.found, width, SphereGrid::no_sphere};
  if (room.found) {
    const std::uint32_t sphere = laid ? laid->tip : structure_.add(room.sphere);
    if (!pedicel) answered_.tip = sphere;
    if (laying_) laid_.push_back({seed_, lineage.address, room, sphere});
  } else if (pedicel) {
    length = constants_.withered_length;
  } else {
    length = 0;
    if (!laying_) ++cuts;
    rachis_cut |= is_rachis(lineage.parent);
    answered_ = {};
  }
}

void Growth::begin_laying() {
  laying_ = true;
  berries_before_ = berries.size();
}

void Growth::end_laying() {
  laying_ = false;
  internodes.resize(static_cast<std::size_t>(first_internode_));
  tips_.resize(internodes.size());
  rachis_depth_.resize(internodes.size());
  berries.resize(berries_before_);
}

const Growth::Laid* Growth::find_laid(std::uint64_t address) const {
  for (const Laid& laid : laid_)
    if (laid.seed == seed_ && laid.address == address) return &laid;
  return nullptr;
}

void Growth::line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
                  const lsystem::Lineage& lineage) {
  if (!within(internodes.size(), limits_.segments, "internodes")) return;
  (void)id;
  Internode internode;
  internode.parent = before.line < 0 ? -1 : first_internode_ + before.line;
  internode.kind = kind_of(lineage.parent, answered_.pending && answered_.pedicel);
  internode.state = answered_.pending && answered_.withered ? State::withered : State::grown;
  internode.start = before.position;
  internode.end = after.position;
  internode.radius_end = after.width * 0.5f;
  internode.radius = answered_.pending ? answered_.width * 0.5f : internode.radius_end;
  internode.axis = axis_of(internode, internodes, rachis_depth_, first_axis_, lineage);

  const std::int32_t above = internode.parent < 0 ? 0 : rachis_depth_[internode.parent];
  rachis_depth_.push_back(above + (internode.kind == Kind::rachis ? 1 : 0));
  tips_.push_back(answered_.tip);
  internodes.push_back(internode);
  answered_ = {};
}

void Growth::sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  if (turtle.line < 0 || !within(berries.size(), limits_.spheres, "berries")) return;
  const std::int32_t pedicel = first_internode_ + turtle.line;
  if (static_cast<std::size_t>(pedicel) >= internodes.size()) return;
  internodes[pedicel].kind = Kind::pedicel;
  berries.push_back({turtle.position, radius, turtle.heading, pedicel, berry_id(lineage.address, first_axis_ > 0)});
}

void Growth::cut(const lsystem::Turtle&) { answered_ = {}; }

bool Growth::within(std::size_t count, std::uint32_t limit, const char* what) {
  if (count < limit) return true;
  if (trouble_.reason == Reason::none)
    trouble_ = {Reason::limit,
                std::string("The bunch has reached the limit of ") + std::to_string(limit) + " " + what +
                    "; make the profile or the grammar smaller.",
                0, 0};
  return false;
}

}  // namespace panicle::bunch
