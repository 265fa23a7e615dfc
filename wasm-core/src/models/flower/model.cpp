#include "models/flower/model.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "expression/diagnostics.hpp"
#include "foundation/vectors.hpp"
#include "generalized_map/embedding.hpp"
#include "mesh/normals.hpp"
#include "models/flower/derivation.hpp"
#include "models/flower/fingerprint.hpp"
#include "models/flower/levels.hpp"
#include "models/flower/measures/measures.generated.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/parameters.generated.hpp"
#include "models/flower/skin.hpp"
#include "models/flower/units.hpp"
#include "plant/fingerprint.hpp"
#include "plant/measures.hpp"
#include "protocol/cache.hpp"
#include "protocol/common_request.hpp"
#include "protocol/parameter_values.hpp"

namespace panicle::flower {

// A dart is one of the two half-edges of an edge of a face.

namespace {

using FlowerValues = Values<Parameter, parameter_table>;
using enum Parameter;

// The words of a text, separated by spaces.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) all.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

// The middle of the corners of a volume's end face (`end`) or base face, in metres.
glm::vec3 middle_of(const generalized_map::Map& map, const generalized_map::Embedding& embedding, std::uint32_t volume,
                    bool end) {
  const std::uint32_t order = map.volume(volume).order;
  glm::vec3 sum(0);
  for (std::uint32_t i = 0; i < order; ++i)
    sum += embedding.positions()[embedding.vertex_of()[end ? map.end_corner(volume, i) : map.base_corner(volume, i)]];
  return metres * y_up(sum / static_cast<float>(order));
}

// Volumes, each after its parent: the parent may have a higher number after a split.
std::vector<std::uint32_t> parents_first(const generalized_map::Map& map) {
  std::vector<std::uint32_t> order, line;
  std::vector<bool> is_known(map.volumes(), false);
  order.reserve(map.volumes());
  for (std::uint32_t v = 0; v < map.volumes(); ++v) {
    for (std::uint32_t at = v; at != generalized_map::none && !is_known[at]; at = map.volume(at).parent) {
      is_known[at] = true;
      line.push_back(at);
    }
    order.insert(order.end(), line.rbegin(), line.rend());
    line.clear();
  }
  return order;
}

// Adds a segment through the middle of each volume, parents first; volumes beside another of their production have
// none.
void add_segments(Plant& plant, const Program& program, const Derived& derived,
                  const generalized_map::Embedding& embedding) {
  std::vector<std::int32_t> tags(program.labels.size(), -1), of_volume(derived.map.volumes(), -1);
  for (const std::uint32_t v : parents_first(derived.map)) {
    const Record& record = derived.records[derived.record_of[v]];
    const std::uint32_t parent_volume = derived.map.volume(v).parent;
    const std::int32_t parent = parent_volume == generalized_map::none ? -1 : of_volume[parent_volume];
    of_volume[v] = parent;
    if (record.rank.beside > 0) continue;
    const std::uint32_t label = derived.map.volume(v).label;
    if (tags[label] < 0) {
      tags[label] = static_cast<std::int32_t>(plant.tags.size());
      plant.tags.push_back(program.labels[label].name);
    }
    const VolumeValues& values = derived.values[derived.record_of[v]];
    const float thick = 0.25f * metres *
                        (std::abs(values[static_cast<std::size_t>(Field::length)]) +
                         std::abs(values[static_cast<std::size_t>(Field::width)]));
    Segment segment;
    segment.parent = parent;
    segment.start = middle_of(derived.map, embedding, v, false);
    segment.end = middle_of(derived.map, embedding, v, true);
    segment.radius = segment.radius_end = thick;
    segment.tag = static_cast<std::uint32_t>(tags[label]);
    of_volume[v] = static_cast<std::int32_t>(plant.segments.size());
    plant.segments.push_back(segment);
  }
}

// Adds the text's lines of each volume: the line where it is grown, and the line where its module is called; 0 for
// first volumes.
void add_lines(Plant& plant, const Program& program, const Derived& derived) {
  std::vector<std::uint32_t> of_growth(program.growths, 0), of_production(program.productions.size(), 0);
  for (const Production& production : program.productions) {
    of_production[production.number] = static_cast<std::uint32_t>(production.place.line);
    for (const GrowAction& growth : production.growths)
      of_growth[growth.number] = static_cast<std::uint32_t>(growth.arguments.place.line);
  }
  std::vector<std::uint32_t> called(derived.instances.size(), 0), lines, calls;
  for (const Record& record : derived.records)
    if (record.instance != record.maker) called[record.instance] = of_growth[record.source];
  for (std::uint32_t v = 0; v < derived.map.volumes(); ++v) {
    const Record& record = derived.records[derived.record_of[v]];
    const bool begins = record.before == invalid || record.instance != record.maker;
    const bool grown = record.kind == Record::Kind::grown;
    lines.push_back(begins ? 0 : grown ? of_growth[record.source] : of_production[record.source]);
    calls.push_back(called[record.instance]);
  }
  plant.columns.add("volumes.line", std::move(lines));
  plant.columns.add("volumes.call", std::move(calls));
}

// Adds the columns of labels and volumes, and with `whole` those of darts and vertices.
void add_columns(Plant& plant, const Program& program, const Derived& derived, bool whole,
                 const generalized_map::Embedding& embedding) {
  std::string labels;
  for (const Label& label : program.labels) labels.append(labels.empty() ? "" : " ").append(label.name);
  plant.columns.add("labels", labels);
  plant.columns.add(
      "labels.module",
      column_of<std::uint32_t>(program.labels, 1, [](const Label& of, std::uint32_t* at) { *at = of.grammar; }));
  std::vector<std::uint32_t> label, order, parent, face;
  std::vector<std::uint8_t> attached;
  std::vector<float> values;
  for (std::uint32_t v = 0; v < derived.map.volumes(); ++v) {
    label.push_back(derived.map.volume(v).label);
    order.push_back(derived.map.volume(v).order);
    parent.push_back(derived.map.volume(v).parent);
    face.push_back(derived.map.volume(v).parent_face);
    attached.push_back(derived.map.volume(v).attached);
    const VolumeValues& own = derived.values[derived.record_of[v]];
    values.insert(values.end(), own.begin(), own.end());
  }
  plant.columns.add("volumes.label", std::move(label));
  plant.columns.add("volumes.order", std::move(order));
  plant.columns.add("volumes.parent", std::move(parent));
  plant.columns.add("volumes.face", std::move(face));
  plant.columns.add("volumes.attached", std::move(attached));
  plant.columns.add("volumes.values", std::move(values), fields);
  add_lines(plant, program, derived);
  if (!whole) return;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto alpha = derived.map.alphas(i);
    plant.columns.add("alpha" + std::to_string(i), std::vector<std::uint32_t>(alpha.begin(), alpha.end()));
  }
  const auto volumes = derived.map.volume_of();
  plant.columns.add("darts.volume", std::vector<std::uint32_t>(volumes.begin(), volumes.end()));
  plant.columns.add("darts.vertex",
                    std::vector<std::uint32_t>(embedding.vertex_of().begin(), embedding.vertex_of().end()));
  plant.columns.add("vertices.position",
                    column_of<float>(embedding.positions(), 3,
                                     [](const glm::vec3& each, float* at) { put(metres * y_up(each), at); }),
                    3);
}

// Adds the columns of the materials with these numbers, one for each mesh, in their colours at that age.
void add_materials(Plant& plant, const Program& program, float age, std::vector<std::uint32_t> numbers) {
  std::vector<std::uint32_t> colours;
  std::vector<float> paint;
  std::string names;
  for (const std::uint32_t number : numbers) {
    const Material material = material_of(program, number);
    const Colours now = colours_at(material, age);
    names.append(colours.empty() ? "" : "\n").append(material.name);
    colours.insert(colours.end(), {now.base, now.tip, material.margin, material.veins});
    paint.insert(paint.end(), {material.foot, material.margin_width, material.vein_count, material.vein_strength,
                               material.light, material.feathered ? 1.0f : 0.0f});
  }
  plant.columns.add("materials.number", std::move(numbers));
  plant.columns.add("materials.name", names);
  plant.columns.add("materials.colours", std::move(colours), 4);
  plant.columns.add("materials.paint", std::move(paint), 6);
}

// Measures the flower by its vertices: height and mean width, in centimetres, and its number of organs.
void measure(Plant& plant, const generalized_map::Embedding& embedding, std::size_t organs) {
  Measures<Measure> measures(measure_count);
  glm::vec3 low(1e9f), high(-1e9f);
  for (const glm::vec3& each : embedding.positions()) {
    low = glm::min(low, metres * y_up(each));
    high = glm::max(high, metres * y_up(each));
  }
  measures[Measure::height] = 100 * (high.y - low.y);
  measures[Measure::spread] = 50 * (high.x - low.x + high.z - low.z);
  measures[Measure::organs] = static_cast<float>(organs);
  plant.measures = measures.take();
}

// Sets the measure of the surface, in cm²: the area of all triangles of the meshes so far.
void measure_surface(Plant& plant) {
  if (plant.meshes.empty()) return;
  double area = 0;
  for (const PlantMesh& each : plant.meshes) {
    const auto corner = [&](std::uint32_t i) { return vector_at(each.mesh.positions, each.mesh.indices[i]); };
    for (std::uint32_t i = 0; i + 2 < each.mesh.indices.size(); i += 3)
      area += static_cast<double>(triangle_area(corner(i), corner(i + 1), corner(i + 2)));
  }
  plant.measures[static_cast<std::size_t>(Measure::surface)] = static_cast<float>(1e4 * area);
}

// Lists names: `a, b and 7 more`; long names are shortened.
Message listed(const std::vector<std::string_view>& names) {
  constexpr std::size_t max_listed = 12, longest_listed = 64;
  std::string all;
  for (std::size_t i = 0; i < std::min(names.size(), max_listed); ++i) {
    all.append(i == 0 ? "" : ", ").append(names[i].substr(0, longest_listed));
    if (names[i].size() > longest_listed) all.append("…");
  }
  if (names.empty()) return message(messages::flower::term_no_names);
  if (names.size() > max_listed) return message(messages::flower::term_and_more, all, names.size() - max_listed);
  return message(messages::flower::term_names, all);
}

// Adds a note on given values of variables that the text does not have, as after an edit: the flower grows without
// them.
void note_unknown_values(Plant& plant, const Program& program, const Given& given) {
  std::vector<std::string_view> own, strange;
  for (const Variable& variable : program.variables)
    if (variable.grammar == 0) own.push_back(variable.name);
  const std::set<std::string_view> known(own.begin(), own.end());
  for (const Given::Value& value : given.values)
    if (!known.contains(value.name)) strange.push_back(value.name);
  if (!strange.empty()) plant.notes.push_back(message(messages::flower::unknown_values, listed(strange), listed(own)));
}

struct FlowerRequest : CommonRequest {
  std::string_view text;
  Given given;
  std::uint32_t smooth = 0;          // rounds of refinement of the skin
  bool map = false, levels = false;  // outputs besides the common ones
};

// Reads the blocks of a request. Errors: bad_request.
Result<FlowerRequest> read_request(Request& blocks, std::vector<std::string>& notes) {
  FlowerRequest request{read_common(blocks), blocks.required_text("text"), {}, 0,
                        blocks.wants("map"), blocks.wants("levels")};
  const std::vector<std::string> names = words_of(blocks.text("values.names"));
  const std::span<const float> given = blocks.floats("values");
  if (Diagnostic error = blocks.trouble(); error.reason != Reason::none) return error;
  if (names.size() != given.size()) return bad_request(message(messages::flower::values_unpaired));
  for (std::size_t i = 0; i < names.size(); ++i) request.given.values.push_back({names[i], given[i]});
  const FlowerValues values(request.parameters, notes);
  request.given.seed = request.seed;
  request.given.steps = values.whole(steps);
  request.given.age = values[age];
  request.smooth = values.whole(smooth);
  return request;
}

// A grown flower with all parts that another flower of the same map can reuse.
struct CachedFlower {
  explicit CachedFlower(Derived grown) : derived(std::move(grown)) { embedding.build(derived.map); }

