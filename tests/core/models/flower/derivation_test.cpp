// Derivations of flowers: by the rules that the thesis states for productions, and by its own printed grammars.
#include <cmath>
#include <set>

#include "flowers.hpp"
#include "foundation/english.hpp"
#include "generalized_map/cells.hpp"
#include "generalized_map/embedding.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;
namespace gm = panicle::generalized_map;

namespace {

const std::string volume =
    "#define A(4,0,0,0,1,1,1,1)\n#define B(4,0,0,0,2,1,1,2)\n#define C(4,0,0,0,3,1,1,3)\n#axiom: A\n";

}  // namespace

TEST_CASE("a chain grows by one volume a step") {
  const Flower flower = grown(volume + "A -> A[A]_{E}", steps(7));
  CHECK(flower.derived.map.volumes() == 8);
  CHECK(flower.derived.map.darts() == 8 * 48);
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
  for (std::uint32_t v = 1; v < 8; ++v) {
    CHECK(flower.derived.map.volume(v).parent == v - 1);
    CHECK(flower.derived.map.volume(v).parent_face == gm::end_face);
    CHECK_FALSE(flower.derived.map.volume(v).attached);
  }
  CHECK(flower.derived.notes.empty());
}

TEST_CASE("a face may follow blanks or begin a line of its own") {
  for (const char* const blank : {"", " ", "\t", " \n", "\r\n  "})
    CHECK(grown(volume + "A -> A[B]" + blank + "_{C1}", steps(1)).count("B") == 1);
}

TEST_CASE("all matching productions apply, and the last listed wins on a face") {
  const Flower flower = grown(volume + "A -> A[B]_{C1}\nA -> A[B]_{E}\nA -> A[C]_{E}\nA -> A[C]_{C1,C3}", steps(1));
  CHECK(flower.count("B") == 0);
  CHECK(flower.count("C") == 3);
  // Only where conditions hold: the last of those productions.
  const Flower other = grown(volume + "A{}{step>=0}{} -> A[B]_{E}\nA{}{step>0}{} -> A[C]_{E}", steps(3));
  CHECK(other.count("B") == 1);
  CHECK(other.count("C") == 0);
}

TEST_CASE("a taken face is skipped, and other matching productions still apply") {
  const Flower flower = grown(volume + "A -> A[B]_{E}\nA{}{step==3}{} -> A[C]_{E,C2}", steps(6));
  CHECK(flower.count("B") == 1);
  CHECK(flower.count("C") == 1);
  CHECK(flower.derived.map.volume(2).parent_face == gm::side(2));
}

TEST_CASE("omitted numbers are the predecessor's where it has the same name, else the definition's") {
  const Flower flower = grown(volume + "A -> A[A(,5,,,,3*L,,)]_{E}\nA -> A[B(,,,,,W+7,,)]_{C1}", steps(2));
  // A grows A, which is thrice as long and turned by 5.
  REQUIRE(flower.name(1) == "A");
  CHECK(flower.value(1, Field::length) == 3);
  CHECK(flower.value(1, Field::turn_x) == 5);
  CHECK(flower.value(1, Field::height) == 1);
  CHECK(flower.value(1, Field::material) == 1);
  // B has its own height and material.
  REQUIRE(flower.name(2) == "B");
  CHECK(flower.value(2, Field::length) == 8);
  CHECK(flower.value(2, Field::height) == 2);
  CHECK(flower.value(2, Field::material) == 2);
  CHECK(flower.value(3, Field::length) == 9);
}

