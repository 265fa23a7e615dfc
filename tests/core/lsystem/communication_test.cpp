// ?E: queried during interpretation, with a response from the listener, applied in place (Měch and Prusinkiewicz 1996).
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

const char* const second_grape = R"(
#define l_w 10
axiom: A(2)
A(i) : i>0 --> ?E(0,0,i*60) [ + A(i-1) ] B
B --> ?E(1,0,30)
?E(type,theta,l) : type=0 && l>0    --> +(theta) F(l)
?E(type,theta,l) : type=0 && l=0    --> %
?E(type,theta,l) : type=1 && l=l_w  --> +(theta) F(l) %
?E(type,theta,l) : type=1 && l!=l_w --> +(theta) F(l) S(5)
)";

Recorder answered(std::string_view text, std::vector<std::vector<float>> answers, std::uint32_t steps = 4096) {
  const BoundPointer bound = compiled(text);
  Recorder recorder;
  recorder.answers = std::move(answers);
  draw(*bound, derived(*bound, steps), recorder);
  return recorder;
}

}  // namespace

TEST_CASE("communication modules query with their parameters, in the order of the string") {
  const Recorder recorder = answered(second_grape, {});
  REQUIRE(recorder.queried.size() == 4);
  CHECK(recorder.queried[0] == std::vector<float>{0, 0, 120});
  CHECK(recorder.queried[1] == std::vector<float>{0, 0, 60});
  CHECK(recorder.queried[2] == std::vector<float>{1, 0, 30});
  CHECK(recorder.queried[3] == std::vector<float>{1, 0, 30});
  CHECK(recorder.queried_by == std::vector<std::string>{"A", "A", "B", "B"});
  CHECK(recorder.lines.size() == 4);
  CHECK(recorder.spheres.size() == 2);
}

TEST_CASE("the production that matches the response is drawn in place") {
  const Recorder recorder = answered(second_grape, {{0, 90, 7}, {0, -90, 3}, {1, 0, 10}, {1, 0, 4}});
  REQUIRE(recorder.lines.size() == 4);
  CHECK(recorder.lines[0].after.position == glm::vec3(7, 0, 0));
  CHECK(recorder.lines[1].after.position == glm::vec3(10, 0, 0));  // turned by 90° + 90° − 90°
  CHECK(recorder.spheres.size() == 1);
  CHECK(recorder.cuts == 1);
}

TEST_CASE("a response may cut its branch, and no more") {
  const Recorder all = answered(second_grape, {{0, 0, 0}});
  CHECK(all.lines.empty());
  CHECK(all.queried.size() == 1);
  CHECK(all.cuts == 1);
  const Recorder inner = answered(second_grape, {{0, 0, 9}, {0, 0, 0}, {1, 0, 30}});
  CHECK(inner.queried.size() == 3);
  CHECK(inner.lines.size() == 2);
  const Recorder bracketed = answered("axiom: ?E(1) F F\n?E(x) --> [ F % F F ] F", {});
  CHECK(bracketed.lines.size() == 4);
}

TEST_CASE("without a production that matches, a communication module does nothing") {
  CHECK(answered(second_grape, {{7, 0, 5}}).lines.empty());
  CHECK(answered("axiom: ?E(1,2) F\n?E(x) --> F F", {}).lines.size() == 1);
  CHECK(answered("axiom: ?E F\n?E --> F F", {}).lines.size() == 3);
}

TEST_CASE("derivation leaves communication modules alone") {
  CHECK(after("axiom: ?E(1) A\nA --> ?E(2)\n?E(x) --> F", 5) == "?E(1)?E(2)");
}

TEST_CASE("modules drawn as a response have the lineage of the communication module") {
  const Recorder recorder = answered(second_grape, {});
  REQUIRE(recorder.lines.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(recorder.lines[i].address == recorder.addresses[i]);
    CHECK(recorder.lines[i].parent == recorder.queried_by[i]);
  }
  CHECK(recorder.lines[1].grandparent == "A");
  CHECK(recorder.lines[0].grandparent.empty());
}

TEST_CASE("a response that is not finite is an error where the turtle would use it") {
  const BoundPointer bound = compiled(second_grape);
  const Derived string = derived(*bound, 4096);
  Recorder recorder;
  recorder.answers = {{0, 0, 1 / 0.0f}};
  const auto result = lsystem::interpret(*bound, *string.string, {}, recorder, 1, Limits{});
  REQUIRE_FALSE(result);
  CHECK(result.error().reason == Reason::evaluation);
  CHECK(result.error().line == 6);
  CHECK(result.error().column == 52);
}

TEST_CASE("random values in a response belong to the communication module") {
  const char* text = "axiom: ?E(1) ?E(1)\n?E(x) --> F(ran(1))";
  const Recorder first = answered(text, {}), again = answered(text, {});
  REQUIRE(first.lines.size() == 2);
  const float a = first.lines[0].after.position.y, b = first.lines[1].after.position.y - a;
  CHECK(a != b);
  CHECK(again.lines[1].after.position == first.lines[1].after.position);
}
