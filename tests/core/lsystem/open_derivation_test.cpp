// Steps and answers in turn: open L-systems (Měch and Prusinkiewicz 1996).
#include "lsystem/derivation/derivation.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;
using lsystem::Derivation;

namespace {

std::string text_of(const BoundProgram& bound, const Derivation& derivation) {
  return lsystem::to_text(lsystem::program_of(bound), derivation.string());
}

// Responds with the height of each module above the floor.
class Floor : public Recorder {
 public:
  explicit Floor(float y) : y_(y) {}
  void query(const Turtle& turtle, std::span<float> parameters, const Lineage& lineage) override {
    Recorder::query(turtle, parameters, lineage);
    parameters[0] = turtle.position.y - y_;
  }

 private:
  float y_;
};

}  // namespace

TEST_CASE("a derivation begins with the axiom and goes on step by step") {
  const BoundPointer bound = compiled("axiom: A(2) B\nA(i) : i>0 --> F A(i-1)\nB --> C % D\nC --> G");
  Derivation derivation(*bound, 1, Limits{});
  CHECK(text_of(*bound, derivation) == "A(2)B");
  CHECK_FALSE(derivation.at_rest());
  const char* const strings[] = {"F A(1)C%D", "F F A(0)G"};
  for (std::uint32_t i = 0; i < 2; ++i) {
    CHECK(derivation.step());
    CHECK(derivation.steps() == i + 1);
    CHECK(text_of(*bound, derivation) == strings[i]);
  }
  CHECK_FALSE(derivation.step());
  CHECK(derivation.at_rest());
  CHECK(derivation.steps() == 3);
  CHECK_FALSE(derivation.step());
  CHECK(text_of(*bound, derivation) == strings[1]);
  CHECK(derivation.error().reason == Reason::none);
}

TEST_CASE("a shoot grows until the environment's response is that it has reached the floor") {
  const BoundPointer bound =
      compiled("derivation length: 9\naxiom: ?E(9)\n?E(h) : h>=1 --> F ?E(h)\n?E(h) : h<1 --> [ +L ] L\nL --> S(0.5)");
  Derivation derivation(*bound, 1, Limits{});
  Floor floor(-2.5);
  const char* const strings[] = {"F?E(2.5)", "F F?E(1.5)", "F F[+L]L", "F F[+S(0.5)]S(0.5)"};
  std::vector<std::size_t> seen;  // the environment observes the whole string before it responds
  for (const char* string : strings) {
    floor.lines.clear();
    REQUIRE(derivation.query_environment({}, floor));
    seen.push_back(floor.lines.size());
    CHECK(derivation.step());
    CHECK(text_of(*bound, derivation) == string);
  }
  CHECK(floor.queried.size() == 3);
  CHECK(seen == std::vector<std::size_t>{0, 1, 2, 2});
  floor.lines.clear();
  REQUIRE(derivation.query_environment({}, floor));
  CHECK_FALSE(derivation.step());
}

TEST_CASE("a response is written into the string, and only modules queried since the last step are rewritten") {
  const BoundPointer bound = compiled("axiom: A(2) [ ?E(0,5) ] F\nA(i) : i>0 --> A(i-1) ?E(9,1)\n?E(a,b) : a>6 --> F");
  Derivation derivation(*bound, 1, Limits{});
  CHECK(derivation.step());
  CHECK(text_of(*bound, derivation) == "A(1)?E(9,1)[?E(0,5)]F");
  Recorder recorder;
  recorder.answers = {{7}, {6, 4}};
  CHECK(derivation.query_environment({}, recorder));
  CHECK(recorder.queried == std::vector<std::vector<float>>{{9, 1}, {0, 5}});
  CHECK(recorder.queried_by == std::vector<std::string>{"A", ""});
  CHECK(text_of(*bound, derivation) == "A(1)?E(7,1)[?E(6,4)]F");
  CHECK(derivation.step());
  CHECK(text_of(*bound, derivation) == "A(0)?E(9,1)F[?E(6,4)]F");
  CHECK_FALSE(derivation.step());
  CHECK(derivation.at_rest());
  recorder.answers = {{8}};
  recorder.lines.clear();
  CHECK(derivation.query_environment({}, recorder));
  CHECK_FALSE(derivation.at_rest());
  CHECK(derivation.step());
  CHECK(text_of(*bound, derivation) == "A(0)F F[F]F");
}

