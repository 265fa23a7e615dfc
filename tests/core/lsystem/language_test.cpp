// cpfg's features besides productions and contexts: notations, sections, parts, blocks, curves, turtle queries.
#include <algorithm>
#include <glm/geometric.hpp>

#include "foundation/english.hpp"
#include "lsystem/derivation/derivation.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

// Records the events that are no lines.
class Whole : public Recorder {
 public:
  struct Polygon {
    Turtle start;
    std::vector<glm::vec3> corners;
  };
  void polygon(const Turtle& start, std::span<const glm::vec3> corners, const Lineage& lineage) override {
    polygons.push_back({start, {corners.begin(), corners.end()}});
    modules.push_back(lineage.module);
  }
  void surface(const Turtle& turtle, std::string_view name, float size, const Lineage& lineage) override {
    surfaces += std::string(name) + "*" + std::to_string(static_cast<int>(size * 100)) + "@" +
                std::to_string(turtle.colour) + " ";
    modules.push_back(lineage.module);
  }
  void ball(const Turtle&, float radius, const Lineage&) override { balls.push_back(radius); }
  void disc(const Turtle& turtle, float radius, const Lineage&) override {
    discs.push_back(radius);
    facing.push_back(turtle.heading);
  }
  void note(std::string_view sentence) override { notes.emplace_back(sentence); }

  std::vector<Polygon> polygons;
  std::vector<std::uint32_t> modules;
  std::vector<float> balls, discs;
  std::vector<glm::vec3> facing;  // of discs
  std::string surfaces;
  std::vector<std::string> notes;
};

// Looking along −z: heading up, left to the left, up axis towards the viewer.
Turtle upright() {
  Turtle turtle;
  turtle.heading = {0, 1, 0};
  turtle.left = {-1, 0, 0};
  turtle.up = {0, 0, 1};
  return turtle;
}

Whole heard(const std::string& text, std::uint32_t steps = 0) {
  const BoundPointer bound = compiled(text);
  Whole whole;
  const Derived string = sound(lsystem::develop(*bound, 1, steps, Limits{}, {upright()}));
  const auto drawn = lsystem::interpret(*bound, *string.string, upright(), whole, 1, Limits{});
  if (!drawn) FAIL(english(drawn.error().message));
  return whole;
}

glm::vec3 end_of(const std::string& text, std::uint32_t steps = 0) {
  return heard(text, steps).lines.back().after.position;
}

void is_at(const glm::vec3& p, float x, float y, float z) {
  CAPTURE(p.x);
  CAPTURE(p.y);
  CAPTURE(p.z);
  CHECK(glm::length(p - glm::vec3(x, y, z)) < 1e-5f);
}

const std::string cpfg = "#turtle cpfg\naxiom: ";

// Inside of area 1 is where y < 3.5.
class Below : public expression::Space {
 public:
  bool bound(const glm::vec3& place, float area) const override { return area == 1 && place.y < 3.5f; }
  float reach(const glm::vec3& from, const glm::vec3& way, float area, float most) const override {
    return area == 1 && way.y > 0 ? std::min(most, (3.5f - from.y) / way.y) : 0;
  }
};

}  // namespace

TEST_CASE("the two notations turn the other way round") {
  is_at(end_of(cpfg + "+(90) F"), -1, 0, 0);
  is_at(end_of(cpfg + "-(90) F"), 1, 0, 0);
  is_at(end_of(cpfg + "&(90) F"), 0, 0, -1);
  is_at(end_of(cpfg + "^(90) F"), 0, 0, 1);
  is_at(end_of(cpfg + "/(90) +(90) F"), 0, 0, 1);  // the right side down: left goes to up
  is_at(end_of(cpfg + "\\(90) +(90) F"), 0, 0, -1);
  is_at(end_of(cpfg + ">(90) +(90) F"), 0, 0, 1);
  is_at(end_of(cpfg + "<(90) +(90) F"), 0, 0, -1);
  is_at(end_of(cpfg + "+(30) | F"), 0.5f, -0.8660254f, 0);
  is_at(end_of("#turtle huang\naxiom: +(90) F"), 1, 0, 0);
  is_at(end_of("#turtle huang\naxiom: &(90) F"), 0, 0, 1);
  is_at(end_of("#turtle huang\naxiom: /(90) +(90) F"), 0, 0, 1);  // left away from up, and + to the right
  is_at(end_of("axiom: +(90) F"), 1, 0, 0);
  const auto as_cpfg =
      lsystem::compile("axiom: +(90) F G T(1) g", Limits{}, lsystem::Lineages::where_needed, lsystem::Notation::cpfg);
  Whole whole;
  const BoundPointer bound = sound(lsystem::bind(sound(as_cpfg), {}, Limits{}));
  const Derived string = sound(lsystem::develop(*bound, 1, 0, Limits{}));
  CHECK(sound(lsystem::interpret(*bound, *string.string, upright(), whole, 1, Limits{})) == 2);
  is_at(whole.lines[0].after.position, -1, 0, 0);
}

