// The tree (Rodkaew et al. 2003, section 4; docs/models/tree/tree.md): particles in a crown, dense where it is light,
// whose trails to the ground are its branches. Blocks: those of space_request.hpp, and of foliage/flat_leaf.hpp its
// leaf, except for needles. Columns: those of trail_plant.hpp, `organs.sky`, and where `outputs` names `light` the
// array of figure 8: `light.cells` (uint8 a cell, x fastest: 255 is all light), `light.counts` (uint32: along x, y and
// z) and `light.box` (float32: the lowest corner and the edge of a cell, metres). Organs: `leaf`, `particle`. Meshes:
// `stems`, `leaves`, `balls`.
#include "protocol/model.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "foliage/blade.hpp"
#include "foliage/messages.generated.hpp"
#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"
#include "mesh/uv_sphere.hpp"
#include "models/particles/crown_light.hpp"
#include "models/particles/dressing.hpp"
#include "models/particles/grown.hpp"
#include "models/particles/hormone.hpp"
#include "models/particles/refusals.hpp"
#include "models/particles/space_request.hpp"
#include "models/tree/crown.hpp"
#include "models/tree/leaves.hpp"
#include "models/tree/measures/measures.generated.hpp"
#include "models/tree/messages.generated.hpp"
#include "models/tree/parameters.generated.hpp"
#include "plant/fingerprint.hpp"
#include "plant/wood_measures.hpp"
#include "protocol/parameter_values.hpp"

namespace panicle::particles::tree {
namespace {

using TreeValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr std::uint32_t leaf_tag = 0, particle_tag = 1;
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t needle = 0;  // kind of leaf; all others come with the request
constexpr float light_cells = 28;    // along the longest edge of a crown
constexpr float coarse = 2.5f;       // cells wider than this do not resolve the sides of a crown
constexpr std::uint32_t ball_segments = 12;
constexpr float highest = 1e6f;  // greatest height of a way past an obstacle
// The share of the bole without branches, of the height below the crown.
constexpr float bole = 0.6f;
// Twigs with fewer tips are a pixel or two wide, and need not be crooked.
constexpr float straight_tips = 2;
// Reach of the hormone, in heights of the crown; radius of the leader, in widths.
constexpr float hormone_reach = 0.5f, leader = 0.06f;
// Day lengths, hours. From the first to the second of each pair, shoots become longer, and leaves stay attached.
constexpr float shoots_end = 10, shoots_grow = 14, leaves_fall = 9, leaves_stay = 12;
constexpr float shortest_shoots = 0.3f;
constexpr std::array<glm::vec2, 5> egg{{{0.1f, 0}, {0.8f, 0.2f}, {1, 0.45f}, {0.7f, 0.8f}, {0.08f, 1}}};

// The form of the crown for the parameter's number.
Form form_of(std::uint32_t shape) {
  constexpr std::array forms{Form::ellipsoid, Form::ellipsoid, Form::box, Form::cone, Form::spline, Form::mesh};
  return forms[shape];
}

// Returns the shape of the crowns by the parameters, at the age (years) and day length (hours) that they give.
CrownHabit crown_of(const TreeValues& values, std::uint64_t seed) {
  CrownHabit habit;
  habit.form = form_of(values.whole(shape));
  habit.size =
      values.whole(shape) == 0 ? glm::vec3(values[width]) : glm::vec3(values[width], values[height], values[depth]);
  habit.inner = values[inner];
  habit.trunk = values[trunk];
  habit.crowns = values.whole(crowns);
  habit.distance = values[distance];
  habit.stems = values.whole(stems);
  if (values.whole(life) == 1) habit.growth = std::max(values[age] / 100, youngest);
  habit.ragged = values[ragged];
  habit.seed = seed;
  habit.shoots = shortest_shoots + (1 - shortest_shoots) * smooth_step(shoots_end, shoots_grow, values[day]);
  return habit;
}

// The leaves' number, size and poses by the parameters. `light`: direction of most light.
LeafHabit leaves_of(const TreeValues& values, const glm::vec3& light, std::uint64_t seed) {
  LeafHabit habit;
  habit.count = values.whole(leaves);
  habit.size = 0.01f * values[leaf_size];
  habit.attached = smooth_step(leaves_fall, leaves_stay, values[day]);
  habit.needles = values.whole(leaf_kind) == needle;
  habit.light = light;
  habit.seed = seed;
  return habit;
}

// The parts of the tree that measures need.
struct MeasureInput {
  const GrownWood& grown;
  const Region& crown;
  const VoxelLight& light;
  float leaf_area;  // of all leaves
  std::uint32_t leaf_count;
};

// Measures of the branching, the crown and the leaves. `light` is the mean over the places where particles start.
std::vector<float> measures_of(const Plant& plant, const MeasureInput& input) {
  const Branching branching = branching_of(plant.segments);
  auto measures = wood_measures<Measure>(branching, measure_count);
  double lit = 0, starts = 0;
  for (const Trails& trails : input.grown.trails)
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.particle[i] < 0) continue;
      lit += static_cast<double>(input.light.at(trails.places[i]));
      ++starts;
    }
  const glm::vec3 size = input.crown.high() - input.crown.low();
  const double shaded = 0.25 * static_cast<double>(pi * size.x * size.z);
  measures.set(Measure::height, std::max(branching.high, 0.0f));
  measures.set(Measure::crown_volume, input.grown.room);
  measures.set(Measure::trunk_width, 100 * branching.thickest);
  measures.set(Measure::leaf_count, input.leaf_count);
  measures.set(Measure::leaf_area, input.leaf_area);
  measures.set(Measure::leaf_index, shaded > 0 ? input.leaf_area / shaded : nothing);
  measures.set(Measure::light, starts > 0 ? lit / starts : nothing);
  return measures.take();
}

