// Reads the declarations of a growth grammar: its footprint, and the divisor functions of its tree.
#include <algorithm>
#include <utility>

#include "models/growth/messages.generated.hpp"
#include "models/growth/reader.hpp"

namespace panicle::growth {
namespace {

using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

struct AttributeName {
  std::string_view name;
  Attribute::Kind kind;
};
constexpr AttributeName attribute_names[] = {
    {"cnt", Attribute::Kind::count},       {"id", Attribute::Kind::id},     {"wb", Attribute::Kind::base},
    {"h", Attribute::Kind::height},        {"wt", Attribute::Kind::top},    {"grad", Attribute::Kind::gradient},
    {"towards", Attribute::Kind::towards}, {"wm", Attribute::Kind::middle},
};
// Number of attributes that may be given without names, in this order.
constexpr std::size_t in_brackets = 6;

}  // namespace

// Reads `footprint -> GrowVol(…), GrowVol(…)`. As all readers here, returns false with the error in `trouble_`.
bool GrowthReader::footprint() {
  ++at_;
  if (at_ != arrow_) return wrong(here(), message(messages::growth::footprint_condition, found_text()));
  if (successors_end_ < end_)
    return wrong(tokens_[successors_end_].place, message(messages::growth::footprint_probability));
  ++at_;
  do {
    if (on_sign(',')) ++at_;
    if (!growth_volume()) return false;
  } while (at_ < end_);
  return true;
}

// Reads `GrowVol(…)`: six numbers in their order or none, then named attributes such as `at(1, 2)` or `h.rand(3, 4)`.
bool GrowthReader::growth_volume() {
  if (!on("GrowVol") || !opens(at_ + 1)) return wrong(here(), message(messages::growth::volume_expected, found_text()));
  VolumeRule rule;
  rule.place = here();
  at_ += 2;
  std::vector<Number> values;
  while (!on_sign(')')) {
    if (at_ >= end_) return never_closed(rule.place);
    if (on_name() && opens(at_ + 1)) {
      std::string_view name = tokens_[at_].text;
      if (const std::size_t part = name.find('.'); part != std::string_view::npos) name = name.substr(0, part);
      const bool known = name == "size" || name == "at" ||
                         std::any_of(std::begin(attribute_names), std::end(attribute_names),
                                     [&](const AttributeName& each) { return each.name == name; });
      if (known || tokens_[at_].text.size() > name.size()) {
        if (!attribute(name, rule) || !next_argument()) return false;
        continue;
      }
    }
    if (!rule.attributes.empty()) return wrong(here(), message(messages::growth::volume_unnamed_value));
    if (!number(end_, 0, values.emplace_back()) || !next_argument()) return false;
  }
  ++at_;
  if (!values.empty() && !positional(values, rule)) return false;
  rules_.footprint.push_back(std::move(rule));
  return true;
}

// Skips the comma between two arguments; at the closing bracket there is none to skip.
bool GrowthReader::next_argument() {
  if (on_sign(')') || at_ >= end_) return true;
  if (!expect_comma()) return false;
  return !on_sign(')') || wrong(here(), message(messages::growth::value_after_comma));
}

// Adds the six values that were given without names as attributes, in their fixed order.
bool GrowthReader::positional(std::vector<Number>& values, VolumeRule& rule) {
  if (values.size() != in_brackets) return wrong(rule.place, message(messages::growth::volume_values));
  std::vector<Attribute> attributes;
  for (std::size_t i = 0; i < values.size(); ++i)
    attributes.push_back({attribute_names[i].kind, false, {values[i], {}}});
  rule.attributes.insert(rule.attributes.begin(), attributes.begin(), attributes.end());
  return true;
}

// Reads a named attribute such as `h(3)` or `h.rand(3, 4)`; `name` is its name without `.rand`.
bool GrowthReader::attribute(std::string_view name, VolumeRule& rule) {
  const Token& token = tokens_[at_];
  const std::string_view part = token.text.substr(name.size());
  if (!part.empty() && part != ".rand")
    return wrong(token.place, message(messages::growth::attribute_part, token.text, name));
  ++at_;
  std::vector<Number> values;
  return numbers(0, values) && range_of(values, !part.empty(), name, rule, token.place);
}

// Adds the attribute `name` of a growth volume to a rule; `drawn`: the values are limits between which its value is
// drawn.
bool GrowthReader::range_of(std::vector<Number>& values, bool drawn, std::string_view name, VolumeRule& rule,
                            const SourceLocation& place) {
  if (name == "size") {
    if (values.size() != 4)
      return wrong(place, message(messages::growth::attribute_four_numbers, drawn ? "size.rand" : name));
    for (std::size_t i = 0; i < 4; ++i) {
      Attribute attribute{attribute_names[2 + i].kind, drawn, {}};
      attribute.range[drawn ? 1 : 0] = values[i];
      rule.attributes.push_back(attribute);
    }
    return true;
  }
  if (name == "at") {
    if (drawn || values.size() != 2) return wrong(place, message(messages::growth::attribute_place));
    rule.attributes.push_back({Attribute::Kind::at, false, {values[0], values[1]}});
    return true;
  }
  const auto* const known = std::find_if(std::begin(attribute_names), std::end(attribute_names),
                                         [&](const AttributeName& each) { return each.name == name; });
  if (known == std::end(attribute_names))
    return fail(Reason::undefined, place, message(messages::growth::attribute_unknown, name));
  if (values.empty() || values.size() > (drawn ? 2u : 1u))
    return wrong(place, message(drawn ? messages::growth::attribute_random : messages::growth::one_number, name));
  Attribute attribute{known->kind, drawn, {}};
  if (drawn && values.size() == 1) {
    attribute.range[1] = values[0];
  } else {
    std::copy(values.begin(), values.end(), attribute.range.begin());
  }
  rule.attributes.push_back(attribute);
  return true;
}

// Reads `tree -> DivFunc(…){…}, DivFunc(…){…} : weight`: the divisor functions that count branches and leaves.
bool GrowthReader::tree() {
  TreeRule rule;
  rule.place = here();
  ++at_;
  if (at_ != arrow_) return wrong(here(), message(messages::growth::tree_condition, found_text()));
  ++at_;
  do {
    if (on_sign(',') && !rule.functions.empty()) ++at_;
    if (!divisor_function(rule)) return false;
  } while (at_ < successors_end_);
  if (!weight(rule.weight)) return false;
  rules_.tree.push_back(std::move(rule));
  return true;
}

// Reads `DivFunc("sigma1"){branches}`: the quoted type, its parameters, and whether it counts branches or leaves.
bool GrowthReader::divisor_function(TreeRule& rule) {
  if (!(at_ < successors_end_ && tokens_[at_].is("DivFunc") && opens(at_ + 1)))
    return wrong(here(), message(messages::growth::function_expected, "DivFunc(\"sigma1\"){branches}", found_text()));
  DivisorFunction function;
  function.place = here();
  at_ += 2;
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::quoted)
    return wrong(here(), message(messages::growth::function_type));
  const Token& type = tokens_[at_++];
  if (!type_of(type, function)) return false;
  while (!on_sign(')')) {
    if (at_ >= end_) return never_closed(function.place);
    if (!expect_comma() || !number(end_, 0, function.parameters.emplace_back())) return false;
  }
  ++at_;
  if (!parameters_fit(type, function)) return false;
  const Message braces = message(messages::growth::function_target, "{branches}", "{leaves}");
  if (!on_sign('{')) return wrong(here(), braces);
  ++at_;
  const std::string_view what = found();
  if (!on_name() || !(what == "branches" || what == "branch" || what == "leaves" || what == "leaf"))
    return wrong(here(), braces);
  function.of = what[0] == 'b' ? DivisorFunction::Of::branches : DivisorFunction::Of::leaves;
  ++at_;
  if (!expect('}')) return false;
  rule.functions.push_back(std::move(function));
  return true;
}