TEST_CASE("letters of cpfg are the text's own symbols in the paper's notation") {
  CHECK(heard("axiom: F G(2) T(3) g(4) F").lines.size() == 2);
  CHECK(after("axiom: G(2)\nG(x) --> T(x)", 1) == "T(2)");
  CHECK(heard(cpfg + "F(1,7,8) G(2) F").lines.size() == 3);
  // A symbol that cpfg lacks is the text's own where the text rewrites it, and the turtle's where it does not.
  CHECK(heard(cpfg + "S(1) T(2) F S(3)").spheres.size() == 2);
  CHECK(heard(cpfg + "S(1) T(2) F S(3,4)\nS(x,y) --> T\nT --> S(1,2)").spheres.empty());
  CHECK(trouble("axiom: F(1,2)") == "syntax 1:8");
}

TEST_CASE("the text sets the defaults of arguments") {
  is_at(end_of("#turtle cpfg\nangle increment: 30\naxiom: + F"), -0.5f, 0.8660254f, 0);
  is_at(end_of("#turtle cpfg\nline length: 3\naxiom: F"), 0, 3, 0);
  is_at(end_of("#turtle cpfg\n#define d 2\nangle increment: 45*d\nline length: d\naxiom: + F(1) - F"), -1, 2, 0);
  const Whole widths = heard(
      "#turtle cpfg\nline width: 2\nline width increment: 0.5\naxiom: F ! F ! F # F !(7) F ! ! ! ! ! ! ! ! ! ! ! ! ! ! "
      "! F");
  const float wanted[] = {2, 1.5f, 1, 1.5f, 7, 0};
  for (std::size_t i = 0; i < 6; ++i) CHECK(widths.lines[i].after.width == wanted[i]);
  CHECK(heard("axiom: !(3) F ! F").lines[1].after.width == 1);
}

TEST_CASE("lines bend towards the tropism") {
  // The Algorithmic Beauty of Plants, section 2.3.3: by e·|H × T| radians after each line.
  const Whole bent = heard("#turtle cpfg\ntropism: 0, -1, 0, 0.3\naxiom: +(90) F F");
  is_at(bent.lines[0].after.position, -1, 0, 0);
  is_at(bent.lines[1].after.position, -1 - std::cos(0.3f), -std::sin(0.3f), 0);
  const Whole same = heard(cpfg + "@Ts(0,0.3) @Ts(1,9) +(90) F F @Ts(0,0) F F");
  is_at(same.lines[1].after.position, -1 - std::cos(0.3f), -std::sin(0.3f), 0);
  CHECK(same.lines[2].after.heading == same.lines[3].after.heading);
  is_at(end_of("#turtle cpfg\ntropism: 0, -1, 0, 0.3\naxiom: F F F"), 0, 3, 0);
}

