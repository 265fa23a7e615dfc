#include "models/bunch/grammars.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "grammar_files.hpp"
#include "models/bunch/builtin.hpp"

using namespace panicle;

namespace {

// A text without comments between /* and */, and without spaces.
std::string bare(const std::string& text) {
  std::string left;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.compare(at, 2, "/*") == 0) {
      at = text.find("*/", at) + 1;
    } else if (text[at] != ' ' && text[at] != '\n') {
      left += text[at];
    }
  }
  return left;
}

}  // namespace

TEST_CASE("the grammars compiled in are the files, less their comments") {
  for (const int number : {1, 2, 3, 4}) {
    std::ifstream file(panicle::tests::repository_folder() + "/wasm-core/grammars/bunch/grape-bunch-" +
                       std::to_string(number) + ".lsys");
    std::ostringstream text;
    text << file.rdbuf();
    const std::string compiled_in(bunch::builtin_grammar(number));
    CHECK(text.str().size() > 500);
    CHECK(bare(compiled_in) == bare(text.str()));
    CHECK(compiled_in.find("/*") == std::string::npos);
    // Lines keep their numbers.
    const auto lines = [](const std::string& each) { return std::count(each.begin(), each.end(), '\n'); };
    CHECK(lines(compiled_in) == lines(text.str()));
  }
}
