#include "models/growth/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "foliage/blade.hpp"
#include "foliage/messages.generated.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "light/sky_visibility.hpp"
#include "models/growth/coarse_leaf.hpp"
#include "models/growth/foliage.hpp"
#include "models/growth/form.hpp"
#include "models/growth/levels.hpp"
#include "models/growth/measures/measures.generated.hpp"
#include "models/growth/messages.generated.hpp"
#include "models/growth/moment.hpp"
#include "models/growth/parameters.generated.hpp"
#include "models/growth/population.hpp"
#include "models/growth/rules.hpp"
#include "models/growth/stubs.hpp"
#include "models/growth/twig_shapes.hpp"
#include "plant/fingerprint.hpp"
#include "plant/wood_measures.hpp"
#include "protocol/common_request.hpp"
#include "protocol/parameter_values.hpp"
#include "stems/wood.hpp"

namespace panicle::growth {
namespace {

using GrowthValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr std::uint16_t usual_steps = 8;
// kinds of leaf; the shape of all others comes with the request
constexpr std::uint32_t no_leaf = 0, needle = 1, spray = 2;
constexpr std::uint32_t max_leaf_triangles = 12;  // of a leaf of a twig, of which a tree has hundreds of thousands
constexpr float bare_from = 0.75f;                // of the year: leaves fall, and buds show

// Collects the parameters that the shoots' form depends on.
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
  habit.whorl_size = values.whole(whorl_size);
  habit.shade_limit = values[shade_limit];
  habit.seed = seed;
  return habit;
}

// Collects the parameters of shoots' curves.
CurveHabit curve_habit(const GrowthValues& values, std::uint64_t seed) {
  return {values.whole(curve), values[gnarl], values[sag], values[rise], values[taper], seed};
}

// Collects the parameters of twigs; lengths in lengths of a twig.
TwigHabit twig_habit(const GrowthValues& values) {
  constexpr float mean_twig = 0.85f, mean_leaf = 0.86f;         // over the longest
  constexpr float thickness = 0.75f, needled_thickness = 0.4f;  // of a twig at its base, centimetres
  const std::uint32_t kind = values.whole(leaf_kind);
  const float length = values[twig_length];
  TwigHabit habit;
  habit.shapes = kind == no_leaf ? 0 : values.whole(twigs);
  habit.phyllotaxis = values.choice<Phyllotaxis>(phyllotaxis);
  habit.leaves = values.whole(leaf_twig);
  habit.sides = values.whole(twig_sides);
  habit.leaf = values[leaf_size] / (mean_twig * mean_leaf * length);
  habit.bud = 0.1f * values[bud] / (mean_twig * length);
  habit.spurs = values[spurs];
  habit.crowd = values[twig_crowd];
  habit.droop = values[twig_droop];
  habit.stray = values[leaf_stray];
  habit.foliage = kind == needle  ? TwigHabit::Leaf::pair
                  : kind == spray ? TwigHabit::Leaf::needle
                                  : TwigHabit::Leaf::flat;
  habit.needle_breadth = values[leaf_breadth];
  habit.thickness = (habit.foliage == TwigHabit::Leaf::flat ? thickness : needled_thickness) / length;
  return habit;
}

// The number of leaves that one leaf organ has: needles and sprays are one.
std::uint32_t leaves_on_twig(const GrowthValues& values) {
  const std::uint32_t kind = values.whole(leaf_kind);
  return kind == needle || kind == spray ? 1 : values.whole(leaf_twig);
}

// Collects the parameters that the leaves, blossoms and bunches depend on; lengths in metres.
LeafHabit leaf_habit(const GrowthValues& values, std::uint64_t seed) {
  const std::uint32_t kind = values.whole(leaf_kind);
  LeafHabit habit;
  habit.size = 0.01f * values[leaf_size] * panicle::twig_length(leaves_on_twig(values));
  habit.many = kind == no_leaf ? 0 : values.whole(leaf_many);
  habit.fallen = 0.01f * values[fallen];
  habit.stray = values[leaf_stray];
  habit.needles = kind == needle || kind == spray;
  habit.season = values[season];
  habit.evergreen = values.whole(year) == 1;
  habit.blossoms = values.whole(blossoms);
  habit.blossom_size = 0.01f * values[blossom_size];
  habit.bunches = values.whole(bunches);
  habit.twigs = twig_habit(values);
  habit.twig_length = 0.01f * values[twig_length];
  habit.lift = values[twig_lift];
  habit.seed = seed;
  return habit;
}

// Makes the shared mesh of leaves by the parameters: needles, a spray of needles, or a twig of flat leaves.
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

// Whether an organ is a leaf, on a twig or on the ground.
bool is_leaf(const Organ& organ) { return organ.tag <= fallen_tag; }

// The leaves of organs: one shape for all, or the shapes of twigs.
struct Leafage {
  Blade blade;                    // of an organ without twigs; of one leaf of a twig
  std::vector<TwigShape> shapes;  // of twigs, see Organ::mesh in foliage.hpp; empty: none
  std::uint32_t leaves_each = 1;  // of an organ without twigs

