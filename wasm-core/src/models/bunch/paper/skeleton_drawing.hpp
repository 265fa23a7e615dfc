// The listener that both procedures derive from: draws, and finds the kind (rachis, axis, pedicel …) of each line.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lsystem/lsystem.hpp"
#include "lsystem/trace/derivation_trace.hpp"
#include "lsystem_plant/drawing.hpp"
#include "models/bunch/communication.hpp"
#include "models/bunch/roles.hpp"
#include "models/bunch/skeleton.hpp"

namespace panicle::bunch {

// Several interpretations may follow one another; begin() starts each. There are no collisions: modules get the answer
// that they request, unless a derived class overrides `answer`.
class SkeletonDrawing : public Drawing {
 public:
  using Drawing::Drawing;

  // Begins an interpretation of a text, of the first bunch or the second; its first-order axes are numbered from
  // `first_axis`.
  void begin(const lsystem::BoundProgram& text, const SymbolRoles& roles, bool second, std::int32_t first_axis);

  // From now on the queries and answers of the first bunch's modules are traced in `chronicle`, unless it is null.
  void set_trace(lsystem::DerivationTrace* trace) { trace_ = trace; }

  void line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
            const lsystem::Lineage& lineage) override;
  void query(const lsystem::Turtle& turtle, std::span<float> parameters, const lsystem::Lineage& lineage) final;

  // Finishes the drawing, in the grammar's unit: settles which internodes are pedicels, which depends on balls and
  // answers. Removes from `balls` those that hang on no line, and returns their number.
  std::uint32_t finish();

  // The number of balls that hang on a line so far.
  std::size_t attached_balls() const;

  std::vector<Internode> internodes;  // parents first; empty until it is finished

 protected:
  // The query of a communication module.
  struct Question {
    bool pedicel = false;
    float width = 0;
    ParameterSlots slots;
  };
  // The answer to a query: properties of every line that the module draws, known by the address of its ?E.
  struct Answer {
    bool pedicel = false;
    bool withered = false;
    float width = 0;  // at the start of its first line; 0: the turtle's own
    std::string why;  // for the trace
  };

  // Changes `parameters` into the answer.
  virtual Answer answer(const Question& question, const lsystem::Turtle& turtle, std::span<float> parameters,
                        const lsystem::Lineage& lineage);

  // Erases everything drawn since begin().
  void erase();

  // Whether queries of this module are traced.
  bool is_traced(const lsystem::Lineage& lineage) const {
    return trace_ != nullptr && !second_ && trace_->has(lineage.module);
  }
  bool second() const { return second_; }

  bool is_rachis(std::uint32_t symbol) const { return roles_.of(symbol) == Kind::rachis; }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  // Properties of a segment besides its place.
  struct Part {
    Kind kind = Kind::axis;
    State state = State::grown;
    std::int32_t axis = -1;
    bool joint = false;
    std::uint32_t question = none;  // number of the query whose answer drew it
    std::int32_t rachis_depth = 0;  // rachis internodes from the root to its end
    std::uint32_t module = no_module;
  };

  std::int32_t axis_of(const Segment& segment, Kind kind, const lsystem::Lineage& lineage) const;
  void settle_pedicels();

  SymbolRoles roles_;
  float width_ = 1;                                 // `w`, for modules that do not carry one
  std::size_t first_segment_ = 0, first_ball_ = 0;  // of this interpretation
  std::int32_t first_axis_ = 0;
  bool second_ = false;
  lsystem::DerivationTrace* trace_ = nullptr;

  Answer answer_;  // the last
  bool answering_ = false;
  std::uint64_t query_address_ = 0;
  std::uint32_t questions_ = 0;

  std::vector<Part> parts_;  // one a segment
};

}  // namespace panicle::bunch
