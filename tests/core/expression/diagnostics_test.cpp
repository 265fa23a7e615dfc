// Errors of texts: each has its line and column, and advice.
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

struct Case {
  std::string text;
  std::string trouble;
};
const Case cases[] = {
    {"", "syntax 1:1"},
    {"A --> B", "syntax 1:1"},
    {"axiom:", "syntax 1:7"},
    {"axiom: A\naxiom: B", "syntax 2:1"},
    {"axiom: A : 1", "syntax 1:10"},
    {"hello\naxiom: A", "syntax 1:1"},
    {"#define x 1\n+2\naxiom: A", "syntax 2:1"},
    {"#include x\naxiom: A", "syntax 1:2"},
    {"#\naxiom: A", "syntax 1:2"},
    {"#define\naxiom: A", "syntax 1:8"},
    {"#define x\naxiom: A", "syntax 1:10"},
    {"#define x 1 2\naxiom: A", "syntax 1:13"},
    {"#define x 1\n#define x 2\naxiom: A", "syntax 2:9"},
    {"#input x y\naxiom: A", "syntax 1:10"},
    {"#input n[3]\naxiom: A", "syntax 1:10"},
    {"#define x ran(1)\naxiom: A", "syntax 1:11"},
    {"axiom: A\n --> B", "syntax 2:2"},
    {"axiom: A\nA --> B --> C", "syntax 2:9"},
    {"axiom: A\nA B --> C", "syntax 2:3"},
    {"axiom: A\nA < B < C --> C", "syntax 2:7"},
    {"axiom: A\nA(1) --> C", "syntax 2:3"},
    {"axiom: A\nA(x --> C", "syntax 2:2"},
    {"axiom: A\nA(x,x) --> C", "syntax 2:5"},
    {"axiom: A\nA(x y) --> C", "syntax 2:5"},
    {"axiom: A\nA(x) : x>  --> C", "syntax 2:10"},
    {"axiom: A\nA(x) : x) --> C", "syntax 2:9"},
    {"axiom: A\nA(x) : 1<x<3 --> C", "syntax 2:11"},
    {"axiom: A\n[ --> C", "syntax 2:1"},
    {"axiom: A\n% --> C", "syntax 2:1"},
    {"axiom: A ]", "syntax 1:10"},
    {"axiom: A [ [ B ]", "syntax 1:10"},
    {"axiom: A(", "syntax 1:10"},
    {"axiom: A(1", "syntax 1:9"},
    {"axiom: A(1,)", "syntax 1:12"},
    {"axiom: A(1 2)", "syntax 1:12"},
    {"axiom: A((1)", "syntax 1:9"},
    {"axiom: A(1)) B", "syntax 1:12"},
    {"axiom: A(min(1))", "syntax 1:10"},
    {"axiom: A(min(1,2,3))", "syntax 1:10"},
    {"axiom: A((1,2))", "syntax 1:12"},
    {"axiom: A(n[1)", "syntax 1:13"},
    {"axiom: A(1]", "syntax 1:11"},
    {"axiom: F(1,2)", "syntax 1:8"},
    {"axiom: A\nF(x,y) --> F", "syntax 2:1"},
    {"axiom: A [(1) ]", "syntax 1:10"},
    {"axiom: ?F(1)", "syntax 1:8"},
    {"axiom: ? E(1)", "syntax 1:8"},
    {"axiom: A * B", "syntax 1:10"},
    {"axiom: A\nA --> * B", "syntax 2:9"},
    {"axiom: A\nA --> B : 1 2", "syntax 2:13"},
    {"axiom: A\nA --> B :", "syntax 2:10"},
    {"axiom: A\nA --> B\nderivation: 5", "syntax 3:1"},
    {"derivation length: 2\naxiom: A\nderivation length: 3", "syntax 3:1"},
    {"derivation length:\naxiom: A", "syntax 1:19"},
    {"derivation length: 2 3\naxiom: A", "syntax 1:22"},
    {"derivation length: ran(3)\naxiom: A", "syntax 1:20"},
    {"axiom: FF+F\nF --> FF", "syntax 1:8"},
    {"axiom: A\nA --> AB\nB --> A", "syntax 2:7"},
    {"axiom: A\n?E(x) --> F A", "syntax 2:13"},
    {"axiom: A\n?E(x) --> ?E(1)", "syntax 2:11"},
    {"#roll A\naxiom: A", "syntax 1:2"},
    {"δ α\naxiom: θ → B", "syntax 2:10"},
};

}  // namespace

TEST_CASE("syntax errors have line and column") {
  for (const Case& c : cases) {
    std::string message;
    const std::string found = trouble(c.text, {}, {}, &message);
    CAPTURE(c.text);
    CAPTURE(message);
    CHECK(found == c.trouble);
    CHECK(message.size() > 10);
    CHECK(message.back() == '.');
    CHECK(message.find('\n') == std::string::npos);
  }
}

