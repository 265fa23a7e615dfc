// Expressions by their values: each is the parameter of an axiom.
#include <cmath>
#include <cstring>

#include "foundation/mathematics.hpp"
#include "lsystem/grammars.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

// Value of an expression; in a production, so that nothing is worked out beforehand.
std::string value(const std::string& expression) {
  return after("#define two 2\naxiom: A(1,3)\nA(x,y) --> V(" + expression + ")", 1);
}

// And once more where constants are folded.
std::string folded(const std::string& expression) {
  return after("#define two 2\n#define x 1\n#define y 3\naxiom: V(" + expression + ")", 0);
}

void same(const std::string& expression, const std::string& expected) {
  CAPTURE(expression);
  CHECK(value(expression) == "V(" + expected + ")");
  CHECK(folded(expression) == "V(" + expected + ")");
}

}  // namespace

TEST_CASE("operators bind as in C, powers tightest and from the right") {
  same("x+y*two", "7");
  same("(x+y)*two", "8");
  same("y-x-x", "1");
  same("12/y/two", "2");
  same("-two^two", "-4");
  same("two^y^two", "512");
  same("two^-x", "0.5");
  same("-x*-y", "3");
  same("y- -x", "4");
  same("17%5*two", "4");
  same("7.5 % two", "1.5");
  same("+y", "3");
  same("--y", "3");
  same("((((y))))", "3");
}

TEST_CASE("comparisons and logic give 1 or 0") {
  same("x<y", "1");
  same("x>=y", "0");
  same("x=1", "1");
  same("x==1", "1");
  same("x!=1", "0");
  same("x<=1", "1");
  same("!x", "0");
  same("!!y", "1");
  same("x<y == y>x", "1");
  same("1+x < y", "1");
  same("x && y", "1");
  same("x && 0", "0");
  same("0 || y", "1");
  same("0 || 0", "0");
  same("x>5 || y>2 && two=2", "1");
  same("(x>5 || y>2) && two=3", "0");
  same("x=1 && y=3 && two=2", "1");
}

TEST_CASE("the second operand of && and || is skipped where the first decides") {
  Inputs inputs;
  inputs.arrays = {{"n", {4}}};
  const auto with = [&](const std::string& condition) {
    return after("#input n[]\naxiom: A(0)\nA(i) : " + condition + " --> B", 1, inputs);
  };
  CHECK(with("i>0 && n[i]>0") == "A(0)");
  CHECK(with("i=0 || n[i]>0") == "B");
  CHECK(with("i=0 && (i<0 || n[i+1]=4)") == "B");
  CHECK(with("!(i>0 && n[i]>0) && n[1]=4") == "B");
}

TEST_CASE("each function of expressions has its value") {
  same("floor(-2.5)", "-3");
  same("ceil(2.1)", "3");
  same("nearest(2.5)", "3");
  same("nearest(-2.5)", "-2");
  same("nearest(0.49999997)", "0");
  same("abs(-y)", "3");
  same("min(x, y)", "1");
  same("max(x, y)", "3");
  same("clamp(5, x, y)", "3");
  same("clamp(-5, x, y)", "1");
  same("clamp(2, x, y)", "2");
  same("sqrt(16)", "4");
  same("pow(two, 10)", "1024");
  same("exp(0)", "1");
  same("log(1)", "0");
  same("sin(30)", "0.5");
  same("cos(180)", "-1");
  same("sin(180)", "0");
  same("tan(45)", "1");
  same("asin(1)", "90");
  same("acos(-1)", "180");
  same("atan(1)", "45");
  same("atan2(1, -1)", "135");
  same("max(min(y, two), floor(x))", "2");
}

TEST_CASE("transcendental functions are the foundation's, bit for bit") {
  const auto text = [](float v) { return after("#input v\naxiom: V(v)", 0, {{{"v", v}}, {}}); };
  CHECK(value("sin(y*7.3)") == text(sincos_degrees(3 * 7.3f).sine));
  CHECK(value("exp(y/7)") == text(exponential(3 / 7.0f)));
  CHECK(value("log(y/7)") == text(logarithm(3 / 7.0f)));
  CHECK(value("(y/7)^0.3") == text(power(3 / 7.0f, 0.3f)));
}

TEST_CASE("arithmetic is single precision") {
  same("16777216+x", "16777216");
  same("0.1+0.2 = 0.3", std::string(0.1f + 0.2f == 0.3f ? "1" : "0"));
  same("x/y", "0.33333334");
  CHECK(after("#define l_w 10\naxiom: A(10)\nA(l) : l=l_w --> B", 1) == "B");
  CHECK(after("#define l_w 0.7\naxiom: A(7/10)\nA(l) : l=l_w --> B", 1) == (7 / 10.0f == 0.7f ? "B" : "A(0.7)"));
}

TEST_CASE("a #define may use earlier ones, and an input replaces its value for all later ones") {
  const char* text = "#define a 2\n#define b a*3\n#define c b+a\naxiom: V(a,b,c)";
  CHECK(after(text, 0) == "V(2,6,8)");
  CHECK(after(text, 0, {{{"a", 5}}, {}}) == "V(5,15,20)");
  CHECK(after(text, 0, {{{"b", 1}, {"unknown", 7}}, {}}) == "V(2,1,3)");
}

TEST_CASE("a parameter hides a #define of the same name in its production alone") {
  CHECK(after("#define l 60\naxiom: A(1)\nA(l) --> V(l) B(2)\nB(j) --> V(l)", 2) == "V(1)V(60)");
}

TEST_CASE("equal subexpressions are computed once, unless the first may be skipped") {
  CHECK(after("axiom: A(3)\nA(x) --> V(x*x+1, x*x+2, (x>5 && x*x*x>0) + x*x*x)", 1) == "V(10,11,27)");
  CHECK(after("axiom: A(3)\nA(x) --> V((x>1 || x*x*x>0) + x*x*x, x*x*x)", 1) == "V(28,27)");
}

TEST_CASE("arrays are read from 1, and an index beyond their ends is an error with its place") {
  Inputs inputs;
  inputs.arrays = {{"n", {10, 20, 30}}};
  CHECK(after("#input n[]\n#define k n[2]\naxiom: V(n[1],k,n[k/10+1])", 0, inputs) == "V(10,20,30)");
  std::string message;
  const char* text = "#input n[]\naxiom: A(1)\nA(i) --> B(2,\n  n[i-1])";
  CHECK(trouble(text, inputs, {}, &message) == "evaluation 4:3");
  CHECK(message == "“n[0]” does not exist; the index must be a whole number from 1 to 3.");
  CHECK(trouble("#input n[]\naxiom: V(n[4])", inputs, {}, &message) == "evaluation 2:10");
  CHECK(message == "“n[4]” does not exist; the index must be a whole number from 1 to 3.");
  CHECK(trouble("#input n[]\naxiom: V(n[1.5])", inputs, {}, &message) == "evaluation 2:10");
  CHECK(trouble("#input n[]\naxiom: V(n[1/0])", inputs) == "evaluation 2:10");
  CHECK(trouble("#input n[]\naxiom: V(n[0/0])", inputs) == "evaluation 2:10");
  CHECK(trouble("#input n[]\naxiom: V(n[1])", {{}, {{"n", {}}}}, {}, &message) == "evaluation 2:10");
  CHECK(message == "“n[1]” does not exist, because the array has no values.");
}