// Reads the type of a divisor function with its power, such as "sigma1" or "hat2"; "exp" is a factor of the argument.
bool GrowthReader::type_of(const Token& token, DivisorFunction& function) {
  std::string_view name = token.text;
  struct Type {
    std::string_view name;
    DivisorRule::Kind kind;
  };
  static constexpr Type types[] = {{"sigma", DivisorRule::Kind::all},
                                   {"hat", DivisorRule::Kind::alternating},
                                   {"star", DivisorRule::Kind::odd_quotient}};
  if (name == "exp") return function.argument = true;
  for (const Type& type : types) {
    if (name.substr(0, type.name.size()) != type.name) continue;
    name.remove_prefix(type.name.size());
    function.kind = type.kind;
    while (!name.empty() && name[0] >= '0' && name[0] <= '9' && function.power < 100) {
      function.power = 10 * function.power + static_cast<std::uint32_t>(name[0] - '0');
      function.powered = true;
      name.remove_prefix(1);
    }
    if (name == "b" && type.kind == DivisorRule::Kind::all) {
      function.kind = DivisorRule::Kind::residue;
      name = {};
    }
    if (name.empty()) return true;
    break;
  }
  return fail(Reason::undefined, token.place, message(messages::growth::function_unknown, token.text));
}

// Whether a divisor function has as many parameters as its type needs: two for the factor exp; else the power, where
// the name does not have it, and a remainder and a modulus for a residue.
bool GrowthReader::parameters_fit(const Token& type, DivisorFunction& function) {
  const bool residue = function.kind == DivisorRule::Kind::residue;
  const std::size_t wanted = function.argument ? 2 : (function.powered ? 0u : 1u) + (residue ? 2u : 0u);
  if (function.parameters.size() == wanted) return true;
  MessageCode<1> problem = messages::growth::function_power;
  if (function.argument) {
    problem = messages::growth::function_exponent;
  } else if (residue) {
    problem = function.powered ? messages::growth::function_remainder : messages::growth::function_power_remainder;
  } else if (function.powered) {
    problem = messages::growth::function_no_number;
  }
  return wrong(type.place, message(problem, type.text));
}

}  // namespace panicle::growth
