#include "lsystem/derivation/skippable_symbols.hpp"

namespace panicle::lsystem {

// The turtle is the moving pen that draws a string.

namespace {

// Whether an action changes the turtle's position, or its later positions.
bool leads_on(Action action) {
  switch (action) {
    case Action::width:
    case Action::widen:
    case Action::next_colour:
    case Action::last_colour:
    case Action::surface:
    case Action::ball:
    case Action::disc:
      return false;
    default:
      return true;
  }
}

// Whether an action belongs to polygons.
bool draws_polygons(Action action) {
  return action == Action::begin_polygon || action == Action::end_polygon || action == Action::corner;
}

// Any action at all.
bool any_action(Action) { return true; }

}  // namespace

// Finds the symbols that an interpretation can skip: without a listener (`heard` false) all that do not move the
// turtle, else those without a meaning.
SkippableSymbols::SkippableSymbols(const Program& program, const Rules* images, bool heard)
    : program_(program), images_(images), quiet_(program.symbols.size()) {
  for (std::uint32_t symbol = 0; symbol < quiet_.size(); ++symbol) {
    bool quiet = !means(symbol, heard ? any_action : leads_on);
    const Range drawn = has_image(symbol) ? images[symbol].productions : Range{};
    for (std::uint32_t i = drawn.begin; i < drawn.end; ++i)
      quiet = quiet && !heard && comes_back(program.productions[i].successor);
    quiet_[symbol] = quiet;
  }
}

// Whether a symbol's turtle action satisfies a predicate.
bool SkippableSymbols::means(std::uint32_t symbol, bool (*what)(Action)) const {
  const std::uint8_t meaning = program_.meanings[symbol];
  return meaning != no_meaning && what(turtle_symbols[meaning].action);
}

// Whether the image of a module leaves the turtle where it was, as leaves do: all moves are in branches, and there is
// no polygon, which could be left open in one.
bool SkippableSymbols::comes_back(const Template& image) const {
  std::uint32_t open = 0;
  const std::uint32_t* at = program_.words.data() + image.first;
  for (const std::uint32_t* const end = at + image.words; at < end; at += words_of(*at)) {
    const std::uint32_t symbol = symbol_of(*at);
    if (symbol == push_symbol) {
      ++open;
    } else if (symbol == pop_symbol) {
      --open;
    } else if (has_image(symbol) || means(symbol, draws_polygons) || (open == 0 && means(symbol, leads_on))) {
      return false;
    }
  }
  return true;
}

// Finds the branches without queries, which the turtle need not walk, in one walk over the headers: a growing plant has
// queries only at its tips. Branches are listed in the order of their [; one with a query is stored as empty.
void SkippableSymbols::find_branches(const String& string) {
  std::vector<std::size_t> open;
  std::uint64_t offset = 0;
  for (const std::uint32_t* at = string.begin(); at < string.end(); at += words_of(*at)) {
    const std::uint32_t symbol = symbol_of(*at);
    offset = static_cast<std::uint64_t>(at - string.begin());
    if (symbol == push_symbol) {
      open.push_back(branches_.size());
      branches_.push_back({offset, offset + 1});
    } else if (symbol == pop_symbol && !open.empty()) {
      Branch& closed = branches_[open.back()];
      if (closed.end != closed.begin) closed.end = offset + words_of(*at);
      open.pop_back();
    } else if (program_.is_turtle_query(symbol)) {
      for (std::size_t i = open.size(); i-- > 0 && branches_[open[i]].end != branches_[open[i]].begin;)
        branches_[open[i]].end = branches_[open[i]].begin;
    }
  }
}

}  // namespace panicle::lsystem
