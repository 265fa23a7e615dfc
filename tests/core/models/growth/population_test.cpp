#include <algorithm>
#include <array>
#include <cstdio>

#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

constexpr const char* sigma = "tree -> DivFunc(\"sigma1\"){branches}\n";
constexpr const char* plain = "footprint -> GrowVol(1, 1, 4, 10, 2, 0)\n";

bool same(const Shoot& a, const Shoot& b) {
  return a.parent == b.parent && a.volume == b.volume && a.born == b.born && a.node == b.node && a.order == b.order &&
         a.trunk == b.trunk;
}

}  // namespace

TEST_CASE("every preset grows at its own steps without a note") {
  CHECK(files().size() >= 13);
  for (const auto& path : files()) {
    CAPTURE(path.filename().string());
    const Rules rules = rules_of(content(path));
    for (const std::string& note : rules.notes) CHECK(note == "");
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const std::uint16_t steps = sound(steps_of(rules, seed, 0));
      CHECK(steps >= 5);
      const Population plant = grown(rules, steps, seed);
      CHECK(plant.branches > 5);
      CHECK(plant.leaves.size() > 0);
    }
  }
}

TEST_CASE("shoots come after their parents and are attached to an existing internode") {
  for (const auto& path : files()) {
    CAPTURE(path.filename().string());
    const Population plant = grown(content(path), 9, 3);
    std::uint32_t trunks = 0;
    for (std::size_t i = 0; i < plant.shoots.size(); ++i) {
      const Shoot& shoot = plant.shoots[i];
      trunks += shoot.trunk;
      REQUIRE(shoot.volume < plant.volumes.size());
      if (i > 0) REQUIRE(shoot.born >= plant.shoots[i - 1].born);
      if (shoot.parent < 0) {
        REQUIRE(shoot.trunk);
        REQUIRE(shoot.born == 0);
        continue;
      }
      REQUIRE(shoot.parent < static_cast<std::int32_t>(i));
      const Shoot& parent = plant.shoots[static_cast<std::size_t>(shoot.parent)];
      REQUIRE(shoot.node >= 1);
      REQUIRE(shoot.node <= shoot.born - parent.born);
      REQUIRE(shoot.order == (shoot.trunk ? 0 : parent.order + 1));
      if (!shoot.trunk) REQUIRE(shoot.volume == parent.volume);
    }
    CHECK(plant.branches + trunks == plant.shoots.size());
    CHECK(plant.volumes.size() == plant.environments.size());
    CHECK(trunks == plant.volumes.size());
    for (const Leaf& leaf : plant.leaves) {
      const std::uint16_t born = plant.shoots[leaf.shoot].born;
      REQUIRE((leaf.gone == Leaf::never ? born == leaf.born : born <= leaf.born && leaf.born < leaf.gone));
    }
  }
}

TEST_CASE("an internode has no more branches than buds") {
  const Population plant = grown(sigma, 11, 2);
  std::vector<std::uint32_t> attached(plant.shoots.size() * 12);
  for (const Shoot& shoot : plant.shoots)
    if (shoot.order > 1) ++attached[static_cast<std::size_t>(shoot.parent) * 12 + shoot.node];
  for (std::size_t i = 0; i < attached.size(); ++i)
    if (attached[i] > 0) REQUIRE(attached[i] <= i % 12 - 1);
}

TEST_CASE("a later step only adds to an earlier one") {
  for (const auto& path : files()) {
    CAPTURE(path.filename().string());
    const Rules rules = rules_of(content(path));
    for (const std::uint64_t seed : {1ull, 9ull}) {
      Population before = grown(rules, 0, seed);
      for (std::uint16_t step = 1; step <= 9; ++step) {
        const Population after = grown(rules, step, seed);
        CHECK(after.steps == step);
        REQUIRE(after.shoots.size() >= before.shoots.size());
        REQUIRE(std::equal(before.shoots.begin(), before.shoots.end(), after.shoots.begin(), same));
        for (std::size_t i = before.shoots.size(); i < after.shoots.size(); ++i) REQUIRE(after.shoots[i].born == step);
        REQUIRE(after.leaves.size() >= before.leaves.size());
        for (std::size_t i = 0; i < after.leaves.size(); ++i) {
          if (i >= before.leaves.size()) {
            REQUIRE(after.leaves[i].born == step);
            continue;
          }
          REQUIRE(after.leaves[i].shoot == before.leaves[i].shoot);
          if (after.leaves[i].falls != before.leaves[i].falls) {
            REQUIRE(before.leaves[i].falls == Leaf::never);
            REQUIRE(after.leaves[i].falls == step);
          }
        }
        REQUIRE(after.deformations.size() >= before.deformations.size());
        for (std::size_t i = 0; i < before.deformations.size(); ++i) {
          REQUIRE(after.deformations[i].shoot == before.deformations[i].shoot);
          REQUIRE(after.deformations[i].step == before.deformations[i].step);
        }
        REQUIRE(after.volumes.size() >= before.volumes.size());
        for (std::size_t i = 0; i < before.volumes.size(); ++i)
          REQUIRE(after.volumes[i].height == before.volumes[i].height);
        before = after;
      }
    }
  }
}

