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
#include "generalized_map/embedding.hpp"
#include "models/flower/derivation.hpp"
#include "models/flower/fingerprint.hpp"
#include "models/flower/levels.hpp"
#include "models/flower/measures/measures.generated.hpp"
#include "models/flower/parameters.generated.hpp"
#include "models/flower/skin.hpp"
#include "models/flower/units.hpp"
#include "plant/fingerprint.hpp"
#include "protocol/cache.hpp"
#include "protocol/parameter_values.hpp"

namespace panicle::flower {
namespace {

using FlowerValues = Values<Parameter, parameter_table>;
using enum Parameter;

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) all.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

// The middle of a face's corners.
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

void measure(Plant& plant, const generalized_map::Embedding& embedding, std::size_t organs) {
  plant.measures.assign(measure_count, 0);
  const auto set = [&](Measure which, float value) { plant.measures[static_cast<std::size_t>(which)] = value; };
  glm::vec3 low(1e9f), high(-1e9f);
  for (const glm::vec3& each : embedding.positions()) {
    low = glm::min(low, metres * y_up(each));
    high = glm::max(high, metres * y_up(each));
  }
  set(Measure::height, 100 * (high.y - low.y));
  set(Measure::spread, 50 * (high.x - low.x + high.z - low.z));
  set(Measure::surface, std::nanf(""));
  set(Measure::organs, static_cast<float>(organs));
}

void measure_surface(Plant& plant) {
  if (plant.meshes.empty()) return;
  double area = 0;
  for (const PlantMesh& each : plant.meshes) {
    const auto corner = [&](std::uint32_t i) {
      const float* const at = &each.mesh.positions[3 * each.mesh.indices[i]];
      return glm::vec3(at[0], at[1], at[2]);
    };
    for (std::uint32_t i = 0; i + 2 < each.mesh.indices.size(); i += 3)
      area += 0.5 * static_cast<double>(glm::length(glm::cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i))));
  }
  plant.measures[static_cast<std::size_t>(Measure::surface)] = static_cast<float>(1e4 * area);
}

// `a, b and 7 more`; long names are shortened.
std::string listed(const std::vector<std::string_view>& names) {
  constexpr std::size_t most_listed = 12, longest_listed = 64;
  std::string all;
  for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i) {
    all.append(i == 0 ? "" : ", ").append(names[i].substr(0, longest_listed));
    if (names[i].size() > longest_listed) all.append("…");
  }
  if (names.size() > most_listed)
    all.append(expression::sentence(" and % more", {std::to_string(names.size() - most_listed)}));
  return names.empty() ? "none" : all;
}

// A note on given values of variables that the text does not have, as after an edit: the flower grows without them.
void note_unknown_values(Plant& plant, const Program& program, const Given& given) {
  std::vector<std::string_view> own, strange;
  for (const Variable& variable : program.variables)
    if (variable.grammar == 0) own.push_back(variable.name);
  const std::set<std::string_view> known(own.begin(), own.end());
  for (const Given::Value& value : given.values)
    if (!known.contains(value.name)) strange.push_back(value.name);
  if (!strange.empty())
    plant.notes.push_back(expression::sentence(
        "The text has no #define of %, so a value of it changes nothing; it has %.", {listed(strange), listed(own)}));
}

bool read_values(Request& request, Given& given) {
  const std::vector<std::string> names = words_of(request.text("values.names"));
  const std::span<const float> values = request.floats("values");
  if (names.size() != values.size()) return false;
  for (std::size_t i = 0; i < names.size(); ++i) given.values.push_back({names[i], values[i]});
  return true;
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

  std::uint64_t bytes() const {
    return text.capacity() + program->bytes() + derived.bytes() + embedding.bytes() + (skin ? skin->bytes() : 0) +
           (levels ? levels->bytes() : 0);
  }
};

// The latest flower first. A bed has several: plants of one text whose maps differ alternate.
struct FlowerCache : Cache {
  std::vector<std::unique_ptr<CachedFlower>> all;
};

constexpr std::size_t most_cached = 12;

// Reworks a cached flower's values for a text that grows the same map. False, and the flower is unchanged, where only
// growing gives the right result.
bool rework_cached(CachedFlower& last, const Program& program, const Given& given, const Limits& limits) {
  if (rebuilds(program, last.given, given, limits)) return false;
  auto values = reworked(program, given, last.derived, limits);
  // Growing reports the error.
  if (!values) return false;
  last.derived.values = std::move(values.value());
  return true;
}

// The flower, which is now the first in the cache. Errors: those of reading and of growing.
Result<CachedFlower*> find_or_grow(std::string_view text, const Given& given, const Limits& limits, bool skinless,
                                   FlowerCache& last) {
  auto& all = last.all;
  std::shared_ptr<const Program> program;
  for (const auto& each : all)
    if (each->text == text) program = each->program;
  const bool same_text = program != nullptr;
  if (!same_text) {
    auto read = read_program(text, limits);
    if (!read) return read.error();
    program = std::make_shared<const Program>(std::move(read.value()));
  }
  bool again = false;
  for (std::size_t i = 0; i < all.size() && !again; ++i) {
    if (same_text ? all[i]->text != text : i > 0 || !same_map(*program, *all[i]->program)) continue;
    again = rework_cached(*all[i], *program, given, limits);
    if (again)
      std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i),
                  all.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  if (!again) {
    // Before growing, so that two skins never need memory at once.
    if (!skinless) all.clear();
    auto derived = derive(*program, given, limits);
    if (!derived) return derived.error();
    all.insert(all.begin(), std::make_unique<CachedFlower>(std::move(derived.value())));
  }
  CachedFlower& flower = *all.front();
  // Levels are thinned by the text's own sizes.
  if (!same_text) flower.levels.reset();
  flower.program = std::move(program);
  flower.text = text;
  flower.given = given;
  return &flower;
}

