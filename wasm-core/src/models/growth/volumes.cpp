#include "models/growth/volumes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "expression/diagnostics.hpp"
#include "expression/number_text.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/growth/messages.generated.hpp"

namespace panicle::growth {
namespace {

using expression::error_at;

// Rounds drawn values to centimetres and hundredths of degrees, so that a text can state them exactly.
float rounded(float value) { return std::floor(value * 100 + 0.5f) / 100; }

// Angle from one volume to the next about the first, in degrees, and their distance, in sums of their half widths:
// crowns meet and trunks do not.
constexpr float turn = 137.5f, spacing = 0.6f;
// Largest number below which a float holds every whole number.
constexpr std::int64_t exact = std::int64_t{1} << 24;

// Bounds of an attribute, and its least value if it is drawn.
struct Bounds {
  const char* what;
  float least, most, least_drawn;
};
// By Attribute::Kind. A drawn size is at least 1, as the paper has it of child trunks: [1, …].
constexpr Bounds bounds[] = {
    {"cnt", 1, max_volumes, 1}, {"id", 0, 1e6f, 1},     {"wb", 0, 1000, 1},
    {"h", 0.1f, 1000, 1},       {"wt", 0, 1000, 1},     {"grad", -80, 80, 0},
    {"towards", -360, 360, 0},  {"at", -1e4f, 1e4f, 0}, {"wm", 0, 1000, 1},
};

// The width halfway up a frustum.
float mean_width(const GrowthVolume& volume) { return (volume.base + volume.top) / 2; }

// Evaluates or draws the attributes of growth volumes. Methods return false with the error in `evaluation`.
struct Drawer {
  const Rules& rules;
  std::uint64_t seed;
  GrowthEvaluation& evaluation;

  // Evaluates or draws an attribute; `address` is that of the volume's random values.
  bool value(const Attribute& attribute, std::uint64_t address, float& out) {
    const Bounds& allowed = bounds[static_cast<std::size_t>(attribute.kind)];
    evaluation.at(address);
    if (!attribute.drawn) return evaluation.within(attribute.range[0], allowed.least, allowed.most, allowed.what, out);
    float least = allowed.least_drawn, most = 0;
    if (!evaluation.within(attribute.range[1], allowed.least, allowed.most, allowed.what, most)) return false;
    if (!attribute.range[0].value.given) {
      least = std::min(least, most);
    } else if (!evaluation.within(attribute.range[0], allowed.least, allowed.most, allowed.what, least)) {
      return false;
    }
    const std::uint64_t stream = hash_text(allowed.what);
    const bool whole = attribute.kind == Attribute::Kind::count || attribute.kind == Attribute::Kind::id;
    out = whole ? static_cast<float>(random_integer(seed, stream, address, static_cast<std::int32_t>(least),
                                                    static_cast<std::int32_t>(most)))
                : rounded(least + (most - least) * random_unit(seed, stream, address));
    return true;
  }

  // The number of volumes of a rule.
  bool count(const VolumeRule& rule, std::uint64_t address, std::uint32_t& volumes) {
    float found = 1;
    for (const Attribute& attribute : rule.attributes)
      if (attribute.kind == Attribute::Kind::count && !value(attribute, address, found)) return false;
    volumes = static_cast<std::uint32_t>(found);
    if (found == static_cast<float>(volumes)) return true;
    return evaluation.fail(
        error_at(Reason::evaluation, rule.place,
                 message(messages::growth::not_whole, expression::number_text(found), Quantity("cnt").in_words())));
  }

