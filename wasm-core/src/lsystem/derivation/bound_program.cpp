#include "lsystem/derivation/bound_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "expression/names.hpp"
#include "expression/number_text.hpp"
#include "lsystem/derivation/machine.hpp"
#include "lsystem/messages.generated.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::uint32_t max_depth = 256;

// Whether a value is finite: infinity and NaN minus themselves are NaN.
bool is_finite(float value) { return value - value == 0; }

// Finds inputs by name. Of several with one name the first counts.
template <class Given>
class Index {
 public:
  explicit Index(const std::vector<Given>& given) : given_(given) {
    for (std::uint32_t i = 0; i < given.size(); ++i)
      if (names_.add(given[i].name) == places_.size()) places_.push_back(i);
  }
  // The input of a name, or null.
  const Given* find(std::string_view name) const {
    const std::uint32_t number = names_.find(name);
    return number == Names::none ? nullptr : &given_[places_[number]];
  }

 private:
  const std::vector<Given>& given_;
  Names names_;
  std::vector<std::uint32_t> places_;
};

// Binder of a compiled program to the inputs of a request: computes its definitions, settings and all that depends on
// them alone. Methods that return a bool return false with the error in `error_`.
class Binder {
 public:
  Binder(std::shared_ptr<const Program> program, const Inputs& inputs, const Limits& limits)
      : program_(*program),
        scalars_(inputs.scalars),
        arrays_(inputs.arrays),
        limits_(limits),
        bound_(std::make_shared<BoundProgram>()) {
    bound_->program = std::move(program);
    bound_->registers = program_.code.registers;
    bound_->precise = program_.code.precise;
    bound_->lists.resize(program_.code.arrays.size());
    bound_->words = program_.words;
  }

  // Computes all values that the inputs decide: declarations, number of steps, settings, depths, and constants in the
  // compiled code.
  Result<std::shared_ptr<const BoundProgram>> run() {
    for (const Declaration& declaration : program_.declarations) {
      const bool array = declaration.kind == Definition::Kind::array;
      if (!(array ? list(declaration) : scalar(declaration))) return error_;
    }
    if (program_.steps.given && !steps()) return error_;
    for (std::size_t i = 0; i < settings_count; ++i)
      if (program_.settings[i].given && !setting(program_.settings[i], bound_->settings[i])) return error_;
    for (std::size_t i = 0; i < program_.depths.size(); ++i)
      if (program_.depths[i].given && !depth(program_.depths[i], bound_->depths[i])) return error_;
    compute_registers();
    if (!fill_in()) return error_;
    return std::shared_ptr<const BoundProgram>(std::move(bound_));
  }

 private:
  bool fail(Reason reason, const SourceLocation& place, const Message& problem) {
    error_ = error_at(reason, place, problem);
    return false;
  }

  // Executes a range of instructions, in the precision of the text.
  bool execute(std::uint32_t begin, std::uint32_t end, Diagnostic& error) {
    const Sources sources{bound_->lists, 0, 0};
    if (program_.code.doubles)
      return lsystem::execute(program_.code, begin, end, bound_->precise.data(), sources, error);
    return lsystem::execute(program_.code, begin, end, bound_->registers.data(), sources, error);
  }

  // The value of a register.
  double value_at(std::uint32_t reg) const {
    return program_.code.doubles ? bound_->precise[reg] : bound_->registers[reg];
  }
  // Sets a register.
  void set(std::uint32_t reg, double value) {
    bound_->registers[reg] = static_cast<float>(value);
    if (program_.code.doubles) bound_->precise[reg] = value;
  }

  // The double that a user means by an input, which is a float: that of the shortest decimal with this float.
  double meant_by(float value) const {
    if (!program_.code.doubles) return value;
    const double size = double_from(number_text(value < 0 ? -value : value));
    return value < 0 ? -size : size;
  }

  // Binds a number: to the value of the request, else, if it is a constant, to that of the text.
  bool scalar(const Declaration& declaration) {
    float value = 0;
    if (const Inputs::Scalar* const given = scalars_.find(declaration.name)) {
      value = given->value;
      if (!is_finite(value))
        return fail(Reason::bad_input, declaration.place,
                    message(messages::lsystem::value_not_finite, declaration.name, number_text(value)));
      set(declaration.to, meant_by(value));
    } else if (declaration.kind == Definition::Kind::input) {
      return fail(Reason::bad_input, declaration.place, message(messages::lsystem::input_missing, declaration.name));
    } else {
      if (!compute_value(declaration.name, declaration.values[0], value)) return false;
      set(declaration.to, value_at(declaration.values[0].source));
    }
    bound_->definitions.push_back({declaration.name, declaration.kind, {value}});
    return true;
  }

  // Computes a finite value. `name` is that of a definition for messages; empty for a setting.
  bool compute_value(std::string_view name, const Value& of, float& value) {
    if (!execute(of.code.begin, of.code.end, error_)) return false;
    value = static_cast<float>(value_at(of.source));
    if (is_finite(value)) return true;
    return fail(Reason::evaluation, of.place,
                name.empty() ? message(messages::lsystem::setting_not_finite, number_text(value))
                             : message(messages::lsystem::result_not_finite, name, number_text(value)));
  }

