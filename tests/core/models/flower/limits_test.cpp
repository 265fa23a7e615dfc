// Texts beyond the limits: reading and growing them ends, and the memory of the result stays in proportion.
#include "flowers.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

// `v0=value;v1=value;…`, or a line of #define for each.
std::string settings(std::size_t count, const std::string& value) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += "v" + std::to_string(i) + "=" + value + ";";
  return all;
}

std::string defines(std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += "#define v" + std::to_string(i) + "=1\n";
  return all;
}

}  // namespace

// Would take six gigabytes if each setting stored every mention of a variable in the blocks before it.
TEST_CASE("dependences of calls are stored once, however often the text repeats them") {
  std::string sum = "b";
  for (int i = 0; i < 12; ++i) sum = "(" + sum + "+" + sum + ")";
  std::string text = "#define A(4)\n#define b=1\n#define c=1\n#axiom: A\nA{a=" + sum + "}{}{} -> A";
  for (int i = 0; i < 50; ++i) text += "\n[&M{" + settings(300, "a") + "}]_{E}";
  text += "\n#module M\n" + defines(300) + "#define A(4)\n#axiom: A\nA{}{v7<step}{} -> A[A]_{E}";
  REQUIRE(text.size() < Limits{}.text_bytes);
  const Program program = program_of(text);
  CHECK(program.productions[0].growths.size() == 50);
  const auto rebuilds = [&](std::string_view name) {
    return std::any_of(program.variables.begin(), program.variables.end(),
                       [&](const Variable& variable) { return variable.name == name && variable.rebuilds; });
  };
  CHECK(rebuilds("b"));
  CHECK_FALSE(rebuilds("c"));
  CHECK_FALSE(rebuilds("v8"));
}

TEST_CASE("settings of calls count as work") {
  Limits limits;
  limits.work = 50'000;
  const auto calling = [](const std::string& order, const std::string& faces, const std::string& value) {
    return "#define A(" + order + ")\n#axiom: A\nA -> A[A]_{E}[&M{v500=" + value + ";" + settings(500, "step") +
           "}]_{" + faces + "}\n#module M\n" + defines(501) + "#define B(4)\n#axiom: B\n";
  };
  // A call a step, and all calls in one step, where the limit ends the growth.
  std::string faces = "C1";
  for (int i = 2; i <= 400; ++i) faces += ",C" + std::to_string(i);
  for (const std::string& text : {calling("4", "C1", "1"), calling("400", faces, "1")}) {
    const Flower flower = grown(text, steps(300), limits);
    CHECK(flower.noted(" units of computing work"));
    CHECK(flower.derived.instances.size() > 10);
    CHECK(500 * flower.derived.instances.size() <= limits.work);
  }
  // The work of evaluating them, and of a variable's draws, counts too.
  std::string sum = "step";
  for (int i = 0; i < 500; ++i) sum += "+step*" + std::to_string(i);
  const auto instances = [&](const std::string& value) {
    return grown(calling("4", "C1", value), steps(300), limits).derived.instances.size();
  };
  CHECK(instances(sum) < instances("step"));
  std::string draws = "ran(1)";
  for (int i = 0; i < 500; ++i) draws += "+ran(1)";
  CHECK(grown("#define A(4)\n#axiom: A\nA -> A[A]_{E}[&M]_{C1}\n#module M\n#define v=" + draws +
                  "\n#define B(4)\n#axiom: B\n",
              steps(300), limits)
            .noted(" units of computing work"));
}

TEST_CASE("conditions, blocks and numbers count as work by their length") {
  Limits limits;
  limits.work = 100'000;
  std::string sum = "0*step";
  for (int i = 0; i < 1000; ++i) sum += "+step*0";
  const auto volumes = [&](const std::string& production) {
    const Flower flower = grown("#define A(4)\n#axiom: A\n" + production + "\n", steps(4000), limits);
    CHECK(flower.noted(" units of computing work"));
    return flower.derived.map.volumes();
  };
  // Each takes a thousand instructions or more; the limit is a hundred times as much.
  CHECK(volumes("A{}{" + sum + "==0}{} -> A[A]_{E}") <= 100);
  CHECK(volumes("A{a=" + sum + "}{a==0}{} -> A[A]_{E}") <= 100);
  CHECK(volumes("A{}{}{a=" + sum + "} -> A[A(,a,,,,,,)]_{E}") <= 100);
  CHECK(volumes("A -> A[A(," + sum + ",,,,,,)]_{E}") <= 100);
  CHECK(volumes("A -> A[A]_{C(1+" + sum + ")}") <= 100);
  CHECK(volumes("A -> A[A(" + sum + "+4,,,,,,,)]_{E}") <= 100);
  CHECK(grown("#define A(4)\n#axiom: A\nA -> A[A]_{E}\n", steps(4000), limits).derived.map.volumes() == 4001);
}

