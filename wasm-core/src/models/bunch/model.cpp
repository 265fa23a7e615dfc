#include "models/bunch/model.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "lsystem_plant/derivation_trace_columns.hpp"
#include "lsystem_plant/requested_program.hpp"
#include "models/bunch/stems.hpp"
#include "protocol/common_request.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry; the rachis is the main axis of the bunch.

namespace {

using Floats = std::vector<float>;
using Integers = std::vector<std::int32_t>;
using Words = std::vector<std::uint32_t>;

// Adds the columns of a plan: its sides, their counts, and the lengths of its axes.
void add_plan(Columns& columns, const std::string& name, const Plan& plan) {
  columns.add(name + ".sides",
              column_of<float>(plan.sides, 2,
                               [](const SidePlan& side, float* at) {
                                 at[0] = side.point.width;
                                 at[1] = side.point.drop;
                               }),
              2);
  columns.add(name + ".counts",
              column_of<std::int32_t>(plan.sides, 2,
                                      [](const SidePlan& side, std::int32_t* at) {
                                        at[0] = side.n;
                                        at[1] = side.rd;
                                      }),
              2);
  Integers axes(plan.axes.size() + 1, plan.m);
  std::copy(plan.axes.begin(), plan.axes.end(), axes.begin() + 1);
  columns.add(name + ".axes", std::move(axes));
}

// Adds the profile, the outline that the handles draw, as a column of numbers.
void add_profile(Columns& columns, const Profile& profile) {
  Floats numbers{profile.length};
  for (const SidePoint& side : profile.sides) numbers.insert(numbers.end(), {side.width, side.drop});
  columns.add("profile", std::move(numbers));
}

// Adds the internodes as segments, with their tags and columns.
void add_skeleton(Plant& plant, const std::vector<Internode>& internodes) {
  plant.tags = {"rachis", "axis", "end", "pedicel"};
  plant.segments = segments_of(internodes);
  plant.columns.add("segments.axis", column_of<std::int32_t>(internodes, 1, [](const Internode& one, std::int32_t* at) {
                      *at = one.axis;
                    }));
  plant.columns.add("segments.state",
                    column_of<std::uint8_t>(internodes, 1, [](const Internode& one, std::uint8_t* at) {
                      *at = static_cast<std::uint8_t>(one.state);
                    }));
}

// Adds the columns of all berries: their balls, directions, pedicels and ids, and one for each trait.
void add_berries(Columns& columns, const GrownBunch& grown) {
  const std::vector<Berry>& berries = grown.berries;
  columns.add("berries.spheres",
              column_of<float>(berries, 4,
                               [](const Berry& berry, float* at) {
                                 put(berry.centre, at);
                                 at[3] = berry.radius;
                               }),
              4);
  columns.add("berries.directions",
              column_of<float>(berries, 3, [](const Berry& berry, float* at) { put(berry.direction, at); }), 3);
  columns.add("berries.parent",
              column_of<std::int32_t>(berries, 1, [](const Berry& berry, std::int32_t* at) { *at = berry.parent; }));
  columns.add("berries.id",
              column_of<std::uint32_t>(berries, 1, [](const Berry& berry, std::uint32_t* at) { *at = berry.id; }));
  const std::pair<const char*, float Traits::*> traits[] = {
      {"berries.width", &Traits::width},       {"berries.length", &Traits::length},
      {"berries.exposure", &Traits::exposure}, {"berries.turned", &Traits::turned},
      {"berries.opened", &Traits::opened},     {"berries.set", &Traits::set},
      {"berries.shrivel", &Traits::shrivel},   {"berries.seeds", &Traits::seeds}};
  for (const auto& [name, trait] : traits)
    columns.add(name,
                column_of<float>(grown.traits, 1, [trait = trait](const Traits& one, float* at) { *at = one.*trait; }));
}

// Adds the lost berries: ids, reasons and places.
void add_thinned(Columns& columns, const std::vector<Thinned>& thinned) {
  columns.add("thinned.id",
              column_of<std::uint32_t>(thinned, 1, [](const Thinned& one, std::uint32_t* at) { *at = one.id; }));
  columns.add("thinned.why", column_of<std::uint32_t>(thinned, 1, [](const Thinned& one, std::uint32_t* at) {
                *at = static_cast<std::uint32_t>(one.why);
              }));
  columns.add("thinned.places", column_of<float>(thinned, 3, [](const Thinned& one, float* at) { put(one.place, at); }),
              3);
}

// Makes the mesh `stems` with a run for the rachis and for each first-order axis.
PlantMesh stems_of(StemMesh stem) {
  PlantMesh mesh{"stems", "stem", std::move(stem.mesh), {}, {}};
  for (const StemPart& part : stem.parts) {
    const std::string name = part.group < 0 ? "rachis" : "axis " + std::to_string(part.group);
    mesh.runs.push_back({part, name});
  }
  mesh.columns.add(
      "axis", column_of<std::int32_t>(stem.parts, 1, [](const StemPart& part, std::int32_t* at) { *at = part.group; }));
  mesh.columns.add("segment", std::move(stem.segment));
  return mesh;
}

// Makes the mesh `flower` with a run for each kind of organ.
PlantMesh flower_of(FlowerMesh flower) {
  PlantMesh mesh{"flower", "petal", std::move(flower.mesh), {}, {}};
  static constexpr const char* names[] = {"stamens", "cap", "pistil", "petals", "calyx"};
  for (const FlowerPiece& piece : flower.pieces)
    mesh.runs.push_back({piece, names[static_cast<std::size_t>(piece.kind)]});
  mesh.columns.add("unit", Floats{flower.unit});
  return mesh;
}

// Makes the mesh `foliage` with a run for each part.
PlantMesh foliage_of(Foliage foliage) {
  PlantMesh mesh{"foliage", "blade", std::move(foliage.mesh), {}, {}};
  static constexpr const char* names[] = {"cane", "leaf", "petiole"};
  for (const FoliagePart& part : foliage.parts) mesh.runs.push_back({part, names[static_cast<std::size_t>(part.kind)]});
  return mesh;
}

// Adds the surfaces of pressed berries; all have the texture coordinates and triangles of one pattern.
void add_surfaces(Columns& columns, BerrySurfaces surfaces) {
  columns.add("berries.pattern.uvs", std::move(surfaces.uvs), 2);
  columns.add("berries.pattern.indices", std::move(surfaces.indices), 3);
  columns.add("berries.positions", std::move(surfaces.positions), 3);
  columns.add("berries.normals", std::move(surfaces.normals), 3);
  columns.add("berries.pressed", std::move(surfaces.pressed));
}

// Adds how much sky the vertices see to the meshes and the berries.
void add_sky(Plant& plant, SkyBytes sky) {
  for (PlantMesh& mesh : plant.meshes) {
    if (mesh.name == "stems") mesh.columns.add("sky", std::move(sky.stems));
    if (mesh.name == "foliage") mesh.columns.add("sky", std::move(sky.foliage));
  }
  plant.columns.add("berries.sky", std::move(sky.berries));
}

// Adds the derivation's trace, and the modules that drew each internode and berry.
void add_trace(Plant& plant, const GrownBunch& grown) {
  const lsystem::DerivationTrace& trace = *grown.trace;
  // After a limit the traced string differs from the drawn one.
  const bool whole = trace.stopped().reason == Reason::none;
  if (!whole) plant.notes.push_back(cut_short(trace));
  add_trace_columns(plant, trace);
  const auto modules = [whole](const auto& all) {
    return column_of<std::uint32_t>(
        all, 1, [whole](const auto& one, std::uint32_t* at) { *at = whole ? one.module : no_module; });
  };
  plant.columns.add("segments.module", modules(grown.internodes));
  plant.columns.add("organs.module", modules(grown.berries));
}

// Reads a request and grows its bunch.
Result<Plant> grow_plant(panicle::Request& blocks, const Limits& limits) {
  const auto request = read_request(blocks);
  if (!request) return request.error();
  auto grown = grow(request.value(), limits);
  if (!grown) return grown.error();
  return plant_of(std::move(grown.value()));
}

}  // namespace