namespace {

void expect_error(std::string_view text, const std::string& where, const std::string& part) {
  std::string message;
  CAPTURE(text);
  CHECK(trouble(text, {}, {}, &message) == where);
  CAPTURE(message);
  CHECK(message.find(part) != std::string::npos);
  CHECK(message.back() == '.');
}

}  // namespace

TEST_CASE("errors of cpfg statements explain their meaning and replacement") {
  expect_error("axiom: A\nLsystem: 2\nA --> B", "syntax 2:1", "needs a name, as in “Lsystem: leaf”");
  expect_error("axiom: A\nA --> ?leaf(2) B", "syntax 2:7", "There is no query “?leaf”");
  expect_error("axiom: A\nA --> ?leaf(2) B\nLsystem: leaf\nB --> C", "syntax 2:7", "write “[” before the part");
  expect_error("axiom: A\nderivation: 5", "syntax 2:1", "derivation length: 10");
  expect_error("axiom: A\n#consider A", "syntax 2:2", "“consider: A B”");
  expect_error("axiom: A\nA --> B\nhomomorphism\nA < B --> F", "syntax 4:5", "cannot have a context");
  expect_error("axiom: A\nA --> B\nmaximum depth: 5", "syntax 3:1", "move this line below “decomposition:”");
  expect_error("axiom: A\nhomomorphism\nmaximum depth: 0", "evaluation 3:16", "a whole number from 1 to 256");
  expect_error("axiom: A\nangle increment: 1/0", "evaluation 2:18", "must be a finite number");
  expect_error("axiom: A\ntropism: 0, -1, 0", "syntax 2:18", "x, y, z and the elasticity");
  expect_error("axiom: A\n#turtle logo", "syntax 2:9", "found “logo”");
  expect_error("axiom: A\n#turtle cpfg\n#turtle cpfg", "syntax 3:9", "a second “#turtle”");
  expect_error("axiom: A\n#curve c (0, 0)", "syntax 2:8", "at least two points");
  expect_error("axiom: A\n#curve c (0, 0) (0, 1)", "syntax 2:17", "from left to right");
  expect_error("axiom: A\n#curve sin (0, 0) (1, 1)", "syntax 2:8", "already a function “sin”");
  expect_error("axiom: A(1)\nA(x) : {y = 2; 3} --> F(y)", "syntax 2:16", "Expected an assignment in this block");
  expect_error("axiom: A(1)\nA(x) : {y = 2 --> F(y)", "syntax 2:8", "“{” is never closed");
  expect_error("axiom: A(1)\nA(x) : {y = 2} y>1 {z = y} --> F(z) : z", "undefined 2:39", "“z” is not defined");
  expect_error("axiom: A\nseed: 5", "syntax 2:1", "set outside the grammar");
  expect_error("ω: A\nA --> B", "syntax 1:1", "Write the axiom as “axiom: …”");
  expect_error("axiom: A\nA --> B\nω: A", "syntax 3:1", "Write the axiom as “axiom: …”");
  CHECK(after("axiom: ω seed\nω --> F ignore", 1) == "F ignore seed");
}

TEST_CASE("errors of labels, printed arrows and comments explain how they are read") {
  expect_error("axiom: A\np1: A --> B", "syntax 2:1", "“p1:” labels a production");
  expect_error("axiom: A(1)\np1: A(i) : i>0 --> B", "syntax 2:1", "labels a production");
  expect_error("axiom: A\np1 : A < B --> C", "syntax 2:1", "labels a production");
  expect_error("axiom: A\np1 : [ --> C", "syntax 2:1", "labels a production");
  CHECK(trouble("#define k 1\naxiom: B\nA : k>0 --> B") == "none");
  CHECK(trouble("axiom: B\nA : k>0 --> B\n#define k 1") == "none");
  CHECK(trouble("axiom: B\nA : sin(30)>0 --> B sin") == "none");
  expect_error("axiom: A\nA : k --> B", "undefined 2:5", "“k” is not defined");
  expect_error("axiom: A B\nA : B --> C", "undefined 2:5", "“B” is not defined");
  expect_error("axiom: A\nA -.33-> B", "syntax 2:4", "“A --> B : .33”");
  expect_error("axiom: A\nA -> B", "syntax 2:3", "Write an arrow as “-->”.");
  expect_error("// a tree\naxiom: A", "syntax 1:1", "Write a comment as “/*");
  expect_error("axiom: A\n// the tree's stem", "syntax 2:12", "Write a comment as “/*");
  expect_error("axiom: A\n// end of it.", "syntax 2:13", "Write a comment as “/*");
}