TEST_CASE("the turtle can be levelled, moved, headed and made larger") {
  const Whole level = heard(cpfg + "+(40) /(77) $ F");
  CHECK(std::abs(level.lines[0].after.left.y) < 1e-6f);
  CHECK(level.lines[0].after.up.y > 0);
  is_at(heard(cpfg + "/(30) @v F").lines[0].after.left, -0.8660254f, 0, 0.5f);  // straight up: as it was
  is_at(end_of(cpfg + "F @M(1,2,3) F"), 1, 3, 3);
  is_at(end_of(cpfg + "@R(3,0,0) F"), 1, 0, 0);
  is_at(end_of(cpfg + "@R(0,0,0) F"), 0, 1, 0);
  const Turtle headed = heard(cpfg + "@R(1,0,0,0,1,1) F").lines[0].after;
  is_at(headed.up, 0, 0.70710678f, 0.70710678f);
  is_at(glm::cross(headed.heading, headed.left), headed.up.x, headed.up.y, headed.up.z);
  // @D sets the size, @Di and @Dd change it; widths stay.
  is_at(end_of(cpfg + "[@D(3) F F] @D(2) F @D(2) F @D(1) F"), 0, 5, 0);
  is_at(end_of(cpfg + "@D(2) F @Di(3) F @Dd(4) F @Dd(0) F"), 0, 2 + 6 + 1.5f + 1.5f, 0);
  CHECK(heard(cpfg + "!(2) @D(3) F !(1) F").lines[1].after.width == 1);
  CHECK(heard(cpfg + "!(2) @D(3) F !(1) F").lines[0].after.width == 2);
}

TEST_CASE("polygons have their corners, also across brackets") {
  const Whole square = heard(cpfg + "{ . F +(90) f +(90) G . +(90) g . }");
  REQUIRE(square.polygons.size() == 1);
  CHECK(square.polygons[0].corners.size() == 5);
  CHECK(square.lines.size() == 1);  // G's alone
  is_at(square.polygons[0].corners[2], -1, 1, 0);
  const Whole across =
      heard(cpfg + "[ { . F ] [ +(90) f(2) . } ] { }");  // The Algorithmic Beauty of Plants, figure 5.5
  REQUIRE(across.polygons.size() == 2);
  CHECK(across.polygons[0].corners.size() == 4);
  CHECK(across.polygons[1].corners.empty());
  const Whole nested = heard(cpfg + "{ . f { . f . f . } . }");
  REQUIRE(nested.polygons.size() == 2);
  CHECK(nested.polygons[0].corners.size() == 5);
  CHECK(nested.polygons[1].corners.size() == 3);
  CHECK(heard(cpfg + "} } F .").notes.size() == 2);
  CHECK(heard(cpfg + "{ . F").notes.size() == 1);
  CHECK(square.modules[0] == 11);
}

TEST_CASE("surfaces, balls, discs and colours") {
  CHECK(heard(cpfg + "~leaf(2) ' ~petal [ ;(7) ~leaf ] , ~bud(0) @D(3) ~bud").surfaces ==
        "leaf*200@1 petal*100@2 leaf*100@7 bud*300@1 ");
  CHECK(heard(cpfg + ", ~a ;(0) ~a ;(9999) ~a").surfaces == "a*100@1 a*100@1 a*100@255 ");
  const Whole round = heard(cpfg + "@O(3) @o(2) @c @O(0)");
  CHECK(round.balls == std::vector<float>{1.5f});
  CHECK(round.discs == std::vector<float>{1, 0.5f});
  // @o lies across the heading; @c in its plane, and that of the left axis.
  is_at(round.facing[0], 0, 1, 0);
  is_at(round.facing[1], 0, 0, 1);
  CHECK(after("axiom: ~leaf(2)\n~leaf(s) : s>1 --> ~leaf(s-1) A", 2) == "~leaf(1)A");
}

TEST_CASE("blocks work values out for condition, successor and weight") {
  CHECK(after("axiom: A(3)\nA(x) : {y = 2*x; z = y+1} z>6 {w = z-y} --> B(x,y,z,w)", 1) == "B(3,6,7,1)");
  CHECK(after("axiom: A(3)\nA(x) : {x = x+1; x = x*2;} --> B(x)", 1) == "B(8)");
  CHECK(after("axiom: A(3)\nA(x) : {y = x} y>5 --> B\nA(x) : * {y = x} --> C(y)", 1) == "C(3)");
  CHECK(after("#define y 5\naxiom: A(1) A(2)\nA(x) : {y = x} x=1 --> B(y)\nA(x) --> C(y)", 1) == "B(1)C(5)");
  CHECK(after("axiom: A(0)\nA(x) : {y = x} --> B : y\nA(x) --> C : 1", 1) == "C");
  // Worked out once for condition and successor.
  const std::string drawn = after("axiom: A(1)\nA(x) : {y = ran(1)} y>=0 --> B(y,y)", 1);
  const std::size_t comma = drawn.find(',');
  CHECK(drawn.substr(2, comma - 2) == drawn.substr(comma + 1, drawn.size() - comma - 2));
}

