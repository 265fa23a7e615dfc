// The tree (Rodkaew et al. 2003, section 4; docs/models/tree/tree.md): particles in a crown, dense where it is light, whose
// trails to the ground are its branches. Blocks: those of space_request.hpp. Columns: those of trail_plant.hpp, and
// `organs.sky`. Organs: `leaf`, `particle`. Meshes: `stems`, `leaves`, `balls`.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "foundation/easing.hpp"
#include "geometry/ball.hpp"
#include "models/particles/crown_light.hpp"
#include "models/particles/dressing.hpp"
#include "models/particles/scatter.hpp"
#include "models/particles/space_request.hpp"
#include "models/particles/tree/crown.hpp"
#include "models/particles/tree/leaves.hpp"
#include "models/particles/tree/parameters.generated.hpp"
#include "models/particles/values.hpp"
#include "models/particles/wood.hpp"
#include "plant/model.hpp"
#include "plant/plain.hpp"

namespace panicle::particles::tree {
namespace {

using TreeValues = Values<Parameter, parameter_table>;
using enum Parameter;

constexpr std::uint32_t leaf_tag = 0, particle_tag = 1;
constexpr std::uint32_t light_cells = 36;
constexpr std::uint32_t ball_segments = 12;
constexpr float least_ball = 0.06f;  // of a particle, in spacings
constexpr float youngest = 0.02f;    // size of a tree that has hardly grown
// Hours of day between which shoots grow longer, and leaves stay.
constexpr float shoots_end = 10, shoots_grow = 14, leaves_fall = 9, leaves_stay = 12;
constexpr float shortest_shoots = 0.3f;
constexpr std::array<glm::vec2, 5> egg{{{0.1f, 0}, {0.8f, 0.2f}, {1, 0.45f}, {0.7f, 0.8f}, {0.08f, 1}}};

Form form_of(std::uint32_t shape) {
  constexpr std::array forms{Form::ellipsoid, Form::ellipsoid, Form::box, Form::cone, Form::spline, Form::mesh};
  return forms[shape];
}

CrownHabit crown_of(const TreeValues& values) {
  CrownHabit habit;
  habit.form = form_of(values.whole(shape));
  habit.size = values.whole(shape) == 0 ? glm::vec3(values[width]) : glm::vec3(values[width], values[height], values[depth]);
  habit.inner = values[inner];
  habit.trunk = values[trunk];
  habit.crowns = values.whole(crowns);
  habit.distance = values[distance];
  habit.stems = values.whole(stems);
  if (values.whole(life) == 1) habit.growth = std::max(values[age] / 100, youngest);
  habit.shoots = shortest_shoots + (1 - shortest_shoots) * smooth_step(shoots_end, shoots_grow, values[day]);
  return habit;
}

Motion motion_of(const TreeValues& values) {
  return {static_cast<double>(values[energy]),
          {.step = values[step],
           .merge = values[merge],
           .neighbourhood = values[neighbourhood],
           .pull = values[pull],
           .printed = values.whole(rule) == 1}};
}

Girth girth_of(const TreeValues& values, float growth) {
  constexpr std::array laws{WidthLaw::linear, WidthLaw::square_root, WidthLaw::power, WidthLaw::power};
  const std::uint32_t chosen = values.whole(law);
  return {laws[chosen], chosen == 2 ? 1.0f / 3 : values[exponent], 0.5f * growth * values[girth], 0.0005f * values[twig]};
}

// What bends the way of particles is the other way round than what bends the tips that they come from.
TrunkHabit trunk_of(const TreeValues& values, const CrownHabit& crown, const glm::vec3& light) {
  TrunkHabit habit;
  habit.slant = values[slant];
  habit.bend = values[gravitropism] * glm::vec3(0, 1, 0) - values[phototropism] * light;
  habit.reach = 0.25f * crown.growth * (crown.size.x + crown.size.z);
  return habit;
}

Result<Plant> grow(Request& request, const Limits&) {
  const Result<SpaceRequest> read = read_space(request);
  if (!read) return read.error();
  Plant plant;
  const TreeValues values(read->parameters, plant.notes);
  CrownHabit habit = crown_of(values);
  if (habit.form == Form::mesh) {
    if (read->volume.triangles.empty()) {
      habit.form = Form::ellipsoid;
      plant.notes.push_back("There is no mesh, so the crown is an ellipsoid; drop a closed mesh.");
    } else {
      for (std::string& remark : remarks_on(read->volume)) plant.notes.push_back(std::move(remark));
    }
  }
  const std::vector<glm::vec2> profile =
      spline_through(read->profile.size() > 1 ? std::span<const glm::vec2>(read->profile) : std::span<const glm::vec2>(egg));
  Crowns crowns_made = make_crowns(habit, profile, read->volume);
  if (!read->targets.empty()) crowns_made.feet = read->targets;

  const LightHabit light_habit{towards_sun(values[sun], values[sun_height]), values[sky],
                               values[absorption] / crowns_made.across};
  const VoxelLight light = light_in(crowns_made.outer, light_habit, light_cells);
  const bool by_light_too = values.whole(pattern) == 3;
  const Foliage foliage(crowns_made, by_light_too ? &light : nullptr, values[by_light], values[hormone]);

  // A young tree has the grown one's spacing, and so fewer particles.
  const float spacing = spacing_of(foliage, values.whole(particles)) / habit.growth;
  const auto count = static_cast<std::uint32_t>(values[particles] * habit.growth * habit.growth * habit.growth + 0.5f);
  constexpr std::array patterns{Pattern::uniform, Pattern::jittered, Pattern::blue, Pattern::blue};
  std::vector<glm::vec3> starts = scatter(foliage, patterns[values.whole(pattern)], count, spacing, read->seed);
  const Obstacles obstacles(read->obstacles, 0.1f * spacing, 0, 1e6f);
  std::erase_if(starts, [&](const glm::vec3& start) { return obstacles.contains(start); });

  const glm::vec3 brightest = glm::normalize((1 - values[sky]) * light_habit.sun + values[sky] * glm::vec3(0, 1, 0));
  const Girth girth_now = girth_of(values, habit.growth);
  const Wood wood = run(starts, crowns_made.feet, spacing, motion_of(values), trunk_of(values, habit, brightest),
                        crowns_made.outer, obstacles);
  const bool running = values.whole(life) == 0 && values[age] < 100;
  const auto now = running ? static_cast<std::uint32_t>(values[age] / 100 * static_cast<float>(wood.last)) : wood.last;
  std::vector<Trails> young;
  for (const Trails& trails : wood.crowds) young.push_back(running ? until(trails, now) : trails);

  plant.tags = {"branch"};
  plant.organ_tags = {"leaf", "particle"};
  const auto numbers = add_trails(plant, young, wood.all, girth_now, {}, wood.tally, 0);
  LeafHabit leaf_habit;
  leaf_habit.count = values.whole(leaves);
  leaf_habit.size = 0.01f * values[leaf_size];
  leaf_habit.kept = smooth_step(leaves_fall, leaves_stay, values[day]);
  leaf_habit.needles = values.choice<LeafShape>(leaf_shape) == LeafShape::needle;
  leaf_habit.light = brightest;
  leaf_habit.seed = read->seed;
  for (std::size_t c = 0; c < young.size(); ++c) add_leaves(plant, young[c], numbers[c], leaf_habit, leaf_tag);
  const std::size_t leaf_count = plant.organs.size();
  if (running)
    for (std::size_t c = 0; c < young.size(); ++c)
      add_travellers(plant, wood.crowds[c], now, wood.all[c], girth_now, least_ball * spacing, particle_tag);
  plant.counts.push_back({"leaves", static_cast<std::uint32_t>(leaf_count)});
  if (starts.empty()) plant.notes.push_back("No particle found room between the boundaries; make the crown larger.");
  if (wood.unreachable > 0)
    plant.notes.push_back(std::to_string(wood.unreachable) + " particles have no way past the obstacles and were left out.");

  if (read->meshes) {
    const Blade blade = make_blade(values.choice<LeafShape>(leaf_shape), values[leaf_width], values[leaf_fold]);
    std::unique_ptr<VoxelLight> open;
    if (read->sky) open = std::make_unique<VoxelLight>(openness(plant, leaf_tag, blade.area));
    if (open) plant.columns.add("organs.sky", sky_of_organs(plant, *open));
    add_stems(plant, axes_of(young, numbers, plant.segments.size()), "bark", open.get());
    for (Organ& organ : plant.organs) organ.mesh = organ.tag == leaf_tag ? 1 : 2;
    plant.meshes.push_back({"leaves", "blade", blade.mesh, {}, {}});
    plant.meshes.push_back({"balls", "skin", make_ball(ball_segments), {}, {}});
  }
  plant.fingerprint = fingerprint_of(plant);
  if (read->meshes && read->mesh_fingerprint) plant.mesh_fingerprint = mesh_fingerprint_of(plant);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"tree", grow};

}  // namespace panicle::particles::tree
