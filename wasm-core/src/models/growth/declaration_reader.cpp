// Reads the declarations of a growth grammar: its footprint, and the divisor functions of its tree.
#include <algorithm>
#include <utility>

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

bool GrowthReader::footprint() {
  ++at_;
  if (at_ != arrow_)
    return wrong(here(), "A footprint has no condition; an arrow is expected here, not '%'.", {found()});
  if (successors_end_ < end_)
    return wrong(tokens_[successors_end_].place, "A footprint is certain; take the probability out.");
  ++at_;
  do {
    if (on_sign(',')) ++at_;
    if (!growth_volume()) return false;
  } while (at_ < end_);
  return true;
}

bool GrowthReader::growth_volume() {
  if (!(on_name() && tokens_[at_].is("GrowVol") && opens(at_ + 1)))
    return wrong(here(), "A footprint consists of growth volumes: GrowVol(cnt, id, wb, h, wt, grad), not '%'.",
                 {found()});
  VolumeRule rule;
  rule.place = here();
  at_ += 2;
  std::vector<Number> values;
  while (!on_sign(')')) {
    if (at_ >= end_) return wrong(rule.place, "This ( is never closed.");
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
    if (!rule.attributes.empty())
      return wrong(here(), "What has no name comes first in GrowVol(…); name it, as in h(10), or put it before.");
    if (!number(end_, 0, values.emplace_back()) || !next_argument()) return false;
  }
  ++at_;
  if (!values.empty() && !positional(values, rule)) return false;
  rules_.footprint.push_back(std::move(rule));
  return true;
}

// Skips a comma that another value follows; the end of the brackets needs none.
bool GrowthReader::next_argument() {
  if (on_sign(')') || at_ >= end_) return true;
  if (!expect(',', "A comma is expected here, not '%'.")) return false;
  return !on_sign(')') || wrong(here(), "A value is missing here; take the comma before it out.");
}

bool GrowthReader::positional(std::vector<Number>& values, VolumeRule& rule) {
  if (values.size() != in_brackets)
    return wrong(rule.place, "GrowVol takes (cnt, id, wb, h, wt, grad), or each by its name, as in h(10).");
  std::vector<Attribute> attributes;
  for (std::size_t i = 0; i < values.size(); ++i)
    attributes.push_back({attribute_names[i].kind, false, {values[i], {}}});
  rule.attributes.insert(rule.attributes.begin(), attributes.begin(), attributes.end());
  return true;
}

bool GrowthReader::attribute(std::string_view name, VolumeRule& rule) {
  const Token& token = tokens_[at_];
  const std::string_view part = token.text.substr(name.size());
  if (!part.empty() && part != ".rand")
    return wrong(token.place, "Of % there is %.rand(…), not %.", {name, name, token.text});
  ++at_;
  std::vector<Number> values;
  return numbers(0, values) && range_of(values, !part.empty(), name, rule, token.place);
}

bool GrowthReader::range_of(std::vector<Number>& values, bool drawn, std::string_view name, VolumeRule& rule,
                            const SourceLocation& place) {
  if (name == "size") {
    if (values.size() != 4)
      return wrong(place, "% takes four numbers: wb, h, wt and grad.", {drawn ? "size.rand" : name});
    for (std::size_t i = 0; i < 4; ++i) {
      Attribute attribute{attribute_names[2 + i].kind, drawn, {}};
      attribute.range[drawn ? 1 : 0] = values[i];
      rule.attributes.push_back(attribute);
    }
    return true;
  }
  if (name == "at") {
    if (drawn || values.size() != 2) return wrong(place, "A volume's place is at(x, z), in metres.");
    rule.attributes.push_back({Attribute::Kind::at, false, {values[0], values[1]}});
    return true;
  }
  const auto* const known = std::find_if(std::begin(attribute_names), std::end(attribute_names),
                                         [&](const AttributeName& each) { return each.name == name; });
  if (known == std::end(attribute_names))
    return fail(Reason::undefined, place,
                "A growth volume has cnt, id, wb, h, wt, grad, wm, size, towards and at, not %.", {name});
  if (values.empty() || values.size() > (drawn ? 2u : 1u))
    return wrong(place, drawn ? "%.rand takes the most, or the least and the most." : "% takes one number.", {name});
  Attribute attribute{known->kind, drawn, {}};
  if (drawn && values.size() == 1) {
    attribute.range[1] = values[0];
  } else {
    std::copy(values.begin(), values.end(), attribute.range.begin());
  }
  rule.attributes.push_back(attribute);
  return true;
}

