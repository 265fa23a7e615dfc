#include "models/bunch/natural/sprouting.hpp"

#include <algorithm>
#include <string>

#include "models/bunch/communication.hpp"

namespace panicle::bunch {
namespace {

constexpr float least_strength = 0.001f;

}  // namespace

void Sprouting::begin(const lsystem::Bound& bound, std::uint32_t bunch, std::int32_t first_axis) {
  width_ = lsystem::constant(bound, "w", 1);
  bunch_ = bunch;
  first_internode_ = static_cast<std::int32_t>(internodes.size());
  first_axis_ = first_axis;
}

void Sprouting::ask(const lsystem::Turtle&, std::span<float> parameters, const lsystem::Lineage&) {
  Slots slots;
  if (!slots_for(parameters.size(), slots)) {
    if (trouble_.reason == Reason::none) trouble_ = wrong_arity();
    return;
  }
  pedicel_ = parameters[0] == 1;
  asked_width_ = slots.width ? parameters[slots.width] : width_;
}

void Sprouting::line(std::int32_t, const lsystem::Turtle& before, const lsystem::Turtle& after,
                     const lsystem::Lineage& lineage) {
  if (!within(internodes.size(), limits_.segments, "internodes")) return;
  Internode internode;
  internode.parent = before.line < 0 ? -1 : first_internode_ + before.line;
  internode.kind = kind_of(lineage.parent, pedicel_);
  internode.start = before.position;
  internode.end = after.position;
  internode.radius_end = after.width * 0.5f;
  internode.radius = asked_width_ > 0 ? asked_width_ * 0.5f : internode.radius_end;
  internode.axis = axis_of(internode, internodes, rachis_depth_, first_axis_, lineage);
  const std::int32_t above = internode.parent < 0 ? 0 : rachis_depth_[static_cast<std::size_t>(internode.parent)];
  rachis_depth_.push_back(above + (internode.kind == Kind::rachis ? 1 : 0));
  depth_.push_back(internode.parent < 0 ? 0 : depth_[static_cast<std::size_t>(internode.parent)] + 1);
  borne_.push_back(0);
  internodes.push_back(internode);
  pedicel_ = false;
  asked_width_ = 0;
}

void Sprouting::sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  if (turtle.line < 0 || !within(flowers.size(), limits_.organs, "flowers")) return;
  const std::int32_t pedicel = first_internode_ + turtle.line;
  if (static_cast<std::size_t>(pedicel) >= internodes.size()) return;
  internodes[static_cast<std::size_t>(pedicel)].kind = Kind::pedicel;
  const Internode& internode = internodes[static_cast<std::size_t>(pedicel)];
  Flower flower;
  flower.pedicel = pedicel;
  flower.id = berry_id(lineage.address, bunch_ > 0);
  flower.bunch = bunch_;
  flower.address = lineage.address;
  flower.heading = turtle.heading;
  flower.axis = internode.axis;
  flower.depth = depth_[static_cast<std::size_t>(pedicel)];
  if (internode.parent >= 0) flower.place = borne_[static_cast<std::size_t>(internode.parent)]++;
  flower.strength = std::clamp(radius, least_strength, 1.0f);
  flowers.push_back(flower);
}

bool Sprouting::within(std::size_t count, std::uint32_t limit, const char* what) {
  if (count < limit) return true;
  if (trouble_.reason == Reason::none)
    trouble_ = {Reason::limit,
                std::string("The bunch has reached the limit of ") + std::to_string(limit) + " " + what +
                    "; make the profile or the grammar smaller.",
                0, 0};
  return false;
}

}  // namespace panicle::bunch