  // Computes a global setting.
  bool setting(const Value& of, std::optional<float>& value) {
    float worked_out = 0;
    if (!compute_value({}, of, worked_out)) return false;
    value = worked_out;
    return true;
  }

  // Computes the depth of recursion of a section: a whole number from 1 to `max_depth`.
  bool depth(const Value& of, std::uint32_t& depth) {
    float value = 0;
    if (!compute_value({}, of, value)) return false;
    if (!(value >= 1 && value <= max_depth && std::floor(value) == value))
      return fail(Reason::evaluation, of.place,
                  message(messages::lsystem::depth_out_of_range, number_text(value), max_depth));
    depth = static_cast<std::uint32_t>(value);
    return true;
  }

  // Binds an array: to the values of the request, else to those of the text.
  bool list(const Declaration& declaration) {
    const Inputs::Array* const given = arrays_.find(declaration.name);
    if (given == nullptr && !declaration.values.empty()) {
      std::vector<float>& values = bound_->lists[declaration.to];
      for (const Value& of : declaration.values)
        if (!compute_value(declaration.name, of, values.emplace_back())) return false;
      bound_->definitions.push_back({declaration.name, declaration.kind, values});
      return true;
    }
    if (given == nullptr)
      return fail(Reason::bad_input, declaration.place,
                  message(messages::lsystem::array_input_missing, declaration.name));
    for (std::size_t i = 0; i < given->values.size(); ++i)
      if (!is_finite(given->values[i]))
        return fail(
            Reason::bad_input, declaration.place,
            message(messages::lsystem::array_value_not_finite, declaration.name, i + 1, number_text(given->values[i])));
    bound_->lists[declaration.to] = given->values;
    bound_->definitions.push_back({declaration.name, declaration.kind, given->values});
    return true;
  }

  // Computes the derivation length, a whole number within the limit.
  bool steps() {
    if (!execute(program_.steps.code.begin, program_.steps.code.end, error_)) return false;
    const auto value = static_cast<float>(value_at(program_.steps.source));
    if (!(value >= 0 && std::floor(value) == value))
      return fail(Reason::evaluation, program_.steps.place,
                  message(messages::lsystem::steps_not_whole, number_text(value)));
    if (value > static_cast<float>(limits_.steps))
      return fail(Reason::limit, program_.steps.place,
                  message(messages::lsystem::steps_over_limit, number_text(value), limits_.steps));
    bound_->steps = static_cast<std::uint32_t>(value);
    return true;
  }

  // Computes the registers that depend on inputs. Results of errors, and of operands with errors, stay 0, which the
  // turtle takes: productions that need them report the error when they are applied.
  void compute_registers() {
    std::vector<std::uint8_t> wrong(bound_->registers.size(), 0);
    Diagnostic ignored_error;
    for (std::uint32_t at = program_.once_bound.begin; at < program_.once_bound.end; ++at) {
      const Instruction& step = program_.code.instructions[at];
      wrong[step.out] = wrong[step.a] || wrong[step.b] || !execute(at, at + 1, ignored_error);
    }
  }

  // Writes the values that depend on inputs into the templates of successors.
  bool fill_in() {
    for (const Patch& patch : program_.bound_patches) {
      const double precise = value_at(patch.source);
      const auto value = static_cast<float>(precise);
      if (!Machine::meets(patch.demand, value)) {
        error_ = Machine::refusal(program_, patch, value);
        return false;
      }
      std::memcpy(bound_->words.data() + patch.offset, &value, sizeof value);
      if (program_.code.doubles) std::memcpy(bound_->words.data() + patch.precise, &precise, sizeof precise);
    }
    return true;
  }

  const Program& program_;
  const Index<Inputs::Scalar> scalars_;
  const Index<Inputs::Array> arrays_;
  const Limits& limits_;
  std::shared_ptr<BoundProgram> bound_;
  Diagnostic error_;
};

}  // namespace

// Binds a program to inputs. Returns an error for missing or unusable inputs.
Result<std::shared_ptr<const BoundProgram>> bind(std::shared_ptr<const Program> program, const Inputs& inputs,
                                                 const Limits& limits) {
  return Binder(std::move(program), inputs, limits).run();
}

// The compiled program without its inputs.
const Program& program_of(const BoundProgram& bound) { return *bound.program; }

// The value of a definition by its name; `otherwise` if there is none or it is an array.
float constant(const BoundProgram& bound, std::string_view name, float otherwise) {
  const auto found = std::find_if(bound.definitions.begin(), bound.definitions.end(),
                                  [&](const Definition& definition) { return definition.name == name; });
  return found != bound.definitions.end() && found->kind != Definition::Kind::array ? found->values[0] : otherwise;
}

// The number of steps that the text declares; none if it declares none.
std::optional<std::uint32_t> derivation_length(const BoundProgram& bound) { return bound.steps; }

// The declarations with their values.
std::span<const Definition> definitions(const BoundProgram& bound) { return bound.definitions; }

}  // namespace panicle::lsystem