  // Sets the attributes that a rule gives to its volume number `of_rule`. `placed` becomes true if the rule gives a
  // place.
  bool volume(const VolumeRule& rule, std::uint32_t of_rule, std::uint64_t address, GrowthVolume& volume,
              bool& placed) {
    float id = static_cast<float>(volume.id), gradient = 0, towards = volume.towards, middle = -1;
    for (const Attribute& attribute : rule.attributes) {
      bool fine = true;
      switch (attribute.kind) {
        case Attribute::Kind::count:
          break;
        case Attribute::Kind::id:
          fine = value(attribute, address, id);
          id += static_cast<float>(of_rule);
          break;
        case Attribute::Kind::base:
          fine = value(attribute, address, volume.base);
          break;
        case Attribute::Kind::height:
          fine = value(attribute, address, volume.height);
          break;
        case Attribute::Kind::top:
          fine = value(attribute, address, volume.top);
          break;
        case Attribute::Kind::gradient:
          fine = value(attribute, address, gradient);
          break;
        case Attribute::Kind::towards:
          fine = value(attribute, address, towards);
          break;
        case Attribute::Kind::middle:
          fine = value(attribute, address, middle);
          break;
        case Attribute::Kind::at:
          evaluation.at(address);
          placed = true;
          fine = evaluation.within(attribute.range[0], -1e4f, 1e4f, "x", volume.at.x) &&
                 evaluation.within(attribute.range[1], -1e4f, 1e4f, "z", volume.at.z);
          break;
      }
      if (!fine) return false;
    }
    volume.id = static_cast<std::uint32_t>(id);
    volume.gradient = gradient * pi / 180;
    volume.towards = towards * pi / 180;
    volume.middle = middle < 0 ? mean_width(volume) : middle;
    return true;
  }
};

// The largest radius of a volume, metres.
float half_width(const GrowthVolume& volume) { return std::max({volume.base, volume.middle, volume.top}) / 2; }

}  // namespace

// Draws the growth volumes of all footprint rules; those without a place are arranged in a spiral about the first.
bool draw_volumes(const Rules& rules, std::uint64_t seed, GrowthEvaluation& evaluation,
                  std::vector<GrowthVolume>& volumes) {
  Drawer drawer{rules, seed, evaluation};
  const GrowthVolume otherwise{1, 8, 10, 5, 0, {}, 1, 0, 6.5f};
  for (std::uint64_t i = 0; i < rules.footprint.size(); ++i) {
    const VolumeRule& rule = rules.footprint[i];
    std::uint32_t count = 1;
    if (!drawer.count(rule, hash_combine(hash_text("footprint"), i), count)) return false;
    if (volumes.size() + count > max_volumes)
      return evaluation.fail(
          error_at(Reason::limit, rule.place, message(messages::growth::too_many_volumes, max_volumes)));
    for (std::uint32_t of_rule = 0; of_rule < count; ++of_rule) {
      const std::size_t number = volumes.size();
      GrowthVolume volume = otherwise;
      volume.id = static_cast<std::uint32_t>(number) + 1 - of_rule;
      volume.towards = rounded(std::fmod(turn * static_cast<float>(number), 360.0f));
      bool placed = false;
      if (!drawer.volume(rule, of_rule, number, volume, placed)) return false;
      if (!placed && number > 0) {
        const SinCos way = sincos_degrees(turn * static_cast<float>(number));
        const float out =
            spacing * std::sqrt(static_cast<float>(number)) * (half_width(volumes[0]) + half_width(volume));
        volume.at = {rounded(out * way.cosine), 0, rounded(out * way.sine)};
      }
      volumes.push_back(volume);
    }
  }
  if (volumes.empty()) volumes.push_back(otherwise);
  evaluation.set(Word::count, static_cast<float>(volumes.size()));
  return true;
}

// Sets the words of a volume and its environment for the next evaluations.
void enter_volume(const GrowthVolume& volume, const Environment& environment, GrowthEvaluation& evaluation) {
  evaluation.set(Word::id, static_cast<float>(volume.id));
  evaluation.set(Word::base, volume.base);
  evaluation.set(Word::height, volume.height);
  evaluation.set(Word::top, volume.top);
  evaluation.set(Word::gradient, volume.gradient * 180 / pi);
  evaluation.set(Word::phototropism, environment.phototropism);
  evaluation.set(Word::gravitropism, environment.gravitropism);
  evaluation.set(Word::neighbours, environment.neighbours);
}

// Evaluates the environment of a volume (strength of phototropism, gravitropism, regard of neighbours) by the rules.
bool environment_of(const Rules& rules, std::uint64_t seed, const GrowthVolume& volume, std::uint32_t number,
                    GrowthEvaluation& evaluation, Environment& environment) {
  enter_volume(volume, {}, evaluation);
  evaluation.at(hash_combine(hash_text("volume"), number));
  for (const Rule& rule : rules.of_volumes) {
    float chance = 1;
    if (!evaluation.holds(rule.condition)) {
      if (evaluation.failed()) return false;
      continue;
    }
    if (!evaluation.probability(rule.probability, chance)) return false;
    if (random_unit(seed, rule.stream, number) >= chance) continue;
    for (const Consequence& each : rule.consequences) {
      float value = 0;
      if (!evaluation.within(each.number, -10, 10, word_names[static_cast<std::size_t>(each.word)].data(), value))
        return false;
      evaluation.set(each.word, value);
    }
  }
  environment = {evaluation.get(Word::phototropism), evaluation.get(Word::gravitropism),
                 evaluation.get(Word::neighbours)};
  return true;
}

namespace {

// The rules of a tree that apply: all without a probability, and one of the others.
bool drawn_rules(const Rules& rules, std::uint64_t seed, GrowthEvaluation& evaluation,
                 std::vector<const TreeRule*>& drawn) {
  std::vector<float> weights(rules.tree.size());
  float total = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!rules.tree[i].weight.value.given) continue;
    if (!evaluation.within(rules.tree[i].weight, 0, 1e6f, messages::growth::term_probability, weights[i])) return false;
    total += weights[i];
  }
  float left = total * random_unit(seed, hash_text("tree"), 0);
  std::size_t chosen = weights.size();
  for (std::size_t i = 0; i < weights.size() && left >= 0; ++i) {
    if (weights[i] == 0) continue;
    chosen = i;
    left -= weights[i];
  }
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!rules.tree[i].weight.value.given || i == chosen) drawn.push_back(&rules.tree[i]);
  return true;
}