TEST_CASE("lists of numbers are read by their length") {
  const auto values = [](const std::string& list) {
    const Flower flower = grown(
        "#define A(8,1,2,3,4,5,6,7)\n#define T(8,.5,1,2,3,4,5,6,7)\n#axiom: A\nA -> A[" + list + "]_{E}", steps(1));
    return flower.derived.values[1];
  };
  CHECK(values("A(8,0,0,0,9,9,9,9)") == VolumeValues{8, 1, 0, 0, 0, 9, 9, 9, 9});
  CHECK(values("A(8,.25,0,0,0,9,9,9,9)") == VolumeValues{8, .25f, 0, 0, 0, 9, 9, 9, 9});
  CHECK(values("A(,,,,9)") == VolumeValues{8, 1, 1, 2, 3, 9, 5, 6, 7});
  CHECK(values("A(,,,,,4.1,5,1.5,)") == VolumeValues{8, 1, 1, 2, 3, 4.1f, 5, 1.5f, 7});
  CHECK(values("T(,,9)") == VolumeValues{8, .5f, 9, 2, 3, 4, 5, 6, 7});
  CHECK(values("T(,,,,4.1,5,1.5,)") == VolumeValues{8, .5f, 1, 2, 3, 4.1f, 5, 1.5f, 7});
  CHECK(values("A(,,,,,,)") == VolumeValues{8, 1, 1, 2, 3, 4, 5, 6, 7});
  CHECK(values("A()") == VolumeValues{8, 1, 1, 2, 3, 4, 5, 6, 7});
  CHECK(values("A(4)")[0] == 4);
  // Ten numbers are one angle too many (Table 3's petal).
  const Flower ten = grown("#define P(4,1,0,0,0,0,5,0.5,1,4)\n#axiom: P", steps(1));
  CHECK(ten.derived.values[0] == VolumeValues{4, 1, 0, 0, 0, 5, .5f, 1, 4});
  CHECK(ten.noted("ten numbers"));
}

TEST_CASE("a volume without numbers has as many sides as the face that it grows on") {
  const Flower flower =
      grown("#define A\n#define B(7,0,0,0,1,1,1,1)\n#axiom: B\nB -> B[A]_{E}\n#define D\nA -> A[D]_{C1}", steps(2));
  CHECK(flower.derived.map.volume(1).order == 7);
  CHECK(flower.derived.map.volume(2).order == 4);
  CHECK(flower.noted("without numbers"));
}

TEST_CASE("a face's number may be an expression") {
  const Flower flower = grown(
      "#define A(21,0,0,0,1,1,1,1)\n#define F(4,0,0,0,face,1,1,2)\n#axiom: A\n"
      "A -> A[A]_{E}\nA -> A[F]_{C(1 + 8*step%21)}",
      steps(5));
  std::vector<std::uint32_t> sides;
  for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v) {
    if (flower.name(v) != "F") continue;
    sides.push_back(gm::side_number(flower.derived.map.volume(v).parent_face));
    CHECK(flower.value(v, Field::height) == static_cast<float>(sides.back()));
  }
  CHECK(std::set<std::uint32_t>(sides.begin(), sides.end()) == std::set<std::uint32_t>{1, 9, 17, 4, 12});
}

TEST_CASE("`along` and `beside` count volumes along an organ's axis and beside it") {
  const std::string text =
      "#define A(4,0,0,0,1,1,1,1)\n#define F(4,0,0,0,along,beside,1,2)\n#define R(4,0,0,0,1,1,1,1)\n#axiom: A\n"
      "A{}{along<3}{} -> A[A]_{E}\nA -> A[R]_{C2}\nR{}{beside<2+along}{} -> R[R]_{E}\nR -> R[F]_{C1}\n"
      "R{}{beside==2}{} -> R[&M]_{C3}\n#module M\n#define G(4,0,0,0,along,beside,1,2)\n#axiom: G\nG -> "
      "G[G(,,,,along,beside,,)]_{E}";
  const Flower flower = grown(text, steps(9));
  // Four rows, of 2, 3, 4 and 5 volumes beside the axis.
  CHECK(flower.count("A") == 4);
  CHECK(flower.count("R") == 2 + 3 + 4 + 5);
  std::set<std::pair<float, float>> places;
  for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v) {
    const std::pair place(flower.value(v, Field::height), flower.value(v, Field::length));
    if (flower.name(v) == "F") places.insert(place);
    // A module counts its own steps, from 0 on; its first volume has the step of its call.
    if (flower.name(v) != "G") continue;
    const bool begins = flower.name(flower.derived.map.volume(v).parent) == "R";
    CHECK(place.second == (begins ? 2 : 0));
    if (!begins) CHECK(place.first <= 9);
  }
  CHECK(places.size() == 2 + 3 + 4 + 5);
  for (const auto& [along, beside] : places) CHECK((beside >= 1 && beside <= 2 + along));
  CHECK(grown("#define along=7\n#define A(4,0,0,0,1,1,1,1)\n#axiom: A\nA{beside=3}{}{} -> A[A(,,,,along,beside,,)]_{E}",
              steps(1))
            .derived.values[1] == VolumeValues{4, 1, 0, 0, 0, 7, 3, 1, 1});
}

