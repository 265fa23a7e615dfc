#include "growth.hpp"

#include <string_view>

#include "models/growth/foliage.hpp"
#include "models/growth/levels.hpp"

namespace panicle::bench {
namespace {

using namespace growth;

constexpr std::string_view sigma = "tree -> DivFunc(\"sigma1\"){branches}\n";
constexpr float blade_area = 0.5f;

}  // namespace

double run_growth(Stage stage, std::uint32_t steps, std::uint32_t seed) {
  const Limits limits;
  const auto rules = read_rules(sigma, limits);
  if (!rules) return -1;
  if (stage == Stage::text) return static_cast<double>(rules->of_shoots.size());
  Plant plant;
  const auto population = populate(rules.value(), seed, static_cast<std::uint16_t>(steps), limits, plant.notes);
  if (!population) return -1;
  if (stage == Stage::population) return population->branches;
  FormHabit habit;
  habit.seed = seed;
  const Form form = form_of(population.value(), habit);
  if (stage == Stage::form) return static_cast<double>(form.nodes.size());
  const auto time = static_cast<float>(steps);
  const auto moment = moment_of(population.value(), form, time, {}, limits);
  if (!moment) return -1;
  if (stage == Stage::moment) return static_cast<double>(moment->segments.size());
  LeafHabit leaves;
  leaves.many = 3;
  leaves.seed = seed;
  if (add_leaves(plant, population.value(), form, moment.value(), time, leaves, limits).reason != Reason::none)
    return -1;
  if (stage == Stage::leaves) return static_cast<double>(plant.organs.size());
  const TreeLevels levels = levels_of(moment.value(), plant.organs, blade_area, 0);
  const std::size_t triangles = levels.meshes[0].mesh.indices.size() / 3;
  return static_cast<double>(triangles);
}

}  // namespace panicle::bench
