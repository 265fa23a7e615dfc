// Common mistakes in growth grammars: each has a diagnostic at its place, with advice.
#include "mistakes.hpp"

#include "foundation/english.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

using panicle::tests::Mistake;

const std::string tree = "tree -> DivFunc(\"sigma1\"){branches}\n";

const Mistake mistakes[] = {
    {"«", "empty"},
    {"«footprnt -> GrowVol(1,1,1,1,1,1)", "footprint"},
    {"«axiom: A", "A line must start with"},
    {"«steps = 8", "cannot be set"},
    {"«F(1)", "A line must start with"},
    {"«-> ndv = 1", "condition is missing"},
    {"gs = «x", "write a number"},
    {"gs = 8\n«gs = 9", "once"},
    {"«gs.rand(1)", "gs.rand(7, 8)"},
    {tree + "gs = «1.5", "whole number"},
    {tree + "gs = «-1", "“gs” must be from 0 to"},
    // Footprints.
    {"footprint «: 1 -> GrowVol()", "cannot have a condition"},
    {"footprint -> «Vol(1)", "GrowVol(cnt, id, wb, h, wt, grad)"},
    {"footprint -> «GrowVol(1, 2, 3)", "(cnt, id, wb, h, wt, grad)"},
    {"footprint -> «GrowVol(1, 2", "never closed"},
    {"footprint -> GrowVol(«width(3))", "no such function"},
    {"footprint -> GrowVol(«width.rand(3))", "cnt, id, wb, h, wt, grad, wm, size, towards and at"},
    {"footprint -> GrowVol(«h.random(3))", "h.rand"},
    {"footprint -> GrowVol(«h(3, 4))", "one number"},
    {"footprint -> GrowVol(«size.rand(3))", "four numbers"},
    {"footprint -> GrowVol(«at(3))", "at(x, z)"},
    {"footprint -> GrowVol(h(3) «h(4))", "Expected “,”"},
    {"footprint -> GrowVol(h(3),«)", "write a value"},
    {"footprint -> GrowVol(h(3), «4)", "must come first"},
    {"footprint -> GrowVol(h(«k))", "write a number"},
    {"footprint -> GrowVol(h(«D(3)))", "write a number"},
    {"footprint -> GrowVol(h(3)) «: 0.5", "cannot have a probability"},
    {tree + "footprint -> GrowVol(h(«0))", "“h” must be from 0.1"},
    {tree + "footprint -> GrowVol(grad(«90))", "“grad” must be from -80 to 80"},
    {tree + "footprint -> «GrowVol(cnt(1.5))", "whole number"},
    // Trees.
    {"tree -> «sigma1", "DivFunc(\"sigma1\"){branches}"},
    {"tree -> DivFunc(«sigma1){branches}", "in quotes"},
    {"tree -> DivFunc(«\"sigma1){branches}", "never closed"},
    {"tree -> DivFunc(«“sigma1”){branches}", "write \" instead"},
    {"tree -> DivFunc(«\"tau\"){branches}", "\"star1\""},
    {"tree -> DivFunc(«\"sigma\"){branches}", "write a power"},
    {"tree -> DivFunc(«\"sigma1\", 1){branches}", "includes the power"},
    {"tree -> DivFunc(«\"sigma1b\", 1){branches}", "remainder"},
    {"tree -> DivFunc(«\"exp\", 3){branch}", "x^y"},
    {"tree -> DivFunc(\"sigma1\")«", "{branches} or {leaves}"},
    {"tree -> DivFunc(\"sigma1\"){«flowers}", "{branches} or {leaves}"},
    {"tree -> DivFunc(\"sigma1b\", «2, 2){branches}", "the remainder must be from 0 to 1"},
    {"tree -> DivFunc(\"sigma1b\", 0, «0){branches}", "the divisor must be from 1"},
    {"tree -> DivFunc(\"sigma\", «-1){branches}", "the power must be from 0"},
    {tree + "tree -> «DivFunc(\"hat1\"){branches}", "already"},
    {"tree -> DivFunc(\"sigma1\"){branches} «DivFunc(\"hat1\"){branches}", "already"},
    {"«gravitropism = 1", "divisor function D is not defined"},
    {"k == 1 -> nbr = «E(1)\nbud(1) -> branch", "divisor function D is not defined"},
    // Buds.
    {tree + "bud «-> branch", "bud(k - 1)"},
    {tree + "bud(«gs) -> branch", "“gs” is not available here; use one of k."},
    {tree + "«bud(ran(3)) -> branch", "only on k"},
    {tree + "bud(1) -> «leaf", "bud(k - 1) -> branch"},
    {tree + "bud(1) «k < 3 -> branch", "after a colon"},
    {tree + "bud(1) -> branch : «2", "a probability must be from 0 to 1"},
    {tree + "bud(1) -> branch :«", "probability is missing"},
    // Conditions and consequences.
    {tree + "«trunk : k > 1 -> nbr = 1", "A line must start with"},
    {tree + "k > 1 «: k < 3 -> nbr = 1", "colon"},
    {tree + "«age > 1 -> nbr = 1", "one of k, N, gs"},
    {tree + "k > 1«) -> nbr = 1", "Expected “->”"},
    {tree + "bud(k)«) -> branch", "colon"},
    {tree + "k > 1 -> «k = 1", "cannot be set"},
    {tree + "k > 1 -> «grow", "is not an effect"},
    {tree + "k > 1 -> «3", "is not an effect"},
    {tree + "k > 1 -> «foliage(1, 2, 3)", "takes one number"},
    {tree + "k > 1 -> leaf«", "number is missing"},
    {tree + "k > 1 -> «leaf(1, 2)", "one number"},
    {tree + "k > 1 -> nbr = 1,«", "Expected the effect of the rule"},
    {tree + "«k > 1 -> phototropism = 0.3", "single branches"},
    {tree + "GrowVol.h > 1 -> gravitropism = «20", "must be from -10 to 10"},
    {tree + "GrowVol.h > 1 -> gravitropism = 1 : «1.5", "a probability must be from 0 to 1"},
    {tree + "k > 1 -> length = «-1", "“length” must be from 0"},
    {tree + "«GrowVol.size > 1 -> gravitropism = 1", "GrowVol.h"},
    {tree + "ndv «≡ 0 -> childTrunk", "write “==”"},
    {tree + "k =«> 1 -> nbr = 1", ">="},
    {tree + "nbr = «D(0.5)", "whole numbers from 0"},
    {tree + "nbr = «D(1000)", "whole numbers from 0"},
    {tree + "nbr = «D[1]", "parentheses"},
    {tree + "nbr = «sigma(1)", "no such function"},
    {tree + "nbr = «bound(1, 2, 3, 4)", "delete it"},
    {tree + "nbr = «1/0", "finite number"},
    {tree + "nbr =«", "value is missing"},
    {tree + "nbr = «(1 + 2", "never closed"},
    {tree + "nbr = 1 «2", "operator"},
};

}  // namespace

