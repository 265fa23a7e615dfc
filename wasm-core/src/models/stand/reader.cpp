// Reads the text of a plan, line by line.
#include <algorithm>
#include <cmath>
#include <utility>

#include "expression/lowering.hpp"
#include "expression/number_text.hpp"
#include "expression/token_reader.hpp"
#include "models/stand/plan.hpp"

namespace panicle::stand {
namespace {

using expression::error_at;
using expression::number_text;
using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

constexpr const char* beginnings =
    "A line begins with ground, plants, trellis, or what grows there as model/preset; '%' is none of these.";

// Least depth of a strip as a share of the ground's: 0.001, less the rounding of 1 − 0.999.
constexpr float least_depth = 0.000999f;

// Whether a token stands between two numbers and so ends the first.
bool joins(const Token& token) { return token.is("x") || token.is("to"); }

class PlanReader : expression::TokenReader {
 public:
  explicit PlanReader(std::span<const Token> tokens) : TokenReader(tokens), lowering_(code_) {}

  bool run() {
    while (at_ < tokens_.size()) {
      end_ = statement_end();
      if (!statement()) return false;
    }
    return whole();
  }
  const Diagnostic& trouble() const { return trouble_; }
  Plan& plan() { return plan_; }

 private:
  std::size_t statement_end() const;
  bool statement();
  bool ground();
  bool layer();
  bool rows(Layer& layer);
  bool trellis();
  bool kind();
  bool kind_item(Kind& kind);
  bool settings(Kind& kind);
  bool setting(Setting& setting);
  bool whole();
  // Whether the line has another item, behind a comma: false at the line's end, or with `trouble()`.
  bool item_follows();
  bool number(float least, float most, const char* what, float& value);
  bool count(std::uint32_t least, std::uint32_t most, const char* what, std::uint32_t& value);
  bool range(float least, float most, const char* what, ValueRange& range);
  bool product(float least, float most, const char* what, float& first, float& second);
  // Skips a required word.
  bool word(std::string_view word, const char* otherwise);
  bool on(std::string_view word) const { return at_ < end_ && tokens_[at_].is(word); }