TEST_CASE("a #define's value may be a number in parentheses") {
  CHECK(after("#define f(2)*3\naxiom: A(f)", 0) == "A(6)");
  CHECK(after("#define f(2)\naxiom: A(f)", 0) == "A(2)");
  CHECK(after("#define x 5\n#define f(x)\naxiom: A(f)", 0) == "A(5)");
}

TEST_CASE("a #define with parameters is a function whose calls its body replaces") {
  CHECK(after("#define twice(x) x*2\naxiom: A(twice(1+1), twice(twice(3)))", 0) == "A(4,12)");
  CHECK(after("#define f(x,y) x-y*y\naxiom: B(7)\nB(n) : f(n,2)>2 --> C(f(n,n-5)) : f(3,1)", 1) == "C(3)");
  CHECK(after("#define between(x,a,b) x>=a && x<=b\naxiom: A(1) A(5)\nA(x) : !between(x,2,6) --> B", 1) == "B A(5)");
  CHECK(after("#define k 3\n#define f(x) k*x\n#define g(x) f(x)+f(1)\naxiom: A(g(2))", 0) == "A(9)");
  // Other names of the body are those of the place where it is called.
  CHECK(after("#define f(x) x+n\naxiom: A(2)\nA(n) --> B(f(1))", 1) == "B(3)");
  CHECK(trouble("#define f(x) x + min(x, c(1))\n#curve c (0, 0) (1, 1)\naxiom: A") == "undefined 1:25");
  CHECK(after("#curve c (0, 0) (1, 2)\n#define f(x) c(x)*x\n#input n[]\naxiom: A(f(n[1]))", 0, {{}, {{"n", {0.5f}}}}) ==
        "A(0.5)");
  CHECK(trouble("#define f(x) x*y\naxiom: A(f(1))") == "undefined 1:16");
  CHECK(trouble("#define f(x,x) x\naxiom: A") == "syntax 1:13");
  CHECK(trouble("#define f(x) x*2\naxiom: A(f(1,2))") == "syntax 2:10");
  CHECK(trouble("#define f(x) x*2\n#define f 3\naxiom: A") == "syntax 2:9");
  CHECK(trouble("#define sin(x) x*2\naxiom: A") == "syntax 1:9");
  CHECK(trouble("axiom: A(f(1))\n#define f(x) x*2") == "undefined 1:10");
}

TEST_CASE("functions that call each other end at a limit, within memory") {
  std::string text = "#define f0(x) x+x\n";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "f" + std::to_string(i - 1);
    text += "#define f" + std::to_string(i) + "(x) " + before + "(" + before + "(x))\n";
  }
  std::string message;
  CHECK(trouble(text + "axiom: A", {}, {}, &message).starts_with("limit "));
  CHECK(message.find("100,000 operations") != std::string::npos);
  // All calls of a text count together.
  text = "#define f(x) x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x\naxiom:";
  for (int i = 0; i < 2000; ++i) text += "\nA(f(2))";
  CHECK(trouble(text + "\n") == "none");
  for (int i = 0; i < 2000; ++i) text += "\nA(f(2))";
  CHECK(trouble(text + "\n").starts_with("limit "));
}