// Adds the mesh of the stems, and those of leaves and particles only if organs use them: a mesh without organs would be
// drawn by itself. Sets the mesh of each organ: its index in `plant.meshes`, −1 for none. Organs before `first_leaf`
// are particles. `sky`: whether to add the share of the sky that vertices and organs see; `root_flare`: how the trunk
// widens at the ground.
void add_meshes(Plant& plant, const GrownWood& grown, const Blade& blade, std::size_t first_leaf, bool sky,
                const RootFlareOptions& root_flare) {
  dress(plant, grown, {.material = "bark", .leaf = leaf_tag, .leaf_area = blade.area, .sky = sky, .foot = root_flare});
  const bool leafy = plant.organs.size() > first_leaf && !blade.mesh.indices.empty();
  const auto add_mesh = [&](PlantMesh mesh) {
    plant.meshes.push_back(std::move(mesh));
    return static_cast<std::int32_t>(plant.meshes.size() - 1);
  };
  const std::int32_t leaf_mesh = leafy ? add_mesh({"leaves", "blade", blade.mesh, {}, {}}) : -1;
  const std::int32_t ball_mesh =
      first_leaf > 0 ? add_mesh({"balls", "skin", make_uv_sphere(ball_segments), {}, {}}) : -1;
  for (Organ& organ : plant.organs) organ.mesh = organ.tag == leaf_tag ? leaf_mesh : ball_mesh;
}

// Adds the columns of the light in the crown: cells as bytes, their numbers along x, y and z, and the grid's corner and
// edge.
void add_light(Plant& plant, const VoxelLight& light) {
  std::vector<std::uint8_t> cells;
  cells.reserve(light.cells().size());
  for (const float share : light.cells())
    cells.push_back(static_cast<std::uint8_t>(255 * std::clamp(share, 0.0f, 1.0f) + 0.5f));
  const std::array<std::uint32_t, 3> counts = light.counts();
  plant.columns.add("light.cells", std::move(cells));
  plant.columns.add("light.counts", std::vector<std::uint32_t>(counts.begin(), counts.end()));
  plant.columns.add("light.box", std::vector<float>{light.low().x, light.low().y, light.low().z, light.edge()});
}

// The crowns by their habit, with the meshes, profile and feet of the request.
Crowns crowns_of(const SpaceRequest& request, const CrownHabit& habit, const Limits& limits,
                 std::vector<std::string>& notes) {
  if (!request.hollow.triangles.empty()) note_seams(request.hollow, "inner", notes);
  Crowns crowns_made = make_crowns(habit, profile_of(request.profile, egg), request.volume, request.hollow,
                                   std::make_shared<QueryBudget>(limits.looks));
  if (!request.targets.empty()) crowns_made.feet = request.targets;
  return crowns_made;
}

// The light in the crowns as a grid of cells; a note if the grid is coarse.
VoxelLight light_of(const SpaceRequest& request, const Crowns& crowns_made, const LightHabit& habit,
                    std::vector<std::string>& notes) {
  const float edge = crowns_made.longest / light_cells;
  VoxelLight light = light_in(crowns_made.outer, {request.rounds, request.obstacles}, habit, edge);
  if (light.edge() > coarse * edge)
    notes.push_back(message(messages::tree::light_coarse, static_cast<int>(crowns_made.longest / light.edge())));
  return light;
}

// Sets how trunks and twigs grow in the space of the crown. `brightest`: direction of most light.
void set_space(SpaceHabit& space, const TreeValues& values, const CrownHabit& habit, const Crowns& crowns_made,
               const glm::vec3& brightest) {
  space.trunk.bend -= values[phototropism] * brightest;
  space.twigs.weep = values[weep];
  space.twigs.weep_tips = values[weep_tips];
  space.twigs.crook_tips = straight_tips;
  space.trunk.bole = bole * habit.growth * habit.trunk;
  space.trunk.height = crowns_made.top;
  space.trunk.reach = 0.25f * habit.growth * (habit.size.x + habit.size.z);
}