TEST_CASE("blocks set values for the parts after them") {
  const Flower flower = grown(volume + "A{w = 2*step+1; v = w*w;}{w < 6}{u = v+1} -> A[A(,,,,w,v,u,)]_{E}", steps(6));
  REQUIRE(flower.derived.map.volumes() == 4);
  for (std::uint32_t v = 1; v < 4; ++v) {
    const auto w = static_cast<float>(2 * v - 1);
    CHECK(flower.value(v, Field::height) == w);
    CHECK(flower.value(v, Field::length) == w * w);
    CHECK(flower.value(v, Field::width) == w * w + 1);
  }
}

TEST_CASE("a glue waits until its faces are adjacent, and a note lists glues that never applied") {
  // A stack whose sides grow; the lobes' neighbouring sides meet.
  const std::string lobes =
      "#define V(4,0,0,0,1,1,1,1)\n#define R(4,0,0,0,1,1,1,2)\n#axiom: V\n"
      "V -> V[V]_{E}\nV -> V[R]_{C2}\n";
  const Flower flower = grown(lobes + "R : R_C1 < R_C3 -> R_C1 | R_C3", steps(6));
  CHECK(flower.count("R") == 6);
  std::size_t glued = 0;
  gm::OrbitWalk walk(flower.derived.map);
  for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v)
    if (flower.name(v) == "R")
      glued += gm::neighbours(walk, flower.derived.map, v, flower.derived.map.volume(v).label).size();
  CHECK(glued == 2 * 5);
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
  CHECK(flower.derived.notes.empty());
  CHECK(grown(lobes + "R : R_C2 < R_C4 -> R_C2 | R_C4", steps(6)).noted("never became adjacent"));
  // Where volumes have not grown there is nothing to glue, and no note either.
  CHECK_FALSE(grown(lobes + "#define lobes=1\n#define W(4,0,0,0,1,1,1,1)\nV{}{lobes>1}{} -> V[W]_{C1}\n" +
                        "W : W_C1 < W_C3 -> W_C1 | W_C3",
                    steps(6))
                  .noted("were not glued"));
  CHECK(grown(lobes + "R : R_C5 < R_C4 -> R_C5 | R_C4", steps(6))
            .noted("Line 6: “R” is a prism with 4 sides and has no face C5, so"));
  CHECK(grown(lobes + "R : R_C1 < V_C7 -> R_C1 | V_C7", steps(6))
            .noted("Line 6: “V” is a prism with 4 sides and has no face C7, so"));
}

TEST_CASE("a glue finds the face of its own instance where another's is adjacent too") {
  // On each side of a prism a module's chain of two, whose sides are beside those of the neighbouring chain.
  const Flower flower = grown(
      "#define A(8,0,0,0,1,1,1,1)\n#axiom: A\n#define finalStep=1\nA -> A[&M]_{C1,C2,C3}\n#module M\n"
      "#define P(4,0,0,0,1,1,1,1)\n#axiom: P\n#define finalStep=3\nP -> P[P]_{C1,C2}\nP : P_C4 < P_C2 -> P_C4 | P_C2\n"
      "P : P_C3 < P_C3 -> P_C3 | P_C3");
  gm::OrbitWalk walk(flower.derived.map);
  std::size_t glued = 0;
  for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v) {
    const auto instance = [&](std::uint32_t of) {
      return flower.derived.records[flower.derived.record_of[of]].instance;
    };
    for (const gm::Neighbour& each : gm::neighbours(walk, flower.derived.map, v)) {
      const bool grown_on = each.own == gm::base_face || each.other == gm::base_face;
      if (grown_on) continue;
      CHECK(instance(each.volume) == instance(v));
      ++glued;
    }
  }
  CHECK(glued > 0);
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
}