  std::string text;
  std::shared_ptr<const Program> program;
  Given given;
  Derived derived;
  generalized_map::Embedding embedding;
  std::optional<Skin> skin;
  std::optional<FlowerLevels> levels;

  // The memory that it holds, roughly.
  std::uint64_t bytes() const {
    return text.capacity() + program->bytes() + derived.bytes() + embedding.bytes() + (skin ? skin->bytes() : 0) +
           (levels ? levels->bytes() : 0);
  }
};

// The latest flower first. A bed has several: plants of one text whose maps differ alternate.
struct FlowerCache : Cache {
  std::vector<std::unique_ptr<CachedFlower>> all;
};

constexpr std::size_t max_cached = 12;

// Reworks a cached flower's values for a text that grows the same map. Returns false, and leaves the flower unchanged,
// if only growing gives the right result.
bool rework_cached(CachedFlower& last, const Program& program, const Given& given, const Limits& limits) {
  if (rebuilds(program, last.given, given, limits)) return false;
  auto values = reworked(program, given, last.derived, limits);
  // Growing reports the error.
  if (!values) return false;
  last.derived.values = std::move(values.value());
  return true;
}

// Returns the flower of a text and values, and moves it to the front of the cache: a cached one with the same map,
// given the new values, or one that is grown. Errors: those of reading and of growing.
Result<CachedFlower*> find_or_grow(std::string_view text, const Given& given, const Limits& limits, bool skinless,
                                   FlowerCache& cache) {
  auto& flowers = cache.all;
  std::shared_ptr<const Program> program;
  for (const auto& each : flowers)
    if (each->text == text) program = each->program;
  const bool same_text = program != nullptr;
  if (!same_text) {
    auto read = read_program(text, limits);
    if (!read) return read.error();
    program = std::make_shared<const Program>(std::move(read.value()));
  }
  bool reused = false;
  for (std::size_t i = 0; i < flowers.size() && !reused; ++i) {
    if (same_text ? flowers[i]->text != text : i > 0 || !same_map(*program, *flowers[i]->program)) continue;
    reused = rework_cached(*flowers[i], *program, given, limits);
    if (reused)
      std::rotate(flowers.begin(), flowers.begin() + static_cast<std::ptrdiff_t>(i),
                  flowers.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  if (!reused) {
    // Before growing, so that two skins never need memory at once.
    if (!skinless) flowers.clear();
    auto derived = derive(*program, given, limits);
    if (!derived) return derived.error();
    flowers.insert(flowers.begin(), std::make_unique<CachedFlower>(std::move(derived.value())));
  }
  CachedFlower& flower = *flowers.front();
  // Levels are thinned by the text's own sizes.
  if (!same_text) flower.levels.reset();
  flower.program = std::move(program);
  flower.text = text;
  flower.given = given;
  return &flower;
}

// Removes flowers that cannot be reused, and the oldest ones beyond the limits of the cache.
void evict(FlowerCache& cache) {
  auto& flowers = cache.all;
  if (flowers.front()->levels && !flowers.front()->levels->lasting()) flowers.front()->levels.reset();
  if (!flowers.front()->derived.whole) flowers.erase(flowers.begin());
  std::uint64_t bytes = 0;
  std::size_t count = 0;
  while (count < flowers.size() && count < max_cached && (bytes += flowers[count]->bytes()) <= Cache::most_bytes)
    ++count;
  flowers.resize(count);
}

// The cache of the request; `own` where nothing is cached between growths.
FlowerCache& cache_of(Request& request, FlowerCache& own) {
  CacheSlot* const slot = request.cache();
  if (slot == nullptr) return own;
  if (!*slot) *slot = std::make_unique<FlowerCache>();
  return static_cast<FlowerCache&>(**slot);
}

// Adds the meshes of the skin, the smoothed surface of the volumes, in as many rounds of smoothing as the limit of
// triangles allows. Places the cached embedding anew. Returns the numbers of the materials.
std::vector<std::uint32_t> add_skin(Plant& plant, CachedFlower& flower, const FlowerRequest& request) {
  const std::uint32_t rounds = Skin::rounds_for(flower.derived, request.smooth);
  if (rounds < request.smooth)
    plant.notes.push_back(message(messages::flower::rounding_reduced, rounds, request.smooth, Skin::max_triangles));
  std::optional<Skin>& skin = flower.skin;
  if (!skin || skin->rounds() != rounds) skin.emplace(flower.derived, flower.embedding, rounds);
  flower.embedding.place(skin->shapes(flower.derived));
  return skin->add_to(plant, *flower.program, flower.derived, flower.embedding, request.sky);
}

// Adds the plant's counts.
void add_counts(Plant& plant, const Derived& derived) {
  std::uint32_t triangles = 0;
  for (const PlantMesh& each : plant.meshes) triangles += static_cast<std::uint32_t>(each.mesh.indices.size() / 3);
  plant.counts = {{"volumes", derived.map.volumes()},
                  {"darts", derived.map.darts()},
                  {"organs", static_cast<std::uint32_t>(derived.instances.size() - 1)},
                  {"triangles", triangles}};
}

// Adds the skin, its measure and the levels, which place the embedding anew, and the materials of them all.
void add_meshes(Plant& plant, CachedFlower& flower, const FlowerRequest& request, const Limits& limits) {
  std::vector<std::uint32_t> numbers;
  if (request.meshes) numbers = add_skin(plant, flower, request);
  if (request.meshes && request.measures) measure_surface(plant);
  add_counts(plant, flower.derived);
  if (request.levels) {
    if (!flower.levels) flower.levels.emplace(*flower.program, request.given, limits, flower.derived, flower.embedding);
    flower.levels->add_to(plant, *flower.program, flower.derived, flower.embedding, numbers);
  }
  if (request.meshes || request.levels) add_materials(plant, *flower.program, request.given.age, std::move(numbers));
}

// Grows a flower, or takes it from the cache and only places it again; adds columns, meshes and measures as requested.
Result<Plant> grow(Request& blocks, const Limits& limits) {
  Plant plant;
  const auto request = read_request(blocks, plant.notes);
  if (!request) return request.error();
  FlowerCache own;
  FlowerCache& cache = cache_of(blocks, own);
  const auto found = find_or_grow(request->text, request->given, limits, !request->meshes, cache);
  if (!found) return found.error();
  CachedFlower& flower = *found.value();
  const Program& program = *flower.program;
  const Derived& derived = flower.derived;
  plant.notes.insert(plant.notes.end(), derived.notes.begin(), derived.notes.end());
  if (!derived.whole) plant.cut_short = limits.budget != nullptr ? cut_short_by(*limits.budget) : CutShort::limit;
  note_unknown_values(plant, program, request->given);

  flower.embedding.place(derived.shapes());
  plant.fingerprint = fingerprint_of(derived, flower.embedding);
  add_segments(plant, program, derived, flower.embedding);
  // Plants of a bed need levels only, not columns of volumes.
  if (request->meshes || !request->levels) add_columns(plant, program, derived, request->map, flower.embedding);
  if (request->measures) measure(plant, flower.embedding, derived.instances.size() - 1);
  add_meshes(plant, flower, request.value(), limits);
  if (request->mesh_fingerprint) plant.mesh_fingerprint = mesh_fingerprint_of(plant);
  evict(cache);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"flower", grow};

}  // namespace panicle::flower