// Appends the leaves to the organs.
void add_all_leaves(Plant& plant, const GrownWood& grown, const LeafHabit& habit) {
  const std::size_t first_leaf = plant.organs.size();
  for (std::size_t c = 0; c < grown.trails.size(); ++c)
    add_leaves(plant, grown.trails[c], grown.numbers[c], habit, leaf_tag);
  plant.counts.push_back({"leaves", static_cast<std::uint32_t>(plant.organs.size() - first_leaf)});
}

// The area of all leaves, which are the organs from `first_leaf` on, in m².
float leaf_area_of(const Plant& plant, std::size_t first_leaf, const Blade& blade) {
  float area = 0;
  for (std::size_t i = first_leaf; i < plant.organs.size(); ++i)
    area += blade.area * plant.organs[i].scale * plant.organs[i].scale;
  return area;
}

// Grows a tree: crowns, the light in them, wood from particles that walk down from the crown, then leaves, meshes and
// measures as requested.
Result<Plant> grow(Request& request, const Limits& limits) {
  const FlatLeaf leaf = request.flat_leaf();
  const Result<SpaceRequest> read = read_space(request, limits);
  if (!read) return read.error();
  if (Diagnostic error = check(leaf); error.reason != Reason::none) return error;
  Plant plant;
  const TreeValues values(read->parameters, plant.notes);
  SpaceHabit space = space_habit<Parameter>(values);
  if (Diagnostic error = too_many_parts(limits, 0, std::size_t{space.young()} * values.whole(leaves));
      error.reason != Reason::none)
    return error;
  CrownHabit habit = crown_of(values, read->seed);
  if (habit.form == Form::mesh) note_on(read->volume, habit.form, plant.notes);
  const Crowns crowns_made = crowns_of(read.value(), habit, limits, plant.notes);
  const LightHabit light_habit{towards_sun(values[sun], values[sun_height]), values[sky],
                               values[absorption] / crowns_made.across};
  // The light in the crown, where particles, measures or the output need it.
  const bool by_light_too = values.whole(pattern) == 3 && values[by_light] > 0;
  std::optional<VoxelLight> light;
  if (by_light_too || read->measures || read->light)
    light.emplace(light_of(read.value(), crowns_made, light_habit, plant.notes));
  const Hormone held{values[hormone], crowns_made.top, hormone_reach * crowns_made.height, leader * crowns_made.across,
                     crowns_made.feet};
  const Foliage foliage(crowns_made, by_light_too ? &*light : nullptr, values[by_light], held);

  // The wood: particles walk from the crown to the feet of the trunks.
  const glm::vec3 brightest = glm::normalize((1 - values[sky]) * light_habit.sun + values[sky] * glm::vec3(0, 1, 0));
  set_space(space, values, habit, crowns_made, brightest);
  LeafHabit leaf_habit = leaves_of(values, brightest, read->seed);
  space.leafy = leaf_habit.count > 0 && leaf_habit.attached > 0;
  plant.tags = {"branch"};
  plant.organ_tags = {"leaf", "particle"};
  const Result<GrownWood> ran = grow_wood(plant, foliage, crowns_made.outer, crowns_made.feet, space, read.value(), 0,
                                          highest, particle_tag, limits);
  if (!ran) return ran.error();
  const GrownWood& grown = ran.value();
  leaf_habit.unfolded = grown.unfolded;
  if (Diagnostic error =
          too_many_parts(limits, plant.segments.size(), std::size_t{grown.wood.tally.particles} * leaf_habit.count);
      error.reason != Reason::none)
    return error;
  const std::size_t first_leaf = plant.organs.size();
  add_all_leaves(plant, grown, leaf_habit);

  const Blade blade = leaf_habit.needles ? make_needles(values[leaf_breadth])
                                         : make_blade(leaf, values[leaf_breadth], values[leaf_fold]);
  const bool shapeless = blade.mesh.indices.empty() && plant.organs.size() > first_leaf;
  if (shapeless && (read->measures || read->meshes))
    plant.notes.push_back(message(messages::foliage::leaves_without_shape));
  if (read->measures) {
    const float area = shapeless ? nothing : leaf_area_of(plant, first_leaf, blade);
    const auto leaf_count = static_cast<std::uint32_t>(plant.organs.size() - first_leaf);
    plant.measures = measures_of(plant, {grown, foliage, *light, area, leaf_count});
  }
  if (read->meshes)
    add_meshes(plant, grown, blade, first_leaf, read->sky, {.flare = values[flare], .seed = read->seed});
  if (read->light) add_light(plant, *light);
  set_fingerprints(plant, read->mesh_fingerprint);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"tree", grow};

}  // namespace panicle::particles::tree
