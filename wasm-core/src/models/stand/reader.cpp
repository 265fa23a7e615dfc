// Reads the text of a plan, line by line.
#include <algorithm>
#include <cmath>
#include <utility>

#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "expression/statement_reader.hpp"
#include "models/stand/messages.generated.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {
namespace {

using expression::number_text;
using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

// Least depth of a strip as a share of the ground's: 0.001, less the rounding of 1 − 0.999.
constexpr float least_depth = 0.000999f;

// Whether a token joins two numbers (`3 x 5`, `5 to 7`) and so ends the first.
bool joins_numbers(const Token& token) { return token.is("x") || token.is("to"); }

// A statement continues in the next line after a comma or a colon.
constexpr expression::StatementSyntax syntax{"(", [](const Token& last, const Token& next) {
                                               return last.is(',') || last.is(':') || next.is(',') || next.is(':');
                                             }};

// Recursive-descent reader of a plan. Each method reads at the token `at_` and moves `at_` behind the tokens it read;
// the methods that return a bool return false with the error in `trouble_`.
class PlanReader : expression::StatementReader {
 public:
  PlanReader(std::span<const Token> tokens, const expression::Code& code, expression::Lowering& lowering)
      : StatementReader(tokens, syntax, lowering), code_(code) {}

  // Reads all statements into `plan()`, then checks the check_plan plan.
  bool run() {
    return read_statements([this] { return statement(); }) && check_plan();
  }
  using StatementReader::trouble;
  Plan& plan() { return plan_; }

 private:
  bool statement();
  bool ground();
  bool layer();
  bool rows(Layer& layer);
  bool trellis();
  bool kind();
  bool kind_item(Kind& kind);
  bool settings(Kind& kind);
  bool setting(Setting& setting);
  bool check_plan();
  // Whether the line has another item, behind a comma: false at the line's end, or with `trouble()`.
  bool item_follows();
  // Whether the line ends behind its items.
  bool items_end();
  // Readers of numbers from `least` to `most`; error messages call the number by `quantity`.
  bool number(float least, float most, const MessageCode<0>& quantity, float& value);
  bool count(std::uint32_t least, std::uint32_t most, const MessageCode<0>& quantity, std::uint32_t& value);
  bool range(float least, float most, const MessageCode<0>& quantity, ValueRange& range);
  bool product(float least, float most, const MessageCode<0>& quantity, float& first, float& second);
  // Skips a required word; `otherwise` is the error message if another token is found.
  bool word(std::string_view word, const MessageCode<1>& otherwise);

