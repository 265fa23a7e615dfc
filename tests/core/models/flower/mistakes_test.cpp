// Common mistakes in flower grammars: each has a diagnostic at its place, with advice.
#include "mistakes.hpp"

#include "flowers.hpp"
#include "foundation/english.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

using panicle::tests::Mistake;

const std::string good = "#define A(4,0,0,0,1,1,1,1)\n#define B(4,0,0,0,1,1,1,1)\n#axiom: A\n";
const std::string module = "\n#module M\n#define k=1\n#define C(4,0,0,0,k,1,1,1)\n#axiom: C";

const Mistake mistakes[] = {
    {"«", "empty"},
    {"«@ volumes\n#define A(4)", "end it with “@”"},
    {"«@ all @", "empty"},
    {"«A -> A[A]_{E}", "add “#define A(N, atx"},
    {"«#define A(4)", "#axiom"},
    {"#«volume A", "#define NAME"},
    {"#define «(4)", "Expected a name"},
    {"#define A «4", "after its name"},
    {"#define A«(4", "never closed"},
    {"#define A(«ten)", "“ten”"},
    {"#define A«(1,2,3,4,5,6,7,8,9,10,11)", "here are 11"},
    {"#define A(4,0,0,0,0,«2,1,1,1,1)", "ten numbers"},
    {"#define A(4)\n#define «A(5)", "already"},
    {"#define a=1\n#define «a=2", "already"},
    {"#define a=«", "value is missing"},
    {"#define a=1 +« ", "value is missing"},
    {"#define a=«b\n#define b=1", "no value above this line"},
    {"#define a=«step", "differs from volume"},
    {"#define «step=1", "reserved name"},
    {"#define finalStep=2\n#define «finalStep=3", "already"},
    {"#define a=«math.random", "math.random(from, to)"},
    {"#define a=«math.random(1", "math.random(from, to)"},
    {"#define a=«math.random(1)", "math.random(from, to)"},
    {"#define a=«math.random(1,2,3)", "math.random(from, to)"},
    {"#define a=«math.random(1,math.random(2,3))", "without another random number"},
    {"#axiom «A", "colon"},
    {"#axiom: «A", "add “#define A"},
    {"#axiom:« ", "name of a volume"},
    {good + "#«axiom: A", "already"},
    {good + "#module« ", "needs a name"},
    {good + "#module M\n#axiom: A\n#module «M", "already"},
    {good + "#module «M\n", "module “M”"},
    // Productions.
    {good + "«4 -> A", "at the start of a production"},
    {good + "p1 «C -> A", "add “#define C"},
    {good + "A A«", "Expected an arrow"},
    {good + "A ->« ", "name of a volume"},
    {good + "A -> A«", "no effect"},
    {good + "A -> A[«", "name of a volume"},
    {good + "A -> A«[B", "never closed"},
    {good + "A -> A[«C]_{E}", "add “#define C"},
    {good + "A -> A[&«M]_{E}", "#module M"},
    {good + "A -> A[&M{«l=3}]_{E}" + module, "no variable “l”"},
    {good + "A -> A[&M{k=3; «k=4}]_{E}" + module, "already"},
    {good + "A -> A[&M{«k}]_{E}" + module, "Set the variables"},
    {good + "A -> A[&M{k=«1/0}]_{E}" + module, "finite"},
    {good + "A -> A[B«{k=3}]_{E}", "Expected “]”"},
    {good + "A -> A[«B_{E}", "“]” is missing before “_{”; write “B]_{E}”."},
    {good + "A -> A[«B_C1", "“]” is missing before “_C1”"},
    {good + "A -> A[&«M_{E}" + module, "“]” is missing"},
    {good + "A -> A[B(,«math.foo(1))]_{E}", "functions: math.random, RND, ran"},
    {good + "A -> A[B(,«sine(1))]_{E}", "atan, atan2."},
    {good + "A -> A[B]«", "is not a face; write O, E"},
    {good + "A -> A[B]_{«D}", "is not a face; write O, E"},
    {good + "A -> A[B]_{«C0}", "is not a face; write O, E"},
    {good + "A -> A[B]_{«C9999}", "is not a face; write O, E"},
    {good + "A -> A[B]_«{E", "Expected “}”"},
    {good + "A -> A[B]_{C(«)}", "value is missing"},
    {good + "A -> A[B]_{«C(1}", "never closed"},
    {good + "A -> A[B]_{E} «C", "not allowed here"},
    {good + "A -> A[B(4) «D]_{E}", "Expected “]”"},
    {good + "A -> A[B(,«k,,)]_{E}", "“k” is not defined"},
    {good + "A -> A[B(,2 «3,,)]_{E}", "operator"},
    {good + "A -> A[B(,«x[1],,)]_{E}", "no lists of numbers"},
    {good + "A -> A[B(,«bound(1,2,3,4),,)]_{E}", "not available"},
    {good + "A -> A«(4)[B]_{E}", "keeps its numbers"},
    {good + "A{}«-> A[B]_{E}", "three blocks"},
    {good + "A{}{step<3}«-> A[B]_{E}", "three blocks"},
    {good + "A«{step", "never closed"},
    {good + "A{«step<3}{}{} -> A[B]_{E}", "assigns values"},
    {good + "A{«step=3;}{}{} -> A[B]_{E}", "reserved name"},
    {good + "A{w=«;}{}{} -> A[B]_{E}", "value is missing"},
    {good + "A{}{step =«> 3}{} -> A[B]_{E}", ">="},
    {good + "A{}{«w}{} -> A[B]_{E}", "is not defined"},
    // Glue and split.
    {good + "A : «B_C1 < B_C2 -> B_C1 | B_C2", "before the colon"},
    {good + "A : «A < A_C2 -> A_C1 | A_C2", "PETAL_C3"},
    {good + "A : A_C1 «-> A_C2", "Expected “<”"},
    {good + "A : A_C1 < «D_C2 -> A_C1 | D_C2", "add “#define D"},
    {good + "A : A_C1 < «A_D2 -> A_C1 | A_D2", "PETAL_C3"},
    {good + "A : A_C1 < A_C3« ", "Expected an arrow"},
    {good + "A : A_C1 < A_C3 -> «A_C2 | A_C3", "the same two faces"},
    {good + "A : A_C1 < A_C3 -> A_C1 «A_C3", "Expected “|”"},
    {good + "«A{}{step>2}{} : A_C1 < A_C3 -> A_C1 | A_C3", "delete the blocks"},
    {good + "#material «256 petal \"ffffff\"", "0 to 255"},
    {good + "#material «2.5 petal \"ffffff\"", "0 to 255"},
    {good + "#material 2 «paper \"ffffff\"", "not a kind of material"},
    {good + "#material 2 petal «white", "six hexadecimal"},
    {good + "#material 2 petal «\"fffffg\"", "six hexadecimal"},
    {good + "#material 2 petal \"ffffff\" «sheen 0.5", "foot, margin, veins"},
    {good + "#material 2 petal \"ffffff\" foot «1.5", "from 0 to 1"},
    {good + "#material 2 petal \"ffffff\" veins \"000000\" «61 1", "from 0 to 60"},
    {good + "#material 2 petal \"ffffff\" margin «0.2", "six hexadecimal"},
    {good + "#material 2 petal \"ffffff\" light 1 «light 1", "already"},
    {good + "#material 2 petal \"ffffff\" name «petal", "in quotes"},
    {good + "#material 2 petal \"ffffff\" name «\"\"", "in quotes"},
    {good + "#material 2 petal \"ffffff\" name «\"a/b\"", "letters, digits"},
    {good + "#material 2 petal \"ffffff\" name «\"a name of forty-one letters, which is too many\"", "at most 40"},
    {good + "#material 2 petal \"ffffff\"\n#material «2 leaf \"ffffff\"", "already"},
    {good + "A -«C(2)-> A B", "named face"},
    {good + "A -E «A B", "arrow"},
    {good + "A -E-> A« ", "name of a volume"},
    // While it grows.
    {good + "A -> A[B]_{«C5}", "4 sides and has no face C5"},
    {good + "A -> A[B]_{«C(0.5)}", "whole number"},
    {good + "A -> A[B]_{«C(-1)}", "whole number"},
    {good + "A -> A[B(«2)]_{E}", "3 to 4,096"},
    {good + "A -> A[B(«4.5)]_{E}", "3 to 4,096"},
    {good + "A -> A[B(,«1e7)]_{E}", "between"},
    {good + "A{}{step>1}{} -> A[B(,«1/(step-2))]_{E}", "∞ in step 2, as after a division by 0"},
    {good + "#define finalStep=«1.5", "whole number"},
    {good + "#define finalStep=«-1", "whole number"},
    {good + "#define finalStep=«5000", "limit"},
    {good + "#define a=«1/0", "finite"},
};

}  // namespace