TEST_CASE("the same text and seed give the same, and another seed another tree") {
  const Rules rules = rules_of(text_named("figure-8"));
  const Population one = grown(rules, 8, 5), again = grown(rules, 8, 5), other = grown(rules, 8, 6);
  CHECK(one.branches == again.branches);
  CHECK(std::equal(one.shoots.begin(), one.shoots.end(), again.shoots.begin(), again.shoots.end(), same));
  CHECK(one.volumes[0].height == again.volumes[0].height);
  CHECK(one.volumes[0].height != other.volumes[0].height);
}

TEST_CASE("the trunk has as many branches as its divisor function gives") {
  const Population plant = grown(sigma, 9);
  const std::uint32_t sums[] = {0, 1, 3, 4, 7, 6, 12, 8, 15, 13};
  for (std::uint16_t step = 1; step <= 9; ++step)
    CHECK(std::count_if(plant.shoots.begin(), plant.shoots.end(),
                        [&](const Shoot& shoot) { return shoot.order == 1 && shoot.born == step; }) == sums[step]);
  // D(3 · k): σ(3), σ(6).
  const Population more = grown(std::string(sigma) + "tree -> DivFunc(\"exp\", 3, 1){branch}", 2);
  CHECK(std::count_if(more.shoots.begin(), more.shoots.end(), [](const Shoot& shoot) { return shoot.order == 1; }) ==
        4 + 12);
}

TEST_CASE("negative leaf counts mark leaves of the step before") {
  // Four leaves on each shoot of step 2; at step 3 three of them are about to fall.
  const Population plant = grown(std::string(plain) +
                                     "k == 2 -> nbr = 1\nk == 2 -> leaf(4)\nk == 3 -> nlf = -3\n"
                                     "nlf < 0 -> fallingLeaf(-nlf)\nbud(9) -> branch",
                                 3);
  REQUIRE(plant.leaves.size() == 4);
  CHECK(std::count_if(plant.leaves.begin(), plant.leaves.end(), [](const Leaf& leaf) { return leaf.falls == 3; }) == 3);
  CHECK(std::count_if(plant.leaves.begin(), plant.leaves.end(),
                      [](const Leaf& leaf) { return leaf.falls == Leaf::never; }) == 1);
  // Those of the step before alone.
  const Population later =
      grown(std::string(plain) + "k == 2 -> nbr = 1\nk == 2 -> leaf(4)\nk == 4 -> fallingLeaf(3)\nbud(9) -> branch", 5);
  for (const Leaf& leaf : later.leaves) CHECK(leaf.falls == Leaf::never);
}

TEST_CASE("a shoot whose count of leaves is negative sheds its own leaves of the step before") {
  // N − k is constant while a shoot ages, so the count is that of its first step b: σ(b + 1) − σ(b).
  const std::array<int, 13> sums = {0, 1, 3, 4, 7, 6, 12, 8, 15, 13, 18, 12, 28};
  const Population plant = grown(text_named("figure-5"), 11);
  std::vector<std::uint32_t> had(plant.shoots.size(), 0), fell(plant.shoots.size(), 0);
  std::array<std::size_t, 12> falling{};
  for (const Leaf& leaf : plant.leaves) {
    ++had[leaf.shoot];
    if (leaf.falls == Leaf::never) continue;
    ++fell[leaf.shoot];
    ++falling[leaf.falls];
    CHECK(leaf.falls == leaf.born + 1);
  }
  for (std::size_t q = 0; q < plant.shoots.size(); ++q) {
    const std::uint16_t born = plant.shoots[q].born;
    const int count = sums[born + 1u] - sums[born];
    const bool sheds = !plant.shoots[q].trunk && count < 0 && born < 11;
    REQUIRE(fell[q] == (sheds ? std::min(had[q], static_cast<std::uint32_t>(-count)) : 0));
  }
  for (std::size_t step = 1; step <= 11; ++step)
    CHECK((falling[step] > 0) == (step == 5 || step == 7 || step == 9 || step == 11));
}