// Evaluates the parameters of a divisor function: the power, and the remainder and modulus of a residue.
bool rule_of(const DivisorFunction& function, GrowthEvaluation& evaluation, DivisorRule& rule) {
  rule = {function.kind, function.power, 0, 1};
  const Number* next = function.parameters.data();
  if (!function.powered && !evaluation.whole(*next++, 0, 100, messages::growth::term_power, rule.power)) return false;
  if (function.kind != DivisorRule::Kind::residue) return true;
  return evaluation.whole(next[1], 1, 1e6f, messages::growth::term_divisor, rule.modulus) &&
         evaluation.whole(next[0], 0, static_cast<float>(rule.modulus - 1), messages::growth::term_remainder,
                          rule.remainder);
}

// Fails with an error at a place in the text; returns false.
bool fail_at(GrowthEvaluation& evaluation, Diagnostic error, const expression::SourceLocation& place) {
  error.line = place.line;
  error.column = place.column;
  return evaluation.fail(std::move(error));
}

// Computes the values of a divisor function from 0 to `last` as floats, which hold whole numbers to 2^24 exactly.
bool values_of(const DivisorRule& rule, std::uint32_t last, const expression::SourceLocation& place,
               GrowthEvaluation& evaluation, std::vector<float>& values) {
  const auto sums = divisor_sums(rule, last);
  if (!sums) return fail_at(evaluation, sums.error(), place);
  values.clear();
  for (const std::int64_t sum : sums.value()) {
    if (sum > exact || sum < -exact)
      return evaluation.fail(
          error_at(Reason::bad_input, place, message(messages::growth::function_too_large, values.size())));
    values.push_back(static_cast<float>(sum));
  }
  return true;
}

}  // namespace

// Chooses the tree rules that apply, and computes the divisor functions of branches and leaves for all arguments that
// can occur in so many steps.
bool draw_functions(const Rules& rules, std::uint64_t seed, std::uint16_t steps, GrowthEvaluation& evaluation) {
  std::vector<const TreeRule*> drawn;
  evaluation.at(hash_text("tree"));
  if (!drawn_rules(rules, seed, evaluation, drawn)) return false;
  // The functions of branches (0) and of leaves (1), the factors of their arguments, and the greatest argument of both.
  const DivisorFunction* of[2] = {nullptr, nullptr};
  std::uint32_t factors[2] = {1, 1}, last = steps + 1u;
  for (const TreeRule* rule : drawn) {
    for (const DivisorFunction& function : rule->functions) {
      const std::size_t which = function.of == DivisorFunction::Of::leaves ? 1 : 0;
      if (!function.argument) {
        of[which] = &function;
        continue;
      }
      DivisorArgument argument;
      if (!evaluation.whole(function.parameters[0], 0, 1e6f, "x", argument.base) ||
          !evaluation.whole(function.parameters[1], 0, 100, "y", argument.exponent))
        return false;
      const auto greatest = greatest_argument(argument, steps + 1u);
      if (!greatest) return fail_at(evaluation, greatest.error(), function.place);
      factors[which] = greatest.value() / (steps + 1u);
      last = std::max(last, greatest.value());
    }
  }
  evaluation.set(Word::b, static_cast<float>(factors[0]));
  evaluation.set(Word::l, static_cast<float>(factors[1]));
  if (of[0] == nullptr && of[1] == nullptr) return true;
  std::vector<float> branches, leaves;
  DivisorRule rule;
  if (of[0] != nullptr &&
      (!rule_of(*of[0], evaluation, rule) || !values_of(rule, last, of[0]->place, evaluation, branches)))
    return false;
  if (of[1] != nullptr &&
      (!rule_of(*of[1], evaluation, rule) || !values_of(rule, last, of[1]->place, evaluation, leaves)))
    return false;
  if (of[1] == nullptr) leaves = branches;
  evaluation.give(std::move(branches), std::move(leaves));
  return true;
}

}  // namespace panicle::growth