TEST_CASE("errors of cpfg signs explain their meaning") {
  expect_error("axiom: F @X(2)", "syntax 1:10", "There is no command “@X”. Available commands: @O");
  expect_error("axiom: F @ O", "syntax 1:10", "as one word, such as “@O(1)”");
  expect_error("axiom: ~", "syntax 1:8", "such as “~leaf”");
  expect_error("axiom: ?Q(1)", "syntax 1:8", "There is no query “?Q”");
  expect_error("axiom: F * F", "syntax 1:10", "an empty successor");
  expect_error("axiom: F 1", "syntax 1:10", "symbols start with a letter");
  expect_error("axiom: _(2) F", "syntax 1:8", "write “!(width)”");
  expect_error("axiom: F `", "syntax 1:10", "cannot be used in a grammar");
}

TEST_CASE("errors in expressions suggest a replacement") {
  expect_error("axiom: A(1 2)", "syntax 1:12",
               "An operator or a comma is missing before “2”; write an operator such as “*”");
  expect_error("axiom: A(2(3))", "syntax 1:11", "An operator is missing between two values");
  expect_error("axiom: A(1)\nA(x) --> B(x>1 ? 2 : 3)", "syntax 2:16", "“?:” is not supported");
  expect_error("axiom: A(1)\nA(x) : x>1 & x<2 --> B", "syntax 2:12", "Write “and” between conditions as “&&”");
  expect_error("axiom: A(1)\nA(x) : x>1 | x<2 --> B", "syntax 2:12", "Write “or” between conditions as “||”");
  expect_error("axiom: A(1 : 2", "syntax 1:12", "put “)” in front of it");
  expect_error("#define n[3] 1\naxiom: A", "syntax 1:11", "with empty brackets");
}

TEST_CASE("undefined names are errors") {
  std::string message;
  CHECK(trouble("axiom: A(x)", {}, {}, &message) == "undefined 1:10");
  CHECK(message ==
        "“x” is not defined here; add a “#define” for it above this line, or make it a parameter of the predecessor.");
  CHECK(trouble("axiom: A(1)\nA(i) : j>1 --> B") == "undefined 2:8");
  CHECK(trouble("axiom: A(1)\nA(i) --> B(i)\nB(j) --> A(i)") == "undefined 3:12");
  CHECK(trouble("#define a b\n#define b 1\naxiom: A(1)") == "undefined 1:11");
  CHECK(trouble("axiom: A(sine(1))") == "undefined 1:10");
  CHECK(trouble("axiom: A(n[1])") == "undefined 1:10");
  CHECK(trouble("#input n[]\naxiom: A(n)", {{}, {{"n", {1}}}}) == "undefined 2:10");
  CHECK(trouble("axiom: A(1)\nA(x) --> B : w") == "undefined 2:14");
}

TEST_CASE("inputs without a value are named") {
  std::string message;
  CHECK(trouble("#input m\naxiom: A(m)", {}, {}, &message) == "bad_input 1:8");
  CHECK(message == "The input “m” has no value; set a value for this input in the request.");
  CHECK(trouble("#input n[]\naxiom: A", {}, {}, &message) == "bad_input 1:8");
  CHECK(message == "The input “n[]” has no values; set values for this input in the request.");
  CHECK(trouble("#input m\naxiom: A(m)", {{{"m", 0 / 0.0f}}, {}}) == "bad_input 1:8");
  CHECK(trouble("#input n[]\naxiom: A", {{}, {{"n", {1, 1 / 0.0f}}}}) == "bad_input 1:8");
  CHECK(trouble("#define x 1\naxiom: A", {{{"x", 1 / 0.0f}}, {}}) == "bad_input 1:9");
}

TEST_CASE("numbers that are not finite are errors before the turtle uses them") {
  std::string message;
  CHECK(trouble("axiom: A(1)\nA(x) --> B F(x/0)", {}, {}, &message) == "evaluation 2:14");
  CHECK(message == "The argument of “F” must be a finite number, but it is ∞.");
  CHECK(trouble("axiom: F(0/0)", {}, {}, &message) == "evaluation 1:10");
  CHECK(message == "The argument of “F” must be a finite number, but it is NaN.");
  CHECK(trouble("axiom: A(1)\nA(x) --> S(-x)", {}, {}, &message) == "evaluation 2:12");
  CHECK(message == "The argument of “S” must be 0 or greater, but it is -1.");
  CHECK(trouble("axiom: A(0)\nA(x) --> B(1/x)\nB(x) --> [+(x)F]") == "evaluation 3:13");
  CHECK(trouble("axiom: A(0)\nA(x) --> B(1/x)") == "none");
  CHECK(trouble("#define x 1/0\naxiom: A") == "evaluation 1:11");
  CHECK(trouble("axiom: A\nA --> B : 0-1") == "evaluation 2:11");
  CHECK(trouble("axiom: A(1)\nA(x) --> B(RND(0.2, 0.8))", {}, {}, &message) == "evaluation 2:12");
  CHECK(message == "There is no whole number between 0.2 and 0.8 for RND; use a wider range.");
  CHECK(trouble("axiom: A(1)\nA(x) --> B(RND(0, 1e30))") == "evaluation 2:12");
  CHECK(trouble("axiom: A(1)\nA(x) --> B(RND(0, x/0))") == "evaluation 2:12");
}