TEST_CASE("notes list lines that later ones displace, and lines that could not be applied") {
  const Flower twice = grown(volume + "A{}{step==0}{} -E-> B C\nA{}{step==0}{} -C1-> B C", steps(1));
  CHECK(twice.noted("Line 5: This production had no effect where a later line splits"));
  const Flower renamed = grown(volume + "A -> B\nA -> C", steps(1));
  CHECK(renamed.name(0) == "C");
  CHECK(renamed.noted("Line 5: This production had no effect where a later line"));
}

TEST_CASE("a split halves a volume, and both go on growing") {
  const Flower flower = grown(volume + "A{}{step==0}{} -E-> B C\nC{}{step==1}{} -> C[A]_{E}", steps(2));
  REQUIRE(flower.derived.map.volumes() == 3);
  CHECK(flower.name(0) == "B");
  CHECK(flower.name(1) == "C");
  CHECK(flower.value(0, Field::height) == 0.5f);
  CHECK(flower.value(1, Field::height) == 0.5f);
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
  gm::Embedding embedding;
  embedding.build(flower.derived.map);
  embedding.place(flower.derived.shapes());
  float top = 0;
  for (const glm::vec3& at : embedding.positions()) top = std::max(top, at.z);
  CHECK(top == doctest::Approx(2));
  CHECK(grown(volume + "A -E-> B(,,,,.25) C(,,,,.75)", steps(1)).value(1, Field::height) == 0.75f);
}

TEST_CASE("a relabelled volume has the new label's productions from then on") {
  const Flower flower = grown(volume + "A -> B\nB -> B[C]_{E}", steps(2));
  CHECK(flower.name(0) == "B");
  CHECK(flower.count("C") == 1);
  CHECK(flower.noted("renames “A” to “B”"));
}

TEST_CASE("a module has a step of its own and runs to its end") {
  const std::string text =
      volume +
      "A{}{step==1}{} -> A[&M(,,,,9,,,)]_{E}\n#define finalStep=2\n"
      "#module M\n#define A(4,0,0,0,7,1,1,5)\n#define B(4,0,0,0,1,1,1,1)\n#axiom: A\n#define finalStep=5\n"
      "A -> A[A(,,,,step,,,)]_{E}\nA{}{step==finalStep-1}{} -> A[B]_{C1}";
  const Flower flower = grown(text);
  // Its A is not the text's.
  CHECK(flower.derived.map.volumes() == 1 + 1 + 5 + 5);
  CHECK(flower.derived.instances.size() == 2);
  CHECK(flower.value(1, Field::height) == 9);
  CHECK(flower.value(1, Field::material) == 5);
  float step = 0;
  for (std::uint32_t v = 2; v < flower.derived.map.volumes(); ++v)
    if (flower.name(v) == "A") CHECK(flower.value(v, Field::height) == step++);
  CHECK(step == 5);
}

TEST_CASE("a module's number of steps depends on the values that each call gives and draws") {
  const auto text = [](const std::string& n, const std::string& calls) {
    return "#define A(9)\n#define k=8\n#axiom: A\nA -> A" + calls + "\n#define finalStep=1\n#module P\n#define n=" + n +
           "\n#define finalStep=n\n#define B(4,finalStep)\n#axiom: B\nB -> B[B]_{E}";
  };
  const std::string calls = "[&P{n=k}]_{C1}[&P]_{C2}[&P{n=0}]_{C3}";
  const Flower flower = grown(text("3", calls));
  CHECK(flower.count("B") == 9 + 4 + 1);
  CHECK(flower.value(1, Field::turn_x) == 8);
  CHECK(flower.value(2, Field::turn_x) == 3);
  // So another given value makes another map.
  Given now;
  now.values = {{"k", 2}};
  CHECK(flower::rebuilds(flower.program, {}, now));
  CHECK(grown(text("3", calls), now).count("B") == 3 + 4 + 1);
  CHECK(english(trouble(text("3", "[&P{n=0.5}]_{C1}")).message).find("whole number") != std::string::npos);
  CHECK(trouble(text("3", "[&P{n=5000}]_{C1}")).reason == Reason::limit);
  std::set<std::size_t> counts;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    counts.insert(grown(text("floor(ran(9))", "[&P]_{C1,C2}"), steps(1, seed)).count("B"));
  CHECK(counts.size() > 3);
}

