// Reading and placing any text ends with a plan or a diagnostic.
#include "foundation/random.hpp"
#include "models/stand/plans.hpp"

using namespace panicle;
using namespace panicle::stand;
using namespace panicle::stand::tests;

TEST_CASE("stand: any text gives a plan or a diagnostic") {
  static const std::vector<std::string> words = {
      "ground", "plants", "blue",  "rows",  "random", "stratified", "towards", "jitter", "depth",  "relief",
      "hills",  "a/b",    "c/d-1", "share", "crown",  "scale",      "seeds",   "each",   "height", "reach",
      "x",      "to",     ",",     ",",     ":",      "\n",         "\n",      "(",      ")",      "1",
      "20",     "0.5",    "-",     "1e9",   "1/0",    "\"oak\"",    "age",     "ran(2)", "…",      "/*"};
  static const std::vector<std::string> sound = {
      "ground", "20", "x",   "0.5", ",",     "relief", "1",  "\n",    "plants", "20", ",",      "blue",
      "0.5",    "\n", "a/b", ",",   "share", "0.5",    ",",  "crown", "1",      "x",  "20",     ":",
      "age",    "1",  "to",  "20",  "\n",    "c/d-1",  ",",  "each",  "1",      "\n", "plants", ",",
      "rows",   "1",  "x",   "0.5", ",",     "jitter", "20", "\n",    "a/b",    ",",  "seeds",  "20"};
  std::uint32_t read = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    // Random words, or a valid plan with a word or two replaced.
    std::vector<std::string> all = sound;
    if (i % 2 == 0) {
      all.resize(1 + random_bits(1, i, 0) % 20);
      for (std::size_t k = 0; k < all.size(); ++k) all[k] = words[random_bits(2, i, k) % words.size()];
    }
    for (std::uint64_t k = 0; k < 1 + i % 3; ++k)
      all[random_bits(3, i, k) % all.size()] = words[random_bits(4, i, k) % words.size()];
    std::string text;
    for (const std::string& word : all) text += word + " ";
    const auto plan = read_plan(text);
    if (!plan) {
      CHECK_FALSE(plan.error().message.empty());
      continue;
    }
    ++read;
    std::vector<std::string> notes;
    const auto plants = place(plan.value(), Relief(plan->ground, i), i, 0, notes);
    if (plants) CHECK(surroundings_of(plan.value(), plants.value()).size() == 16 * plants->size());
  }
  CHECK(read > 100);
}
