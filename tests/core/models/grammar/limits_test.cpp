// Grammars beyond the limits: each ends with a note and the plant that has grown so far, and all its work is counted in
// one budget.
#include <algorithm>

#include "foundation/english.hpp"
#include "models/grammar/growing.hpp"

namespace panicle::grammar {
namespace {

struct Limited {
  Plant plant;
  std::uint64_t spent = 0, held = 0;

  bool notes(std::string_view part) const {
    return std::any_of(plant.notes.begin(), plant.notes.end(),
                       [&](const std::string& note) { return english(note).find(part) != std::string::npos; });
  }
};

Limited limited(GrammarRequest request, const char* outputs = "meshes sky measures") {
  request.outputs = outputs;
  WorkBudget budget(request.limits.work, request.limits.bytes);
  request.limits.budget = &budget;
  Limited grown{grow(request)};
  grown.spent = budget.spent();
  grown.held = budget.held();
  return grown;
}

Limits small(std::uint32_t work, std::uint32_t bytes = Limits{}.bytes) {
  Limits limits;
  limits.work = work;
  limits.bytes = bytes;
  return limits;
}

constexpr std::string_view so_far = "The plant is shown as far as it has grown. The grammar exceeds the limit of ";

TEST_CASE("responses to ?E count as work, with one radius for all and with a radius for each") {
  for (const char* const radius : {"1000", "i/100"}) {
    CAPTURE(radius);
    const std::string text =
        std::string("derivation length: 4096\naxiom: A(1)\nA(i) --> F(0.1) ?E(") + radius + ",0,0) A(i+1)\n";
    const Limited grown = limited({.text = text, .limits = small(1'000'000)});
    CHECK(grown.notes(so_far));
    CHECK(grown.plant.segments.size() > 20);
    CHECK(grown.plant.segments.size() < 600);
  }
}

TEST_CASE("a response to ?E with a radius near the largest number takes the work of one cell") {
  const Limited grown = limited({.text = "derivation length: 2\naxiom: F(1) ?E(3e38,0,0)\n?E(r,n,l) --> F(1)\n"});
  CHECK_FALSE(grown.notes(so_far));
  CHECK(grown.plant.segments.size() == 2);
  CHECK(grown.spent < 1000);
}

TEST_CASE("a homomorphism without an end shows what it drew until then") {
  const std::string text =
      "#turtle cpfg\nderivation length: 1\naxiom: A\nA --> B\nhomomorphism\nmaximum depth: 256\nB --> F B F B\n";
  const Limited grown = limited({.text = text, .limits = small(200'000)});
  CHECK(grown.notes(so_far));
  CHECK(grown.plant.segments.size() > 10'000);
}

TEST_CASE("turtle walks that locate modules count as work, with what a homomorphism draws in them") {
  const std::string text =
      "derivation length: 4096\n#turtle cpfg\naxiom: A ?P(0,0,0)\nA --> A\n?P(x,y,z) --> F ?P(0,0,0)\nhomomorphism\n"
      "maximum depth: 12\nA --> F A + A\n";
  const Limited grown = limited({.text = text, .limits = small(1'000'000)});
  CHECK(grown.notes(so_far));
  CHECK(count_of(grown.plant, "steps") < 300);
}

TEST_CASE("functions take more work than sums do") {
  const auto steps = [](std::string_view term) {
    std::string text = "derivation length: 4096\naxiom: A(1)\nA(x) --> A(0*(1";
    for (int i = 1; i < 200; ++i) text += "+" + std::string(term) + std::to_string(i) + ")";
    const Limited grown = limited({.text = text + "))\n", .limits = small(30'000)});
    return count_of(grown.plant, "steps");
  };
  CHECK(steps("(x+") > 10 * steps("sin(x+"));
  CHECK(steps("sin(x+") > 2 * steps("nran(x,"));
}

TEST_CASE("filling polygons is work, and polygons are filled where none is left") {
  std::string star = "{ ";
  for (int i = 0; i < 300; ++i) star += ". F(9) . +(177) ";
  const std::string text = "axiom: A\nderivation length: 6\nA --> A A\nhomomorphism\nA --> " + star + "}\n";
  const Limited whole = limited({.text = text}), grown = limited({.text = text, .limits = small(200'000)});
  CHECK(count_of(whole.plant, "polygons") == 64);
  CHECK(count_of(grown.plant, "polygons") == 64);
  CHECK(whole.spent > 300'000);
  CHECK(grown.spent < 300'000);
  CHECK(grown.plant.meshes.size() == whole.plant.meshes.size());
}

TEST_CASE("lines, balls, surfaces and polygons end where a file of them would be too large") {
  for (const char* const drawn : {"F + F & F", "@O(1) f", "~fivelobed ~toothed f", "{ . f . + f . + f . }"}) {
    CAPTURE(drawn);
    const std::string text =
        std::string("#turtle cpfg\naxiom: A\nderivation length: 15\nA --> A A\nhomomorphism\nA --> ") + drawn + "\n";
    const Limited grown = limited({.text = text, .limits = small(50'000'000, 20'000'000)});
    CHECK(grown.notes("the limit of 20 MB for a file"));
    CHECK(grown.held <= 20'000'000);
    CHECK(grown.held > 19'900'000);
    std::uint64_t bytes = 0;
    for (const Organ& organ : grown.plant.organs)
      if (organ.mesh >= 0) {
        const Mesh& mesh = grown.plant.meshes[static_cast<std::size_t>(organ.mesh)].mesh;
        bytes += 4 * (mesh.positions.size() + mesh.normals.size() + mesh.uvs.size() + mesh.indices.size());
      }
    CHECK(bytes <= 20'000'000);
  }
}

TEST_CASE("a string that is too long to be written as text is left out, with a note") {
  const std::string text = "axiom: A(1)\nA(x) --> A(x) A(x)\n";
  const Plant plant = grow({.text = text, .steps = 22, .outputs = "string"});
  CHECK(column_in<char>(plant.columns, "string").empty());
  CHECK(std::any_of(plant.notes.begin(), plant.notes.end(), [](const std::string& note) {
    return english(note).find("too long to be shown as text") != std::string::npos;
  }));
  CHECK(column_in<char>(grow({.text = text, .steps = 10, .outputs = "string"}).columns, "string").size() > 4000);
}

TEST_CASE("surfaces that are unknown are named a few times, however many there are") {
  std::string text = "axiom: ";
  for (int i = 0; i < 20'000; ++i) text += "~x" + std::to_string(i) + " ";
  const Plant plant = grow({.text = text});
  CHECK(std::count_if(plant.notes.begin(), plant.notes.end(),
                      [](const std::string& note) { return english(note).starts_with("There is no surface"); }) == 12);
}

// A clock that advances by a hundredth of the time limit at each reading.
double hundredths = 0;
double next_hundredth() { return ++hundredths / 100; }

Limited limited_in_time(GrammarRequest request) {
  hundredths = 0;
  request.outputs = "meshes sky measures";
  WorkBudget budget(request.limits.work, request.limits.bytes, next_hundredth);
  request.limits.budget = &budget;
  return {grow(request), budget.spent(), budget.held()};
}

TEST_CASE("a grammar that reaches its time limit shows the plant after three quarters of the time") {
  const std::string text = "derivation length: 4096\naxiom: A\nA --> F(1) {[+F(1).][-F(1).]} B A\nB --> B\n";
  const Limits limits = small(4'000'000'000);
  const Limited grown = limited_in_time({.text = text, .limits = limits});
  CHECK(grown.plant.cut_short == CutShort::time);
  CHECK(grown.notes("The plant is shown as far as it has grown. The time limit was reached; "));
  CHECK(hundredths >= 75);
  CHECK(hundredths < 100);
  CHECK(count_of(grown.plant, "steps") > 100);
  CHECK(grown.plant.segments.size() == count_of(grown.plant, "steps"));
}

TEST_CASE("a grammar that ends within its time limit grows as without one") {
  const GrammarRequest request{.text = "derivation length: 40\naxiom: A\nA --> F(1) [+A] F\n"};
  const Limited timed = limited_in_time(request), untimed = limited(request);
  CHECK(timed.plant.cut_short == CutShort::none);
  CHECK(timed.plant.fingerprint == untimed.plant.fingerprint);
  CHECK(timed.plant.notes == untimed.plant.notes);
  CHECK(timed.spent == untimed.spent);
}

TEST_CASE("a plant that a limit of work, of segments or of its file ended is marked as cut short") {
  const std::string text = "derivation length: 4096\naxiom: A\nA --> F(1) A\n";
  CHECK(limited({.text = text, .limits = small(100'000)}).plant.cut_short == CutShort::limit);
  CHECK(limited({.text = text, .limits = small(50'000'000, 100'000)}).plant.cut_short == CutShort::limit);
  CHECK(limited({.text = "derivation length: 3\naxiom: A\nA --> F(1) A\n"}).plant.cut_short == CutShort::none);
}

TEST_CASE("a trace with reasons takes no work from the plant's budget") {
  const std::string text = "derivation length: 6\naxiom: A(0)\nA(x) : x<0 --> F\nA(x) --> F(1) [+(30) A(x+1)] A(x+1)\n";
  const std::uint32_t step = 5;
  GrammarRequest request{.text = text};
  const Limited plain = limited(request);
  request.more = {{"chronicle_step", Element::uint32, 1, 1, reinterpret_cast<const std::uint8_t*>(&step)}};
  const Limited traced = limited(request, "meshes sky measures chronicle");
  bool has_refusals = false;
  for (std::size_t i = 0; i < traced.plant.columns.size(); ++i)
    has_refusals |= traced.plant.columns[i].name == "chronicle.refusals";
  CHECK(has_refusals);
  CHECK(traced.spent == plain.spent);
}

}  // namespace
}  // namespace panicle::grammar
