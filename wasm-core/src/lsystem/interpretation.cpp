#include "lsystem/interpretation.hpp"

#include <string>

#include "lsystem/branch.hpp"
#include "lsystem/machine.hpp"
#include "lsystem/parser.hpp"

namespace panicle::lsystem {
namespace {

bool is_finite(const glm::vec3& p) { return p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0; }

// What becomes of ?E.
enum class Questions : std::uint8_t { drawn, written, unasked };

class Interpreter {
 public:
  Interpreter(const Bound& bound, const Turtle& start, Listener& listener, std::uint64_t seed, const Limits& limits)
      : machine_(bound, seed, limits), program_(*bound.program), limits_(limits), listener_(listener), turtle_(start) {}

  // `answered` is the string itself where answers are written into it.
  Result<std::uint32_t> run(const String& string, Questions questions, String* answered = nullptr) {
    questions_ = questions;
    answered_ = answered;
    if (questions == Questions::drawn && program_.not_drawable.reason != Reason::none) return program_.not_drawable;
    const std::uint32_t* at = string.begin();
    const std::uint32_t* const end = string.end();
    while (at < end) {
      const std::uint32_t* const module = at;
      at += words_of(*module);
      if (symbol_of(*module) == ask_symbol) {
        if (ask(module)) at = rest_of_branch(at, end).end;
      } else if (is_turtle_symbol(symbol_of(*module))) {
        if (act(module, module)) at = rest_of_branch(at, end).end;
      }
      if (machine_.failed()) return machine_.trouble();
    }
    return static_cast<std::uint32_t>(lines_);
  }

 private:
  // Does what one module of the turtle says, with the lineage of `bearer`. True: the rest of the branch is cut.
  bool act(const std::uint32_t* module, const std::uint32_t* bearer) {
    const TurtleSymbol& symbol = turtle_symbols[symbol_of(*module)];
    float value = symbol.standard;
    if (parameters_of(*module) > 0) std::memcpy(&value, module + 1, sizeof value);
    switch (symbol.action) {
      case Action::line:
        line(value, bearer);
        break;
      case Action::move:
        move(value);
        break;
      case Action::sphere:
        sphere(value, bearer);
        break;
      case Action::turn:
        turn(turtle_, symbol.sign * value);
        break;
      case Action::pitch:
        pitch(turtle_, symbol.sign * value);
        break;
      case Action::roll:
        roll(turtle_, symbol.sign * value);
        break;
      case Action::width:
        turtle_.width = value;
        break;
      case Action::push:
        push();
        break;
      case Action::pop:
        turtle_ = stack_.back();
        stack_.pop_back();
        break;
      case Action::cut:
        listener_.cut(turtle_);
        return true;
      case Action::ask:
        break;
    }
    return false;
  }

  Lineage lineage_of(const std::uint32_t* module) const {
    if (!has_lineage(*module)) return {};
    const Origin origin = origin_of(module);
    const std::uint32_t parent = origin.ancestors & 0xffff, grandparent = origin.ancestors >> 16;
    return {name_of(parent), name_of(grandparent), origin.address, parent, grandparent};
  }

  std::string_view name_of(std::uint32_t symbol) const {
    return symbol == no_symbol ? std::string_view() : std::string_view(program_.symbols[symbol]);
  }

  void move(float distance) {
    turtle_.position = ahead(turtle_, distance);
    if (!is_finite(turtle_.position))
      machine_.fail(error_at(Reason::evaluation, {},
                             "The turtle has gone too far for its position to be a number; shorten its lines."));
  }

  void line(float distance, const std::uint32_t* bearer) {
    if (distance == 0) return;
    const Turtle before = turtle_;
    move(distance);
    if (machine_.failed()) return;
    turtle_.line = lines_++;
    listener_.line(turtle_.line, before, turtle_, lineage_of(bearer));
  }

  void sphere(float radius, const std::uint32_t* bearer) {
    if (radius == 0) return;
    move(radius);
    if (!machine_.failed()) listener_.sphere(turtle_, radius, lineage_of(bearer));
  }

  void push() {
    if (stack_.size() < limits_.depth) {
      stack_.push_back(turtle_);
      return;
    }
    machine_.fail(error_at(Reason::limit, {},
                           "More than % branches are open at once, which is the limit; nest fewer brackets.",
                           {std::to_string(limits_.depth)}));
  }

  // True: the answer cut the branch.
  bool ask(const std::uint32_t* module) {
    if (questions_ == Questions::unasked) return false;
    const std::uint32_t count = parameters_of(*module);
    float parameters[most_parameters];
    std::memcpy(parameters, module + 1, count * sizeof(float));
    listener_.ask(turtle_, {parameters, count}, lineage_of(module));
    if (questions_ == Questions::drawn) return draw_answer(module, parameters, count);
    std::memcpy(answered_->words.data() + (module - answered_->begin()) + 1, parameters, count * sizeof(float));
    return false;
  }

  // Applies the production that matches the answer and draws its successor in place.
  bool draw_answer(const std::uint32_t* module, const float* parameters, std::uint32_t count) {
    std::uint32_t answered[1 + most_parameters + lineage_words + block] = {};
    std::memcpy(answered, module, words_of(*module) * sizeof *module);
    std::memcpy(answered + 1, parameters, count * sizeof(float));
    const Production* const production = machine_.choose(answered);
    if (production == nullptr) return false;
    const Template& successor = production->successor;
    if (!answer_.reserve(successor.words, successor.words))
      return !machine_.fail(
          error_at(Reason::limit, {}, "There is no memory for the answer of ?E; make its production shorter."));
    if (!machine_.write(successor, answer_.data(), {}, ask_symbol)) return false;
    return draw(answer_.data(), answer_.data() + successor.words, module);
  }

  bool draw(const std::uint32_t* at, const std::uint32_t* end, const std::uint32_t* bearer) {
    while (at < end) {
      const std::uint32_t* const module = at;
      at += words_of(*module);
      const bool cut = act(module, bearer);
      if (machine_.failed()) return false;
      if (!cut) continue;
      at = rest_of_branch(at, end).end;
      if (at == end) return true;
    }
    return false;
  }

  Machine machine_;
  const Program& program_;
  const Limits& limits_;
  Listener& listener_;
  Turtle turtle_;
  std::vector<Turtle> stack_;
  Words answer_;
  Questions questions_ = Questions::drawn;
  String* answered_ = nullptr;
  std::int32_t lines_ = 0;
};

}  // namespace

Result<std::uint32_t> interpret(const Bound& bound, const String& string, const Turtle& start, Listener& listener,
                                std::uint64_t seed, const Limits& limits) {
  return Interpreter(bound, start, listener, seed, limits).run(string, Questions::drawn);
}

Result<std::uint32_t> trace(const Bound& bound, const String& string, const Turtle& start, Listener& listener,
                            const Limits& limits) {
  return Interpreter(bound, start, listener, 0, limits).run(string, Questions::unasked);
}

Diagnostic answer(const Bound& bound, String& string, const Turtle& start, Listener& listener, const Limits& limits) {
  const auto walked = Interpreter(bound, start, listener, 0, limits).run(string, Questions::written, &string);
  return walked ? Diagnostic{} : walked.error();
}

}  // namespace panicle::lsystem
