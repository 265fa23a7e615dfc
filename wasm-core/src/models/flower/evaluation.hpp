// Evaluates a flower's numbers for a volume, a step and an address of random values.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "models/flower/syntax/program.hpp"

namespace panicle::flower {

// Position of a volume in its organ. The axis of an instance is the chain of volumes end on end from its first one; all
// others are beside it, as far along as the volume that they grow from, and one further out.
struct Rank {
  std::uint16_t along = 0, beside = 0;
};

// Values given besides the text.
struct Given {
  struct Value {
    std::string name;  // of a variable of the text itself
    float value = 0;
  };
  std::vector<Value> values;
  std::uint32_t steps = 0;  // of the text itself; 0: the text's own number
  float age = 1;
  std::uint64_t seed = 1;
};

// The values of a call's settings: variables, by their index in the program and in that order, and their values.
using GivenVariables = std::vector<std::pair<std::uint32_t, float>>;

class FlowerEvaluation {
 public:
  FlowerEvaluation(const Program& program, const Given& given);
  FlowerEvaluation(const FlowerEvaluation&) = delete;

  // Evaluates the variables of all grammars, and the number of steps of each. False: `error()`.
  bool bind(const Limits& limits);
  // Number of steps of the entered instance.
  std::uint32_t steps() const { return own_steps_; }
  // Sets the values of a grammar's variables to those of one of its instances, whose own draws go by `address`.
  bool enter(std::uint32_t grammar, std::uint64_t address, const GivenVariables& given);

  // Sets the volume that a production is for, or that another grows from.
  void set_volume(const VolumeValues& values, const Rank& rank, std::uint32_t step);
  // Sets the word of the text for the number of the side face.
  void set_face(std::uint32_t side) { set(Word::face, static_cast<float>(side)); }
  bool holds(const Number& condition, std::uint64_t address);
  bool run(expression::Range code, std::uint64_t address);
  // The value of a register.
  float at(std::uint32_t source) const { return registers_[source]; }
  // Evaluates a description and overwrites the values that it gives. False: `error()`.
  bool describe(const Description& description, std::uint64_t address, VolumeValues& values);

  // Evaluates the settings of a call, for a module's variables.
  bool evaluate_settings(const std::vector<Setting>& settings, std::uint64_t address, GivenVariables& given);

  // Work of all evaluations so far, in instructions and values, for limits of work: it depends on the text, and not on
  // the results.
  std::uint64_t work() const { return work_; }
  // Variables of the text itself, by their index in the program, as they were bound.
  const std::vector<float>& variables() const { return variables_; }
  bool failed() const { return error_.reason != Reason::none; }
  const Diagnostic& error() const { return error_; }
  // Stores an error; returns false.
  bool fail(Diagnostic error) {
    error_ = std::move(error);
    return false;
  }

 private:
  void set(Word word, float value) { registers_[static_cast<std::size_t>(word)] = value; }
  bool variables(std::uint32_t grammar, std::uint64_t address, const GivenVariables& given);
  // Sets a variable to the value that the request gives it (only variables of the text itself, grammar 0), else to its
  // expression's, whose random values go by `random_address`. False: `error()`.
  bool bind_variable(std::size_t index, std::uint64_t random_address);
  bool is_finite(std::uint32_t variable, float value, const expression::SourceLocation& place);
  void execute_once_bound(std::uint32_t begin, std::uint32_t end);
  bool count(const Number& number, std::uint32_t& steps);

  const Program& program_;
  const Given& given_;
  std::vector<float> registers_;
  std::vector<float> variables_;
  std::vector<std::uint32_t> steps_;  // by grammar
  std::uint32_t own_steps_ = 0, max_steps_ = 0;
  expression::Sources sources_;
  std::uint64_t work_ = 0;
  Diagnostic error_;
};

}  // namespace panicle::flower