TEST_CASE("as many leaves of an internode's foliage fall as the grammar sets, in their own step") {
  const Population plant = grown(std::string(plain) + "nbr = 0\nk >= 1 -> foliage(3)\nk == 3 -> fallingLeaf(2)\n", 4);
  std::size_t falling = 0;
  for (const Leaf& leaf : plant.leaves) {
    if (leaf.falls == Leaf::never) continue;
    ++falling;
    CHECK(leaf.born == 3);
    CHECK(leaf.falls == 3);
  }
  CHECK(falling == 2);
}

TEST_CASE("child trunks come at their condition, with sizes from 1 to half of the parent's") {
  const Rules rules = rules_of(
      "footprint -> GrowVol(1, 1, 5, 10, 3, 0)\ntree -> DivFunc(\"sigma1b\", 0, 2){branches}\n"
      "ndv == 0 -> childTrunk : 0.1");
  std::size_t chances = 0, trunks = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Population plant = grown(rules, 2, seed);
    // At step 1 the divisors of 1 are odd.
    ++chances;
    trunks += plant.volumes.size() - 1;
    if (plant.volumes.size() == 1) continue;
    const auto child =
        std::find_if(plant.shoots.begin() + 1, plant.shoots.end(), [](const Shoot& shoot) { return shoot.trunk; });
    CHECK(child->born == 1);
    CHECK(child->parent == 0);
    CHECK(child->order == 0);
    const GrowthVolume& volume = plant.volumes[child->volume];
    CHECK(volume.height >= 1);
    CHECK(volume.height <= 5);
    CHECK(volume.base >= 1);
    CHECK(volume.base <= 2.5f);
    CHECK(volume.size == doctest::Approx(volume.height / 10));
  }
  CHECK(static_cast<double>(trunks) / static_cast<double>(chances) == doctest::Approx(0.1).epsilon(0.4));
  // A child trunk's age counts from its own first step: at its age of 2 it has as many branches as the first trunk had
  // at 2.
  const Population certain = grown("tree -> DivFunc(\"sigma1\"){branches}\ngs == 1 -> childTrunk", 3);
  CHECK(std::count_if(certain.shoots.begin(), certain.shoots.end(),
                      [](const Shoot& shoot) { return shoot.volume == 1 && shoot.order == 1; }) == 1 + 3);
}

TEST_CASE("only trunks have child trunks") {
  const Population plant = grown("tree -> DivFunc(\"sigma1\"){branches}\ngs == 3 -> childTrunk", 4);
  CHECK(plant.volumes.size() == 2);
}

TEST_CASE("every bud, shoot and step has random values of its own") {
  const std::string trunk = std::string(plain) + "k == N - 1 && gs == 1 -> nbr = 64\n";
  for (const char* text : {"k < N - 1 -> nbr = 1\nbud(1) : k < N - 1 -> branch : 0.5",
                           "k < N - 1 -> nbr = RND(0, 1)\nbud(9) : k < N - 1 -> branch",
                           "k < N - 1 -> nbr = 1 : 0.5\nbud(9) : k < N - 1 -> branch",
                           "k < N - 1 && ran(1) < 0.5 -> nbr = 1\nbud(9) : k < N - 1 -> branch"}) {
    CAPTURE(text);
    const Population plant = grown(trunk + text, 3);
    std::array<int, 4> came{};
    for (const Shoot& shoot : plant.shoots) ++came[shoot.born];
    CHECK(came[1] == 64);
    CHECK(came[2] > 18);
    CHECK(came[2] < 46);
    CHECK(came[3] > 18);
    CHECK(came[3] < 80);
  }
  // Rules that use a shoot's order are evaluated for each shoot.
  const Population plant = grown(trunk +
                                     "order == 1 && gs == 2 -> nbr = 1\norder == 2 && gs == 3 -> nbr = 2\n"
                                     "k < 0 -> leaf(1)\nbud(9) : k < N - 1 -> branch",
                                 3);
  CHECK(plant.branches == 64 + 64 + 128);
}