TEST_CASE("a backslash at the end of a line continues it, unless it can be a roll") {
  CHECK(after("#define k 1 + \\\n 2\naxiom: A(k)", 0) == "A(3)");
  CHECK(after("#define k 1 + \\ /* first */\n\\\n 2 + \\\n 3\naxiom: A(k)", 0) == "A(6)");
  CHECK(after("axiom: A(2)\nA(x) : x>1 && \\\n x<3 --> B\nB --> C", 2) == "C");
  CHECK(after("axiom: A(2)\nA(x) \\\n --> B", 1) == "B");
  CHECK(after("axiom: A(1 + \\\n 2) B", 0) == "A(3)B");
  CHECK(after("derivation length: \\\n 3\naxiom: A", 0) == "A");
  // In a string it is one in cpfg alone, and never before a statement.
  CHECK(after("axiom: A \\\n B", 0) == "A\\B");
  CHECK(after("#turtle cpfg\naxiom: A \\\n B", 0) == "A B");
  CHECK(after("#turtle cpfg\naxiom: A(2)\nA(x) --> F \\\n + \\\n F", 1) == "F+F");
  CHECK(after("#turtle cpfg\naxiom: A B\nA --> F \\\nB --> G", 1) == "F\\G");
  CHECK(after("#turtle cpfg\naxiom: A \\ B \\", 0) == "A\\B\\");
}

TEST_CASE("a text may define arrays and curves") {
  CHECK(after("#define n 3\n#define a[] 1, n*2, 5\naxiom: A(a[1]) A(a[2]) A(a[n])", 0) == "A(1)A(6)A(5)");
  CHECK(after("#define a[] {1, 2}\naxiom: A(a[2])", 0, {{}, {{"a", {7, 8}}}}) == "A(8)");
  CHECK(trouble("#define a[] 1, 2\naxiom: A(a[3])") == "evaluation 2:10");
  const std::string ends =
      after("#curve c (0, 0) (1, 2) (3, 2)\naxiom: A(c(-5)) A(c(0)) A(c(1)) A(c(2)) A(c(3)) A(c(99))", 0);
  CHECK(ends == "A(0)A(0)A(2)A(2)A(2)A(2)");
  // Monotone: it stays between its points.
  const BoundPointer bound =
      compiled("#curve c (0, 0) (1, 1) (2, 1.01) (3, 4)\naxiom: A(0)\nA(x) : x<3 --> B(c(x)) A(x+0.03125)");
  const std::string text = text_of(*bound, derived(*bound, 200));
  float last = -1;
  for (std::size_t at = text.find("B("); at != std::string::npos; at = text.find("B(", at + 1)) {
    const float value = std::stof(text.substr(at + 2));
    CHECK(value >= last);
    last = value;
  }
  CHECK(last <= 4);
  CHECK(after("#curve c (0, 1) (1, 3)\n#define k c(0.5)\naxiom: A(k)", 0) == "A(2)");
}

TEST_CASE("a decomposition applies within the step, up to its maximum depth") {
  const std::string text = "axiom: A\nA --> B B\ndecomposition\nmaximum depth: 3\nB --> C C\nC --> D\n";
  CHECK(after(text, 0) == "A");
  CHECK(after(text, 1) == "D D D D");
  CHECK(after("axiom: B\ndecomposition\nB --> C B", 0) == "C B");
  CHECK(after("axiom: B\ndecomposition\nmaximum depth: 4\nB --> C B", 0) == "C C C C B");
  CHECK(after("axiom: A(3)\nA(x) : x>0 --> B(x)\ndecomposition\nB(x) : x>1 --> F(x) [ + A(x-1) ]\nderivation\nF(x) --> "
              "G(x)",
              2) == "G(3)[+F(2)[+A(1)]]");
  CHECK(text_of(*compiled("axiom: A\nA --> B\ndecomposition\nB --> C"),
                sound(lsystem::develop(*compiled("axiom: A\nA --> B\ndecomposition\nB --> C"), 1, {}, Limits{}))) ==
        "C");
}

TEST_CASE("a homomorphism changes a module's drawing, not the string") {
  const std::string text = cpfg + "A(2) [ +(90) A(1) ]\nhomomorphism\nA(x) --> F(x) F(x)";
  CHECK(after(text, 3) == "A(2)[+(90)A(1)]");
  const Whole whole = heard(text);
  REQUIRE(whole.lines.size() == 4);
  is_at(whole.lines[1].after.position, 0, 4, 0);
  is_at(whole.lines[3].after.position, -2, 4, 0);
  CHECK(heard(cpfg + "F(2)\nhomomorphism\nF(x) --> F(x/2) F(x/2)").lines.size() == 2);
  CHECK(heard(cpfg + "F(2)\nhomomorphism\nmaximum depth: 5\nF(x) --> F(x/2) F(x/2)").lines.size() == 32);
  CHECK(heard(cpfg + "F(2) [ A F ] F\nhomomorphism\nA --> F % F").lines.size() == 3);
  CHECK(heard(cpfg + "A B\nhomomorphism\nA --> { . f .\nB --> + f . }").polygons.size() == 1);
}

