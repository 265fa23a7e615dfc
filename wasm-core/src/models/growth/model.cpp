#include "models/growth/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "foliage/blade.hpp"
#include "foundation/mathematics.hpp"
#include "light/sky_visibility.hpp"
#include "models/growth/foliage.hpp"
#include "models/growth/form.hpp"
#include "models/growth/levels.hpp"
#include "models/growth/measures/measures.generated.hpp"
#include "models/growth/moment.hpp"
#include "models/growth/parameters.generated.hpp"
#include "models/growth/population.hpp"
#include "models/growth/rules.hpp"
#include "plant/fingerprint.hpp"
#include "plant/wood_measures.hpp"
#include "protocol/parameter_values.hpp"
#include "stems/wood.hpp"

namespace panicle::growth {
namespace {

using GrowthValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr std::uint16_t usual_steps = 8;
// kinds of leaf; the shape of all others comes with the request
constexpr std::uint32_t no_leaf = 0, needle = 1, spray = 2;

FormHabit form_habit(const GrowthValues& values, std::uint64_t seed) {
  FormHabit habit;
  habit.shoot = values[shoot];
  habit.order_ratio = values[order_ratio];
  habit.age_ratio = values[age_ratio];
  habit.bole = values[bole];
  habit.trunk_angle = values[trunk_angle];
  habit.branch_angle = values[branch_angle];
  habit.turn = values[turn];
  habit.inertia = values[inertia];
  habit.space = values[space];
  habit.crook = values[crook];
  habit.hang = values[hang];
  habit.leader = values[leader];
  habit.reach = values[reach];
  habit.whorl = values[whorl];
  habit.flat = values[flat];
  habit.cordon = values[cordon];
  habit.seed = seed;
  return habit;
}

std::uint32_t leaves_on_twig(const GrowthValues& values) {
  const std::uint32_t kind = values.whole(leaf_kind);
  return kind == needle || kind == spray ? 1 : values.whole(leaf_twig);
}

LeafHabit leaf_habit(const GrowthValues& values, std::uint64_t seed) {
  const std::uint32_t kind = values.whole(leaf_kind);
  LeafHabit habit;
  habit.size = 0.01f * values[leaf_size] * twig_length(leaves_on_twig(values));
  habit.many = kind == no_leaf ? 0 : values.whole(leaf_many);
  habit.fallen = 0.01f * values[fallen];
  habit.stray = values[leaf_stray];
  habit.needles = kind == needle || kind == spray;
  habit.season = values[season];
  habit.evergreen = values.whole(year) == 1;
  habit.blossoms = values.whole(blossoms);
  habit.blossom_size = 0.01f * values[blossom_size];
  habit.bunches = values.whole(bunches);
  habit.seed = seed;
  return habit;
}

Blade blade_of(const GrowthValues& values, const FlatLeaf& flat) {
  switch (values.whole(leaf_kind)) {
    case needle:
      return make_needles(values[leaf_breadth]);
    case spray:
      return make_spray(values[leaf_breadth]);
    default:
      return make_twig(make_blade(flat, values[leaf_breadth], values[leaf_fold]), leaves_on_twig(values));
  }
}

bool is_leaf(const Organ& organ) { return organ.tag <= fallen_tag; }

// The number of organs of each tag.
std::array<std::uint32_t, organ_tags> tally(const Plant& plant) {
  std::array<std::uint32_t, organ_tags> many{};
  for (const Organ& organ : plant.organs) ++many[organ.tag];
  return many;
}

void add_columns(Plant& plant, const Population& population, const Moment& moment) {
  std::vector<std::uint32_t> shoots, born;
  std::vector<std::uint8_t> orders;
  for (const std::int32_t axis : moment.axes) {
    const Shoot& of = population.shoots[static_cast<std::size_t>(axis)];
    shoots.push_back(static_cast<std::uint32_t>(axis));
    orders.push_back(of.order);
    born.push_back(of.born);
  }
  plant.columns.add("segments.shoot", std::move(shoots));
  plant.columns.add("segments.order", std::move(orders));
  plant.columns.add("segments.born", std::move(born));
  std::vector<std::uint8_t> child(population.volumes.size(), 0);
  for (const Shoot& of : population.shoots)
    if (of.trunk && of.parent >= 0) child[of.volume] = 1;
  plant.columns.add("volumes.child", std::move(child));
  plant.columns.add("volumes.id",
                    column_of<std::uint32_t>(population.volumes, 1,
                                             [](const GrowthVolume& each, std::uint32_t* at) { *at = each.id; }));
  plant.columns.add("volumes.shape",
                    column_of<float>(population.volumes, 5,
                                     [](const GrowthVolume& each, float* at) {
                                       at[0] = each.base;
                                       at[1] = each.height;
                                       at[2] = each.top;
                                       at[3] = each.gradient * 180 / pi;
                                       at[4] = each.towards * 180 / pi;
                                     }),
                    5);
  plant.columns.add("volumes.middle", column_of<float>(population.volumes, 1,
                                                       [](const GrowthVolume& each, float* at) { *at = each.middle; }));
  plant.columns.add("volumes.at",
                    column_of<float>(population.volumes, 2,
                                     [](const GrowthVolume& each, float* at) {
                                       at[0] = each.at.x;
                                       at[1] = each.at.z;
                                     }),
                    2);
}

void measure(Plant& plant, float leaf_area, std::uint32_t leaves_each) {
  const Branching branching = branching_of(plant.segments);
  WoodMeasures<Measure> measures(branching, measure_count);
  double area = 0;
  for (const Organ& organ : plant.organs)
    if (is_leaf(organ)) area += static_cast<double>(leaf_area * organ.scale * organ.scale);
  const double shaded = 0.25 * static_cast<double>(pi * branching.width_x * branching.width_z);
  measures.set(Measure::height, std::max(branching.high, 0.0f));
  measures.set(Measure::trunk_width, 100 * branching.thickest);
  measures.set(Measure::leaf_count,
               static_cast<double>(leaves_each * std::count_if(plant.organs.begin(), plant.organs.end(), is_leaf)));
  measures.set(Measure::leaf_area, area);
  measures.set(Measure::leaf_index, shaded > 0 ? area / shaded : std::numeric_limits<double>::quiet_NaN());
  plant.measures = measures.values();
}

// Adds a mesh that the organs of a kind share, where there are any.
template <class Is>
void add_organ_mesh(Plant& plant, std::string name, std::string material, const Mesh& mesh, Is is) {
  const auto number = static_cast<std::int32_t>(plant.meshes.size());
  bool any = false;
  for (Organ& organ : plant.organs) {
    if (!is(organ) || mesh.indices.empty()) continue;
    organ.mesh = number;
    any = true;
  }
  if (any) plant.meshes.push_back({std::move(name), std::move(material), mesh, {}, {}});
}

void add_meshes(Plant& plant, const Moment& moment, const Blade& blade, bool sky, const RootFlareOptions& foot) {
  const Blade blossom = make_blossom();
  StemMesh stems = sweep_wood(plant.segments, moment.axes, moment.feet, foot);
  Columns columns;
  if (sky) {
    std::vector<Occluder> occluders;
    for (const Organ& organ : plant.organs) {
      if (organ.tag == bunch_tag) continue;  // only a place, without a mesh
      const float area = organ.tag == blossom_tag ? blossom.area : blade.area;
      occluders.push_back({organ.position, 0.5f * area * organ.scale * organ.scale});
    }
    const SkyVisibility open(plant.segments, occluders);
    std::vector<std::uint8_t> of_organs;
    for (const Organ& organ : plant.organs) of_organs.push_back(open.at(organ.position));
    columns.add("sky", open.of(stems.mesh));
    plant.columns.add("organs.sky", std::move(of_organs));
  }
  columns.add("segment", std::move(stems.segment));
  plant.meshes.push_back({"stems", "bark", std::move(stems.mesh), {}, std::move(columns)});
  add_organ_mesh(plant, "leaves", "blade", blade.mesh, [](const Organ& organ) { return organ.tag < blossom_tag; });
  add_organ_mesh(plant, "blossoms", "petal", blossom.mesh, [](const Organ& organ) { return organ.tag == blossom_tag; });
}

void add_levels(Plant& plant, const Moment& moment, float leaf_area, std::size_t count) {
  TreeLevels levels = levels_of(moment, plant.organs, leaf_area, make_blossom().area, count);
  for (PlantMesh& mesh : levels.meshes) plant.meshes.push_back(std::move(mesh));
  plant.columns.add("levels.tolerance", std::move(levels.tolerance));
}

Result<Plant> grow(Request& request, const Limits& limits) {
  request.text("model");
  const FlatLeaf flat = request.flat_leaf();
  const std::uint64_t seed = request.word("seed", 1);
  const bool meshes = request.wants("meshes"), measures = request.wants("measures"), sky = request.wants("sky"),
             mesh_fingerprint = request.wants("mesh_fingerprint"), levels = request.wants("levels");
  const std::uint32_t many_levels = request.word("levels", level_count);
  const std::span<const float> parameters = request.floats("parameters"), about = request.floats("surroundings");
  const bool has_text = request.has("rules");
  const std::string_view text = request.text("rules");
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;
  if (many_levels == 0 || many_levels > level_count)
    return Diagnostic{Reason::bad_request, "The request asks for other than one to four levels.", 0, 0};
  if (!has_text) return Diagnostic{Reason::bad_request, "The request has no rules.", 0, 0};
  if (Diagnostic trouble = check(flat); trouble.reason != Reason::none) return trouble;
  const Result<Surroundings> surroundings = about.empty() ? Surroundings() : Surroundings::of(about);
  if (!surroundings) return surroundings.error();
  Plant plant;
  const GrowthValues values(parameters, plant.notes);
  const auto rules = read_rules(text, limits);
  if (!rules) return rules.error();
  plant.notes.insert(plant.notes.end(), rules->notes.begin(), rules->notes.end());
  const auto steps_in_rules = steps_of(rules.value(), seed, usual_steps);
  if (!steps_in_rules) return steps_in_rules.error();
  const auto count = values.whole(steps) > 0 ? static_cast<std::uint16_t>(values.whole(steps)) : steps_in_rules.value();
  const auto population = populate(rules.value(), seed, count, limits, plant.notes);
  if (!population) return population.error();

  const float time = values[age] / 100 * static_cast<float>(count);
  const Form form = form_of(population.value(), form_habit(values, seed), surroundings.value());
  auto moment = moment_of(population.value(), form, time, {0.001f * values[twig], values[pipe]}, limits);
  if (!moment) return moment.error();
  plant.tags = {"trunk", "branch"};
  plant.organ_tags = {"leaf", "falling", "fallen", "shed", "blossom", "bunch"};
  plant.segments = moment->segments;
  const Diagnostic trouble =
      add_leaves(plant, population.value(), form, moment.value(), time, leaf_habit(values, seed), limits);
  if (trouble.reason != Reason::none) return trouble;
  const Blade blade = blade_of(values, flat);
  const auto many = tally(plant);
  const std::uint32_t leaves = many[leaf_tag] + many[falling_tag] + many[fallen_tag];
  if (meshes && blade.mesh.indices.empty() && leaves > 0)
    plant.notes.emplace_back("The leaves have no shape: the request brings none to make them from.");
  add_columns(plant, population.value(), moment.value());
  // Counts include all leaves of a twig.
  const std::uint32_t each = leaves_on_twig(values);
  plant.counts = {{"branches", moment->branches},
                  {"steps", count},
                  {"segments", static_cast<std::uint32_t>(plant.segments.size())},
                  {"leaves", each * leaves},
                  {"falling", each * (many[falling_tag] + many[fallen_tag])},
                  {"shed", each * many[shed_tag]},
                  {"blossoms", many[blossom_tag]},
                  {"bunches", many[bunch_tag]}};
  if (measures) measure(plant, blade.area, each);
  if (meshes) add_meshes(plant, moment.value(), blade, sky, {.flare = values[flare], .seed = seed});
  if (levels) add_levels(plant, moment.value(), blade.area, many_levels);
  plant.fingerprint = fingerprint_of(plant);
  if (meshes && mesh_fingerprint) plant.mesh_fingerprint = mesh_fingerprint_of(plant);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"growth", grow};

}  // namespace panicle::growth