TEST_CASE("modules of a response have lineages, and draw random values of their own") {
  const BoundPointer bound =
      compiled("derivation length: 3\naxiom: ?E(1) ?E(1)\n?E(x) --> B(ran(1)) ?E(x)\nB(r) --> F(r)");
  Derivation derivation(*bound, 1, Limits{});
  Recorder drawing;
  for (int i = 0; i < 4; ++i) {
    Recorder silent;
    CHECK(derivation.query_environment({}, silent));
    CHECK(derivation.step());
  }
  const auto drawn = lsystem::interpret_without_queries(*bound, derivation.string(), {}, drawing, 1, Limits{});
  REQUIRE(drawn);
  REQUIRE(drawn.value() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(drawing.lines[i].parent == "B");
    CHECK(drawing.lines[i].grandparent == "?E");
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(drawing.lines[i].address != drawing.lines[j].address);
      CHECK(drawing.lines[i].after.position != drawing.lines[j].after.position);
    }
  }
  CHECK(drawing.queried.empty());
}

TEST_CASE("a cut in a response acts in the step after it was written") {
  const BoundPointer bound = compiled("axiom: [ ?E(1) A ] A\n?E(x) : x=0 --> F %\nA --> F A");
  Derivation derivation(*bound, 1, Limits{});
  Recorder recorder;
  recorder.answers = {{0}};
  CHECK(derivation.query_environment({}, recorder));
  CHECK(derivation.step());
  CHECK(text_of(*bound, derivation) == "[F%F A]F A");
  CHECK(derivation.step());
  CHECK(text_of(*bound, derivation) == "[F]F F A");
}

TEST_CASE("a response with other symbols than the turtle's needs steps, and cannot be drawn in place") {
  std::string message;
  CHECK(trouble("axiom: ?E(1)\n?E(x) --> F A", {}, {}, &message) == "syntax 2:13");
  CHECK(message.find("derivation length") != std::string::npos);
  const BoundPointer bound = compiled("derivation length: 1\naxiom: ?E(1)\n?E(x) --> F A");
  Recorder recorder;
  const auto drawn = lsystem::interpret(*bound, *derived(*bound, 1).string, {}, recorder, 1, Limits{});
  REQUIRE_FALSE(drawn);
  CHECK(drawn.error().reason == Reason::syntax);
  CHECK(drawn.error().line == 3);
  CHECK(drawn.error().column == 13);
}

TEST_CASE("an error in a step or a response ends the derivation") {
  const BoundPointer bound = compiled("axiom: A(2)\nA(i) --> F(1/(i-1)) A(i-1)");
  Derivation derivation(*bound, 1, Limits{});
  CHECK(derivation.step());
  CHECK_FALSE(derivation.step());
  CHECK(derivation.error().reason == Reason::evaluation);
  CHECK(derivation.at_rest());
  Recorder recorder;
  CHECK_FALSE(derivation.query_environment({}, recorder));
  const BoundPointer wrong = compiled("#input n[]\naxiom: A(RND(n[1],0.5))", {{}, {{"n", {0.2f}}}});
  CHECK(Derivation(*wrong, 1, Limits{}).error().line == 2);

  Limits shallow;
  shallow.depth = 1;
  const BoundPointer nested = compiled("axiom: [[F]]");
  Derivation deep(*nested, 1, shallow);
  CHECK_FALSE(deep.query_environment({}, recorder));
  CHECK(deep.error().reason == Reason::limit);
}