bool GrowthReader::tree() {
  TreeRule rule;
  rule.place = here();
  ++at_;
  if (at_ != arrow_) return wrong(here(), "A tree has no condition; an arrow is expected here, not '%'.", {found()});
  ++at_;
  do {
    if (on_sign(',') && !rule.functions.empty()) ++at_;
    if (!divisor_function(rule)) return false;
  } while (at_ < successors_end_);
  if (!weight(rule.weight)) return false;
  rules_.tree.push_back(std::move(rule));
  return true;
}

bool GrowthReader::divisor_function(TreeRule& rule) {
  if (!(at_ < successors_end_ && tokens_[at_].is("DivFunc") && opens(at_ + 1)))
    return wrong(here(), "A tree consists of divisor functions: DivFunc(\"sigma1\"){branches}, not '%'.", {found()});
  DivisorFunction function;
  function.place = here();
  at_ += 2;
  if (at_ >= end_ || tokens_[at_].kind != TokenKind::quoted)
    return wrong(
        here(),
        "The type of a divisor function stands in quotes: \"sigma1\", \"sigma1b\", \"hat1\", \"star1\", \"exp\".");
  const Token& type = tokens_[at_++];
  if (!type_of(type, function)) return false;
  while (!on_sign(')')) {
    if (at_ >= end_) return wrong(function.place, "This ( is never closed.");
    if (!expect(',', "A comma is expected here, not '%'.") || !number(end_, 0, function.parameters.emplace_back()))
      return false;
  }
  ++at_;
  if (!parameters_fit(type, function)) return false;
  const char* const braces = "What a divisor function is for stands behind it: {branches} or {leaves}.";
  if (!on_sign('{')) return wrong(here(), braces);
  ++at_;
  const std::string_view what = found();
  if (!on_name() || !(what == "branches" || what == "branch" || what == "leaves" || what == "leaf"))
    return wrong(here(), braces);
  function.of = what[0] == 'b' ? DivisorFunction::Of::branches : DivisorFunction::Of::leaves;
  ++at_;
  if (!expect('}', "A } is expected here, not '%'.")) return false;
  rule.functions.push_back(std::move(function));
  return true;
}

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
  return fail(
      Reason::undefined, token.place,
      "There is no divisor function \"%\"; there are \"sigma1\" (all divisors, to the power 1), \"sigma1b\" (those "
      "with a remainder), \"hat1\" (even ones negative), \"star1\" (those with odd quotients), and \"exp\" (B(x, y) = "
      "x^y).",
      {token.text});
}

bool GrowthReader::parameters_fit(const Token& type, DivisorFunction& function) {
  const bool residue = function.kind == DivisorRule::Kind::residue;
  const std::size_t wanted = function.argument ? 2 : (function.powered ? 0u : 1u) + (residue ? 2u : 0u);
  if (function.parameters.size() == wanted) return true;
  const char* sentence = "\"%\" takes its power, as in DivFunc(\"%\", 1).";
  if (function.argument) {
    sentence = "\"%\" takes x and y of x^y, as in DivFunc(\"%\", 3, 1).";
  } else if (residue) {
    sentence = function.powered ? "\"%\" takes the remainder b and what is divided by, m, as in DivFunc(\"%\", 0, 2)."
                                : "\"%\" takes the power, the remainder b and m, as in DivFunc(\"%\", 1, 0, 2).";
  } else if (function.powered) {
    sentence = "\"%\" has its power in its name and takes no number: DivFunc(\"%\").";
  }
  return wrong(type.place, sentence, {type.text, type.text});
}

}  // namespace panicle::growth
