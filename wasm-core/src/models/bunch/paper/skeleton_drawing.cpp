#include "models/bunch/paper/skeleton_drawing.hpp"

#include <algorithm>

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry; the rachis is the main axis of the bunch.

// Begins to draw a bunch: the roles of the text's symbols, its usual width, and the number of its first axis.
void SkeletonDrawing::begin(const lsystem::BoundProgram& text, const SymbolRoles& roles, bool second,
                            std::int32_t first_axis) {
  Drawing::begin();
  roles_ = roles;
  width_ = lsystem::constant(text, "w", 1);
  first_segment_ = segments.size();
  first_ball_ = balls.size();
  first_axis_ = first_axis;
  second_ = second;
  answering_ = false;
}

// Removes all that has been drawn since `begin`.
void SkeletonDrawing::erase() {
  segments.resize(first_segment_);
  parts_.resize(first_segment_);
  balls.resize(first_ball_);
}

// Called for a query module ?E(…) of the text: reads its parameters, lets `answer` change them, and stores the answer
// for the lines that the module draws. Traces the query and the response if requested.
void SkeletonDrawing::query(const lsystem::Turtle& turtle, std::span<float> parameters,
                            const lsystem::Lineage& lineage) {
  answering_ = false;
  Question question;
  if (!slots_for(parameters.size(), question.slots)) return fail(wrong_arity());
  question.pedicel = parameters[0] == pedicel_type;
  question.width = question.slots.width ? parameters[question.slots.width] : width_;
  const bool is_traced_here = is_traced(lineage);
  if (is_traced_here) trace_->add_response(lineage.module, "asked" + lsystem::numbers_text(parameters));
  answer_ = answer(question, turtle, parameters, lineage);
  if (is_traced_here) {
    trace_->add_response(lineage.module, " →" + lsystem::numbers_text(parameters));
    if (!answer_.why.empty()) trace_->add_response(lineage.module, "; " + answer_.why);
  }
  answering_ = true;
  query_address_ = lineage.address;
  ++questions_;
}

// The answer to a query: here the query's own values, for there is always room.
SkeletonDrawing::Answer SkeletonDrawing::answer(const Question& question, const lsystem::Turtle&, std::span<float>,
                                                const lsystem::Lineage&) {
  return {question.pedicel, false, question.width, {}};
}

// Draws a segment, and records its kind, axis and place in the rachis; the width may come from the answer to its query.
void SkeletonDrawing::line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
                           const lsystem::Lineage& lineage) {
  Drawing::line(id, before, after, lineage);
  if (segments.size() == parts_.size()) return;  // the segment was refused by the limit
  Segment& segment = segments.back();
  const Part* const parent = segment.parent < 0 ? nullptr : &parts_[static_cast<std::size_t>(segment.parent)];
  const bool answered = answering_ && lineage.address == query_address_;
  Part part;
  if (!second_) part.module = lineage.module;
  part.kind = answered && answer_.pedicel ? Kind::pedicel : roles_.of(lineage.parent_symbol);
  if (answered) {
    part.question = questions_;
    part.state = answer_.withered ? State::withered : State::grown;
    part.joint = parent && parent->question == questions_;
    if (!part.joint && answer_.width > 0) segment.radius = answer_.width * 0.5f;
  }
  part.axis = axis_of(segment, part.kind, lineage);
  part.rachis_depth = (parent ? parent->rachis_depth : 0) + (part.kind == Kind::rachis ? 1 : 0);
  parts_.push_back(part);
}

// A first-order axis is a line that leaves the rachis, except the end structure in which the rachis itself ends. It has
// the number of the rachis internode whose tip it leaves; −1 for lines of no axis.
std::int32_t SkeletonDrawing::axis_of(const Segment& segment, Kind kind, const lsystem::Lineage& lineage) const {
  if (segment.parent < 0 || kind == Kind::rachis) return -1;
  const Part& parent = parts_[static_cast<std::size_t>(segment.parent)];
  if (parent.kind != Kind::rachis) return parent.axis;
  if (kind == Kind::end && is_rachis(lineage.grandparent_symbol)) return -1;
  return first_axis_ + parent.rachis_depth - 1;
}

// Marks the pedicels: lines that lead to a ball, drawn by an answer or by the text. A line whose answer has no ball is
// a pedicel too, withered or as the text has it; a thorn beside it is not, nor is a stem that leads on beyond its ball.
void SkeletonDrawing::settle_pedicels() {
  std::vector<std::uint8_t> has_ball(segments.size(), 0), leads_on(segments.size(), 0), fruitful(questions_ + 1, 0);
  for (const Ball& ball : balls) has_ball[static_cast<std::size_t>(ball.segment)] = 1;
  for (std::size_t i = segments.size(); i-- > 0;) {
    if (!has_ball[i] && !leads_on[i]) continue;
    if (parts_[i].question != none) fruitful[parts_[i].question] = 1;
    if (segments[i].parent >= 0) leads_on[static_cast<std::size_t>(segments[i].parent)] = 1;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Part& part = parts_[i];
    const bool answered = part.question != none;
    if (part.kind != Kind::pedicel) {
      if (has_ball[i] && !leads_on[i]) part.kind = Kind::pedicel;
    } else if (!has_ball[i] && !leads_on[i] && (answered ? fruitful[part.question] != 0 : !balls.empty())) {
      part.kind = Kind::axis;
      part.joint = false;
    }
    if (part.kind != Kind::pedicel || answered || segments[i].parent < 0) continue;
    const Part& parent = parts_[static_cast<std::size_t>(segments[i].parent)];
    part.joint = parent.kind == Kind::pedicel && parent.question == none;
  }
}

// The number of balls that hang on a segment.
std::size_t SkeletonDrawing::attached_balls() const {
  return static_cast<std::size_t>(
      std::count_if(balls.begin(), balls.end(), [](const Ball& ball) { return ball.segment >= 0; }));
}

// Settles which lines are pedicels, and makes the internodes. Removes balls that hang on nothing, and returns their
// number.
std::uint32_t SkeletonDrawing::finish() {
  const auto loose = std::erase_if(balls, [](const Ball& ball) { return ball.segment < 0; });
  settle_pedicels();
  internodes.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const Part& part = parts_[i];
    internodes.push_back({segment, part.kind, part.state, part.axis, part.joint, part.module});
  }
  return static_cast<std::uint32_t>(loose);
}

}  // namespace panicle::bunch
