// Growing trees and roots by name, for tests.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foliage/flat_leaf.hpp"
#include "models/root/parameters.generated.hpp"
#include "models/tree/parameters.generated.hpp"
#include "protocol/model.hpp"
#include "spatial/closed_surface.hpp"

namespace panicle::particles {
namespace tree {
extern const Model model;
}
namespace root {
extern const Model model;
}

struct Asked {
  std::vector<std::pair<std::string_view, float>> parameters = {};
  std::uint32_t seed = 1;
  std::string outputs = {};
  std::vector<float> profile = {}, targets = {}, obstacles = {}, points = {}, rounds = {};
  std::vector<std::uint32_t> triangles = {};
  Surface hollow = {};
  Limits limits = {};
  bool leaf = true;  // whether a tree's request brings one
};

// What trees bear in tests: a lozenge with a petiole.
inline constexpr std::array<float, 8> leaf_points{0, 0, 0.3f, 0.5f, 0, 1, -0.3f, 0.5f};
inline constexpr std::array<float, 4> leaf_between{0, 1, 0, 1};
inline constexpr std::array<float, 8> leaf_uvs{0.5f, 1, 0.8f, 0.5f, 0.5f, 0, 0.2f, 0.5f};
inline constexpr std::array<float, 2> leaf_petiole{0.4f, 0.02f};
inline constexpr std::array<std::uint32_t, 6> leaf_triangles{0, 1, 2, 0, 2, 3};
inline FlatLeaf flat_leaf() { return {leaf_points, leaf_between, leaf_uvs, leaf_triangles, leaf_petiole}; }

template <class Table>
Result<Plant> ask(const Model& model, const Table& table, const Asked& asked) {
  std::vector<float> values(table.size(), NAN);
  for (const auto& [key, value] : asked.parameters) {
    bool known = false;
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (table[i].key != key) continue;
      values[i] = value;
      known = true;
    }
    REQUIRE_MESSAGE(known, key);
  }
  std::vector<ColumnView> blocks;
  const auto add = [&blocks](std::string_view name, Element element, std::size_t rows, const void* data) {
    if (rows > 0)
      blocks.push_back({name, element, 1, static_cast<std::uint32_t>(rows), static_cast<const std::uint8_t*>(data)});
  };
  add("model", Element::text, model.name.size(), model.name.data());
  add("seed", Element::uint32, 1, &asked.seed);
  add("outputs", Element::text, asked.outputs.size(), asked.outputs.data());
  add("parameters", Element::float32, values.size(), values.data());
  add("profile", Element::float32, asked.profile.size(), asked.profile.data());
  add("targets", Element::float32, asked.targets.size(), asked.targets.data());
  add("obstacles", Element::float32, asked.obstacles.size(), asked.obstacles.data());
  add("obstacles.round", Element::float32, asked.rounds.size(), asked.rounds.data());
  add("volume.points", Element::float32, asked.points.size(), asked.points.data());
  add("volume.triangles", Element::uint32, asked.triangles.size(), asked.triangles.data());
  std::vector<float> hollow;
  for (const glm::vec3& p : asked.hollow.points) hollow.insert(hollow.end(), {p.x, p.y, p.z});
  add("hollow.points", Element::float32, hollow.size(), hollow.data());
  add("hollow.triangles", Element::uint32, asked.hollow.triangles.size(), asked.hollow.triangles.data());
  if (asked.leaf && model.name == "tree") {
    const FlatLeaf leaf = flat_leaf();
    add("leaf.points", Element::float32, leaf.points.size(), leaf.points.data());
    add("leaf.between", Element::float32, leaf.between.size(), leaf.between.data());
    add("leaf.uvs", Element::float32, leaf.uvs.size(), leaf.uvs.data());
    add("leaf.triangles", Element::uint32, leaf.triangles.size(), leaf.triangles.data());
    add("leaf.petiole", Element::float32, leaf.petiole.size(), leaf.petiole.data());
  }
  Request request(blocks, nullptr);
  return model.grow(request, asked.limits);
}

