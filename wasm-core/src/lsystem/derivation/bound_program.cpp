#include "lsystem/derivation/bound_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "expression/names.hpp"
#include "expression/number_text.hpp"
#include "lsystem/derivation/machine.hpp"

namespace panicle::lsystem {
namespace {

constexpr std::uint32_t most_depth = 256;

bool is_finite(float value) { return value - value == 0; }

// Finds inputs by name. Of several with one name the first counts.
template <class Given>
class Index {
 public:
  explicit Index(const std::vector<Given>& given) : given_(given) {
    for (std::uint32_t i = 0; i < given.size(); ++i)
      if (names_.add(given[i].name) == places_.size()) places_.push_back(i);
  }
  const Given* find(std::string_view name) const {
    const std::uint32_t number = names_.find(name);
    return number == Names::none ? nullptr : &given_[places_[number]];
  }

 private:
  const std::vector<Given>& given_;
  Names names_;
  std::vector<std::uint32_t> places_;
};

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

  Result<std::shared_ptr<const BoundProgram>> run() {
    for (const Declaration& declaration : program_.declarations) {
      const bool array = declaration.kind == Definition::Kind::array;
      if (!(array ? list(declaration) : scalar(declaration))) return trouble_;
    }
    if (program_.steps.given && !steps()) return trouble_;
    for (std::size_t i = 0; i < settings_count; ++i)
      if (program_.settings[i].given && !setting(program_.settings[i], bound_->settings[i])) return trouble_;
    for (std::size_t i = 0; i < program_.depths.size(); ++i)
      if (program_.depths[i].given && !depth(program_.depths[i], bound_->depths[i])) return trouble_;
    compute_registers();
    if (!fill_in()) return trouble_;
    return std::shared_ptr<const BoundProgram>(std::move(bound_));
  }

 private:
  bool fail(Reason reason, const SourceLocation& place, const char* pattern, Pieces pieces = {}) {
    trouble_ = error_at(reason, place, pattern, pieces);
    return false;
  }

  bool execute(std::uint32_t begin, std::uint32_t end, Diagnostic& trouble) {
    const Sources sources{bound_->lists, 0, 0};
    if (program_.code.doubles)
      return lsystem::execute(program_.code, begin, end, bound_->precise.data(), sources, trouble);
    return lsystem::execute(program_.code, begin, end, bound_->registers.data(), sources, trouble);
  }

  double value_at(std::uint32_t reg) const {
    return program_.code.doubles ? bound_->precise[reg] : bound_->registers[reg];
  }
  void set(std::uint32_t reg, double value) {
    bound_->registers[reg] = static_cast<float>(value);
    if (program_.code.doubles) bound_->precise[reg] = value;
  }

  // An input is a float; its double is that of the shortest decimal with this float.
  double meant_by(float value) const {
    if (!program_.code.doubles) return value;
    const double size = double_from(number_text(value < 0 ? -value : value));
    return value < 0 ? -size : size;
  }

  bool scalar(const Declaration& declaration) {
    float value = 0;
    if (const Inputs::Scalar* const given = scalars_.find(declaration.name)) {
      value = given->value;
      if (!is_finite(value))
        return fail(Reason::bad_input, declaration.place, "'%' was given %; give it a finite number.",
                    {declaration.name, number_text(value)});
      set(declaration.to, meant_by(value));
    } else if (declaration.kind == Definition::Kind::input) {
      return fail(Reason::bad_input, declaration.place, "The input '%' has no value; give it one with the request.",
                  {declaration.name});
    } else {
      if (!compute_value(declaration.name, declaration.values[0], value)) return false;
      set(declaration.to, value_at(declaration.values[0].source));
    }
    bound_->definitions.push_back({declaration.name, declaration.kind, {value}});
    return true;
  }

  bool compute_value(std::string_view name, const Value& of, float& value) {
    if (!execute(of.code.begin, of.code.end, trouble_)) return false;
    value = static_cast<float>(value_at(of.source));
    return is_finite(value) || fail(Reason::evaluation, of.place, "'%' comes to %; it must be a finite number.",
                                    {name, number_text(value)});
  }

  bool setting(const Value& of, std::optional<float>& value) {
    float worked_out = 0;
    if (!compute_value("This line", of, worked_out)) return false;
    value = worked_out;
    return true;
  }

  bool depth(const Value& of, std::uint32_t& depth) {
    float value = 0;
    if (!compute_value("The depth", of, value)) return false;
    if (!(value >= 1 && value <= most_depth && std::floor(value) == value))
      return fail(Reason::evaluation, of.place, "The maximum depth comes to %; it must be a whole number from 1 to %.",
                  {number_text(value), std::to_string(most_depth)});
    depth = static_cast<std::uint32_t>(value);
    return true;
  }

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
      return fail(Reason::bad_input, declaration.place, "The input '%[]' has no values; give it some with the request.",
                  {declaration.name});
    for (std::size_t i = 0; i < given->values.size(); ++i)
      if (!is_finite(given->values[i]))
        return fail(Reason::bad_input, declaration.place, "%[%] was given %; give it a finite number.",
                    {declaration.name, std::to_string(i + 1), number_text(given->values[i])});
    bound_->lists[declaration.to] = given->values;
    bound_->definitions.push_back({declaration.name, declaration.kind, given->values});
    return true;
  }

  bool steps() {
    if (!execute(program_.steps.code.begin, program_.steps.code.end, trouble_)) return false;
    const auto value = static_cast<float>(value_at(program_.steps.source));
    if (!(value >= 0 && std::floor(value) == value))
      return fail(Reason::evaluation, program_.steps.place,
                  "The derivation length comes to %; it must be a whole number of 0 or more.", {number_text(value)});
    if (value > static_cast<float>(limits_.steps))
      return fail(Reason::limit, program_.steps.place, "The derivation length comes to %; the limit is % steps.",
                  {number_text(value), std::to_string(limits_.steps)});
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

  bool fill_in() {
    for (const Patch& patch : program_.bound_patches) {
      const double precise = value_at(patch.source);
      const auto value = static_cast<float>(precise);
      if (!Machine::meets(patch.demand, value)) {
        trouble_ = Machine::refusal(program_, patch, value);
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
  Diagnostic trouble_;
};

}  // namespace

Result<std::shared_ptr<const BoundProgram>> bind(std::shared_ptr<const Program> program, const Inputs& inputs,
                                                 const Limits& limits) {
  return Binder(std::move(program), inputs, limits).run();
}

const Program& program_of(const BoundProgram& bound) { return *bound.program; }

float constant(const BoundProgram& bound, std::string_view name, float otherwise) {
  const auto found = std::find_if(bound.definitions.begin(), bound.definitions.end(),
                                  [&](const Definition& definition) { return definition.name == name; });
  return found != bound.definitions.end() && found->kind != Definition::Kind::array ? found->values[0] : otherwise;
}

std::optional<std::uint32_t> derivation_length(const BoundProgram& bound) { return bound.steps; }

std::span<const Definition> definitions(const BoundProgram& bound) { return bound.definitions; }

}  // namespace panicle::lsystem