TEST_CASE("modules that call themselves end at a depth, with a note") {
  const Flower flower =
      grown(volume + "A -> A[&M]_{E}\n#module M\n#define A(4,0,0,0,1,1,1,1)\n#axiom: A\nA -> A[&M]_{E}", steps(1));
  CHECK(flower.derived.instances.size() == 33);
  CHECK(flower.noted("Line 9: Modules are nested more than 32 levels deep"));
}

TEST_CASE("variables belong to the text or to their module, and given values replace the text's") {
  const std::string text =
      "#define a=2\n#define b=a*3\n" + volume +
      "A -> A[&M(,,,,b,a,,)]_{E}\n#module M\n#define b=a+100\n#define A(4,0,0,0,1,1,b,1)\n#axiom: A";
  const Flower flower = grown(text, steps(1));
  CHECK(flower.value(1, Field::height) == 6);
  CHECK(flower.value(1, Field::length) == 2);
  CHECK(flower.value(1, Field::width) == 102);
  Given given = steps(1);
  given.values = {{"a", 5}};
  const Flower other = grown(text, given);
  CHECK(other.value(1, Field::height) == 15);
  CHECK(other.value(1, Field::width) == 105);
  // A value of a variable that the text no longer has changes nothing.
  given.values = {{"c", 5}};
  CHECK(grown(text, given).derived.values == flower.derived.values);
}

TEST_CASE("each call gives a module's variables values of its own") {
  const std::string text =
      "#define A(4,0,0,0,1,1,1,1)\n#define tall=3\n#axiom: A\n#define finalStep=1\n"
      "A{k=2}{}{} -> A[&M{high=k*H+tall; n=2}]_{E}[&M{high=math.random(5,6)}]_{C1,C2}[&M]_{C3}\n"
      "#module M\n#define high=7\n#define n=1\n#define twice=2*high\n#define B(4,0,0,0,high,1,1,1)\n"
      "#define C(4,0,0,0,twice,1,1,1)\n#axiom: B\nB{}{n>1}{} -> B[C]_{E}";
  const auto heights = [](const Flower& flower, std::string_view name) {
    std::vector<float> all;
    for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v)
      if (flower.name(v) == name) all.push_back(flower.value(v, Field::height));
    return all;
  };
  const Flower flower = grown(text);
  const std::vector<float> b = heights(flower, "B"), c = heights(flower, "C");
  REQUIRE(b.size() == 4);
  CHECK(b[0] == 5);
  CHECK(b[1] >= 5);
  CHECK(b[1] <= 6);
  CHECK(b[1] != b[2]);
  CHECK(b[3] == 7);
  CHECK(c == std::vector<float>{10});
  // The same map, where no condition depends on the given value.
  Given now;
  now.values = {{"tall", 4}};
  CHECK_FALSE(flower::rebuilds(flower.program, {}, now));
  CHECK(sound(reworked(flower.program, now, flower.derived)) == grown(text, now).derived.values);
  const Program program = program_of(
      "#define A(4)\n#define a=2\n#define b=3\n#axiom: A\nA{l=b}{}{} -> A[&M{q=a; r=l}]_{E}\n"
      "#module M\n#define q=1\n#define p=1\n#define r=1\n#define u=1\n#define A(4)\n#axiom: A\n"
      "A{}{q<step}{} -> A[&M{p=u; u=r; q=99}]_{E}[&N{w=p}]_{C1}\n"
      "#module N\n#define w=1\n#define A(3+w)\n#axiom: A\nA -> A[A]_{E}");
  CHECK(flower::rebuilds(program, {{{"a", 6}}, 0, 1, 1}, {{{"a", 7}}, 0, 1, 1}));
  // b is given to r, which is given to u, which is given to p, which is given to the order of N.
  CHECK(flower::rebuilds(program, {{{"b", 6}}, 0, 1, 1}, {{{"b", 7}}, 0, 1, 1}));
}

