#include "expression/lowering.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "expression/code.hpp"
#include "expression/messages.generated.hpp"
#include "foundation/random.hpp"

namespace panicle::expression {
namespace {

// How many instructions back equal subexpressions are searched: enough for any production, and linear in long ones.
constexpr std::size_t window = 64;

// Whether one of the last instructions is equal; then `instruction.out` becomes its result.
bool same_as_one_of(const std::vector<Instruction>& earlier, Instruction& instruction) {
  const std::size_t oldest = earlier.size() > window ? earlier.size() - window : 0;
  for (std::size_t i = earlier.size(); i-- > oldest;) {
    instruction.out = earlier[i].out;
    if (earlier[i] == instruction) return true;
  }
  return false;
}

}  // namespace

Lowering::Lowering(Code& code) : code_(code) {
  code_.registers.assign(max_parameters, 0);
  if (code_.doubles) code_.precise.assign(max_parameters, 0);
  known_.assign(max_parameters, static_cast<std::uint8_t>(Known::on_the_run));
}

// Defines a name with a value that is known once the inputs are bound. Returns its register.
std::uint32_t Lowering::define(std::string_view name) {
  names_.add(name);
  meanings_.push_back({false, new_register(0, Known::once_bound)});
  return meanings_.back().at;
}

// Defines an array. Returns its number.
std::uint32_t Lowering::define_array(std::string_view name) {
  names_.add(name);
  meanings_.push_back({true, static_cast<std::uint32_t>(code_.arrays.size())});
  code_.arrays.emplace_back(name);
  return meanings_.back().at;
}

// The definition of a name, or null.
const Lowering::Meaning* Lowering::meaning(std::string_view name) const {
  const std::uint32_t number = names_.find(name);
  return number == Names::none ? nullptr : &meanings_[number];
}

// Begins the code of a production with formal parameters, in the first registers; `key` distinguishes its random
// values.
void Lowering::begin_production(std::span<const Named> formals, std::uint64_t key) {
  formals_ = formals;
  locals_.clear();
  drawn_ = {};
  key_ = key;
  in_production_ = true;
  begin_code();
}

// Compiles an expression. Returns the register of its value.
Result<std::uint32_t> Lowering::lower(const Expression& expression) {
  stack_.clear();
  branches_.clear();
  for (const Node& node : expression.nodes)
    if (!lower_node(node)) return error_;
  return pop();
}

// Appends the code that runs once the inputs are bound. Returns its range.
Range Lowering::finish() {
  const std::uint32_t begin = here();
  for (const Instruction& instruction : once_bound_) code_.instructions.push_back(instruction);
  for (const SourceLocation& place : once_bound_places_) code_.places.push_back(place);
  return {begin, here()};
}

bool Lowering::fail(Reason reason, const SourceLocation& place, const Message& problem) {
  error_ = error_at(reason, place, problem);
  return false;
}

// Compiles one node of an expression in postfix order: takes its operands from the stack and puts the register of its
// result on it. Returns false with the error in `error_`.
bool Lowering::lower_node(const Node& node) {
  switch (node.kind) {
    case Node::Kind::number:
      put(number_register(node.number, node.precise));
      return true;
    case Node::Kind::name:
      return name(node);
    case Node::Kind::element:
      return element(node);
    case Node::Kind::operation:
      return operation(node);
    case Node::Kind::and_begin:
    case Node::Kind::or_begin:
      begin_branch(node);
      return true;
    case Node::Kind::and_end:
    case Node::Kind::or_end:
      end_branch(node);
      return true;
  }
  return true;
}

// Puts the register of a name on the stack: of a block's last assignment to it, else of a parameter, else of a
// definition. Returns false for arrays and undefined names, with the error in `error_`.
bool Lowering::name(const Node& node) {
  for (std::size_t i = locals_.size(); i-- > 0;)
    if (locals_[i].name == node.name) return put(locals_[i].reg), true;
  for (std::uint32_t i = 0; i < formals_.size(); ++i)
    if (formals_[i].name == node.name) return put(i), true;
  const Meaning* const meaning = this->meaning(node.name);
  if (meaning && !meaning->array) return put(meaning->at), true;
  if (meaning)
    return fail(Reason::undefined, node.place, message(messages::expression::array_without_index, node.name));
  return fail(Reason::undefined, node.place, message(messages::expression::undefined_name, node.name));
}

// Compiles the element of an array, whose index is on the stack; an error for an undefined array. Reading can fail, so
// the instruction is always executed in place; where the index is known once the inputs are bound, the element is read
// then as well, and its value can be used by other code that runs once.
bool Lowering::element(const Node& node) {
  const Meaning* const array = meaning(node.name);
  if (!array || !array->array)
    return fail(Reason::undefined, node.place, message(messages::expression::undefined_array, node.name));
  const Instruction instruction{Op::element, 0, pop(), 0, array->at};
  const bool once_bound = in_production_ && known(instruction.a) != Known::on_the_run;
  const std::uint32_t read = emit(instruction, node.place);
  put(once_bound ? emit_once_bound(instruction, node.place) : read);
  return true;
}

// Compiles an operator or a function, whose operands are on the stack. clamp(x, low, high) becomes min(max(x, low),
// high). Each call of a random function gets a stream of its own; an error where the call is not allowed.
bool Lowering::operation(const Node& node) {
  if (node.op == Op::clamp) {
    const std::uint32_t high = pop();
    calculate(Op::maximum, 2, node.place);
    put(high);
    calculate(Op::minimum, 2, node.place);
    return true;
  }
  if (is_space_query(node.op)) return space_query(node);
  if (!is_random(node.op)) {
    calculate(node.op, node.arguments, node.place, node.curve);
    return true;
  }
  if (!in_production_)
    return fail(Reason::syntax, node.place, message(messages::expression::random_outside_production));
  Instruction instruction{node.op, 0, 0, 0, static_cast<std::uint32_t>(code_.streams.size())};
  if (node.arguments > 1) instruction.b = pop();
  instruction.a = pop();
  code_.streams.push_back(stream_of(node));
  put(emit(instruction, node.place));
  return true;
}

// Compiles a query of the space, whose arguments are on the stack: hands them over one by one, then queries. Two
// queries never share a result: each is executed.
bool Lowering::space_query(const Node& node) {
  if (!in_production_)
    return fail(Reason::syntax, node.place, message(messages::expression::query_outside_production, node.name));
  for (std::uint32_t i = node.arguments; i-- > 0;) handed_over_[i] = pop();
  for (std::uint32_t i = 0; i < node.arguments; ++i) {
    code_.instructions.push_back({Op::hand_over, new_register(0, Known::on_the_run), handed_over_[i], 0, i});
    code_.places.push_back(node.place);
  }
  const std::uint32_t out = new_register(0, Known::on_the_run);
  code_.instructions.push_back({node.op, out, 0, 0, 0});
  code_.places.push_back(node.place);
  put(out);
  return true;
}

// Replaces one or two operands on the stack by the result of an operation: computed now if all are known, once the
// inputs are bound, or at run. `extra`: further data of the operation, such as an array's index.
void Lowering::calculate(Op op, std::uint32_t operands, const SourceLocation& place, std::uint32_t extra) {
  Instruction instruction{op, 0, 0, 0, extra};
  if (operands > 1) instruction.b = pop();
  instruction.a = pop();
  Known result = known(instruction.a);
  if (operands > 1) result = std::max(result, known(instruction.b));
  if (result == Known::now) {
    put(fold(instruction));
  } else if (result == Known::once_bound && in_production_) {
    put(emit_once_bound(instruction, place));
  } else {
    put(emit(instruction, place));
  }
}

// The stream of random values of a call: by production, function and the number of its calls before.
std::uint64_t Lowering::stream_of(const Node& node) {
  const std::uint32_t before = drawn_[static_cast<std::size_t>(node.op) - static_cast<std::size_t>(Op::random_whole)]++;
  return hash_combine(hash_combine(key_, hash_text(node.name)), before);
}

// Begins `a && b` or `a || b`, behind the code of a: the result is the truth of a, and the code of b is jumped over, if
// that decides; else the truth of b.
void Lowering::begin_branch(const Node& node) {
  const std::uint32_t first = pop();
  const std::uint32_t out = new_register(0, Known::on_the_run);
  code_.instructions.push_back({Op::truth, out, first, 0, 0});
  code_.places.push_back(node.place);
  branches_.push_back({here(), out, available_.size()});
  code_.instructions.push_back(
      {node.kind == Node::Kind::and_begin ? Op::jump_if_false : Op::jump_if_true, 0, out, 0, 0});
  code_.places.push_back(node.place);
}

// Ends `a && b` or `a || b`, behind the code of b: the result becomes the truth of b, and the jump over b gets its
// target. Results computed in b are not available behind it.
void Lowering::end_branch(const Node& node) {
  const Branch branch = branches_.back();
  branches_.pop_back();
  code_.instructions.push_back({Op::truth, branch.out, pop(), 0, 0});
  code_.places.push_back(node.place);
  code_.instructions[branch.jump].c = here();
  available_.resize(branch.available);
  put(branch.out);
}

// Adds a register with a value; `known` is when the value is known.
std::uint32_t Lowering::new_register(double value, Known known) {
  code_.registers.push_back(static_cast<float>(value));
  if (code_.doubles) code_.precise.push_back(value);
  known_.push_back(static_cast<std::uint8_t>(known));
  return static_cast<std::uint32_t>(code_.registers.size() - 1);
}

// The register of a constant; equal constants share one.
std::uint32_t Lowering::number_register(float value, double precise) {
  char bytes[sizeof precise];
  const std::size_t size = code_.doubles ? sizeof precise : sizeof value;
  std::memcpy(bytes, code_.doubles ? static_cast<const void*>(&precise) : &value, size);
  const std::uint32_t number = numbers_.add({bytes, size});
  if (number == number_registers_.size())
    number_registers_.push_back(new_register(code_.doubles ? precise : value, Known::now));
  return number_registers_[number];
}

// Appends an instruction, unless one of the last ones has the same result. Returns the result's register.
std::uint32_t Lowering::emit(Instruction instruction, const SourceLocation& place) {
  const bool shared = !is_random(instruction.op);
  if (shared && same_as_one_of(available_, instruction)) return instruction.out;
  instruction.out = new_register(0, Known::on_the_run);
  code_.instructions.push_back(instruction);
  code_.places.push_back(place);
  if (shared) available_.push_back(instruction);
  return instruction.out;
}

// The same for code that runs once the inputs are bound.
std::uint32_t Lowering::emit_once_bound(Instruction instruction, const SourceLocation& place) {
  if (same_as_one_of(once_bound_, instruction)) return instruction.out;
  instruction.out = new_register(0, Known::once_bound);
  once_bound_.push_back(instruction);
  once_bound_places_.push_back(place);
  return instruction.out;
}

// Computes an instruction whose operands are constants. Returns the register of its result.
std::uint32_t Lowering::fold(Instruction instruction) {
  const std::uint32_t at = here();
  instruction.out = new_register(0, Known::now);
  code_.instructions.push_back(instruction);
  Diagnostic none;  // arithmetic alone cannot go wrong
  if (code_.doubles) {
    execute(code_, at, at + 1, code_.precise.data(), {}, none);
  } else {
    execute(code_, at, at + 1, code_.registers.data(), {}, none);
  }
  const double precise = code_.doubles ? code_.precise.back() : code_.registers.back();
  code_.instructions.pop_back();
  code_.registers.pop_back();
  if (code_.doubles) code_.precise.pop_back();
  known_.pop_back();
  return number_register(static_cast<float>(precise), precise);
}

// Takes a register from the stack.
std::uint32_t Lowering::pop() {
  const std::uint32_t reg = stack_.back();
  stack_.pop_back();
  return reg;
}

}  // namespace panicle::expression
