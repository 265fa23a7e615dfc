#include <algorithm>
#include <string>
#include <utility>

#include "expression/messages.generated.hpp"
#include "foundation/random.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/syntax/reader.hpp"

namespace panicle::flower {
namespace {

using expression::SourceLocation;
using expression::Token;
using expression::TokenKind;

constexpr std::size_t most_locals = 64;
constexpr std::uint64_t most_code = 1'000'000;

// The number of a side face from its name, such as 1 for C1; 0 for another name.
std::uint32_t side_number_of(std::string_view name) {
  if (name.size() < 2 || name.size() > 5 || name[0] != 'C') return 0;
  std::uint32_t side = 0;
  for (const char digit : name.substr(1)) {
    if (digit < '0' || digit > '9') return 0;
    side = 10 * side + static_cast<std::uint32_t>(digit - '0');
  }
  return side <= generalized_map::largest_order ? side : 0;
}

// Finds a face by its name: O the base, E the end, C1 … the sides. Returns false for another name.
bool face_named(std::string_view name, Face& face) {
  if (name == "O") return face = generalized_map::base_face, true;
  if (name == "E") return face = generalized_map::end_face, true;
  const std::uint32_t side = side_number_of(name);
  if (side > 0) face = generalized_map::side(side);
  return side > 0;
}

}  // namespace

// Reads `p00 PREDECESSOR{…}{…}{…} -> …`: its own name may be in parentheses, or missing.
bool FlowerReader::production() {
  if (on_sign('(') && at_ + 2 < end_ && tokens_[at_ + 1].kind == TokenKind::name && tokens_[at_ + 2].is(')')) {
    at_ += 3;
  } else if (on_name() && at_ + 1 < end_ && tokens_[at_ + 1].kind == TokenKind::name) {
    ++at_;
  }
  Production production;
  production.place = here();
  production.number = static_cast<std::uint32_t>(program_.productions.size());
  production_key_ = hash_combine(hash_text("production"), next_key());
  if (!on_name())
    return wrong(here(), message(messages::flower::production_start, "STEM -> STEM[STEM]_{E}", found_text()));
  if (!label_named(production.predecessor)) return false;
  locals_.clear();
  of_blocks_ = {};
  Blocks given;
  if (!blocks(given) || !condition_of(given, production)) return false;
  bool fine = false;
  if (on_sign(':')) {
    const bool blocked =
        given.before_end > given.before || given.condition_end > given.condition || given.after_end > given.after;
    if (blocked) return wrong(production.place, message(messages::flower::glue_with_blocks));
    fine = glue(production);
  } else if (on_sign('-')) {
    fine = split(given, production);
  } else if (at_ < end_ && tokens_[at_].kind == TokenKind::arrow) {
    fine = grow(given, production);
  } else {
    return wrong(here(), message(messages::flower::arrow_expected, found_text()));
  }
  if (fine) program_.productions.push_back(std::move(production));
  return fine;
}

// Reads the blocks before a production's arrow: all three, or none.
bool FlowerReader::blocks(Blocks& blocks) {
  if (!on_sign('{')) return true;
  if (!block(blocks.before, blocks.before_end)) return false;
  if (!on_sign('{')) return wrong(here(), message(messages::flower::three_blocks, "{before} {condition} {after}"));
  if (!block(blocks.condition, blocks.condition_end)) return false;
  if (!on_sign('{')) return wrong(here(), message(messages::flower::three_blocks, "{before} {condition} {after}"));
  return block(blocks.after, blocks.after_end);
}

// Skips a block in braces; `begin` and `end` become the range of tokens in it.
bool FlowerReader::block(std::size_t& begin, std::size_t& end) {
  const SourceLocation opened = here();
  begin = ++at_;
  at_ = find_outside("", at_, end_, [](const Token& token) { return token.is('}'); });
  if (at_ == end_) return never_closed(opened, "{");
  end = at_++;
  return true;
}

// Calls `read(name, value_end)` for each assignment `name = value;` of a block, with `at_` at its value; `advice` is
// the error message where there is none.
template <class Read>
bool FlowerReader::each_assignment(std::size_t begin, std::size_t end, const Message& advice, Read read) {
  const std::size_t behind = at_;
  for (at_ = begin; at_ < end;) {
    if (tokens_[at_].kind != TokenKind::name || !next_is(at_, '=') || at_ + 2 >= end) return wrong(here(), advice);
    const Token& name = tokens_[at_];
    at_ += 2;
    const std::size_t semicolon = find_outside("", at_, end, [](const Token& token) { return token.is(';'); });
    if (!read(name, semicolon)) return false;
    at_ = std::min(end, semicolon + 1);
  }
  at_ = behind;
  return true;
}

// Reads the assignments of a production's block; each name may be used after it.
bool FlowerReader::assignments(std::size_t begin, std::size_t end) {
  return each_assignment(begin, end, message(messages::flower::block_syntax, "{w = 2 * step;}"),
                         [this](const Token& name, std::size_t value_end) {
                           if (is_reserved(name.text))
                             return wrong(name.place, message(messages::flower::reserved_name, name.text));
                           Number value;
                           Uses uses;
                           if (!number(value_end, Scope::production, false, value, &uses)) return false;
                           of_blocks_.add(uses);
                           if (locals_.size() == most_locals)
                             return fail(Reason::limit, here(), message(messages::flower::too_many_names));
                           lowering_.assign(name.text, value.value.source);
                           locals_.push_back(name.text);
                           return true;
                         });
}

// Compiles a production's condition together with the block before it, whose names it may use. A condition that depends
// on nothing but the step is marked, so that it is evaluated once a step.
bool FlowerReader::condition_of(const Blocks& blocks, Production& production) {
  if (blocks.condition == blocks.condition_end) return true;
  lowering_.begin_production(formals_, production_key_);
  const std::uint32_t begin = lowering_.here();
  if (!assignments(blocks.before, blocks.before_end)) return false;
  const std::size_t behind = at_;
  at_ = blocks.condition;
  Uses uses;
  if (!number(blocks.condition_end, Scope::production, true, production.condition, &uses)) return false;
  production.by_step = !(uses.variables.any() || uses.age || uses.values || uses.locals || production.condition.draws);
  production.condition.value.code.begin = begin;
  at_ = behind;
  return true;
}

// Compiles the blocks of a production for one use: its random values are the same each time, and independent of those
// of other productions.
bool FlowerReader::both_blocks(const Blocks& blocks, const Production& production) {
  lowering_.begin_production(formals_, production_key_);
  locals_.clear();
  read_here_ =
      blocks.before_end - blocks.before + blocks.condition_end - blocks.condition + blocks.after_end - blocks.after;
  if (!assignments(blocks.before, blocks.before_end)) return false;
  if (production.condition.draws) {
    const std::size_t behind = at_;
    at_ = blocks.condition;
    Number again;
    if (!number(blocks.condition_end, Scope::production, true, again)) return false;
    at_ = behind;
  }
  return assignments(blocks.after, blocks.after_end);
}

// Reads the successor of a growing production, `-> STEM[STEM(…)]_{E}[PETAL]_{C1, C2}`.
bool FlowerReader::grow(const Blocks& blocks, Production& production) {
  ++at_;
  const SourceLocation place = here();
  std::uint32_t root = 0;
  if (!label_named(root)) return false;
  if (opens(at_)) {
    const Token& list = tokens_[at_];
    Description none;
    lowering_.begin_production(formals_, next_key());
    if (!description(forms_[root], Scope::production, none)) return false;
    if (none.given != 0) return wrong(list.place, message(messages::flower::predecessor_with_numbers));
  }
  if (root != production.predecessor) {
    production.becomes = root;
    renamed_.push_back({place.line, production.predecessor, root});
  }
  if (at_ == end_ && production.becomes == invalid)
    return wrong(here(), message(messages::flower::no_growth, "STEM -> STEM[STEM]_{E}"));
  while (on_sign('['))
    if (!growth(blocks, production)) return false;
  return true;
}

// Reads one growth of a successor: `[PETAL(…)]_{faces}`, or for a module `[&PETAL(…){settings}]_{faces}`.
bool FlowerReader::growth(const Blocks& blocks, Production& production) {
  const SourceLocation opened = here();
  ++at_;
  GrowAction growth;
  growth.number = program_.growths++;
  growth.module = on_sign('&');
  if (growth.module) ++at_;
  if (!on_name()) return wrong(here(), message(messages::flower::volume_name_expected, found_text()));
  const std::size_t name = at_;
  if (is_unclosed(growth.module)) return false;
  if (growth.module) {
    growth.target = find_grammar(found());
    if (growth.target == invalid)
      return fail(Reason::undefined, here(), message(messages::flower::unknown_module, found()));
    ++at_;
  } else if (!label_named(growth.target)) {
    return false;
  }
  // The faces follow the numbers in the text and are evaluated before them.
  const std::size_t list = at_;
  at_ = find_outside("(", at_, end_, [](const Token& token) { return token.is(']'); });
  if (at_ == end_) return never_closed(opened, "[");
  const std::size_t closed = at_;
  ++at_;
  const std::uint32_t begin = lowering_.here();
  if (!both_blocks(blocks, production) || !faces(growth) || too_much(opened)) return false;
  growth.blocks = {begin, lowering_.here()};
  const std::size_t behind = at_, end = end_;
  at_ = list;
  end_ = closed;
  growth.arguments.place = tokens_[name].place;
  const Form form = growth.module ? forms_of_modules_[growth.target] : forms_[growth.target];
  if (!description(form, Scope::production, growth.arguments)) return false;
  if (on_sign('{') && growth.module && !settings(growth)) return false;
  if (at_ < end_) return wrong(here(), message(messages::expression::expected_sign, "]", found_text()));
  end_ = end;
  at_ = behind;
  production.growths.push_back(std::move(growth));
  return true;
}

// Whether a growth lacks its closing bracket, as in `A[A_{E}`: then the text after it was read as the end of the name.
bool FlowerReader::is_unclosed(bool module) {
  const std::string_view both = found();
  const std::size_t low = both.rfind('_');
  if (low == std::string_view::npos || low == 0) return false;
  const auto is_known = [&](std::string_view name) {
    return (module ? find_grammar(name) : find_label(name)) != invalid;
  };
  Face face;
  const std::string_view behind = both.substr(low + 1);
  if (is_known(both)) return false;
  // A statement that is never closed includes the following lines, so that the module may be unknown.
  const bool opens_faces = behind.empty() && next_is(at_, '{');
  if (!(module && opens_faces) && !is_known(both.substr(0, low))) return false;
  if (!opens_faces && !face_named(behind, face)) return false;
  const std::string faces = std::string("_").append(behind.empty() ? "{" : behind);
  const std::string example = std::string(both.substr(0, low)).append("]_{E}");
  wrong(here(), message(messages::flower::bracket_missing, faces, example));
  return true;
}

// Reads the settings `{len = 60; open = age}` after a module that is called.
bool FlowerReader::settings(GrowAction& growth) {
  std::size_t begin = 0, end = 0;
  if (!block(begin, end)) return false;
  program_.grammars[growth.target].draws = true;
  return each_assignment(begin, end, message(messages::flower::module_settings, "&PETAL{len = 60}"),
                         [&](const Token& name, std::size_t value_end) { return setting(growth, name, value_end); });
}

// Reads and compiles the value that a call gives to a variable of its module, and records which other variables this
// value depends on.
bool FlowerReader::setting(GrowAction& growth, const Token& name, std::size_t value_end) {
  Setting setting;
  setting.variable = find_variable(name.text, growth.target);
  if (setting.variable == invalid || program_.variables[setting.variable].grammar != growth.target)
    return fail(Reason::undefined, name.place,
                message(messages::flower::module_without_variable, program_.grammars[growth.target].name, name.text));
  for (const Setting& other : growth.settings)
    if (other.variable == setting.variable) return wrong(name.place, message(messages::flower::set_twice, name.text));
  const std::size_t first = at_;
  Number number;
  Uses uses;
  if (!this->number(value_end, Scope::production, false, number, &uses)) return false;
  const bool of_blocks = uses.locals;
  if (of_blocks) uses.add(of_blocks_);
  uses.locals = false;
  uses_of_variables_[setting.variable].add(uses);
  calls_.emplace_back(setting.variable, of_blocks ? read_ : Statement{first, value_end, grammar_});
  setting.value = number.value;
  growth.settings.push_back(setting);
  return true;
}

// Whether the compiled code exceeds its limit: blocks are written once and compiled for every face.
bool FlowerReader::too_much(const SourceLocation& place) {
  read_again_ += read_here_;
  if (lowering_.here() <= most_code && read_again_ <= most_code) return false;
  fail(Reason::limit, place, message(messages::flower::blocks_too_long));
  return true;
}

// Reads the faces of a growth: `{E}`, `{C1, C4}`, or the same without braces.
bool FlowerReader::faces(GrowAction& growth) {
  const SourceLocation opened = here();
  const bool braces = on_sign('{');
  if (braces) ++at_;
  for (;;) {
    if (!face(growth.faces.emplace_back())) return false;
    if (!on_sign(',')) break;
    ++at_;
  }
  if (braces && !on_sign('}'))
    return wrong(at_ < end_ ? here() : opened, message(messages::expression::expected_sign, "}", found_text()));
  if (braces) ++at_;
  return true;
}

// Reads a face by name (O, E, C1 …) or by number, C(…).
bool FlowerReader::face(FaceOf& face) {
  face.place = here();
  if (!on_name()) return wrong(here(), message(messages::flower::face_syntax, found_text()));
  const std::string_view name = found();
  ++at_;
  if (name == "C" && opens(at_)) {
    ++at_;
    const std::size_t end = entry_end();
    if (end == end_) return never_closed(face.place);
    Number number;
    if (!this->number(end, Scope::production, true, number)) return false;
    if (!expect(')')) return false;
    face.worked_out = true;
    face.source = number.value.source;
    return true;
  }
  return face_named(name, face.face) ||
         wrong(face.place, message(messages::flower::face_syntax, message(messages::expression::term_quoted, name)));
}

// Reads a gluing production, `VOL : VOL_C1 < VOL_C3 -> VOL_C1 | VOL_C3`.
bool FlowerReader::glue(Production& production) {
  production.kind = Production::Kind::glue;
  ++at_;
  std::array<std::uint32_t, 4> labels{};
  std::array<Face, 4> sides{};
  std::array<SourceLocation, 4> places{};
  for (std::size_t i = 0; i < 4; ++i) {
    const SourceLocation place = places[i] = here();
    if (!label_with_face(labels[i], sides[i])) return false;
    if (i == 0 && labels[0] != production.predecessor)
      return wrong(place, message(messages::flower::glue_first_face, program_.labels[production.predecessor].name));
    if (i > 1 && (labels[i] != labels[i - 2] || sides[i] != sides[i - 2]))
      return wrong(place, message(messages::flower::glue_same_faces));
    if (i == 0 && !expect('<', messages::flower::glue_syntax)) return false;
    if (i == 1) {
      if (!(at_ < end_ && tokens_[at_].kind == TokenKind::arrow))
        return wrong(here(), message(messages::flower::arrow_expected, found_text()));
      ++at_;
    }
    if (i == 2 && !expect('|')) return false;
  }
  production.face = sides[0];
  production.other = labels[1];
  production.other_face = sides[1];
  return true;
}

// Reads a splitting production, `VOLA -E-> VOLB VOLC`.
bool FlowerReader::split(const Blocks& blocks, Production& production) {
  production.kind = Production::Kind::split;
  ++at_;
  FaceOf where;
  if (!face(where)) return false;
  if (where.worked_out) return wrong(where.place, message(messages::flower::split_face));
  production.face = where.face;
  if (!(at_ < end_ && tokens_[at_].kind == TokenKind::arrow))
    return wrong(here(), message(messages::flower::split_arrow));
  ++at_;
  const std::uint32_t begin = lowering_.here();
  if (!both_blocks(blocks, production) || too_much(where.place)) return false;
  production.blocks = {begin, lowering_.here()};
  return label_named(production.rest) &&
         description(forms_[production.rest], Scope::production, production.rest_description) &&
         label_named(production.part) &&
         description(forms_[production.part], Scope::production, production.part_description);
}

// Reads a label with a face, `PETAL_C3`.
bool FlowerReader::label_with_face(std::uint32_t& label, Face& face) {
  if (!on_name()) return wrong(here(), message(messages::flower::volume_and_face_expected, found_text()));
  const std::string_view both = found();
  const std::size_t low = both.rfind('_');
  if (low == std::string_view::npos || low == 0 || low + 1 == both.size())
    return wrong(here(), message(messages::flower::volume_and_face_expected, found_text()));
  const std::string_view name = both.substr(0, low), of = both.substr(low + 1);
  label = find_label(name);
  if (label == invalid) return fail(Reason::undefined, here(), message(messages::flower::undefined_volume, name));
  if (!face_named(of, face)) return wrong(here(), message(messages::flower::volume_and_face_expected, found_text()));
  return ++at_, true;
}

// Reads the name of a volume that must be defined.
bool FlowerReader::label_named(std::uint32_t& label) {
  if (!on_name()) return wrong(here(), message(messages::flower::volume_name_expected, found_text()));
  label = find_label(found());
  if (label == invalid) return fail(Reason::undefined, here(), message(messages::flower::undefined_volume, found()));
  ++at_;
  return true;
}

// Adds notes on productions of volumes that the axiom cannot lead to.
void FlowerReader::note_unreached() {
  std::vector<bool> reached(program_.labels.size());
  std::vector<std::uint32_t> waiting;
  const auto reach = [&](std::uint32_t label) {
    if (!reached[label]) waiting.push_back(label);
    reached[label] = true;
  };
  reach(program_.grammars[0].axiom);
  while (!waiting.empty()) {
    const Label& label = program_.labels[waiting.back()];
    waiting.pop_back();
    for (std::uint32_t i = label.productions.begin; i < label.productions.end; ++i) {
      const Production& production = program_.productions[i];
      if (production.becomes != invalid) reach(production.becomes);
      for (const GrowAction& growth : production.growths)
        reach(growth.module ? program_.grammars[growth.target].axiom : growth.target);
      if (production.kind != Production::Kind::split) continue;
      reach(production.rest);
      reach(production.part);
    }
  }
  for (const Production& production : program_.productions) {
    const Label& label = program_.labels[production.predecessor];
    // The call of an unused module may not be written yet.
    const bool called = label.grammar == 0 || reached[program_.grammars[label.grammar].axiom];
    if (called && !reached[production.predecessor])
      program_.notes.push_back(message(messages::expression::at_line, production.place.line,
                                       message(messages::flower::never_grown, label.name)));
  }
}

}  // namespace panicle::flower
