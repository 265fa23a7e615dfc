// Expression → byte code. Values that depend on constants of the text alone are computed here; values that depend on
// the inputs as well become code that runs once when the inputs are bound; all others are computed for each module.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "expression/code.hpp"
#include "expression/expression_tree.hpp"
#include "expression/names.hpp"

namespace panicle::expression {

class Lowering {
 public:
  explicit Lowering(Code& code);

  // When the value of a register is known.
  enum class Known : std::uint8_t { now, once_bound, on_the_run };

  // Defines a name for a number that is known once the inputs are bound, and returns the register that will hold it.
  std::uint32_t define(std::string_view name);
  // Defines a name for an array, and returns its index among the program's arrays.
  std::uint32_t define_array(std::string_view name);

  // Defines a name for the value of an assignment in a block: it hides all others of that name up to the next
  // production.
  void assign(std::string_view name, std::uint32_t reg) { locals_.push_back({name, reg}); }
  std::size_t locals() const { return locals_.size(); }
  // Removes the local variables that were added after the first `down_to`: their block ends.
  void forget_locals(std::size_t down_to) { locals_.resize(down_to); }
  // Returns the register of a constant.
  std::uint32_t number_register(float value) { return number_register(value, value); }

  // Begins the expressions of a production. They may use the predecessor's parameters, which hide defines of the same
  // name, and random draws, whose streams are hashes of `key`, the function and the number of its earlier calls.
  // `formals` must stay until the next production begins.
  void begin_production(std::span<const Named> formals, std::uint64_t key);
  // Begins code that runs by itself: it cannot reuse the results of earlier expressions.
  void begin_code() { available_.clear(); }
  // The index of the next instruction.
  std::uint32_t here() const { return static_cast<std::uint32_t>(code_.instructions.size()); }

  // Compiles an expression, and returns the register that will hold its value. Equal subexpressions are computed once.
  // Before the first production all values that are not constant are computed by code in place. Errors: undefined;
  // syntax (random values outside of productions).
  Result<std::uint32_t> lower(const Expression& expression);
  // When the value of a register is known: now, once the inputs are bound, or only while the code runs.
  Known known(std::uint32_t reg) const { return static_cast<Known>(known_[reg]); }

  // Appends the code that runs once the inputs are bound behind all other code, and returns its range. An instruction
  // in it that fails is no error by itself: the code of each expression that needs the value repeats it.
  Range finish();
  // The present length of that code.
  std::uint32_t once_bound() const { return static_cast<std::uint32_t>(once_bound_.size()); }

 private:
  struct Branch {  // the second operand of && or ||, which may be passed over
    std::uint32_t jump;
    std::uint32_t out;
    std::size_t available;
  };
  bool fail(Reason reason, const SourceLocation& place, const Message& problem);
  bool lower_node(const Node& node);
  bool name(const Node& node);
  bool element(const Node& node);
  bool operation(const Node& node);
  bool space_query(const Node& node);
  void calculate(Op op, std::uint32_t operands, const SourceLocation& place, std::uint32_t extra = 0);
  void begin_branch(const Node& node);
  void end_branch(const Node& node);
  std::uint64_t stream_of(const Node& node);
  // In double precision the second value is used.
  std::uint32_t number_register(float value, double precise);
  std::uint32_t new_register(double value, Known known);
  std::uint32_t emit(Instruction instruction, const SourceLocation& place);
  std::uint32_t emit_once_bound(Instruction instruction, const SourceLocation& place);
  std::uint32_t fold(Instruction instruction);
  std::uint32_t pop();
  // Pushes the register of an operand.
  void put(std::uint32_t reg) { stack_.push_back(reg); }

  Code& code_;
  // The meaning of a definition: a register, or the index of an array.
  struct Meaning {
    bool array;
    std::uint32_t at;
  };
  const Meaning* meaning(std::string_view name) const;

  Names names_;  // of definitions
  std::vector<Meaning> meanings_;
  std::span<const Named> formals_;
  struct Local {
    std::string_view name;
    std::uint32_t reg;
  };
  std::vector<Local> locals_;
  std::array<std::uint32_t, 3> drawn_{};         // how many calls of each random function
  Names numbers_;                                // of the text, by their bytes
  std::vector<std::uint32_t> number_registers_;  // of each
  std::vector<std::uint8_t> known_;              // of each register
  std::vector<std::uint32_t> stack_;
  std::array<std::uint32_t, max_handed_over> handed_over_{};
  std::vector<Branch> branches_;
  std::vector<Instruction> available_;  // whose results can be used again here
  std::vector<Instruction> once_bound_;
  std::vector<SourceLocation> once_bound_places_;
  std::uint64_t key_ = 0;
  bool in_production_ = false;
  Diagnostic error_;
};

}  // namespace panicle::expression
