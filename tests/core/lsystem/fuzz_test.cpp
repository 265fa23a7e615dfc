// Texts of random tokens, and good texts with changed tokens: each ends in a value or a diagnostic. Meant for the
// sanitizers; the seeds are fixed, so a failure can be repeated.
#include "lsystem/fuzz.hpp"

using namespace panicle;
using namespace panicle::tests;

namespace {

const std::vector<std::string> pool = {"A",
                                       "B",
                                       "C",
                                       "F",
                                       "f",
                                       "S",
                                       "?E",
                                       "E",
                                       "n",
                                       "m",
                                       "x",
                                       "i",
                                       "l_1",
                                       "α",
                                       "+",
                                       "-",
                                       "*",
                                       "/",
                                       "^",
                                       "%",
                                       "&",
                                       "&&",
                                       "|",
                                       "||",
                                       "\\",
                                       "!",
                                       "!=",
                                       "=",
                                       "==",
                                       "<",
                                       "<=",
                                       ">",
                                       "(",
                                       "(",
                                       "(",
                                       ")",
                                       ")",
                                       ")",
                                       "[",
                                       "[",
                                       "]",
                                       "]",
                                       ",",
                                       ",",
                                       ":",
                                       ":",
                                       "#",
                                       "#define",
                                       "#input",
                                       "\n",
                                       "\n",
                                       "\n",
                                       "axiom:",
                                       "\naxiom: A(1) ",
                                       "-->",
                                       "\nA(x) --> ",
                                       "\nB(x,i) : ",
                                       "\n?E(x) --> ",
                                       "\nA(x) < B(i) > ",
                                       "\nB > [A] C --> ",
                                       "\nignore: + F",
                                       "\nconsider: A",
                                       " --> F(x) ",
                                       "0",
                                       "1",
                                       "2.5",
                                       "1e30",
                                       "1e-9",
                                       "RND(1,3)",
                                       "ran(x)",
                                       "nran(0,1)",
                                       "sin",
                                       "pow",
                                       "min(",
                                       "clamp(x,1,2)",
                                       "n[1]",
                                       "n[x]",
                                       "/*",
                                       "*/",
                                       "/* c */",
                                       "?",
                                       ".",
                                       "$",
                                       "→",
                                       "\xff",
                                       " ",
                                       "\t",
                                       "\r\n",
                                       "endlsystem",
                                       "derivation length:",
                                       "#role ",
                                       "\n#role r A B\n",
                                       "p1:",
                                       "{",
                                       "T(1)",
                                       "\nderivation length: 3\n",
                                       "ran(1)<0.5",
                                       "\n#turtle cpfg\n",
                                       "\n#turtle huang\n",
                                       "\nhomomorphism\n",
                                       "\ndecomposition\nmaximum depth: 3\n",
                                       "\nderivation\n",
                                       "\nLsystem: leaf\n",
                                       "\nendlsystem\n",
                                       "[?leaf(2) A(1)]",
                                       "[?leaf B]",
                                       "\n#curve f (0,0) (0.5,2) (1,1)\n",
                                       "f(x)",
                                       "\n#define a[] 1, 2, 3\n",
                                       "a[x]",
                                       "\nangle increment: 30\n",
                                       "\nline width: 0.1\n",
                                       "\ntropism: 0, -1, 0, 0.2\n",
                                       "{y = x*2; z = y+1}",
                                       " : {y = x} y>1 {z = y/2} --> ",
                                       "?P(0,0,0)",
                                       "?H(x)",
                                       "\nA(x) > ?P(i,n,m) --> ",
                                       "bound(x,1,2,1)",
                                       "reach(x,0,0,0,1,0,1,2)",
                                       "{ . F . + F . }",
                                       "G(1)",
                                       "g",
                                       "~leaf(2)",
                                       "~x",
                                       "'",
                                       ";(3)",
                                       "@O(1)",
                                       "@v",
                                       "@M(0,1,2)",
                                       "@D(2)",
                                       "@Ts(0,0.3)",
                                       "@Di(2)",
                                       "\nIterations: 3\n",
                                       "<(30)",
                                       "\n?E(x) : x>0 --> A(x) ?E(x) "};

const std::vector<std::string> good = {
    "#input m\n#input n[]\n#define k 2\naxiom: A(m, 1) ?E(0, 1)\nA(i,x) : i>1 --> F(x) [ // A(i-1, x/k) ] [ +(45) "
    "B(n[i-1], x) "
    "] : 2\n"
    "A(i,x) : i>1 && x>0 --> ?E(0, x) A(i-1, ran(x)) : 1\nA(i,x) : i=1 --> S(RND(1,3))\nB(i,x) : i>0 --> f(x) % B(i-1, "
    "x)\n"
    "?E(t,x) : t=0 --> +(x) F(x) [ & F % F ]\n?E(t,x) --> %\n",
    "axiom: F-F-F-F\nF --> F-F+F+F F-F-F+F\n",
    "derivation length: m+2\naxiom: A(m) [ ?E(1) B(m,1) ] ?E(0)\n#input m\n?E(x) : x>0 && ran(1)<0.4 --> F(x) [ % A(x) "
    "?E(x) ] B(x,2)\n"
    "?E(x) : x=0 --> ?E(1) %\nA(x) : ran(1)<0.3 --> F [ +(n[x]) A(x) ] : x\nA(x) --> B(x,x) : 1\nB(x,i) : ran(i)<1 --> "
    "?E(x)\n#input n[]\n",
    "ignore: + -\naxiom: A(1) B [ + A(2) C ] B A(3) ?E(0)\nA(x) < B > [C] B --> A(x) [ - B ]\nB < A(y) > ?E(x) : x<y "
    "--> C %\nC > A --> B : 2\nA(i) < C --> A(i) C : ran(i)\n",
    "consider: A B\naxiom: A B C [ A B ] A\nA < B > A --> A F\nA > [ A B ] A --> B\n* < B > * --> B C\n",
    "#turtle cpfg\nangle increment: 30\ntropism: 0,-1,0,0.1\n#curve c (0,0) (1,2)\n#define a[] 1, 2\naxiom: A(1) { . "
    "A(2) . } ?P(0,0,0)\nA(x) > ?P(i,n,m) "
    ": {y = x*2} y<8 && !bound(i,n,m,1) --> F(c(x)) [?leaf(0.5) B] A(y) ~leaf(a[1])\nA(x) --> + A(x+1) : "
    "x\nhomomorphism\nA(x) --> { . G(x) . + f . } @O(x) ; "
    "F\nLsystem: leaf\naxiom: B\nB --> [ & B ] ! F $\ndecomposition\nmaximum depth: 3\nB --> F B\nendlsystem\n",
    "axiom: A\nA --> A [ + A ] !(2) F(min(3,sqrt(2))) | ^ & \\ B\nB --> *\n"};

std::string made_up(Dice& dice) {
  std::string text = dice.below(2) ? "axiom: A(1) B(2,3) " : "";
  for (std::size_t tokens = dice.below(60); tokens-- > 0;) {
    text += pool[dice.below(pool.size())];
    if (dice.below(3) > 0) text += ' ';
  }
  return text;
}

std::string damaged(Dice& dice) {
  std::string text = good[dice.below(good.size())];
  for (std::size_t changes = 1 + dice.below(4); changes-- > 0;) {
    const std::size_t at = dice.below(text.size());
    switch (dice.below(3)) {
      case 0:
        text.erase(at, 1 + dice.below(4));
        break;
      case 1:
        text.insert(at, pool[dice.below(pool.size())]);
        break;
      default:
        text.replace(at, 1, pool[dice.below(pool.size())]);
        break;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("random texts end in a value or a diagnostic") {
  int outcomes[2][4] = {};
  for (std::uint64_t i = 0; i < fuzz_runs(6000); ++i) {
    Dice dice(7, i);
    const bool whole = i % 2 == 0;
    const std::string text = whole ? made_up(dice) : damaged(dice);
    CAPTURE(text);
    ++outcomes[whole][tried(text, static_cast<std::uint32_t>(i / 2))];
  }
  for (const int* kind : {outcomes[0], outcomes[1]}) {
    CHECK(kind[0] > 20);
    CHECK(kind[1] > 100);
  }
  CHECK(outcomes[0][2] > 10);
  CHECK(outcomes[0][3] > 3);
}
