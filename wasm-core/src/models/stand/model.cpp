#include "models/stand/model.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foundation/fingerprint.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/stand/measures/measures.generated.hpp"
#include "models/stand/messages.generated.hpp"
#include "models/stand/parameters.generated.hpp"
#include "models/stand/places.hpp"
#include "models/stand/plan.hpp"
#include "models/stand/surroundings.hpp"
#include "models/stand/trellises.hpp"
#include "plant/fingerprint.hpp"
#include "plant/measures.hpp"
#include "protocol/common_request.hpp"
#include "protocol/parameter_values.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::stand {
namespace {

using StandValues = Values<Parameter, parameter_table>;
using enum Parameter;

// All kinds of plants of a plan, layer after layer: the number of a kind is its index here.
std::vector<const Kind*> kinds_of(const Plan& plan) {
  std::vector<const Kind*> kinds;
  for (const Layer& layer : plan.layers)
    for (const Kind& kind : layer.kinds) kinds.push_back(&kind);
  return kinds;
}

// The number of different names: a species may be listed in several lines.
std::uint32_t count_names(const std::vector<const Kind*>& kinds) {
  std::vector<std::string_view> names;
  for (const Kind* kind : kinds) names.push_back(kind->name);
  std::sort(names.begin(), names.end());
  return static_cast<std::uint32_t>(std::unique(names.begin(), names.end()) - names.begin());
}

// Adds the columns of the kinds of plants: names, seeds, sizes of crowns, settings, and their places in the text.
void add_kinds(Plant& plant, const std::vector<const Kind*>& kinds) {
  std::string names, spots, keys, words;
  std::vector<std::uint32_t> places, seeds, settings, setting_places;
  std::vector<float> crowns;
  for (std::uint32_t i = 0; i < kinds.size(); ++i) {
    const Kind& kind = *kinds[i];
    names.append(kind.name).append("\n");
    spots.append(kind.spot).append("\n");
    places.insert(places.end(), {kind.place.line, kind.place.column});
    seeds.push_back(kind.seeds);
    crowns.insert(crowns.end(), {kind.width, kind.height});
    for (const Setting& setting : kind.settings) {
      settings.push_back(i);
      keys.append(setting.key).append("\n");
      words.append(setting.word).append("\n");
      setting_places.insert(setting_places.end(), {setting.place.line, setting.place.column});
    }
  }
  Columns& columns = plant.columns;
  columns.add("kinds.names", names);
  columns.add("kinds.spot", spots);
  columns.add("kinds.place", std::move(places), 2);
  columns.add("kinds.seeds", std::move(seeds));
  columns.add("kinds.crown", std::move(crowns), 2);
  columns.add("settings.kind", std::move(settings));
  columns.add("settings.keys", keys);
  columns.add("settings.words", words);
  columns.add("settings.place", std::move(setting_places), 2);
}

// A column with one value for each plant: `of(plant)`.
template <class Value, class Of>
std::vector<Value> column_by(const std::vector<Placement>& plants, Of of) {
  return column_of<Value>(plants, 1, [&](const Placement& plant, Value* at) { *at = of(plant); });
}

// Adds the columns of all plants, and extends the fingerprint by their seeds, settings and surroundings.
void add_plants(Plant& plant, const std::vector<Placement>& plants, std::vector<float> surroundings) {
  std::size_t width = 1;
  for (const Placement& placement : plants) width = std::max(width, placement.settings.size());
  auto values = column_of<float>(plants, static_cast<std::uint32_t>(width), [&](const Placement& placement, float* at) {
    std::fill(at, at + width, std::numeric_limits<float>::quiet_NaN());
    std::copy(placement.settings.begin(), placement.settings.end(), at);
  });
  Fingerprint print;
  print.add(static_cast<std::uint32_t>(plant.fingerprint));
  print.add(static_cast<std::uint32_t>(plant.fingerprint >> 32));
  for (const Placement& placement : plants) print.add(placement.seed);
  print.add(std::span<const float>(values));
  print.add(std::span<const float>(surroundings));
  plant.fingerprint = print.value();
  Columns& columns = plant.columns;
  columns.add("plants.kind",
              column_by<std::uint32_t>(plants, [](const Placement& placement) { return placement.kind; }));
  columns.add("plants.seed",
              column_by<std::uint32_t>(plants, [](const Placement& placement) { return placement.seed; }));
  columns.add("plants.bearer",
              column_by<std::int32_t>(plants, [](const Placement& placement) { return placement.parent; }));
  columns.add("plants.at",
              column_of<float>(plants, 3, [](const Placement& placement, float* at) { put(placement.at, at); }), 3);
  columns.add("plants.scale", column_by<float>(plants, [](const Placement& placement) { return placement.scale; }));
  columns.add("plants.turn", column_by<float>(plants, [](const Placement& placement) { return placement.turn; }));
  columns.add("plants.values", std::move(values), static_cast<std::uint32_t>(width));
  columns.add("plants.surroundings", std::move(surroundings), surrounding);
}

// Adds the placements as organs, without meshes, tagged by their kinds.
void add_organs(Plant& plant, const std::vector<Placement>& plants, const std::vector<const Kind*>& kinds) {
  for (const Kind* const kind : kinds) plant.organ_tags.push_back(kind->name);
  for (const Placement& placement : plants) {
    Organ organ;
    organ.tag = placement.kind;
    organ.position = placement.at;
    // A turn takes +x to (cos, 0, sin): about +y in the negative direction.
    const SinCos half = sincos_degrees(-0.5f * placement.turn);
    organ.rotation = {0, half.sine, 0, half.cosine};
    organ.scale = placement.scale;
    plant.organs.push_back(organ);
  }
}

// The mean distance from each plant on the ground to its nearest neighbour, in metres; `area` of the ground in m² gives
// a first guess. NaN with fewer than two plants.
float spacing_of(const std::vector<glm::vec3>& feet, float area) {
  if (feet.size() < 2) return std::numeric_limits<float>::quiet_NaN();
  float sum = 0;
  float edge = std::sqrt(area / static_cast<float>(feet.size()));
  std::vector<float> nearest(feet.size(), std::numeric_limits<float>::infinity());
  // Doubles the edge until each plant has a neighbour within an edge.
  for (bool found = false; !found; edge *= 2) {
    found = true;
    const PointGrid grid(feet, edge);
    for (std::uint32_t i = 0; i < feet.size(); ++i) {
      if (nearest[i] <= 0.5f * edge) continue;
      grid.visit(feet[i], [&](std::uint32_t j) {
        if (j != i) nearest[i] = std::min(nearest[i], glm::distance(feet[i], feet[j]));
      });
      found &= nearest[i] <= edge;
    }
  }
  for (const float distance : nearest) sum += distance;
  return sum / static_cast<float>(feet.size());
}

// Measures the stand; plants that are attached to others do not count.
void measure(Plant& plant, const Plan& plan, const std::vector<Placement>& plants,
             const std::vector<const Kind*>& kinds) {
  Measures<Measure> measures(measure_count, 0);
  std::vector<glm::vec3> feet;
  float crowns = 0;
  for (const Placement& placement : plants) {
    if (placement.parent >= 0) continue;
    feet.emplace_back(placement.at.x, 0, placement.at.z);
    const float width = kinds[placement.kind]->width * placement.scale;
    crowns += 0.25f * pi * width * width;
  }
  const float area = plan.ground.width * plan.ground.depth;
  measures[Measure::area] = area;
  measures[Measure::standing] = static_cast<float>(feet.size());
  measures[Measure::density] = 10'000 * static_cast<float>(feet.size()) / area;
  measures[Measure::spacing] = spacing_of(feet, area);
  measures[Measure::cover] = 100 * crowns / area;
  plant.measures = measures.take();
}

// Plants a stand: reads its plan, places the plants on the ground, and adds the ground, trellises and measures as
// requested.
Result<Plant> grow(Request& request, const Limits& limits) {
  const CommonRequest common = read_common(request);
  const std::string_view text = request.required_text("plan");
  if (Diagnostic error = request.trouble(); error.reason != Reason::none) return error;
  Plant plant;
  const StandValues values(common.parameters, plant.notes);
  auto plan = read_plan(text, limits);
  if (!plan) return plan.error();
  plan->ground.relief *= values[relief];
  const Relief ground(plan->ground, common.seed);
  const auto plants = place(plan.value(), ground, common.seed, values.whole(many), plant.notes);
  if (!plants) return plants.error();
  const std::vector<const Kind*> kinds = kinds_of(plan.value());
  add_organs(plant, plants.value(), kinds);
  add_kinds(plant, kinds);
  add_plants(plant, plants.value(), surroundings_of(plan.value(), plants.value()));
  plant.columns.add("ground.size", std::vector<float>{plan->ground.width, plan->ground.depth, plan->ground.relief}, 3);
  const auto attached = static_cast<std::uint32_t>(
      std::count_if(plants->begin(), plants->end(), [](const Placement& of) { return of.parent >= 0; }));
  plant.counts = {
      {"plants", static_cast<std::uint32_t>(plants->size())}, {"kinds", count_names(kinds)}, {"borne", attached}};
  Trellises trellises = trellises_of(plan.value(), ground, plants.value());
  if (trellises.posts > 0) plant.counts.push_back({"posts", trellises.posts});
  if (common.measures) measure(plant, plan.value(), plants.value(), kinds);
  if (common.meshes) {
    Mesh mesh = ground.mesh();
    Columns columns;
    columns.add("sky", sky_below(plan.value(), plants.value(), mesh.positions));
    plant.meshes.push_back({"ground", "soil", std::move(mesh), {}, std::move(columns)});
    if (trellises.posts > 0) {
      plant.meshes.push_back({"posts", "wood", std::move(trellises.wood), {}, {}});
      plant.meshes.push_back({"wires", "metal", std::move(trellises.metal), {}, {}});
    }
  }
  set_fingerprints(plant, common.mesh_fingerprint);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"stand", grow};

}  // namespace panicle::stand