TEST_CASE("a branch of negative count is deformed for that step") {
  const Population plant = grown(
      "gravitropism = 0.5\ntree -> DivFunc(\"sigma1\"){branches}\n"
      "ndv < 0 -> gravitropism = gravitropism - 0.2, length = length * 2",
      7);
  CHECK(plant.environments[0].gravitropism == 0.5f);
  REQUIRE_FALSE(plant.deformations.empty());
  // σ(5) − σ(4) = −1 at the age of 5; at 6 it is 6, at 7 −4.
  bool deformed = false, restored = false;
  for (const Deformation& each : plant.deformations) {
    const int age = each.step - plant.shoots[each.shoot].born;
    const bool negative = age == 5 || age == 7;
    CHECK(each.length == (negative ? 2 : 1));
    CHECK(each.gravitropism == doctest::Approx(negative ? -0.2 : 0));
    CHECK_FALSE(plant.shoots[each.shoot].trunk);
    deformed |= negative;
    restored |= each.length == 1;
  }
  CHECK(deformed);
  CHECK(restored);
}

TEST_CASE("conditions on a growth volume set its environment") {
  const Rules rules = rules_of(
      "footprint -> GrowVol(1, 1, 2, 4, 1, 0), GrowVol(2, 5, 2, 6, 1, 30)\n"
      "tree -> DivFunc(\"sigma1\"){branches}\nphototropism = 0.3\nGrowVol.h < 5 -> gravitropism = 0.2\n"
      "GrowVol.id == 6 -> neighbours = 0.5\nGrowVol.cnt == 3 && GrowVol.grad > 29 -> gravitropism = -1");
  const Population plant = grown(rules, 3);
  REQUIRE(plant.volumes.size() == 3);
  CHECK(plant.volumes[0].id == 1);
  CHECK(plant.volumes[1].id == 5);
  CHECK(plant.volumes[2].id == 6);
  CHECK(plant.volumes[2].gradient == doctest::Approx(0.5235988));
  CHECK(plant.environments[0].gravitropism == 0.2f);
  CHECK(plant.environments[1].gravitropism == -1);
  CHECK(plant.environments[1].neighbours == 1);
  CHECK(plant.environments[2].neighbours == 0.5f);
  CHECK(plant.environments[0].phototropism == 0.3f);
  CHECK(plant.volumes[0].at.x == 0);
  CHECK(plant.volumes[1].at != plant.volumes[2].at);
}

TEST_CASE("growth volumes are drawn from 1 to the given size") {
  const Rules rules = rules_of(
      "gs.rand(7, 8)\nfootprint -> GrowVol(cnt.rand(3), size.rand(10, 8, 12, 60°), wt.rand(2, 3))\n"
      "tree -> DivFunc(\"sigma1\"){branches}");
  std::array<int, 4> counts{};
  std::array<int, 9> steps{};
  float lowest = 100, highest = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Population plant = grown(rules, 0, seed);
    REQUIRE(plant.volumes.size() <= 3);
    ++counts[plant.volumes.size()];
    ++steps[sound(steps_of(rules, seed, 1))];
    for (const GrowthVolume& volume : plant.volumes) {
      lowest = std::min(lowest, volume.height);
      highest = std::max(highest, volume.height);
      REQUIRE(volume.base >= 1);
      REQUIRE(volume.base <= 10);
      REQUIRE(volume.top >= 2);
      REQUIRE(volume.top <= 3);
      REQUIRE(volume.gradient >= 0);
      REQUIRE(volume.gradient <= 1.05f);
    }
  }
  for (const int count : {1, 2, 3}) CHECK(counts[static_cast<std::size_t>(count)] > 40);
  CHECK(lowest >= 1);
  CHECK(lowest < 1.2f);
  CHECK(highest <= 8);
  CHECK(highest > 7.8f);
  CHECK(steps[7] + steps[8] == 200);
  CHECK(steps[7] > 60);
  CHECK(sound(steps_of(rules_of(sigma), 1, 6)) == 6);
}

TEST_CASE("divisor functions are drawn by their probabilities") {
  const Rules rules =
      rules_of("tree -> DivFunc(\"sigma1\"){branches} : 0.25\ntree -> DivFunc(\"sigma1b\", 0, 2){branches} : 0.75");
  int even = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) even += grown(rules, 1, seed).branches == 0;
  CHECK(even > 260);
  CHECK(even < 340);
}