TEST_CASE("random values are uniform, repeatable by seed, and different for each volume") {
  const std::string text =
      "#define r=7\n#define V(4,0,0,0,1,1,1,1)\n#define P(4,0,0,0,1,1,1,1)\n#axiom: V\nV -> V[V]_{E}\nV -> "
      "V[P(,<math.random(-r,r)>,,,,,,)]_{C2}";
  const auto angles = [&](std::uint64_t seed) {
    const Flower flower = grown(text, steps(200, seed));
    std::vector<float> all;
    for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v)
      if (flower.name(v) == "P") all.push_back(flower.value(v, Field::turn_x));
    return all;
  };
  const std::vector<float> one = angles(1);
  CHECK(one == angles(1));
  CHECK(one != angles(2));
  REQUIRE(one.size() == 200);
  double mean = 0;
  std::size_t high = 0;
  for (const float angle : one) {
    CHECK(std::abs(angle) <= 7);
    mean += static_cast<double>(angle) / 200;
    high += angle > 3.5f;
  }
  CHECK(std::abs(mean) < 1);
  CHECK(high > 30);
  CHECK(high < 70);
  CHECK(std::set<float>(one.begin(), one.end()).size() > 195);
  // Each instance of a module draws its own variables.
  const Flower modules = grown(
      "#define V(4,0,0,0,1,1,1,1)\n#axiom: V\nV -> V[V]_{E}\nV -> V[&M]_{C1}\n#module M\n#define "
      "h=math.random(1,2)\n#define w=2*h\n#define A(4,0,0,0,h,w,1,1)\n#axiom: A\nA -> A[A(,,,,,w,h,)]_{E}\n#define "
      "finalStep=1",
      steps(9));
  std::set<float> heights;
  for (std::uint32_t v = 0; v < modules.derived.map.volumes(); ++v) {
    if (modules.name(v) != "A") continue;
    CHECK(modules.value(v, Field::length) == 2 * modules.value(v, Field::height));
    heights.insert(modules.value(v, Field::height));
  }
  CHECK(heights.size() == 9);
}

TEST_CASE("reworked values equal those of a flower that grows with the new numbers") {
  const std::string text = text_named("table-3");
  const Program program = program_of(text);
  for (const float turn : {0.0f, 3.0f, 40.0f}) {
    Given before, now;
    now.values = {{"rd", turn}};
    CHECK_FALSE(flower::rebuilds(program, before, now));
    const Derived derived = sound(derive(program, before));
    const Derived anew = sound(derive(program, now));
    CHECK(sound(reworked(program, now, derived)) == anew.values);
    CHECK(anew.map.darts() == derived.map.darts());
  }
  const Program orders =
      program_of("#define n=6\n#define m=n\n#define k=3\n#define A(m,0,0,0,1,1,k,1)\n#axiom: A\nA{x=k}{}{}->A[A]_{E}");
  CHECK(flower::rebuilds(orders, {{{"n", 6}}, 0, 1, 1}, {{{"n", 7}}, 0, 1, 1}));
  CHECK_FALSE(flower::rebuilds(orders, {{{"k", 6}}, 0, 1, 1}, {{{"k", 7}}, 0, 1, 1}));
  // Another seed matters only where the map depends on draws; there the drawn values decide.
  CHECK_FALSE(flower::rebuilds(orders, {}, {{}, 0, 1, 2}));
  const auto random_order = [](const std::string& order) {
    return program_of("#define n=floor(math.random(4,6))\n#define A(" + order +
                      ",0,0,0,1,1,1,1)\n#axiom: A\nA->A[&M{k=" + order +
                      "}]_{E}\n#module M\n#define k=4\n#define finalStep=k\n#axiom: A\n#define A(4)\nA->A[A]_{E}");
  };
  const Program drawn = random_order("n"), anyhow = random_order("floor(math.random(4,6))");
  std::size_t same = 0;
  for (std::uint64_t seed = 2; seed < 42; ++seed) {
    const Given now{{}, 0, 1, seed};
    const bool alike = sound(derive(drawn, now)).map.darts() == sound(derive(drawn, {})).map.darts();
    CHECK(flower::rebuilds(drawn, {}, now) != alike);
    CHECK(flower::rebuilds(anyhow, {}, now));
    same += alike;
  }
  CHECK(same > 10);
  CHECK(same < 30);
  CHECK(flower::rebuilds(orders, {}, steps(3)));
  // −0 is 0, and its inverse is not.
  const Program inverse = program_of("#define k=3\n#define A(4)\n#axiom: A\nA{}{1/k+1/age>0}{}->A[A]_{E}");
  CHECK(flower::rebuilds(inverse, {{{"k", 0.0f}}, 0, 1, 1}, {{{"k", -0.0f}}, 0, 1, 1}));
  CHECK(flower::rebuilds(inverse, {{}, 0, 0.0f, 1}, {{}, 0, -0.0f, 1}));
  CHECK_FALSE(flower::rebuilds(inverse, {{{"k", 0.0f}}, 0, 1, 1}, {{{"k", 0.0f}}, 0, 1, 1}));
  const Program conditions =
      program_of("#define k=3\n#define A(4,0,0,0,1,1,1,1)\n#axiom: A\nA{x=k}{step<x}{}->A[A]_{E}");
  CHECK(flower::rebuilds(conditions, {{{"k", 6}}, 0, 1, 1}, {{{"k", 7}}, 0, 1, 1}));
}