TEST_CASE("parts of a text have productions of their own") {
  const std::string text =
      "#turtle cpfg\nLsystem: 1\nderivation length: 2\naxiom: A [ ?leaf(0.5) A F(2) ] F(2)\nA --> A B\n"
      "endlsystem\nLsystem: leaf\nA --> F(1) A\nF(x) --> F(2*x)\nendlsystem";
  CHECK(after(text, 2) == "A B B[?leaf(0.5)F(2)F(1)A F(8)]F(2)");
  const Whole whole = heard(text, 2);
  REQUIRE(whole.lines.size() == 4);
  is_at(whole.lines[2].after.position, 0, 5.5f, 0);
  is_at(whole.lines[3].after.position, 0, 2, 0);
  // A string reads back: each module is its own L-system's again.
  CHECK(after("#turtle cpfg\naxiom: [ ?leaf(0.5) F(2) F(1) ] F\nLsystem: leaf\nF(x) --> F(2*x)", 1) ==
        "[?leaf(0.5)F(4)F(2)]F");
}

TEST_CASE("turtle queries are filled in after each step, for contexts to match") {
  const auto located = [](const std::string& text, std::uint32_t steps) {
    const BoundPointer bound = compiled(text);
    return text_of(*bound, sound(lsystem::develop(*bound, 1, steps, Limits{}, {upright()})));
  };
  CHECK(located(cpfg + "F(2) ?P(9,9,9,7) ?H(0,0,0) ?L(0,0,0) ?U(0,0,0)", 0) ==
        "F(2)?P(0,2,0,7)?H(0,1,0)?L(-1,0,0)?U(0,0,1)");
  CHECK(located(cpfg + "[ +(90) F(3) ?P(0,0) ] [ F ] F [ F [ F ] F ?P(1,1,1) ]", 0) ==
        "[+(90)F(3)?P(-3,0)][F]F[F[F]F?P(0,3,0)]");
  CHECK(located(cpfg + "A\nA --> F A", 3) == "F F F A");
  // Grows until it is three above the ground (Prusinkiewicz, James and Měch 1994, pruning).
  const std::string pruned =
      "#turtle cpfg\naxiom: A ?P(0,0,0)\nA > ?P(x,y,z) : y<3 --> F A\nA > ?P(x,y,z) : y>=3 --> B";
  CHECK(located(pruned, 20) == "F F F B?P(0,3,0)");
  const BoundPointer bound = compiled(pruned);
  CHECK(text_of(*bound, sound(lsystem::develop(*bound, 1, {}, Limits{}, {upright()}))) == "F F F B?P(0,3,0)");
  CHECK(located("#turtle cpfg\naxiom: ?P(0,0,0) A ?P(0,0,0)\nA --> F(4)\n?P(x,y,z) : y>1 --> *", 2) == "?P(0,0,0)F(4)");
  // A production whose lines move the turtle is not skipped.
  CHECK(located(cpfg + "A ?P(0,0,0)\nhomomorphism\nA --> F(5)", 0) == "A?P(0,5,0)");
  // Nor is one with only some lines in branches, or one that changes the lines after it.
  CHECK(located(cpfg + "A ?P(0,0,0)\nhomomorphism\nA --> [ +(90) F(2) ~leaf(1) ] '", 0) == "A?P(0,0,0)");
  CHECK(located(cpfg + "A ?P(0,0,0)\nhomomorphism\nA --> [ F(2) ] F(3) [ F ]", 0) == "A?P(0,3,0)");
  CHECK(located(cpfg + "A F ?P(0,0,0)\nhomomorphism\nA --> [ F(2) ] @D(3)", 0) == "A F?P(0,3,0)");
  CHECK(located(cpfg + "A ?P(0,0,0)\nhomomorphism\nmaximum depth: 2\nA --> [ F(2) ] B\nB --> F(4)", 0) == "A?P(0,4,0)");
  // An open polygon, in which lines do not bend.
  const std::string bends = "#turtle cpfg\ntropism: 1, 0, 0, 1\naxiom: A F(1) F(1) ?P(0,0,0)\nhomomorphism\n";
  CHECK(located(bends + "A --> [ F ]", 0) != "A F(1)F(1)?P(0,2,0)");
  CHECK(located(bends + "A --> [ { ]", 0) == "A F(1)F(1)?P(0,2,0)");
}