TEST_CASE("the work of an instance does not grow with the variables of other modules") {
  Limits limits;
  limits.work = 20'000;
  const auto instances = [&](std::size_t modules) {
    std::string text =
        "#define A(4)\n#axiom: A\nA -> A[A]_{E}[&M{v=step}]_{C1}\n#module M\n#define v=1\n#define w=v*v+1\n"
        "#define B(4,w/(v+1),0,0,1,1,1,1)\n#axiom: B\n";
    for (std::size_t i = 0; i < modules; ++i)
      text += "#module N" + std::to_string(i) + "\n#define v=1\n#define w=v*v+1\n#define B(4,w/(v+1))\n#axiom: B\n";
    const Flower flower = grown(text, steps(4000), limits);
    CHECK_FALSE(flower.derived.whole);
    for (std::uint32_t v = 0; v < flower.derived.map.volumes(); ++v) {
      if (flower.name(v) != "B") continue;
      const auto step = static_cast<float>(flower.derived.records[flower.derived.record_of[v]].step);
      CHECK(flower.value(v, Field::turn_x) == (step * step + 1) / (step + 1));
    }
    return flower.derived.instances.size();
  };
  CHECK(instances(0) > 100);
  // Except the work of evaluating those once.
  CHECK(instances(200) > 0.9 * static_cast<double>(instances(0)));
}

TEST_CASE("a call's settings may be in any order") {
  const Flower flower = grown(
      "#define A(4)\n#axiom: A\nA -> A[&M{c=2*step+4; a=1; d=(2*step+4)*2}]_{E}\n#module M\n#define a=9\n#define b=9\n"
      "#define c=9\n#define d=9\n#define B(4,a,b,c,d,1,1,1)\n#axiom: B\n",
      steps(1));
  REQUIRE(flower.derived.map.volumes() == 2);
  CHECK(flower.value(1, Field::turn_x) == 1);
  CHECK(flower.value(1, Field::turn_y) == 9);
  CHECK(flower.value(1, Field::turn_z) == 4);
  CHECK(flower.value(1, Field::height) == 8);
}

TEST_CASE("the memory of a cached flower is counted, and settings of calls are not stored") {
  std::string text = "#define A(4)\n#axiom: A\nA -> A[A]_{E}[&M{" + settings(300, "step*step+H") +
                     "}]_{C1}\n#module M\n" + defines(300) + "#define B(4)\n#axiom: B\n";
  std::string sum = "H";
  for (int i = 0; i < 2000; ++i) sum += "+step*0.000" + std::to_string(i);
  text += "B -> B[B(," + sum + ")]_{E}\n";
  const Flower flower = grown(text, steps(30));
  const expression::Code& code = flower.program.code;
  REQUIRE(code.instructions.size() > 3000);
  CHECK(flower.program.bytes() > code.instructions.size() * (sizeof code.instructions[0] + sizeof code.places[0]) +
                                     300 * (sizeof(Variable) + sizeof(Setting)));
  REQUIRE(flower.derived.instances.size() == 31);
  CHECK(flower.derived.bytes() >= flower.derived.map.bytes() + 31 * sizeof(Instance) +
                                      flower.derived.records.size() * (sizeof(Record) + sizeof(VolumeValues)));
  CHECK(sizeof(Instance) <= 2 * sizeof(std::uint64_t));
}

TEST_CASE("placing a flower anew takes no more work than growing it") {
  const Flower flower = grown("#define A(4)\n#axiom: A\nA -> A[A]_{E}[&M]_{C1}\n#module M\n" + defines(300) +
                                  "#define v=ran(1)\n#define B(4,v)\n#axiom: B\n",
                              steps(30));
  CHECK(sound(reworked(flower.program, steps(30), flower.derived)) == flower.derived.values);
  Limits limits;
  limits.work = 5000;
  const auto stopped = reworked(flower.program, steps(30), flower.derived, limits);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().reason == Reason::limit);
  CHECK_FALSE(derive(flower.program, steps(30), limits)->whole);
}