TEST_CASE("mistakes in a flower's grammar have diagnostics at their place, with advice") {
  panicle::tests::check_mistakes(mistakes, [](const std::string& text) {
    const Diagnostic diagnostic = trouble(text);
    CHECK(english(diagnostic.message).find('%') == std::string::npos);
    return diagnostic;
  });
}

TEST_CASE("a flower's grammar may use the thesis's notation, or a simpler one") {
  const Flower plain = grown(good + "A -> A[A]_{E}\nA -> A[B]_{C1,C3}", steps(4));
  for (const char* rules :
       {"p00 A->A[A(,,,,,,)]_ {E}\np00 A->A[B(,,,,,,)]_{C1,C3}", "(p1) A → A[A]E\n(p2) A --> A[B]C1,C3",
        "@rules@ A{ }{ }{ }->A\n  [A]_ {E}\n  [B]_{C1, C3}", "/* mail@place */ A -> A[A]_{E}[B]C(1),C(1+2)"}) {
    CAPTURE(rules);
    const Flower same = grown(good + rules, steps(4));
    CHECK(same.derived.map.volumes() == plain.derived.map.volumes());
    CHECK(same.derived.values == plain.derived.values);
  }
  CHECK(grown("#define A(4)\r\n#axiome: A\r\nA -> A[A]_{E}\r\n", steps(2)).derived.map.volumes() == 3);
}