TEST_CASE("mistakes in a growth grammar have diagnostics at their place, with advice") {
  panicle::tests::check_mistakes(mistakes, [](const std::string& text) { return trouble(text); });
}

TEST_CASE("notes list definitions without effect") {
  const auto notes_of = [](std::string_view text) {
    std::string all;
    for (const std::string& note : rules_of(text).notes) all += english(note);
    return all;
  };
  const std::string footprint = "footprint -> GrowVol(1, 1, 4, 10, 2, 0)\n";
  CHECK(notes_of(tree).find("no footprint") != std::string::npos);
  CHECK(notes_of(footprint + tree) == "");
  CHECK(notes_of(footprint + tree + "k == 1 -> nbr = 2\nnlf = 0\nbud(1) -> branch").find("no rule uses D") !=
        std::string::npos);
  CHECK(notes_of(footprint + tree + "nlf = 0\ntree -> DivFunc(\"hat1\"){leaves}").find("no rule uses E") !=
        std::string::npos);
  CHECK(notes_of(footprint + tree + "nbr = D(k)\ntree -> DivFunc(\"exp\", 2, 1){branch}").find("no rule uses B") !=
        std::string::npos);
  CHECK(notes_of(footprint + tree + "nlf = E(k)\ntree -> DivFunc(\"exp\", 2, 1){leaf}").find("no rule uses L") !=
        std::string::npos);
}

TEST_CASE("a growth grammar may use the notation of the paper") {
  const Population plain = grown("tree -> DivFunc(\"sigma1\"){branches}\nndv < 0 -> length = 2", 8);
  for (const char* text : {"tree → DivFunc(\"sigma1\"){branches}\nndv<0→length=2",
                           "tree --> DivFunc (\"sigma\", 1) {\n  branches\n}\nndv < 0\n  -> length = 2",
                           "/* a comment */ tree ->\n  DivFunc(\"sigma1\") { branch }\nndv < 0 ->\n  length = 2 : 1",
                           "tree -> DivFunc(\"sigma1\"){branches}\r\nndv < 0 && (k > 0 ||\n k < 0) -> length = 1,\r\n "
                           "length = length * 2"}) {
    CAPTURE(text);
    const Population same = grown(text, 8);
    CHECK(same.branches == plain.branches);
    REQUIRE(same.deformations.size() == plain.deformations.size());
    CHECK(same.deformations[0].length == 2);
  }
}