TEST_CASE("Table 3 has one receptacle, four petals and four modules") {
  for (std::uint32_t n = 11; n <= 24; ++n) {
    CAPTURE(n);
    const Flower flower = grown(text_named("table-3"), steps(n));
    CHECK(flower.count("RECEPTACLE") == 1);
    CHECK(flower.count("PETAL") == 4);
    CHECK(flower.derived.instances.size() == 5);
    CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
  }
  const Flower flower = grown(text_named("table-3"));
  CHECK(flower.noted("ten numbers"));
  CHECK(flower.noted("“PTULIP” is attached, but not joined edge to edge"));
  for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v) {
    if (flower.name(v) != "PETAL") continue;
    const std::uint32_t side = gm::side_number(flower.derived.map.volume(v).parent_face);
    if (side == 5) CHECK(flower.value(v, Field::turn_y) == 2);
    if (side == 9) CHECK(flower.value(v, Field::turn_y) == -3);
    if (side != 13 && side != 17) continue;
    CHECK(flower.value(v, Field::turn_x) > 0);
    CHECK(flower.value(v, Field::turn_x) < 7);
  }
}

TEST_CASE("figure 16 has whorls of six sepals, six petals, six stamens and a carpel") {
  const Flower flower = grown(text_named("figure-16"), steps(3));
  std::array<std::size_t, 5> of{};
  for (const Instance& instance : flower.derived.instances) ++of[instance.grammar];
  CHECK(of == std::array<std::size_t, 5>{1, 6, 6, 6, 0});
  const Flower whole = grown(text_named("figure-16"), steps(4));
  of = {};
  for (const Instance& instance : whole.derived.instances) ++of[instance.grammar];
  // The relabelled base has petals and stamens of its own attached.
  CHECK(of[4] == 1);
  CHECK(whole.noted("renames “BASEC” to “BASE”"));
  CHECK(whole.noted("“CARPEL” on line"));
  CHECK(gm::check(whole.derived.map).fault == gm::Fault::nothing);
}

TEST_CASE("growth ends at a limit, and the flower so far remains") {
  Limits limits;
  limits.darts = 48 * 100;
  const Flower flower = grown(volume + "A -> A[A]_{E}", steps(500), limits);
  CHECK(flower.derived.map.volumes() == 100);
  CHECK(flower.noted(
      "Growth ended in step 99, line 5: The flower has reached its maximum size, the limit on darts in its map. "
      "Let the flower grow on fewer faces"));
  CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
  limits = {};
  limits.work = 50;
  CHECK(grown(volume + "A -> A[A]_{E,C1}", steps(500), limits).noted(" units of computing work"));
  // Work is counted by tried productions, not by volumes, and includes the variables of modules.
  std::string many = volume;
  for (int i = 0; i < 200; ++i) many += "A{}{step<0}{} -> B\n";
  limits.work = 20000;
  CHECK(grown(many + "A -> A[A]_{E}", steps(400), limits).noted(" units of computing work"));
  std::string drawing = volume + "A -> A[A]_{E}[&M]_{C1}\n#module M\n#define v0=ran(1)\n";
  for (int i = 1; i < 100; ++i) drawing += "#define v" + std::to_string(i) + "=v" + std::to_string(i - 1) + "*1.001\n";
  CHECK(grown(drawing + "#define Q(4,0,0,0,1+v99,v98*3,1,1)\n#axiom: Q", steps(200), limits)
            .noted(" units of computing work"));
  // Blocks that are compiled in too many places.
  std::string blocks = volume + "A{a=H";
  for (int i = 0; i < 20000; ++i) blocks += "+H";
  blocks += ";}{}{} -> A";
  for (int i = 0; i < 3000; ++i) blocks += "[A]E";
  CHECK(english(trouble(blocks).message).find("too many places") != std::string::npos);
  limits = {};
  limits.steps = 9;
  CHECK(trouble(volume + "A -> A[A]_{E}\n#define finalStep=10", {}, limits).reason == Reason::limit);
}