TEST_CASE("limits end a growth with a message") {
  Limits limits;
  limits.segments = 100;
  CHECK(trouble(sigma, 11, limits).reason == Reason::limit);
  CHECK(trouble("nbr = 10000\nbud(1) : k < 0 -> branch", 3).reason == Reason::limit);
  CHECK(trouble("nbr = 1e9", 1).reason == Reason::limit);
  CHECK(trouble("nbr = 3\nbud(1e9) -> branch : 0", 3).reason == Reason::limit);
  CHECK(trouble("nbr = 1\nleaf(1e6)", 3).reason == Reason::syntax);
  CHECK(trouble("nbr = 1\nk > 0 -> leaf(1e6)", 3).reason == Reason::limit);
  CHECK(trouble("footprint -> GrowVol(cnt(64), h(3))\nfootprint -> GrowVol(cnt(1))\nnbr = 1", 3).reason ==
        Reason::limit);
  limits = {};
  limits.work = 10;
  CHECK(trouble(sigma, 8, limits).reason == Reason::limit);
  // Before anything grows.
  const Diagnostic inexact = trouble("\n tree -> DivFunc(\"sigma60\"){branches}", 6);
  CHECK(inexact.reason == Reason::bad_input);
  CHECK(inexact.line == 2);
  CHECK(inexact.column == 10);
  CHECK(trouble("tree -> DivFunc(\"sigma9\"){branches}", 14).reason == Reason::bad_input);
  CHECK(trouble("tree -> DivFunc(\"sigma1\"){branches} DivFunc(\"exp\", 10, 9){branches}", 6).reason == Reason::limit);
}

TEST_CASE("a tree is the same when its drawn volumes are given as numbers") {
  for (const std::string name : {"figure-8", "figure-9", "table-1-older"}) {
    std::string text = text_named(name);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Population drawn = grown(text, 6, seed);
      const Population bare = grown(text, 0, seed);
      std::string written = "footprint ->";
      for (const GrowthVolume& volume : bare.volumes) {
        char line[200];
        std::snprintf(line, sizeof line, " GrowVol(1, %u, %.2f, %.2f, %.2f, %.2f, at(%.2f, %.2f), towards(%.2f))",
                      volume.id, static_cast<double>(volume.base), static_cast<double>(volume.height),
                      static_cast<double>(volume.top), static_cast<double>(volume.gradient) * 180 / 3.14159265358979,
                      static_cast<double>(volume.at.x), static_cast<double>(volume.at.z),
                      static_cast<double>(volume.towards) * 180 / 3.14159265358979);
        written += line;
      }
      const std::size_t begin = text.find("footprint ->"), end = text.find('\n', begin);
      const Population same_again = grown(text.substr(0, begin) + written + text.substr(end), 6, seed);
      REQUIRE(std::equal(drawn.shoots.begin(), drawn.shoots.end(), same_again.shoots.begin(), same_again.shoots.end(),
                         same));
      REQUIRE(drawn.volumes.size() == same_again.volumes.size());
      for (std::size_t i = 0; i < drawn.volumes.size(); ++i) {
        const GrowthVolume &a = drawn.volumes[i], &b = same_again.volumes[i];
        REQUIRE(a.id == b.id);
        REQUIRE(a.base == b.base);
        REQUIRE(a.height == b.height);
        REQUIRE(a.top == b.top);
        REQUIRE(a.gradient == b.gradient);
        REQUIRE(a.towards == b.towards);
        REQUIRE(a.at == b.at);
        REQUIRE(drawn.environments[i].gravitropism == same_again.environments[i].gravitropism);
      }
    }
  }
}

TEST_CASE("the examples of the language's documentation grow") {
  const std::string page = content(panicle::tests::repository_folder() + "/docs/models/growth/language.md");
  std::size_t examples = 0;
  for (std::size_t at = 0; (at = page.find("```growth\n", at)) != std::string::npos; ++examples) {
    at += 10;
    const std::string text = page.substr(at, page.find("```", at) - at);
    CAPTURE(text);
    CHECK(grown(text, 7).branches > 20);
  }
  CHECK(examples >= 4);
}

TEST_CASE("each internode of the last steps has foliage, also on new branches") {
  const auto leaves = [](const char* rule, std::uint16_t step) {
    const Population population = grown(std::string("tree -> DivFunc(\"sigma1\"){branches}\n") + rule, 6);
    std::size_t count = 0;
    for (const Leaf& leaf : population.leaves) count += leaf.born <= step && leaf.gone > step ? 1 : 0;
    return count;
  };
  const auto shoots = [](std::uint16_t step) {
    return grown("tree -> DivFunc(\"sigma1\"){branches}\n", step).shoots.size();
  };
  for (std::uint16_t step = 1; step <= 6; ++step) CHECK(leaves("k >= 1 -> foliage(3)", step) == 3 * shoots(step));
  CHECK(leaves("k >= 1 -> foliage(3, 2)", 6) == 3 * (shoots(6) + shoots(5)));
  CHECK(leaves("k >= 1 -> foliage(0)", 6) == 0);
}