  Plan plan_;
  expression::Code code_;
  expression::Lowering lowering_;
  bool grounded_ = false;
};

// A statement continues in the next line within brackets, and after a comma or a colon.
std::size_t PlanReader::statement_end() const {
  std::size_t open = 0;
  for (std::size_t at = at_; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    if (at > at_ && token.first_on_line && open == 0) {
      const Token& before = tokens_[at - 1];
      if (!before.is(',') && !before.is(':') && !token.is(',') && !token.is(':')) return at;
    }
    if (token.is('(')) ++open;
    if (token.is(')') && open > 0) --open;
  }
  return tokens_.size();
}

bool PlanReader::statement() {
  const Token& first = tokens_[at_];
  if (first.is("ground")) return ground();
  if (first.is("plants")) return layer();
  if (first.is("trellis")) return trellis();
  if (first.kind == TokenKind::name && next_is(at_, '/')) return kind();
  return fail(first.kind == TokenKind::name ? Reason::undefined : Reason::syntax, first.place, beginnings,
              {first.text});
}

bool PlanReader::item_follows() {
  if (at_ >= end_ || on_sign(':')) return false;
  if (!expect(',', "A comma is expected here, not '%'.")) return false;
  if (on_name()) return true;
  return wrong(here(), "Something is missing behind the comma; take it out, or go on.");
}

bool PlanReader::word(std::string_view wanted, const char* otherwise) {
  if (!on(wanted)) return wrong(here(), otherwise, {found()});
  ++at_;
  return true;
}

bool PlanReader::number(float least, float most, const char* what, float& value) {
  const SourceLocation place = here();
  std::size_t until = at_, open = 0;
  while (until < end_ && (open > 0 || !(tokens_[until].is(',') || tokens_[until].is(':') || joins(tokens_[until])))) {
    if (tokens_[until].is('(')) ++open;
    if (tokens_[until].is(')') && open > 0) --open;
    ++until;
  }
  if (until == at_) return wrong(place, "A number is missing here: %.", {what});
  expression::Expression tree;
  if (!expression_before(until, tree)) return false;
  if (at_ != until) return wrong(here(), "'%' cannot stand here; items are parted by commas.", {found()});
  lowering_.begin_production({}, 0);
  const std::uint32_t begin = lowering_.here();
  const auto source = lowering_.lower(tree);
  if (!source) {
    trouble_ = source.error();
    return false;
  }
  std::vector<float> registers = code_.registers;
  for (const expression::Node& node : tree.nodes)
    if (node.kind == expression::Node::Kind::operation &&
        (expression::is_random(node.op) || expression::is_space_query(node.op) || node.op == expression::Op::curve))
      return wrong(node.place, "Nothing is drawn here; write the least and the most, as in scale 0.7 to 1.2.");
  if (!expression::execute(code_, begin, lowering_.here(), registers.data(), {}, trouble_)) return false;
  value = registers[source.value()];
  if (value >= least && value <= most) return true;
  return fail(Reason::evaluation, place, "% is from % to %, not %.",
              {what, number_text(least), number_text(most), number_text(value)});
}

bool PlanReader::count(std::uint32_t least, std::uint32_t most, const char* what, std::uint32_t& value) {
  const SourceLocation place = here();
  float found = 0;
  if (!number(static_cast<float>(least), static_cast<float>(most), what, found)) return false;
  value = static_cast<std::uint32_t>(found);
  return static_cast<float>(value) == found ||
         fail(Reason::evaluation, place, "% is a whole number, not %.", {what, number_text(found)});
}

bool PlanReader::range(float least, float most, const char* what, ValueRange& range) {
  if (!number(least, most, what, range.from)) return false;
  range.to = range.from;
  if (!on("to")) return true;
  ++at_;
  const SourceLocation place = here();
  if (!number(least, most, what, range.to)) return false;
  return range.to >= range.from || fail(Reason::evaluation, place, "A range begins with the least: % to %.",
                                        {number_text(range.to), number_text(range.from)});
}

bool PlanReader::product(float least, float most, const char* what, float& first, float& second) {
  return number(least, most, what, first) && word("x", "Two lengths with an x between are needed here, not '%'.") &&
         number(least, most, what, second);
}

bool PlanReader::ground() {
  if (grounded_) return wrong(here(), "There is a ground already; a plan has one.");
  grounded_ = true;
  ++at_;
  Ground& ground = plan_.ground;
  if (!product(0.1f, 1000, "A ground's width and depth, in metres,", ground.width, ground.depth)) return false;
  while (item_follows()) {
    if (on("relief")) {
      if (++at_; !number(0, 100, "relief, in metres,", ground.relief)) return false;
    } else if (on("hills")) {
      if (++at_; !number(0.1f, 1000, "hills, in metres,", ground.hills)) return false;
    } else {
      return fail(Reason::undefined, here(), "A ground has relief and hills, not %.", {found()});
    }
  }
  if (trouble_.reason != Reason::none) return false;
  return at_ == end_ || wrong(here(), "'%' cannot stand here; take it out.", {found()});
}

bool PlanReader::rows(Layer& layer) {
  layer.spacing = Spacing::rows;
  return product(0.01f, 1000, "From row to row, and in a row, metres", layer.apart, layer.along);
}

bool PlanReader::layer() {
  Layer layer;
  layer.place = here();
  ++at_;
  if (at_ < end_ && !on_sign(',') && !count(1, most_plants, "How many plants there are", layer.count)) return false;
  while (item_follows()) {
    const Token& item = tokens_[at_++];
    bool fine = true;
    if (item.is("stratified")) {
      layer.spacing = Spacing::strata;
    } else if (item.is("random")) {
      layer.spacing = Spacing::chance;
    } else if (item.is("blue")) {
      layer.spacing = Spacing::blue;
      if (at_ < end_ && !on_sign(',')) fine = number(0.01f, 1000, "The least distance, in metres,", layer.apart);
    } else if (item.is("rows")) {
      fine = rows(layer);
    } else if (item.is("towards")) {
      fine = number(-360, 360, "Where rows run, in degrees,", layer.towards);
    } else if (item.is("jitter")) {
      fine = number(0, 100, "jitter, in metres,", layer.jitter);
    } else if (item.is("depth")) {
      fine = range(0, 1, "A strip of the ground, from its back to its front,", layer.depth);
    } else {
      fine = fail(Reason::undefined, item.place,
                  "Plants stand stratified, blue, random or in rows; besides there are towards, jitter and depth, "
                  "not %.",
                  {item.text});
    }
    if (!fine) return false;
  }
  if (trouble_.reason != Reason::none) return false;
  if (at_ < end_) return wrong(here(), "'%' cannot stand here; take it out.", {found()});
  if (layer.count == 0 && layer.spacing != Spacing::rows)
    return wrong(layer.place, "How many plants there are stands behind it, as in plants 100; rows alone know.");
  if (layer.depth.to - layer.depth.from < least_depth)
    return wrong(layer.place, "A strip of the ground has two ends, at least 0.001 apart, as in depth 0 to 0.5.");
  plan_.layers.push_back(std::move(layer));
  return true;
}

bool PlanReader::trellis() {
  if (plan_.layers.empty() || plan_.layers.back().spacing != Spacing::rows || plan_.layers.back().trellis)
    return wrong(here(),
                 "A trellis is one layer's that stands in rows: plants, rows 2.2 x 1.2, and below it trellis 2.");
  ++at_;
  Trellis trellis;
  if (!number(0.1f, 20, "How high posts are, in metres,", trellis.high)) return false;
  while (item_follows()) {
    const Token& item = tokens_[at_++];
    if (item.is("posts")) {
      if (!number(0.1f, 1000, "From post to post, in metres,", trellis.posts)) return false;
    } else if (item.is("wire") || item.is("pair")) {
      if (trellis.wires.size() == most_wires) return fail(Reason::limit, item.place, "A trellis has at most 12 wires.");
      Wire& wire = trellis.wires.emplace_back();
      wire.pair = item.is("pair");
      if (!number(0, trellis.high, "A wire's height, in metres,", wire.high)) return false;
    } else {
      return fail(Reason::undefined, item.place, "A trellis has posts, wire and pair, not %.", {item.text});
    }
  }
  if (trouble_.reason != Reason::none) return false;
  if (at_ < end_) return wrong(here(), "'%' cannot stand here; take it out.", {found()});
  plan_.layers.back().trellis = std::move(trellis);
  return true;
}

bool PlanReader::kind() {
  Kind kind;
  kind.place = here();
  if (plan_.layers.empty())
    return wrong(kind.place, "Say first how many plants there are and how they stand: plants 100, blue 2.");
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
  if (kind.attached && kinds.empty())
    return wrong(kind.place, "What is borne stands below what bears it; nothing stands above this line.");
  std::size_t all = 1;
  for (const Layer& each : plan_.layers) all += each.kinds.size();
  if (all > most_kinds) return fail(Reason::limit, kind.place, "A plan has at most 64 lines of what grows.");
  kinds.push_back(std::move(kind));
  return true;
}

bool PlanReader::kind_item(Kind& kind) {
  const Token& item = tokens_[at_++];
  if (item.is("share")) return number(0, 1e6f, "A share", kind.share);
  if (item.is("crown"))
    return product(0.001f, 200, "A crown's width and the plant's height, in metres,", kind.width, kind.height);
  if (item.is("scale")) return range(0.01f, 100, "A scale", kind.scale);
  if (item.is("seeds")) return count(1, most_plants, "How many different ones there are", kind.seeds);
  if (item.is("each")) return kind.attached = true, range(0, 100, "How many are on each", kind.each);
  if (item.is("height")) return kind.attached = true, range(-10, 100, "How high they hang, in metres,", kind.high);
  if (item.is("at")) {
    if (!on_name()) return wrong(here(), "Which of its bearer's organs it hangs at stands here, as in at bunch.");
    kind.attached = true;
    kind.spot = tokens_[at_++].text;
    return true;
  }
  if (item.is("reach")) return kind.attached = true, number(0, 100, "reach, in metres,", kind.reach);
  return fail(Reason::undefined, item.place,
              "There is share, crown, scale, seeds, and of what is borne each, at, height and reach, not %; parameters "
              "stand behind a colon.",
              {item.text});
}

bool PlanReader::settings(Kind& kind) {
  do {
    if (on_sign(',') && !kind.settings.empty()) ++at_;
    if (!on_name())
      return wrong(here(), "A parameter by its key stands here, as in : steps 5 to 7, not '%'.", {found()});
    if (kind.settings.size() == most_settings) return fail(Reason::limit, here(), "A line sets at most 16 parameters.");
    if (!setting(kind.settings.emplace_back())) return false;
    if (at_ < end_ && !on_sign(',')) return wrong(here(), "A comma is expected here, not '%'.", {found()});
  } while (at_ < end_);
  return true;
}

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
  return range(-1e6f, 1e6f, "A parameter", setting.range);
}

bool PlanReader::whole() {
  end_ = tokens_.size();
  if (plan_.layers.empty())
    return wrong({1, 1}, "Nothing says how many plants there are; write plants 100, blue 2 and below it what grows.");
  for (const Layer& layer : plan_.layers) {
    float shares = 0;
    for (const Kind& kind : layer.kinds) shares += kind.attached ? 0 : kind.share;
    if (layer.kinds.empty())
      return wrong(layer.place, "Below plants stands what grows, a line each: growth/figure-9, share 3.");
    if (!(shares > 0)) return wrong(layer.place, "The shares below are 0 together; nothing would grow.");
  }
  return true;
}

}  // namespace

Result<Plan> read_plan(std::string_view text, const Limits& limits) {
  if (text.size() > limits.text_bytes)
    return error_at(Reason::limit, {}, "The text is longer than % bytes, which is the limit; make it shorter.",
                    {std::to_string(limits.text_bytes)});
  const auto tokens = expression::tokenize(text, expression::Writing::rules);
  if (!tokens) return tokens.error();
  PlanReader reader(tokens.value());
  if (!reader.run()) return reader.trouble();
  return std::move(reader.plan());
}

}  // namespace panicle::stand