  Plan plan_;
  const expression::Code& code_;
  bool grounded_ = false;
};

// Reads one line: by its first word the ground, plants or a trellis; a name with a slash, as in `tree/oak`, is a kind
// of plant.
bool PlanReader::statement() {
  static constexpr expression::NamedReader<bool (PlanReader::*)()> statements[] = {
      {"ground", &PlanReader::ground}, {"plants", &PlanReader::layer}, {"trellis", &PlanReader::trellis}};
  if (const auto* const known = find_named(statements)) return (this->*known->read)();
  const Token& first = tokens_[at_];
  if (first.kind == TokenKind::name && next_is(at_, '/')) return kind();
  return fail(first.kind == TokenKind::name ? Reason::undefined : Reason::syntax, first.place,
              message(messages::stand::line_start, first.text));
}

// Whether the line has another item: skips the comma before it. Returns false at the line's end and at a colon, and
// with the error in `trouble_` if the item is missing.
bool PlanReader::item_follows() {
  if (at_ >= end_ || on_sign(':')) return false;
  if (!expect_comma()) return false;
  if (on_name()) return true;
  return wrong(here(), message(messages::stand::item_missing));
}

// Checks that nothing is left on the line behind its items.
bool PlanReader::items_end() {
  if (trouble_.reason != Reason::none) return false;
  return at_ == end_ || wrong(here(), message(messages::expression::unexpected, found_text()));
}

// Skips the word `wanted`; if another token is there, fails with the message `otherwise`.
bool PlanReader::word(std::string_view wanted, const MessageCode<1>& otherwise) {
  if (!on(wanted)) return wrong(here(), message(otherwise, found_text()));
  ++at_;
  return true;
}

// Reads and evaluates an expression from `least` to `most`; messages name it by `quantity`. No random values are
// allowed. Returns false with the error in `trouble_`.
bool PlanReader::number(float least, float most, const MessageCode<0>& quantity, float& value) {
  const SourceLocation place = here();
  const std::size_t until = find_outside(
      "(", at_, end_, [](const Token& token) { return token.is(',') || token.is(':') || joins_numbers(token); });
  if (until == at_) return wrong(place, message(messages::stand::number_missing, message(quantity)));
  expression::Expression tree;
  if (!expression_before(until, tree)) return false;
  if (at_ != until) return wrong(here(), message(messages::stand::items_need_commas, found_text()));
  lowering_.begin_production({}, 0);
  expression::Value compiled;
  if (!compile(tree, compiled)) return false;
  std::vector<float> registers = code_.registers;
  for (const expression::Node& node : tree.nodes)
    if (node.kind == expression::Node::Kind::operation &&
        (expression::is_random(node.op) || expression::is_space_query(node.op) || node.op == expression::Op::curve))
      return wrong(node.place, message(messages::stand::no_random));
  if (!expression::execute(code_, compiled.code.begin, compiled.code.end, registers.data(), {}, trouble_)) return false;
  value = registers[compiled.source];
  if (value >= least && value <= most) return true;
  return fail(Reason::evaluation, place,
              message(messages::stand::out_of_range, number_text(value), number_text(least), number_text(most),
                      message(quantity)));
}

// Reads a check_plan number from `least` to `most` into `value`; messages call it by `quantity`.
bool PlanReader::count(std::uint32_t least, std::uint32_t most, const MessageCode<0>& quantity, std::uint32_t& value) {
  const SourceLocation place = here();
  float found = 0;
  if (!number(static_cast<float>(least), static_cast<float>(most), quantity, found)) return false;
  value = static_cast<std::uint32_t>(found);
  return static_cast<float>(value) == found ||
         fail(Reason::evaluation, place, message(messages::stand::not_whole, number_text(found), message(quantity)));
}

// Reads `5` or `5 to 7`, in ascending order. Returns false with the error in `trouble_`.
bool PlanReader::range(float least, float most, const MessageCode<0>& quantity, ValueRange& range) {
  if (!number(least, most, quantity, range.from)) return false;
  range.to = range.from;
  if (!on("to")) return true;
  ++at_;
  const SourceLocation place = here();
  if (!number(least, most, quantity, range.to)) return false;
  return range.to >= range.from ||
         fail(Reason::evaluation, place,
              message(messages::stand::range_reversed, number_text(range.to), number_text(range.from)));
}

// Reads two numbers with an x between, such as `3 x 5`; both lie between `least` and `most`.
bool PlanReader::product(float least, float most, const MessageCode<0>& quantity, float& first, float& second) {
  return number(least, most, quantity, first) && word("x", messages::stand::product_syntax) &&
         number(least, most, quantity, second);
}

// Reads the line of the ground: its width and depth in metres, relief and hills. Returns false with the error in
// `trouble_`.
bool PlanReader::ground() {
  if (grounded_) return wrong(here(), message(messages::stand::ground_twice));
  grounded_ = true;
  ++at_;
  Ground& ground = plan_.ground;
  if (!product(0.1f, 1000, messages::stand::term_ground_size, ground.width, ground.depth)) return false;
  while (item_follows()) {
    if (on("relief")) {
      if (++at_; !number(0, 100, messages::stand::term_relief, ground.relief)) return false;
    } else if (on("hills")) {
      if (++at_; !number(0.1f, 1000, messages::stand::term_hills, ground.hills)) return false;
    } else {
      return fail(Reason::undefined, here(), message(messages::stand::ground_item, found_text()));
    }
  }
  return items_end();
}

// Reads the distances of rows, such as `rows 2 x 1.2`: from row to row and along a row, in metres.
bool PlanReader::rows(Layer& layer) {
  layer.spacing = Spacing::rows;
  return product(0.01f, 1000, messages::stand::term_rows, layer.apart, layer.along);
}

// Reads a line of plants: their number and how they are spaced on the ground. Returns false with the error in
// `trouble_`.
bool PlanReader::layer() {
  Layer layer;
  layer.place = here();
  ++at_;
  if (at_ < end_ && !on_sign(',') && !count(1, most_plants, messages::stand::term_count, layer.count)) return false;
  // The items, in any order.
  while (item_follows()) {
    const Token& item = tokens_[at_++];
    bool fine = true;
    if (item.is("stratified")) {
      layer.spacing = Spacing::strata;
    } else if (item.is("random")) {
      layer.spacing = Spacing::chance;
    } else if (item.is("blue")) {
      layer.spacing = Spacing::blue;
      if (at_ < end_ && !on_sign(',')) fine = number(0.01f, 1000, messages::stand::term_min_distance, layer.apart);
    } else if (item.is("rows")) {
      fine = rows(layer);
    } else if (item.is("towards")) {
      fine = number(-360, 360, messages::stand::term_towards, layer.towards);
    } else if (item.is("jitter")) {
      fine = number(0, 100, messages::stand::term_jitter, layer.jitter);
    } else if (item.is("depth")) {
      fine = range(0, 1, messages::stand::term_depth, layer.depth);
    } else {
      fine = fail(Reason::undefined, item.place, message(messages::stand::layer_item, item.text));
    }
    if (!fine) return false;
  }
  if (!items_end()) return false;
  // The count and the depth depend on other items, so they are checked last.
  if (layer.count == 0 && layer.spacing != Spacing::rows)
    return wrong(layer.place, message(messages::stand::count_missing));
  if (layer.depth.to - layer.depth.from < least_depth)
    return wrong(layer.place, message(messages::stand::depth_syntax));
  plan_.layers.push_back(std::move(layer));
  return true;
}

// Reads the trellis of the last layer, which must be planted in rows. Returns false with the error in `trouble_`.
bool PlanReader::trellis() {
  if (plan_.layers.empty() || plan_.layers.back().spacing != Spacing::rows || plan_.layers.back().trellis)
    return wrong(here(), message(messages::stand::trellis_place));
  ++at_;
  Trellis trellis;
  if (!number(0.1f, 20, messages::stand::term_post_height, trellis.high)) return false;
  while (item_follows()) {
    const Token& item = tokens_[at_++];
    if (item.is("posts")) {
      if (!number(0.1f, 1000, messages::stand::term_post_distance, trellis.posts)) return false;
    } else if (item.is("wire") || item.is("pair")) {
      if (trellis.wires.size() == most_wires)
        return fail(Reason::limit, item.place, message(messages::stand::too_many_wires));
      Wire& wire = trellis.wires.emplace_back();
      wire.pair = item.is("pair");
      if (!number(0, trellis.high, messages::stand::term_wire_height, wire.high)) return false;
    } else {
      return fail(Reason::undefined, item.place, message(messages::stand::trellis_item, item.text));
    }
  }
  if (!items_end()) return false;
  plan_.layers.back().trellis = std::move(trellis);
  return true;
}

// Reads a kind of plant of the last layer: a name, its items, and behind a colon its parameters. Returns false with the
// error in `trouble_`.
bool PlanReader::kind() {
  Kind kind;
  kind.place = here();
  if (plan_.layers.empty()) return wrong(kind.place, message(messages::stand::layer_first));
  std::size_t last = at_;
  while (last + 1 < end_ && !tokens_[last + 1].is(',') && !tokens_[last + 1].is(':') &&
         expression::touching(tokens_[last], tokens_[last + 1]))
    ++last;
  const char* const begin = tokens_[at_].text.data();
  kind.name.assign(begin, static_cast<std::size_t>(tokens_[last].text.data() + tokens_[last].text.size() - begin));
  at_ = last + 1;
  while (item_follows())
    if (!kind_item(kind)) return false;
  if (trouble_.reason != Reason::none) return false;
  if (on_sign(':') && !(++at_, settings(kind))) return false;
  std::vector<Kind>& kinds = plan_.layers.back().kinds;
  if (kind.attached && kinds.empty()) return wrong(kind.place, message(messages::stand::attached_first));
  std::size_t all = 1;
  for (const Layer& each : plan_.layers) all += each.kinds.size();
  if (all > most_kinds) return fail(Reason::limit, kind.place, message(messages::stand::too_many_kinds));
  kinds.push_back(std::move(kind));
  return true;
}

// Reads an item of a kind, such as `crown 3 x 5` or `scale 0.7 to 1.2`. Returns false with the error in `trouble_`.
bool PlanReader::kind_item(Kind& kind) {
  const Token& item = tokens_[at_++];
  if (item.is("share")) return number(0, 1e6f, messages::stand::term_share, kind.share);
  if (item.is("crown")) return product(0.001f, 200, messages::stand::term_crown, kind.width, kind.height);
  if (item.is("scale")) return range(0.01f, 100, messages::stand::term_scale, kind.scale);
  if (item.is("seeds")) return count(1, most_plants, messages::stand::term_seeds, kind.seeds);
  if (item.is("each")) return kind.attached = true, range(0, 100, messages::stand::term_each, kind.each);
  if (item.is("height")) return kind.attached = true, range(-10, 100, messages::stand::term_height, kind.high);
  if (item.is("at")) {
    if (!on_name()) return wrong(here(), message(messages::stand::organ_expected));
    kind.attached = true;
    kind.spot = tokens_[at_++].text;
    return true;
  }
  if (item.is("reach")) return kind.attached = true, number(0, 100, messages::stand::term_reach, kind.reach);
  return fail(Reason::undefined, item.place, message(messages::stand::kind_item, item.text));
}

// Reads the parameters behind a kind's colon, up to the line's end. Returns false with the error in `trouble_`.
bool PlanReader::settings(Kind& kind) {
  do {
    if (on_sign(',') && !kind.settings.empty()) ++at_;
    if (!on_name()) return wrong(here(), message(messages::stand::parameter_expected, found_text()));
    if (kind.settings.size() == most_settings)
      return fail(Reason::limit, here(), message(messages::stand::too_many_settings));
    if (!setting(kind.settings.emplace_back())) return false;
    if (at_ < end_ && !on_sign(','))
      return wrong(here(), message(messages::expression::expected_sign, ",", found_text()));
  } while (at_ < end_);
  return true;
}

// Reads one parameter: its key and a number, a range or a word, which is quoted or alone before the next comma. False:
// `trouble_`.
bool PlanReader::setting(Setting& setting) {
  setting.place = here();
  setting.key = tokens_[at_++].text;
  if (at_ < end_ && tokens_[at_].kind == TokenKind::quoted) {
    setting.word = tokens_[at_++].text;
    return true;
  }
  const bool alone = at_ + 1 >= end_ || tokens_[at_ + 1].is(',');
  if (on_name() && alone) {
    setting.word = tokens_[at_++].text;
    return true;
  }
  return range(-1e6f, 1e6f, messages::stand::term_parameter, setting.range);
}

// Checks the check_plan plan: it needs a layer of plants, and each layer needs a kind of plants on the ground with a
// share above 0.
bool PlanReader::check_plan() {
  end_ = tokens_.size();
  if (plan_.layers.empty()) return wrong({1, 1}, message(messages::stand::no_layers));
  for (const Layer& layer : plan_.layers) {
    float shares = 0;
    for (const Kind& kind : layer.kinds) shares += kind.attached ? 0 : kind.share;
    if (layer.kinds.empty()) return wrong(layer.place, message(messages::stand::no_kinds));
    if (!(shares > 0)) return wrong(layer.place, message(messages::stand::no_shares));
  }
  return true;
}

}  // namespace

// Reads a plan from its text: tokens, then statements. Returns the first error with its line and column.
Result<Plan> read_plan(std::string_view text, const Limits& limits) {
  if (Diagnostic error = expression::check_length(text, limits); error.reason != Reason::none) return error;
  const auto tokens = expression::tokenize(text, expression::Writing::rules);
  if (!tokens) return tokens.error();
  expression::Code code;
  expression::Lowering lowering(code);
  PlanReader reader(tokens.value(), code, lowering);
  if (!reader.run()) return reader.trouble();
  return std::move(reader.plan());
}

}  // namespace panicle::stand