const Model model{"bunch", grow_plant,
                  [](std::string_view text, const Limits& limits) { return compile_program(text, {}, limits); }};

// Reads the blocks of a request; an error if one is wrong.
Result<BunchRequest> read_request(panicle::Request& blocks) {
  BunchRequest request;
  const CommonRequest common = read_common(blocks);
  request.seed = common.seed;
  request.meshes = common.meshes;
  request.measures = common.measures;
  request.sky = common.sky;
  request.mesh_fingerprint = common.mesh_fingerprint;
  request.parameters.assign(common.parameters.begin(), common.parameters.end());
  request.grammar = blocks.text("grammar");
  request.program = program_by_handle(blocks);
  if (blocks.has("steps")) request.steps = blocks.word("steps");
  request.m = blocks.integer("m");
  const auto n = blocks.integers("n");
  request.n.assign(n.begin(), n.end());
  const auto thinned = blocks.words("thinned");
  request.thinned.assign(thinned.begin(), thinned.end());
  auto trace = read_trace_request(blocks);
  if (!trace) return trace.error();
  request.trace = trace.value();
  request.leaf = blocks.flat_leaf();
  request.stem_sides = blocks.word("stem_sides");
  request.berry_segments = blocks.word("berry_segments");
  if (Diagnostic error = blocks.trouble(); error.reason != Reason::none) return error;
  if (Diagnostic error = check(request.leaf); error.reason != Reason::none) return error;
  return request;
}