  // The area of an organ's leaves at scale 1, square metres, and their number.
  float area(const Organ& organ) const { return shapes.empty() ? blade.area : shape(organ).area; }
  std::uint32_t leaves(const Organ& organ) const { return shapes.empty() ? leaves_each : shape(organ).leaf_count; }
  const TwigShape& shape(const Organ& organ) const { return shapes[static_cast<std::size_t>(organ.mesh)]; }
};

// Builds the shared shapes of leaves and twigs. Buds are built where there are leafless twigs.
Leafage leafage_of(const GrowthValues& values, const LeafHabit& habit, const FlatLeaf& flat) {
  if (habit.twigs.shapes == 0) return {blade_of(values, flat), {}, leaves_on_twig(values)};
  const bool flat_leaves = habit.twigs.foliage == TwigHabit::Leaf::flat;
  const CoarseLeaf coarse = coarse_leaf(flat, max_leaf_triangles);
  Leafage leafage{
      flat_leaves ? make_blade(coarse.view(flat), values[leaf_breadth], values[leaf_fold]) : Blade{}, {}, 1};
  const std::vector<float> unfolded = unfolded_by_shape(habit);
  const bool with_buds = !habit.evergreen && (unfolded.back() < 1 || habit.season > bare_from);
  leafage.shapes = twig_shapes(habit.twigs, leafage.blade, unfolded, with_buds);
  return leafage;
}

// Adds the columns of segments and volumes, which the header lists.
void add_columns(Plant& plant, const Population& population, const Form& form, const Moment& moment) {
  std::vector<std::uint32_t> shoots, born;
  std::vector<std::uint8_t> orders;
  for (const std::int32_t axis : moment.axes) {
    const Shoot& shoot = population.shoots[static_cast<std::size_t>(axis)];
    shoots.push_back(static_cast<std::uint32_t>(axis));
    orders.push_back(shoot.order);
    born.push_back(shoot.born);
  }
  plant.columns.add("segments.shoot", std::move(shoots));
  plant.columns.add("segments.order", std::move(orders));
  plant.columns.add("segments.born", std::move(born));
  plant.columns.add("shoots.address",
                    column_of<std::uint32_t>(population.addresses, 2,
                                             [](std::uint64_t address, std::uint32_t* at) {
                                               at[0] = static_cast<std::uint32_t>(address);
                                               at[1] = static_cast<std::uint32_t>(address >> 32);
                                             }),
                    2);
  if (std::vector<std::uint8_t> dead = dead_segments(moment, form); !dead.empty())
    plant.columns.add("segments.dead", std::move(dead));
  std::vector<std::uint8_t> child(population.volumes.size(), 0);
  for (const Shoot& shoot : population.shoots)
    if (shoot.trunk && shoot.parent >= 0) child[shoot.volume] = 1;
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

// Measures wood, twigs and leaves. The leaf index is the leaves' area over that of an ellipse as wide as the branches.
void measure(Plant& plant, const Leafage& leafage) {
  const Branching branching = branching_of(plant.segments);
  auto measures = wood_measures<Measure>(branching, measure_count);
  double area = 0;
  std::uint64_t leaves = 0, twig_tips = 0;
  for (const Organ& organ : plant.organs) {
    if (organ.tag == twig_tag) twig_tips += leafage.shape(organ).tips;
    if (!is_leaf(organ)) continue;
    area += static_cast<double>(leafage.area(organ) * organ.scale * organ.scale);
    leaves += leafage.leaves(organ);
  }
  const double shaded = 0.25 * static_cast<double>(pi * branching.width_x * branching.width_z);
  measures.set(Measure::height, std::max(branching.high, 0.0f));
  measures.set(Measure::trunk_width, 100 * branching.thickest);
  measures.set(Measure::leaf_count, static_cast<double>(leaves));
  measures.set(Measure::twig_tips, static_cast<double>(twig_tips));
  measures.set(Measure::leaf_area, area);
  measures.set(Measure::leaf_index, shaded > 0 ? area / shaded : std::numeric_limits<double>::quiet_NaN());
  plant.measures = measures.take();
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

// Adds the meshes of twigs and of their leaves, one of each a shape, and of a twig's leaves on the ground; sets the
// meshes of their organs, which held shapes before.
void add_twig_meshes(Plant& plant, const Leafage& leafage, const TwigHabit& habit) {
  constexpr std::int32_t unset = -1;
  const std::size_t count = leafage.shapes.size();
  std::vector<std::int32_t> wood(count, unset), leaves(count, unset), litter(count, unset);
  const auto mesh_for = [&](std::int32_t& number, std::string name, const char* material, auto make) {
    if (number != unset) return number;
    number = static_cast<std::int32_t>(plant.meshes.size());
    plant.meshes.push_back({std::move(name), material, make(), {}, {}});
    return number;
  };
  for (Organ& organ : plant.organs) {
    if (organ.tag == blossom_tag || organ.tag == bunch_tag) continue;
    const auto shape = static_cast<std::size_t>(organ.mesh);
    const std::string number = std::to_string(shape + 1);
    const TwigShape& twig = leafage.shapes[shape];
    organ.mesh = unset;
    if (organ.tag == twig_tag) {
      organ.mesh = mesh_for(wood[shape], "twig " + number, "twig", [&] { return twig.wood; });
    } else if (organ.tag == fallen_tag || organ.tag == shed_tag) {
      if (!leafage.blade.mesh.indices.empty())
        organ.mesh = mesh_for(litter[shape], "litter " + number, "blade",
                              [&] { return leaf_litter(habit, leafage.blade, twig.leaf_count); });
    } else if (!twig.leaves.indices.empty()) {
      organ.mesh = mesh_for(leaves[shape], "leaves " + number, "blade", [&] { return twig.leaves; });
    }
  }
}

// Adds the meshes of wood, leaves and blossoms, and with `sky` how much sky each vertex of the wood and each organ
// sees.
void add_meshes(Plant& plant, const Moment& moment, const Leafage& leafage, const TwigHabit& twig, bool sky,
                const RootFlareOptions& foot) {
  const Blade blossom = make_blossom();
  StemMesh stems = sweep_wood(plant.segments, moment.axes, moment.feet, foot);
  Columns columns;
  if (sky) {
    std::vector<Occluder> occluders;
    for (const Organ& organ : plant.organs) {
      // A bunch is only a place, without a mesh; a twig's wood hides little.
      if (organ.tag == bunch_tag || organ.tag == twig_tag) continue;
      const float area = organ.tag == blossom_tag ? blossom.area : leafage.area(organ);
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
  if (leafage.shapes.empty())
    add_organ_mesh(plant, "leaves", "blade", leafage.blade.mesh,
                   [](const Organ& organ) { return organ.tag < blossom_tag; });
  else
    add_twig_meshes(plant, leafage, twig);
  add_organ_mesh(plant, "blossoms", "petal", blossom.mesh, [](const Organ& organ) { return organ.tag == blossom_tag; });
}

// Adds the ends of cut and broken shoots.
void add_stubs(Plant& plant, const Moment& moment, const Form& form, std::uint64_t seed) {
  StubMeshes stubs = stub_meshes(moment, form, seed);
  if (!stubs.cuts.indices.empty()) plant.meshes.push_back({"cuts", "cut", std::move(stubs.cuts), {}, {}});
  if (!stubs.splinters.indices.empty())
    plant.meshes.push_back({"splinters", "dead", std::move(stubs.splinters), {}, {}});
}

// Adds the levels of detail and the column of their tolerances.
void add_levels(Plant& plant, const Moment& moment, const Leafage& leafage, std::size_t count) {
  // All organs of leaves count as equal: with the mean area of the shapes.
  float area = leafage.blade.area;
  if (!leafage.shapes.empty()) {
    area = 0;
    std::size_t leaves = 0;
    for (const Organ& organ : plant.organs) {
      if (organ.tag != leaf_tag) continue;
      area += leafage.area(organ);
      ++leaves;
    }
    area /= static_cast<float>(std::max<std::size_t>(leaves, 1));
  }
  TreeLevels levels = levels_of(moment, plant.organs, area, make_blossom().area, count);
  for (PlantMesh& mesh : levels.meshes) plant.meshes.push_back(std::move(mesh));
  plant.columns.add("levels.tolerance", std::move(levels.tolerance));
}

struct GrowthRequest : CommonRequest {
  explicit GrowthRequest(const CommonRequest& common) : CommonRequest(common) {}

  FlatLeaf leaf;
  std::string_view rules;
  Surroundings surroundings;
  std::vector<BranchEdit> edits;
  std::uint32_t levels = 0;  // number of requested levels
};

// Reads the blocks of a request. Errors: bad_request; those of check(FlatLeaf), read_edits and Surroundings::of.
Result<GrowthRequest> read_request(Request& blocks) {
  GrowthRequest request(read_common(blocks));
  request.leaf = blocks.flat_leaf();
  request.rules = blocks.required_text("rules");
  const std::uint32_t levels = blocks.word("levels", level_count);
  if (blocks.wants("levels")) request.levels = levels;
  const std::span<const float> surroundings = blocks.floats("surroundings");
  Result<std::vector<BranchEdit>> edits = read_edits(blocks.words("edits"), blocks.floats("edits.points"));
  if (Diagnostic error = blocks.trouble(); error.reason != Reason::none) return error;
  if (levels == 0 || levels > level_count) return bad_request(message(messages::growth::levels_out_of_range, levels));
  if (Diagnostic error = check(request.leaf); error.reason != Reason::none) return error;
  if (!edits) return edits.error();
  request.edits = std::move(edits.value());
  if (surroundings.empty()) return request;
  Result<Surroundings> read = Surroundings::of(surroundings);
  if (!read) return read.error();
  request.surroundings = std::move(read.value());
  return request;
}

// Adds the counts, which include all leaves of a twig.
void add_counts(Plant& plant, const Moment& moment, std::uint32_t step_count, const Leafage& leafage) {
  std::array<std::uint32_t, organ_tags> many{}, leaves{};
  for (const Organ& organ : plant.organs) {
    ++many[organ.tag];
    if (organ.tag < blossom_tag) leaves[organ.tag] += leafage.leaves(organ);
  }
  const std::uint32_t falling = leaves[falling_tag] + leaves[fallen_tag];
  plant.counts = {{"branches", moment.branches},
                  {"steps", step_count},
                  {"segments", static_cast<std::uint32_t>(plant.segments.size())},
                  {"twigs", many[twig_tag]},
                  {"leaves", leaves[leaf_tag] + falling},
                  {"falling", falling},
                  {"shed", leaves[shed_tag]},
                  {"blossoms", many[blossom_tag]},
                  {"bunches", many[bunch_tag]}};
}

// Grows a plant from growth rules: populates the volumes with shoots, gives the shoots their form, takes the moment of
// the requested age, and adds leaves, meshes and measures.
Result<Plant> grow(Request& blocks, const Limits& limits) {
  const Result<GrowthRequest> read = read_request(blocks);
  if (!read) return read.error();
  const GrowthRequest& request = read.value();
  Plant plant;
  const GrowthValues values(request.parameters, plant.notes);
  const std::uint32_t random_stream = values.whole(stream);
  const std::uint64_t seed = random_stream > 0 ? hash_combine(request.seed, random_stream) : request.seed;
  const auto rules = read_rules(request.rules, limits);
  if (!rules) return rules.error();
  plant.notes.insert(plant.notes.end(), rules->notes.begin(), rules->notes.end());
  const auto steps_in_rules = steps_of(rules.value(), seed, usual_steps);
  if (!steps_in_rules) return steps_in_rules.error();
  const auto count = values.whole(steps) > 0 ? static_cast<std::uint16_t>(values.whole(steps)) : steps_in_rules.value();
  const auto population = populate(rules.value(), seed, count, limits, plant.notes);
  if (!population) return population.error();

  const float time = values[age] / 100 * static_cast<float>(count);
  const ShootEdits edits(population.value(), request.edits);
  if (limits.budget != nullptr && !request.edits.empty()) limits.budget->spend(population.value().shoots.size());
  if (edits.unknown() > 0) plant.notes.push_back(message(messages::growth::unknown_shoots, edits.unknown()));
  const Form form = form_of(population.value(), form_habit(values, seed), request.surroundings, edits);
  const auto moment = moment_of(population.value(), form, time, {0.001f * values[twig], values[pipe]}, limits,
                                curve_habit(values, seed));
  if (!moment) return moment.error();
  plant.tags = {"trunk", "branch"};
  plant.organ_tags = {"leaf", "falling", "fallen", "shed", "blossom", "bunch", "twig"};
  plant.segments = moment->segments;
  const LeafHabit leaves = leaf_habit(values, seed);
  const Diagnostic error = add_leaves(plant, population.value(), form, moment.value(), time, leaves, limits);
  if (error.reason != Reason::none) return error;
  const Leafage leafage = leafage_of(values, leaves, request.leaf);
  const bool shapeless = leafage.blade.mesh.indices.empty() && leaves.twigs.foliage == TwigHabit::Leaf::flat;
  if (request.meshes && shapeless && std::any_of(plant.organs.begin(), plant.organs.end(), is_leaf))
    plant.notes.push_back(message(messages::foliage::leaves_without_shape));
  add_columns(plant, population.value(), form, moment.value());
  add_counts(plant, moment.value(), count, leafage);
  if (request.measures) measure(plant, leafage);
  if (request.levels > 0) add_levels(plant, moment.value(), leafage, request.levels);
  std::vector<PlantMesh> levels = std::move(plant.meshes);
  plant.meshes.clear();
  if (request.meshes) {
    add_meshes(plant, moment.value(), leafage, leaves.twigs, request.sky, {.flare = values[flare], .seed = seed});
    add_stubs(plant, moment.value(), form, seed);
  } else {
    for (Organ& organ : plant.organs) organ.mesh = -1;
  }
  for (PlantMesh& level : levels) plant.meshes.push_back(std::move(level));
  set_fingerprints(plant, request.mesh_fingerprint);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"growth", grow};

}  // namespace panicle::growth
