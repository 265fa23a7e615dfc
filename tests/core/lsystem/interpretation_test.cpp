#include "foundation/english.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

// L-system 1 of Huang et al. 2013, as docs/bunch.md restores it.
const char* const first_grape = R"(
#input m
#input n[]
#define l 60
#define r_l 1
#define r_r 0.75
#define alpha 45
axiom: Ar(m, l)
Ar(i,j) : i>1 --> F(j) [ // Ar(i-1, j*r_l) ] [ +(alpha) Af(n[i-1], j*r_l) ]
Ar(i,j) : i=1 --> Ae(j*r_l)
Af(i,j) : i>1 --> F(j) [ // Af(i-1, j*r_l) ] [ +(alpha) Ae(j*r_l) ]
Af(i,j) : i=1 --> Ae(j*r_l)
Ae(j) --> F(j) [ Ap(j*r_l) ] [ +(alpha) Ap(j*r_l) ] [ -(alpha) Ap(j*r_l) ]
Ap(j) --> F(j) S(l*r_r)
)";

Diagnostic failure(std::string_view text, const Limits& limits) {
  const BoundPointer bound = compiled(text);
  const Derived string = derived(*bound, 4096);
  Recorder recorder;
  const auto result = lsystem::interpret(*bound, *string.string, {}, recorder, 1, limits);
  REQUIRE_FALSE(result);
  return result.error();
}

}  // namespace

TEST_CASE("L-system 1 with m = 3, n1 = 1, n2 = 2 has 19 internodes and 12 berries") {
  Inputs inputs{{{"m", 3}}, {{"n", {1, 2}}}};
  const BoundPointer bound = compiled(first_grape, inputs);
  const Derived string = derived(*bound, 4096);
  Recorder recorder;
  draw(*bound, string, recorder);
  CHECK(recorder.lines.size() == 19);
  CHECK(recorder.spheres.size() == 12);
  for (const Recorder::Ball& ball : recorder.spheres) {
    CHECK(ball.radius == 45);
    CHECK(ball.turtle.line >= 0);
  }
}

TEST_CASE("lineages have parent and grandparent where enabled") {
  Inputs inputs{{{"m", 3}}, {{"n", {1, 2}}}};
  const BoundPointer bound = compiled(first_grape, inputs, lsystem::Lineages::always);
  Recorder recorder;
  draw(*bound, derived(*bound, 4096), recorder);
  int pedicels = 0;
  for (const Recorder::Line& line : recorder.lines) pedicels += line.parent == "Ap" && line.grandparent == "Ae";
  CHECK(pedicels == 12);
  CHECK(recorder.lines[0].parent == "Ar");
  CHECK(recorder.lines[0].grandparent.empty());
  CHECK(recorder.lines[1].grandparent == "Ar");

  const BoundPointer plain = compiled(first_grape, inputs);
  Recorder without;
  draw(*plain, derived(*plain, 4096), without);
  CHECK(without.lines[1].parent.empty());
  CHECK(without.lines[1].after.position == recorder.lines[1].after.position);
}

TEST_CASE("brackets bring the turtle back, and lines know the line they leave") {
  const Recorder recorder = drawn("axiom: F [ +F F [ F ] F ] F f F", 0);
  REQUIRE(recorder.lines.size() == 7);
  const std::int32_t parents[] = {-1, 0, 1, 2, 2, 0, 5};
  for (std::size_t i = 0; i < 7; ++i) CHECK(recorder.lines[i].before.line == parents[i]);
  CHECK(recorder.lines[5].before.position == recorder.lines[0].after.position);
  CHECK(recorder.lines[6].before.position != recorder.lines[5].after.position);
}

TEST_CASE("lines of length 0 and spheres of radius 0 are not drawn") {
  const Recorder recorder = drawn("axiom: F(0) F(2) F(0) S(0) S(1) F(-2)", 0);
  REQUIRE(recorder.lines.size() == 2);
  CHECK(recorder.spheres.size() == 1);
  CHECK(recorder.lines[1].before.line == 0);
  CHECK(recorder.lines[1].after.position == glm::vec3(0, -1, 0));
}

TEST_CASE("symbols that are not the turtle's are passed over") {
  CHECK(drawn("axiom: A(1,2) F B F C(1)", 0).lines.size() == 2);
}

TEST_CASE("a % that the derivation has not executed is executed by the turtle") {
  const Recorder recorder = drawn("axiom: A\nA --> F [ F % F [ F ] ] F % F F", 1);
  CHECK(recorder.lines.size() == 3);
  CHECK(recorder.cuts == 2);
}