TEST_CASE("bound and reach query the space") {
  const Below below;
  const auto in_space = [&](const std::string& text) {
    const BoundPointer bound = compiled(text);
    return text_of(*bound, sound(lsystem::develop(*bound, 1, {}, Limits{}, {upright(), &below})));
  };
  CHECK(in_space("axiom: A(0)\nA(y) : bound(0,y,0,1) --> F A(y+1)") == "F F F F A(4)");
  CHECK(in_space("axiom: A(0)\nA(y) : bound(0,y,0,2) --> F A(y+1)") == "A(0)");
  CHECK(in_space("axiom: A(reach(0,1,0, 0,1,0, 1, 9), reach(0,1,0, 0,1,0, 1, 2))") == "A(2.5,2)");
  CHECK(in_space("axiom: A(1)\nA(y) : y>0 --> B(reach(0,y,0, 0,1,0, 1, bound(0,y,0,1)*9))") == "B(2.5)");
  CHECK(after("axiom: A(0)\nA(y) : bound(0,y,0,1) --> B", 1) == "A(0)");
  CHECK(trouble("#define x bound(0,0,0,1)\naxiom: A(x)") == "syntax 1:11");
}

TEST_CASE("explosive growth returns the string before the limit") {
  Limits limits;
  limits.words = 10'000;
  const BoundPointer bound = compiled("axiom: A\nA --> A A");
  CHECK_FALSE(lsystem::develop(*bound, 1, 100, limits));
  const Derived derived = sound(lsystem::develop_so_far(*bound, 1, 100, limits));
  CHECK(derived.stopped.reason == Reason::limit);
  CHECK(derived.steps >= 10);
  CHECK(lsystem::length(*derived.string) == std::uint64_t{1} << derived.steps);
  const Derived endless = sound(lsystem::develop_so_far(*bound, 1, {}, limits));
  CHECK(lsystem::length(*endless.string) == std::uint64_t{1} << endless.steps);
  CHECK(sound(lsystem::develop_so_far(*bound, 1, 3, limits)).stopped.reason == Reason::none);
  CHECK_FALSE(lsystem::develop_so_far(*compiled("axiom: A(1)\nA(x) --> F(1/(x-1)) A(x)"), 1, 5, Limits{}));
}

TEST_CASE("a string's text can be read as an axiom") {
  for (const char* string : {"F(1)- - >(2)F@O(0.5)~leaf(2)A.{.F.}A1(1,2)?P(1,2,3)'(3);,#(2)$@v%",
                             "[+(-0.5)F F(1e-20)]&^/\\\\|!(3)<(1)", "- - >A"}) {
    const std::string once = after(std::string(cpfg) + string, 0);
    CHECK(after(cpfg + once, 0) == once);
  }
  CHECK(after(cpfg + "- - > A", 0) == "-- >A");
}

namespace {

// Every 2 units of time a bud becomes a line and two buds: 2^n - 1 lines after n divisions.
std::string divisions(const std::string& numbers, const std::string& dt) {
  return numbers + "#define dt " + dt +
         "\nderivation length: 800\naxiom: A(0)\nA(t) --> A(t+dt)\ndecomposition\n"
         "A(t) : t>=2 --> F(1) [ +(30) A(t-2) ] [ -(30) A(t-2) ]\n";
}

std::size_t lines_in(const std::string& text, const Inputs& inputs = {}) {
  const BoundPointer bound = compiled(text, inputs);
  const std::string string = text_of(*bound, sound(lsystem::develop(*bound, 1, {}, Limits{})));
  return static_cast<std::size_t>(std::count(string.begin(), string.end(), 'F'));
}

}  // namespace