TEST_CASE("every grammar of the presets grows to a valid map, repeatably") {
  for (const auto& file : files()) {
    CAPTURE(file.string());
    const Flower flower = grown(content(file)), again = grown(content(file));
    CHECK(flower.derived.map.volumes() > 1);
    CHECK(gm::check(flower.derived.map).fault == gm::Fault::nothing);
    CHECK(flower.derived.values == again.derived.values);
  }
}

TEST_CASE("the examples of the language's documentation grow") {
  const std::string page = content(panicle::tests::repository_folder() + "/docs/models/flower/language.md");
  std::size_t examples = 0;
  for (std::size_t at = 0; (at = page.find("```flower\n", at)) != std::string::npos; ++examples) {
    at += 10;
    const std::string text = page.substr(at, page.find("```", at) - at);
    CAPTURE(text);
    CHECK(grown(text).derived.map.volumes() > 20);
  }
  CHECK(examples >= 2);
}

TEST_CASE("functions of Lua are read under their own names, its angles as radians") {
  const auto value = [](const std::string& expression) {
    return grown("#define k=" + expression + "\n#define A(4,k,0,0,1,1,1,1)\n#axiom: A").value(0, Field::turn_x);
  };
  CHECK(value("math.sin(math.pi/2)") == doctest::Approx(1));
  CHECK(value("math.cos(math.abs(-math.pi))+sin(90)") == doctest::Approx(0).epsilon(1e-5));
  CHECK(value("4*math.atan(1)") == doctest::Approx(3.14159265));
  CHECK(value("math.floor(math.sqrt(17)) + math.max(1,math.min(3, 2))*10") == doctest::Approx(24));
  const float drawn = value("math.random(math.sin(math.pi/2), math.floor(2.5))");
  CHECK(drawn >= 1);
  CHECK(drawn <= 2);
}

TEST_CASE("a note lists productions that never apply, unless they depend on age, values or given steps") {
  const std::string start = "#define k=100\n#define A(4,0,0,0,1,1,1,1)\n#define Z(4)\n#axiom: A\n#define finalStep=6\n";
  const auto notes_that_it_never_happens = [&](const std::string& production, const Given& given = {}) {
    return grown(start + production, given).noted("never applied");
  };
  CHECK(
      grown(start + "A{}{step>9}{} -> A[A]_{E}")
          .noted("Line 6: This production was never applied, because its condition was false wherever there was room"));
  CHECK_FALSE(notes_that_it_never_happens("A{}{step>4}{} -> A[A]_{E}"));
  CHECK_FALSE(notes_that_it_never_happens("A{}{step>9}{} -> A[A]_{E}", steps(3)));
  CHECK_FALSE(notes_that_it_never_happens("A{}{step>k}{} -> A[A]_{E}"));
  CHECK_FALSE(notes_that_it_never_happens("A{}{age>1.5}{} -> A[A]_{E}"));
  CHECK_FALSE(notes_that_it_never_happens("A{w=k}{step>w}{} -> A[A]_{E}"));
  CHECK_FALSE(notes_that_it_never_happens("A{}{math.random(0,1)>2}{} -> A[A]_{E}"));
  CHECK(grown(start + "A -> A[A]_{E}\nZ -> Z[A]_{E}")
            .noted("Line 7: No production creates “Z”, so this production is never applied."));
  CHECK_FALSE(notes_that_it_never_happens("A -> A[Z]_{E}\nZ -> Z[A]_{E}"));
  CHECK_FALSE(notes_that_it_never_happens("A -> Z\nZ -> Z[A]_{E}"));
  CHECK_FALSE(notes_that_it_never_happens("A -> A[A]_{E}\n#module M\n#define B(4)\n#axiom: B\nB -> B[B]_{E}"));
}