// Removes flowers that cannot be reused, and the oldest ones beyond the limits of the cache.
void evict(FlowerCache& last) {
  auto& all = last.all;
  if (all.front()->levels && !all.front()->levels->lasting()) all.front()->levels.reset();
  if (!all.front()->derived.whole) all.erase(all.begin());
  std::uint64_t bytes = 0;
  std::size_t count = 0;
  while (count < all.size() && count < most_cached && (bytes += all[count]->bytes()) <= Cache::most_bytes) ++count;
  all.resize(count);
}

Result<Plant> grow(Request& request, const Limits& limits) {
  request.text("model");
  Given given;
  given.seed = request.word("seed", 1);
  const bool meshes = request.wants("meshes"), measures = request.wants("measures"), sky = request.wants("sky"),
             whole = request.wants("map"), mesh_fingerprint = request.wants("mesh_fingerprint"),
             levels = request.wants("levels");
  const std::span<const float> parameters = request.floats("parameters");
  const bool has_text = request.has("text");
  const std::string_view text = request.text("text");
  const bool paired = read_values(request, given);
  if (Diagnostic trouble = request.trouble(); trouble.reason != Reason::none) return trouble;
  if (!has_text) return Diagnostic{Reason::bad_request, "The request has no text.", 0, 0};
  if (!paired) return Diagnostic{Reason::bad_request, "There are not as many values as names of values.", 0, 0};
  Plant plant;
  const FlowerValues values(parameters, plant.notes);
  given.steps = values.whole(steps);
  given.age = values[age];
  CacheSlot* const cache_slot = request.cache();
  std::unique_ptr<FlowerCache> last(cache_slot ? static_cast<FlowerCache*>(cache_slot->release()) : nullptr);
  if (!last) last = std::make_unique<FlowerCache>();
  const auto flower = find_or_grow(text, given, limits, !meshes, *last);
  if (!flower) {
    if (cache_slot) *cache_slot = std::move(last);
    return flower.error();
  }
  auto& [own_text, own_program, own_given, derived, embedding, skin, own_levels] = *flower.value();
  const Program& program = *own_program;
  plant.notes.insert(plant.notes.end(), derived.notes.begin(), derived.notes.end());
  if (!derived.whole) plant.cut_short = limits.budget != nullptr ? cut_short_by(*limits.budget) : CutShort::limit;
  note_unknown_values(plant, program, given);

  embedding.place(derived.shapes());
  plant.fingerprint = fingerprint_of(derived, embedding);
  add_segments(plant, program, derived, embedding);
  // Plants of a bed need levels only, not columns of volumes.
  if (meshes || !levels) add_columns(plant, program, derived, whole, embedding);
  if (measures) measure(plant, embedding, derived.instances.size() - 1);
  std::vector<std::uint32_t> numbers;
  if (meshes) {
    const std::uint32_t rounds = Skin::rounds_for(derived, values.whole(smooth));
    if (rounds < values.whole(smooth))
      plant.notes.push_back(expression::sentence(
          "Its skin is rounded %×, as far as the limit of % triangles lets it be, and not %×.",
          {std::to_string(rounds), std::to_string(Skin::most_triangles), std::to_string(values.whole(smooth))}));
    if (!skin || skin->rounds() != rounds) skin.emplace(derived, embedding, rounds);
    embedding.place(skin->shapes(derived));
    skin->add_to(plant, program, derived, embedding, sky);
    for (const PlantMesh& mesh : plant.meshes)
      numbers.push_back(static_cast<std::uint32_t>(std::stoul(mesh.name.substr(1))));
    if (measures) measure_surface(plant);
  }
  std::uint32_t triangles = 0;
  for (const PlantMesh& mesh : plant.meshes) triangles += static_cast<std::uint32_t>(mesh.mesh.indices.size() / 3);
  plant.counts = {{"volumes", derived.map.volumes()},
                  {"darts", derived.map.darts()},
                  {"organs", static_cast<std::uint32_t>(derived.instances.size() - 1)},
                  {"triangles", triangles}};
  if (levels) {
    if (!own_levels) own_levels.emplace(program, given, limits, derived, embedding);
    own_levels->add_to(plant, program, derived, embedding, numbers);
  }
  if (meshes || levels) add_materials(plant, program, given.age, std::move(numbers));
  if (meshes && mesh_fingerprint) plant.mesh_fingerprint = mesh_fingerprint_of(plant);
  if (cache_slot) {
    evict(*last);
    *cache_slot = std::move(last);
  }
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"flower", grow};

}  // namespace panicle::flower
