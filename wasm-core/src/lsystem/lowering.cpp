#include "lsystem/lowering.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "foundation/random.hpp"
#include "lsystem/parser.hpp"

namespace panicle::lsystem {
namespace {

// How far back equal parts are looked for: far enough for any production, and no square of a long one.
constexpr std::size_t window = 64;

}  // namespace

Lowering::Lowering(Code& code) : code_(code) {
  code_.registers.assign(most_parameters, 0);
  constant_.assign(most_parameters, 0);
}

void Lowering::define(std::string_view name, float value) { defines_[name] = value; }

void Lowering::define_array(std::string_view name, std::vector<float> values) {
  arrays_[name] = static_cast<std::uint32_t>(code_.arrays.size());
  code_.arrays.push_back({std::string(name), std::move(values)});
}

void Lowering::begin_production(std::span<const Formal> formals, std::uint64_t key) {
  formals_.clear();
  drawn_.clear();
  for (std::uint32_t i = 0; i < formals.size(); ++i) formals_[formals[i].name] = i;
  key_ = key;
  may_draw_ = true;
  begin_code();
}

Result<std::uint32_t> Lowering::lower(const Expression& expression) {
  stack_.clear();
  branches_.clear();
  for (const Node& node : expression.nodes)
    if (!lower_node(node)) return trouble_;
  return pop();
}

Result<float> Lowering::value(const Expression& expression) {
  begin_code();
  const std::uint32_t begin = here();
  const Result<std::uint32_t> result = lower(expression);
  if (!result) return result.error();
  if (!execute(code_, begin, here(), code_.registers.data(), {}, trouble_)) return trouble_;
  code_.instructions.resize(begin);
  code_.places.resize(begin);
  return code_.registers[result.value()];
}

bool Lowering::fail(Reason reason, const Place& place, Pieces pieces) {
  trouble_ = error_at(reason, place, pieces);
  return false;
}

bool Lowering::lower_node(const Node& node) {
  switch (node.kind) {
    case Node::Kind::number:
      put(constant_register(node.number));
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

bool Lowering::name(const Node& node) {
  if (const auto formal = formals_.find(node.name); formal != formals_.end()) {
    put(formal->second);
    return true;
  }
  if (const auto define = defines_.find(node.name); define != defines_.end()) {
    put(constant_register(define->second));
    return true;
  }
  if (arrays_.contains(node.name))
    return fail(Reason::undefined, node.place,
                {"'", node.name, "' is an array; say which value you mean, as in ", node.name, "[1]."});
  return fail(Reason::undefined, node.place,
              {"Nothing defines '", node.name,
               "' here; add a #define before this line or name it among the predecessor's parameters."});
}

bool Lowering::element(const Node& node) {
  const auto array = arrays_.find(node.name);
  if (array == arrays_.end())
    return fail(Reason::undefined, node.place,
                {"There is no array '", node.name, "'; declare it before this line with #input ", node.name, "[]."});
  const Instruction instruction{Op::element, 0, pop(), 0, array->second};
  if (!fold(instruction, node.place)) put(emit(instruction, node.place));
  return true;
}

bool Lowering::operation(const Node& node) {
  if (node.op == Op::clamp) {
    const std::uint32_t high = pop();
    calculate(Op::maximum, 2, node.place);
    put(high);
    calculate(Op::minimum, 2, node.place);
    return true;
  }
  if (!is_random(node.op)) {
    calculate(node.op, node.arguments, node.place);
    return true;
  }
  if (!may_draw_)
    return fail(Reason::syntax, node.place,
                {"Random values belong to modules; draw them in the axiom or a production, not in a #define."});
  Instruction instruction{node.op, 0, 0, 0, static_cast<std::uint32_t>(code_.streams.size())};
  if (node.arguments > 1) instruction.b = pop();
  instruction.a = pop();
  code_.streams.push_back(stream_of(node));
  put(emit(instruction, node.place));
  return true;
}

// Puts the result of one or two operands from the stack in their place.
void Lowering::calculate(Op op, std::uint32_t operands, const Place& place) {
  Instruction instruction{op, 0, 0, 0, 0};
  if (operands > 1) instruction.b = pop();
  instruction.a = pop();
  const bool constant = is_constant(instruction.a) && (operands < 2 || is_constant(instruction.b));
  if (!constant || !fold(instruction, place)) put(emit(instruction, place));
}

std::uint64_t Lowering::stream_of(const Node& node) {
  const std::uint32_t before = drawn_[node.name]++;
  return hash_combine(hash_combine(key_, hash_text(node.name)), before);
}

// The result is the truth of the first operand, unless that leaves it open: then of the second.
void Lowering::begin_branch(const Node& node) {
  const std::uint32_t first = pop();
  const std::uint32_t out = new_register(0, false);
  code_.instructions.push_back({Op::truth, out, first, 0, 0});
  code_.places.push_back(node.place);
  branches_.push_back({here(), out, available_.size()});
  code_.instructions.push_back(
      {node.kind == Node::Kind::and_begin ? Op::jump_if_false : Op::jump_if_true, 0, out, 0, 0});
  code_.places.push_back(node.place);
}

void Lowering::end_branch(const Node& node) {
  const Branch branch = branches_.back();
  branches_.pop_back();
  code_.instructions.push_back({Op::truth, branch.out, pop(), 0, 0});
  code_.places.push_back(node.place);
  code_.instructions[branch.jump].c = here();
  available_.resize(branch.available);
  put(branch.out);
}

std::uint32_t Lowering::new_register(float value, bool constant) {
  code_.registers.push_back(value);
  constant_.push_back(constant);
  return static_cast<std::uint32_t>(code_.registers.size() - 1);
}

std::uint32_t Lowering::constant_register(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  const auto [place, added] = constants_.try_emplace(bits, 0);
  if (added) place->second = new_register(value, true);
  return place->second;
}

std::uint32_t Lowering::emit(Instruction instruction, const Place& place) {
  const bool shared = !is_random(instruction.op);
  const std::size_t oldest = available_.size() > window ? available_.size() - window : 0;
  for (std::size_t i = available_.size(); shared && i-- > oldest;) {
    instruction.out = available_[i].out;
    if (available_[i] == instruction) return instruction.out;
  }
  instruction.out = new_register(0, false);
  code_.instructions.push_back(instruction);
  code_.places.push_back(place);
  if (shared) available_.push_back(instruction);
  return instruction.out;
}

// Works an instruction out now. One that goes wrong is left for the run, which may never come to it.
bool Lowering::fold(Instruction instruction, const Place& place) {
  if (!is_constant(instruction.a)) return false;
  const std::uint32_t at = here();
  instruction.out = new_register(0, false);
  code_.instructions.push_back(instruction);
  code_.places.push_back(place);
  Diagnostic fault;
  const bool fine = execute(code_, at, at + 1, code_.registers.data(), {}, fault);
  const float value = code_.registers[instruction.out];
  code_.instructions.pop_back();
  code_.places.pop_back();
  code_.registers.pop_back();
  constant_.pop_back();
  if (fine) put(constant_register(value));
  return fine;
}

std::uint32_t Lowering::pop() {
  const std::uint32_t reg = stack_.back();
  stack_.pop_back();
  return reg;
}

}  // namespace panicle::lsystem