TEST_CASE("in double precision 100 times 0.02 is 2") {
  CHECK(lines_in(divisions("#numbers double\n", "0.02")) == 255);
  CHECK(lines_in(divisions("#numbers double\n", "1/50")) == 255);
  // In single precision, which texts of published links have, the sum stays below 2.
  CHECK(lines_in(divisions("", "0.02")) == 127);
  CHECK(lines_in(divisions("#numbers single\n", "0.02")) == 127);
  // A value that comes with the request is the decimal that was meant.
  CHECK(lines_in(divisions("#numbers double\n", "7"), {{{"dt", 0.02f}}, {}}) == 255);
}

TEST_CASE("contexts, responses, blocks and draws are in double precision") {
  const std::string numbers = "#numbers double\n";
  // 2^-30 is lost beside 1 in single precision.
  CHECK(after(numbers + "axiom: A(1+2^-30)\nA(x) : x>1 --> B(x-1)\nA(x) --> C\nB(x) : x=2^-30 --> F", 2) == "F");
  CHECK(after("axiom: A(1+2^-30)\nA(x) : x>1 --> B(x-1)\nA(x) --> C", 2) == "C");
  CHECK(after(numbers + "axiom: L(1+2^-30) A(5) R(1-2^-30)\nL(l) < A(x) > R(r) : l>1 && r<1 --> B(x)", 1) ==
        "L(1)B(5)R(1)");
  CHECK(after(numbers + "axiom: L(1+2^-30) M A(5)\nL(l) M < A(x) : l>1 --> B(x)", 1) == "L(1)M B(5)");
  CHECK(after(numbers + "axiom: A(1) A(1)\nA(x) : {y = x+2^-30} y>1 {z = y-1} --> B(z*2^30) : y-1", 1) == "B(1)B(1)");
  CHECK(after(numbers + "#define k 1+2^-30\n#define m k*1\naxiom: A(m)\nA(x) : x>1 --> F(m-1)\n", 1) ==
        "F(9.313226e-10)");
  CHECK(after(numbers + "axiom: A(2.5)\nA(x) --> B(floor(x),nearest(x),min(x,2),pow(x,2),sqrt(x*x),x%2,2^0.5)", 1) ==
        "B(2,3,2,6.25,2.5,0.5,1.4142135)");
  // Draws are those of single precision.
  const std::string draws = "axiom: A(1)\nA(x) --> B(ran(x)) [ A(RND(1,9)) ] C(nran(0,1))";
  CHECK(after(numbers + draws, 3) == after(draws, 3));
  CHECK(after(numbers + "axiom: A(1)\nA(x) : x<4 --> A(x+1) : 1\nA(x) : x<4 --> A(x+2) : 1", 3) ==
        after("axiom: A(1)\nA(x) : x<4 --> A(x+1) : 1\nA(x) : x<4 --> A(x+2) : 1", 3));
}

TEST_CASE("parameters that the turtle reads and writes are in both precisions") {
  const Recorder exact =
      drawn("#numbers double\n#turtle cpfg\naxiom: F(0.1) A(0)\nA(x) : x<3 --> +(30) F(0.1+x) A(x+1)", 4);
  const Recorder single = drawn("#turtle cpfg\naxiom: F(0.1) A(0)\nA(x) : x<3 --> +(30) F(0.1+x) A(x+1)", 4);
  REQUIRE(exact.lines.size() == 4);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(glm::distance(exact.lines[i].after.position, single.lines[i].after.position) < 1e-5f);
  const std::string located = "axiom: F(2) A\nA --> ?P(0,0,0) B\nB --> *\n?P(x,y,z) : x*x+y*y+z*z>1 --> G(x,y,z)";
  CHECK(after("#numbers double\n" + located, 3) == after(located, 3));
  CHECK(after(located, 3).find("G(") != std::string::npos);
  CHECK(trouble("#numbers half\naxiom: A") == "syntax 1:10");
  CHECK(trouble("#numbers double\n#numbers double\naxiom: A") == "syntax 2:10");
  CHECK(trouble("#numbers double 2\naxiom: A") == "syntax 1:17");
}
