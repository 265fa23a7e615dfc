// Published grammars damaged as people and programs damage texts: lines lost, doubled and out of order, words of one
// text in another, numbers beyond all sense. And the texts that once made the engine fall over, each as a file.
#include <filesystem>

#include "lsystem/fuzz.hpp"
#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

std::vector<std::string> texts_in(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".lsys") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const std::string& path : paths) texts.push_back(file_text(path));
  return texts;
}

// Splits a text into lines, or into words and the characters between them; joined, the pieces give the text.
std::vector<std::string> parts_of(const std::string& text, bool lines) {
  const auto kind = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' ? 2 : 1; };
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || (lines ? text[i - 1] == '\n' : kind(text[i]) == 1 || kind(text[i - 1]) == 1);
    if (begins) parts.emplace_back();
    parts.back() += text[i];
  }
  return parts;
}

const char* const numbers[] = {"0", "-1", "1e30", "1e-30", "0.5", "4096", "4097", "65536", "7", "1/0", "ran(1)", "n"};

std::string damaged(Dice& dice, const std::vector<std::string>& texts) {
  std::string text = texts[dice.below(texts.size())];
  const std::string& other = texts[dice.below(texts.size())];
  for (std::size_t changes = 1 + dice.below(4); changes-- > 0;) {
    const bool lines = dice.below(3) == 0;
    std::vector<std::string> parts = parts_of(text, lines);
    const std::vector<std::string> others = parts_of(other, lines);
    if (parts.empty()) break;
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
      case 4:
        part.insert(dice.below(part.size() + 1), others[dice.below(others.size())]);
        break;
      default:
        if (!part.empty() && std::isdigit(static_cast<unsigned char>(part[0])))
          part = numbers[dice.below(std::size(numbers))];
        break;
    }
    text.clear();
    for (const std::string& each : parts) text += each;
  }
  return text;
}

}  // namespace

TEST_CASE("published grammars with random changes end in a value or a diagnostic") {
  const std::vector<std::string> texts = texts_in(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar");
  REQUIRE(texts.size() > 60);
  int outcomes[4] = {};
  const std::uint64_t runs = fuzz_runs(1500);
  for (std::uint64_t i = 0; i < runs; ++i) {
    Dice dice(7, 1'000'000 + i);
    const std::string text = damaged(dice, texts);
    CAPTURE(text);
    ++outcomes[tried(text, static_cast<std::uint32_t>(i))];
  }
  // Many still grow, many are no grammar any more.
  CHECK(outcomes[0] > static_cast<int>(runs / 12));
  CHECK(outcomes[1] > static_cast<int>(runs / 12));
}

TEST_CASE("texts that once crashed the engine end in a value or a diagnostic") {
  const std::vector<std::string> finds = texts_in(panicle::tests::repository_folder() + "/tests/fuzz/grammars");
  REQUIRE_FALSE(finds.empty());
  for (const std::string& text : finds) {
    CAPTURE(text);
    for (std::uint32_t mood = 0; mood < 8; ++mood) tried(text, mood);
  }
}