TEST_CASE("limits of interpretation") {
  std::string deep = "axiom: ";
  for (int i = 0; i < 101; ++i) deep += "[";
  deep += "F";
  for (int i = 0; i < 101; ++i) deep += "]";
  Limits limits;
  limits.depth = 100;
  const Diagnostic depth = failure(deep, limits);
  CHECK(depth.reason == Reason::limit);
  CHECK(english(depth.message).find("100 branches") != std::string::npos);
  limits.depth = 101;
  Recorder recorder;
  const BoundPointer bound = compiled(deep);
  CHECK(lsystem::interpret(*bound, *derived(*bound, 0).string, {}, recorder, 1, limits));

  const Diagnostic far = failure("axiom: F(3e38) F(3e38) F", Limits{});
  CHECK(far.reason == Reason::evaluation);
  CHECK(failure("axiom: f(3e38) S(3e38)", Limits{}).reason == Reason::evaluation);

  limits.work = 3;
  const Diagnostic answers = failure("axiom: ?E(1) ?E(1) ?E(1) ?E(1)\n?E(x) --> F", limits);
  CHECK(answers.reason == Reason::limit);
}

TEST_CASE("positions too far away and sizes too large or too small are errors with the module") {
  const auto refused = [](std::string_view text, const char* module, const char* why) {
    const Diagnostic error = failure(std::string("axiom: ") + std::string(text), Limits{});
    CAPTURE(text);
    CAPTURE(english(error.message));
    CHECK(error.reason == Reason::evaluation);
    CHECK(english(error.message).find(module) == 0);
    CHECK(english(error.message).find(why) != std::string::npos);
  };
  refused("F(1e37)", "Module 1 of the string (F(1e37)): The shape to draw is larger", "10^9");
  refused("F(1) S(1e38)", "Module 2 of the string (S(1e38)): The shape to draw is larger", "10^9");
  refused("F(9e8) F(9e8)", "Module 2 of the string (F(900000000)): The turtle is more than", "10^9");
  refused("f(9e8) f(9e8) F", "Module 2 of the string (f(900000000)): The turtle is more than", "10^9");
  refused("!(1e38) F", "Module 2 of the string (F): The line width is larger", "with “!”");
  refused("F(1e-30)", "Module 1 of the string (F(1e-30)): The shape to draw is smaller", "10^-18");
  refused("S(1e-30)", "Module 1 of the string (S(1e-30)): The shape to draw is smaller", "10^-18");
  const auto refused_in_cpfg = [](std::string_view text, const char* module) {
    const auto program = lsystem::compile(std::string("axiom: ") + std::string(text), Limits{},
                                          lsystem::Lineages::where_needed, lsystem::Notation::cpfg);
    REQUIRE_MESSAGE(program, english(program.error().message));
    const BoundPointer bound = sound(lsystem::bind(program.value(), {}, Limits{}));
    Recorder recorder;
    const auto result = lsystem::interpret(*bound, *derived(*bound, 1).string, {}, recorder, 1, Limits{});
    CAPTURE(text);
    REQUIRE_FALSE(result);
    CAPTURE(english(result.error().message));
    CHECK(result.error().reason == Reason::evaluation);
    CHECK(english(result.error().message).find(module) == 0);
  };
  refused_in_cpfg("@Di(1e38)@Di(1e38)@O(1)", "Module 3 of the string (@O(1)): The shape to draw is larger");
  refused_in_cpfg("@Di(1e38)@Di(1e38)~leaf", "Module 3 of the string (~leaf): The shape to draw is larger");
  refused_in_cpfg("@Di(1e-30)@Di(1e-30)@O(1)",
                  "Module 2 of the string (@Di(1e-30)): The scale of the drawing becomes too small");
  refused_in_cpfg("@Di(1e-10)@O(1e-10)", "Module 2 of the string (@O(1e-10)): The shape to draw is smaller");
  refused_in_cpfg("@Di(1e38)@o(1)", "Module 2 of the string (@o(1)): The shape to draw is larger");
  refused_in_cpfg("@M(1e12,0,0) F", "Module 1 of the string (@M(1e12,0,0)): The turtle is more than");
  refused_in_cpfg("@Di(1e38) {(1) F(1e-38) }", "Module 2 of the string ({(1)): The polygon is thicker");
  refused_in_cpfg("@R(1e38,1e38,0) F", "Module 2 of the string (F): The turtle has no direction");
  // Errors of drawing a homomorphism name the drawn module.
  refused("A\nhomomorphism:\nA --> F(1e20)", "Module 1 of the string (F(1e20))", "larger");
  // Sizes up to the bounds are drawn, and zero sizes are skipped.
  const Recorder recorder = drawn("axiom: F(9e8) F(-9e8) S(1e-17) F(0) S(0) !(9e8) F(2)", 0);
  CHECK(recorder.lines.size() == 3);
  CHECK(recorder.spheres.size() == 1);
}

TEST_CASE("a hundred thousand open brackets are allowed, one more is an error") {
  std::string deep = "axiom: ";
  deep.append(100'001, '[').append(100'001, ']');
  const BoundPointer bound = compiled(deep);
  const Derived string = derived(*bound, 4096);
  CHECK(length(*string.string) == 200'002);
  Recorder recorder;
  CHECK_FALSE(lsystem::interpret(*bound, *string.string, {}, recorder, 1, Limits{}));
}
