// Texts of every language with random changes: each ends within the limits on work and memory. The changes are the same
// in each run (fuzz_dice.hpp).
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "exports/linked_models.hpp"
#include "foundation/container.hpp"
#include "foundation/english.hpp"
#include "fuzz_dice.hpp"
#include "grammar_files.hpp"
#include "protocol/request.hpp"
#include "sanitizers.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

// A language: its model, the block of a request that holds a text, and the texts of the repository.
struct Language {
  const char* model;
  const char* block;
  std::vector<std::string> texts;
};

std::vector<Language> languages() {
  std::vector<Language> all = {
      {"grammar", "grammar", {}}, {"flower", "text", {}}, {"growth", "rules", {}}, {"stand", "plan", {}}};
  for (Language& language : all)
    for (const auto& file : grammar_files(language.model)) language.texts.push_back(content(file));
  return all;
}

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; }

// Splits a text into lines, or into words and the characters between them; joined, the pieces give the text.
std::vector<std::string> parts_of(const std::string& text, bool lines) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || (lines ? text[i - 1] == '\n' : !is_of_word(text[i]) || !is_of_word(text[i - 1]));
    if (begins) parts.emplace_back();
    parts.back() += text[i];
  }
  return parts;
}

constexpr const char* numbers[] = {"0", "-1", "1", "12", "100", "4096", "1e30", "1e-30", "0.001", "1e6"};

// One to three changes: lines or words left out, doubled, moved, taken from another text; numbers that are far off.
std::string changed(Dice& dice, const std::vector<std::string>& texts) {
  std::string text = texts[dice.below(texts.size())];
  for (std::size_t changes = 1 + dice.below(3); changes > 0; --changes) {
    const bool lines = dice.below(3) == 0;
    std::vector<std::string> parts = parts_of(text, lines);
    const std::vector<std::string> others = parts_of(texts[dice.below(texts.size())], lines);
    if (parts.empty() || others.empty()) break;
    std::vector<std::size_t> of_digits;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (std::isdigit(static_cast<unsigned char>(parts[i][0]))) of_digits.push_back(i);
    std::string& part = parts[dice.below(parts.size())];
    switch (dice.below(6)) {
      case 0:
        part.clear();
        break;
      case 1:
        part += part;
        break;
      case 2:
        std::swap(part, parts[dice.below(parts.size())]);
        break;
      case 3:
        part = others[dice.below(others.size())];
        break;
      default:
        if (!of_digits.empty())
          parts[of_digits[dice.below(of_digits.size())]] = numbers[dice.below(std::size(numbers))];
    }
    text.clear();
    for (const std::string& each : parts) text += each;
  }
  return text;
}

const Model& model_named(std::string_view name) {
  const auto models = linked_models();
  return **std::find_if(models.begin(), models.end(), [&](const Model* each) { return each->name == name; });
}

Result<Plant> grow(const Language& language, const std::string& text, const Limits& limits) {
  const std::uint32_t seed = 1;
  const auto view = [](std::string_view name, std::string_view value) {
    return ColumnView{name, Element::text, 1, static_cast<std::uint32_t>(value.size()),
                      reinterpret_cast<const std::uint8_t*>(value.data())};
  };
  const std::vector<ColumnView> blocks = {
      view("model", language.model),
      view("outputs", "meshes sky measures"),
      view(language.block, text),
      {"seed", Element::uint32, 1, 1, reinterpret_cast<const std::uint8_t*>(&seed)}};
  const Model& model = model_named(language.model);
  Request request(blocks, nullptr);
  return model.grow(request, limits);
}

// The most memory that this program has held so far.
std::uint64_t max_bytes_held() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<std::uint64_t>(usage.ru_maxrss);
}

// `divisor`: of all limits, for a run that takes less.
Limits limits_over(std::uint32_t divisor) {
  Limits limits;
  limits.work /= divisor;
  limits.bytes /= divisor;
  limits.words /= divisor;
  limits.darts /= divisor;
  limits.segments /= divisor;
  limits.pieces /= divisor;
  limits.copies /= divisor;
  limits.moves /= divisor;
  return limits;
}

}  // namespace

// 2,000 texts, 500 of each language: with a tenth of the limits, and where PANICLE_FUZZ is set, as in the long run,
// with all of them. Memory is all that the program has held, so that nothing can be left out of the count; sanitizers,
// which keep freed memory for a while, may hold several times as much.
TEST_CASE("texts with changes take no more work and memory than the limits say") {
  constexpr std::uint64_t runs = 2000;
  const std::uint32_t divisor = fuzz_runs(runs) == runs ? 10 : 1;
  const std::uint64_t most =
      max_bytes_held() + (divisor == 1 ? 1'000'000'000 : 300'000'000) * (has_sanitizers() ? 4u : 1u);
  const std::vector<Language> all = languages();
  std::vector<std::uint64_t> grown(all.size(), 0), limited(all.size(), 0);
  for (std::uint64_t i = 0; i < runs; ++i) {
    const Language& language = all[i % all.size()];
    Dice dice(28, i);
    const std::string text = changed(dice, language.texts);
    CAPTURE(language.model);
    CAPTURE(text);
    Limits limits = limits_over(divisor);
    WorkBudget budget(limits.work, limits.bytes);
    limits.budget = &budget;
    const Result<Plant> plant = grow(language, text, limits);
    // The work that was refused last counts as spent, too.
    CHECK(budget.spent() <= limits.work + limits.work / 10);
    CHECK(budget.held() <= limits.bytes);
    REQUIRE(max_bytes_held() <= most);
    grown[i % all.size()] += plant ? 1 : 0;
    const bool stopped =
        plant ? std::any_of(plant->notes.begin(), plant->notes.end(),
                            [](const std::string& note) { return english(note).find("limit") != std::string::npos; })
              : plant.error().reason == Reason::limit;
    limited[i % all.size()] += stopped ? 1 : 0;
  }
  // Many grow all the same, and some of each language but plans reach a limit: else changes would prove nothing.
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i].model);
    CHECK(grown[i] > runs / 40);
    if (all[i].model != std::string_view("stand")) CHECK(limited[i] > 0);
  }
}