inline Result<Plant> ask_tree(const Asked& asked) { return ask(tree::model, tree::parameter_table, asked); }
inline Result<Plant> ask_root(const Asked& asked) { return ask(root::model, root::parameter_table, asked); }
inline Plant grow_tree(const Asked& asked) {
  Result<Plant> plant = ask_tree(asked);
  REQUIRE_MESSAGE(plant, plant.error().message);
  return std::move(plant.value());
}
inline Plant grow_root(const Asked& asked) {
  Result<Plant> plant = ask_root(asked);
  REQUIRE_MESSAGE(plant, plant.error().message);
  return std::move(plant.value());
}

inline std::uint32_t count_of(const Plant& plant, std::string_view name) {
  for (const Count& count : plant.counts)
    if (count.name == name) return count.value;
  FAIL("no such count");
  return 0;
}

template <class Value>
std::vector<Value> column_in(const Columns& columns, std::string_view name) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ColumnView view = columns[i];
    if (view.name != name) continue;
    std::vector<Value> values(std::size_t{view.rows} * view.width);
    if (!values.empty()) std::memcpy(values.data(), view.data, values.size() * sizeof(Value));
    return values;
  }
  return {};
}
template <class Value>
std::vector<Value> column_in(const Plant& plant, std::string_view name) {
  return column_in<Value>(plant.columns, name);
}

// Where particles started: ends that bear nothing. (All of a grown plant's particles are such ends.)
inline std::vector<std::size_t> tips_of(const Plant& plant) {
  std::vector<std::uint8_t> bears(plant.segments.size(), 0);
  for (const Segment& segment : plant.segments)
    if (segment.parent >= 0) bears[static_cast<std::size_t>(segment.parent)] = 1;
  std::vector<std::size_t> tips;
  for (std::size_t i = 0; i < bears.size(); ++i)
    if (!bears[i]) tips.push_back(i);
  return tips;
}

// Every tree has these, whatever was asked.
inline void check_sound(const Plant& plant, double energy) {
  const auto energies = column_in<float>(plant, "segments.energy");
  const auto arrived = column_in<float>(plant, "targets.energy");
  REQUIRE(energies.size() == plant.segments.size());
  double sum = 0, at_targets = 0;
  for (const float each : arrived) sum += static_cast<double>(each);
  std::vector<double> inflow(plant.segments.size(), 0);
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const Segment& segment = plant.segments[i];
    CHECK(segment.parent < static_cast<std::int32_t>(i));
    CHECK(segment.radius > 0);
    if (segment.parent >= 0) {
      CHECK(plant.segments[static_cast<std::size_t>(segment.parent)].end == segment.start);
      inflow[static_cast<std::size_t>(segment.parent)] += static_cast<double>(energies[i]);
    } else {
      at_targets += static_cast<double>(energies[i]);
    }
  }
  // Whole energies below 2^24 add up exactly.
  CHECK(at_targets == sum);
  CHECK(sum == energy * count_of(plant, "particles"));
  CHECK(count_of(plant, "energy") == static_cast<std::uint32_t>(sum));
  for (std::size_t i = 0; i < inflow.size(); ++i)
    if (inflow[i] > 0) CHECK(inflow[i] <= static_cast<double>(energies[i]));
  // One tree a target, whose ends are the particles.
  CHECK(tips_of(plant).size() == count_of(plant, "particles"));
  const auto places = column_in<float>(plant, "targets.places");
  CHECK(places.size() == 3 * count_of(plant, "targets"));
  for (const Segment& segment : plant.segments) {
    if (segment.parent >= 0) continue;
    bool at_target = false;
    for (std::size_t k = 0; k < places.size(); k += 3)
      at_target = at_target || segment.start == glm::vec3(places[k], places[k + 1], places[k + 2]);
    CHECK(at_target);
  }
}

inline bool notes_say(const Plant& plant, std::string_view words) {
  for (const std::string& note : plant.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace panicle::particles
