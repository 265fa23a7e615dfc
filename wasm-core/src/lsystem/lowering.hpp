// Expression → byte code.
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "lsystem/code.hpp"
#include "lsystem/grammar.hpp"

namespace panicle::lsystem {

class Lowering {
 public:
  explicit Lowering(Code& code);

  void define(std::string_view name, float value);
  void define_array(std::string_view name, std::vector<float> values);

  // Names that the next expressions may use: the predecessor's parameters, which hide defines of the same name, and
  // random draws, whose streams are hashes of `key`, the function and how many of it came before.
  void begin_production(std::span<const Formal> formals, std::uint64_t key);
  // Results of earlier expressions are not there any more: code that runs by itself begins here.
  void begin_code() { available_.clear(); }
  std::uint32_t here() const { return static_cast<std::uint32_t>(code_.instructions.size()); }

  // The register that will hold the value. Constant parts are worked out now, equal parts once. Errors: undefined;
  // syntax (random values where there is no module to draw them for).
  Result<std::uint32_t> lower(const Expression& expression);
  // The value of an expression that needs no module. Errors: those above; evaluation.
  Result<float> value(const Expression& expression);

  bool is_constant(std::uint32_t reg) const { return constant_[reg] != 0; }

 private:
  struct Branch {  // the second operand of && or ||, which may be passed over
    std::uint32_t jump;
    std::uint32_t out;
    std::size_t available;
  };
  bool fail(Reason reason, const Place& place, Pieces pieces);
  bool lower_node(const Node& node);
  bool name(const Node& node);
  bool element(const Node& node);
  bool operation(const Node& node);
  void calculate(Op op, std::uint32_t operands, const Place& place);
  void begin_branch(const Node& node);
  void end_branch(const Node& node);
  std::uint64_t stream_of(const Node& node);
  std::uint32_t new_register(float value, bool constant);
  std::uint32_t constant_register(float value);
  std::uint32_t emit(Instruction instruction, const Place& place);
  bool fold(Instruction instruction, const Place& place);
  std::uint32_t pop();
  void put(std::uint32_t reg) { stack_.push_back(reg); }

  Code& code_;
  std::map<std::string_view, float> defines_;
  std::map<std::string_view, std::uint32_t> arrays_;
  std::map<std::string_view, std::uint32_t> formals_;
  std::map<std::string_view, std::uint32_t> drawn_;   // how many calls of each random function
  std::map<std::uint32_t, std::uint32_t> constants_;  // bits → register
  std::vector<std::uint8_t> constant_;                // whether a register is one
  std::vector<std::uint32_t> stack_;
  std::vector<Branch> branches_;
  std::vector<Instruction> available_;  // whose results can be used again here
  std::uint64_t key_ = 0;
  bool may_draw_ = false;
  Diagnostic trouble_;
};

}  // namespace panicle::lsystem