// Turns a grown bunch into a plant: skeleton, columns, meshes, counts, measures and fingerprints.
Plant plant_of(GrownBunch&& grown) {
  Plant plant;
  add_skeleton(plant, grown.internodes);
  Columns& columns = plant.columns;
  columns.add("procedure", std::string_view(grown.natural ? "natural" : "paper"));
  columns.add("form", Floats{grown.form.taper, grown.form.blunt, grown.form.curve});
  columns.add("fruit", Words{static_cast<std::uint32_t>(grown.form.fruit)});
  if (grown.natural) add_profile(columns, grown.profile);
  add_plan(columns, "plan", grown.plan);
  if (grown.second) add_plan(columns, "second", *grown.second);
  add_berries(columns, grown);
  add_thinned(columns, grown.thinned);
  if (grown.stem) plant.meshes.push_back(stems_of(std::move(*grown.stem)));
  if (grown.berry) plant.meshes.push_back({"berry", "skin", std::move(*grown.berry), {}, {}});
  if (grown.surfaces) add_surfaces(columns, std::move(*grown.surfaces));
  if (grown.flower) plant.meshes.push_back(flower_of(std::move(*grown.flower)));
  if (grown.foliage) plant.meshes.push_back(foliage_of(std::move(*grown.foliage)));
  if (grown.sky) add_sky(plant, std::move(*grown.sky));
  const Counts& counts = grown.counts;
  plant.counts = {{"endStructures", counts.end_structures},
                  {"internodes", counts.internodes},
                  {"pedicels", counts.pedicels},
                  {"berries", counts.berries},
                  {"withered", counts.withered},
                  {"cut", counts.cut}};
  plant.measures = std::move(grown.measures);
  plant.notes = std::move(grown.notes);
  if (grown.trace) add_trace(plant, grown);
  plant.fingerprint = grown.fingerprint;
  plant.mesh_fingerprint = grown.mesh_fingerprint;
  return plant;
}

}  // namespace panicle::bunch
