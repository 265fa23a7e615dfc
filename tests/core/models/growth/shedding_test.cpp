// Properties of shedding: branches in the shade go, with all that grows on them, and nothing else does.
#include <algorithm>

#include "models/growth/moment.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

Form form_with(const Population& population, float shade_limit) {
  FormHabit habit;
  habit.shade_limit = shade_limit;
  return form_of(population, habit);
}

Moment moment_at(const Population& population, const Form& form, float time) {
  return sound(moment_of(population, form, time, WoodHabit{}, Limits{}, {.pieces = 4}));
}

}  // namespace

TEST_CASE("without a limit no branch is shed, and the higher the limit, the fewer branches are left") {
  const Population population = grown(text_named("oak"), 10);
  CHECK(form_with(population, 0).shed.empty());
  std::uint32_t before = moment_at(population, form_with(population, 0), 10).branches;
  CHECK(before == population.branches);
  for (const float limit : {0.5f, 0.7f, 0.85f}) {
    const Form form = form_with(population, limit);
    const std::uint32_t left = moment_at(population, form, 10).branches;
    CHECK(left < before);
    CHECK(left > 0);
    before = left;
  }
}

TEST_CASE("a shed branch takes its side branches along, and trunks are never shed") {
  const Population population = grown(text_named("oak"), 10);
  const Form form = form_with(population, 0.75f);
  std::size_t shed = 0;
  for (std::size_t q = 0; q < form.shed.size(); ++q) {
    const Shoot& shoot = population.shoots[q];
    if (shoot.trunk) CHECK(form.shed[q] == Form::never);
    if (form.shed[q] != Form::never) ++shed;
    if (shoot.parent < 0 || shoot.trunk) continue;
    const std::uint16_t parent = form.shed[static_cast<std::size_t>(shoot.parent)];
    if (parent != Form::never) CHECK(form.shed[q] <= std::max(parent, shoot.born));
  }
  CHECK(shed > 10);
}

TEST_CASE("a branch is there until it is shed, and no segment is left without its parent") {
  const Population population = grown(text_named("oak"), 10);
  const Form form = form_with(population, 0.75f);
  bool some_fell = false;
  for (const float time : {4.5f, 8.0f, 10.0f}) {
    const Moment moment = moment_at(population, form, time);
    for (std::size_t i = 0; i < moment.segments.size(); ++i) {
      const auto q = static_cast<std::size_t>(moment.axes[i]);
      CHECK(time < static_cast<float>(form.shed[q]));
      some_fell |= form.shed[q] != Form::never;
      const std::int32_t parent = moment.segments[i].parent;
      CHECK(parent < static_cast<std::int32_t>(i));
      if (!population.shoots[q].trunk) REQUIRE(parent >= 0);
      if (parent >= 0) CHECK(moment.segments[static_cast<std::size_t>(parent)].end == moment.segments[i].start);
    }
  }
  CHECK(some_fell);
}
