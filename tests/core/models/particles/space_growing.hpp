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
#include "foundation/english.hpp"
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

struct SpaceOptions {
  std::vector<std::pair<std::string_view, float>> parameters = {};
  std::uint32_t seed = 1;
  std::string outputs = {};
  std::vector<float> profile = {}, targets = {}, obstacles = {}, points = {}, rounds = {};
  std::vector<std::uint32_t> triangles = {};
  Surface hollow = {};
  Limits limits = {};
  bool leaf = true;  // whether a tree's request has a leaf
};

// The leaf of trees in tests: a lozenge with a petiole.
inline constexpr std::array<float, 8> leaf_points{0, 0, 0.3f, 0.5f, 0, 1, -0.3f, 0.5f};
inline constexpr std::array<float, 4> leaf_between{0, 1, 0, 1};
inline constexpr std::array<float, 8> leaf_uvs{0.5f, 1, 0.8f, 0.5f, 0.5f, 0, 0.2f, 0.5f};
inline constexpr std::array<float, 2> leaf_petiole{0.4f, 0.02f};
inline constexpr std::array<std::uint32_t, 6> leaf_triangles{0, 1, 2, 0, 2, 3};
inline FlatLeaf flat_leaf() { return {leaf_points, leaf_between, leaf_uvs, leaf_triangles, leaf_petiole}; }

template <class Table>
Result<Plant> request_plant(const Model& model, const Table& table, const SpaceOptions& options) {
  std::vector<float> values(table.size(), NAN);
  for (const auto& [key, value] : options.parameters) {
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
  add("seed", Element::uint32, 1, &options.seed);
  add("outputs", Element::text, options.outputs.size(), options.outputs.data());
  add("parameters", Element::float32, values.size(), values.data());
  add("profile", Element::float32, options.profile.size(), options.profile.data());
  add("targets", Element::float32, options.targets.size(), options.targets.data());
  add("obstacles", Element::float32, options.obstacles.size(), options.obstacles.data());
  add("obstacles.round", Element::float32, options.rounds.size(), options.rounds.data());
  add("volume.points", Element::float32, options.points.size(), options.points.data());
  add("volume.triangles", Element::uint32, options.triangles.size(), options.triangles.data());
  std::vector<float> hollow;
  for (const glm::vec3& p : options.hollow.points) hollow.insert(hollow.end(), {p.x, p.y, p.z});
  add("hollow.points", Element::float32, hollow.size(), hollow.data());
  add("hollow.triangles", Element::uint32, options.hollow.triangles.size(), options.hollow.triangles.data());
  if (options.leaf && model.name == "tree") {
    const FlatLeaf leaf = flat_leaf();
    add("leaf.points", Element::float32, leaf.points.size(), leaf.points.data());
    add("leaf.between", Element::float32, leaf.between.size(), leaf.between.data());
    add("leaf.uvs", Element::float32, leaf.uvs.size(), leaf.uvs.data());
    add("leaf.triangles", Element::uint32, leaf.triangles.size(), leaf.triangles.data());
    add("leaf.petiole", Element::float32, leaf.petiole.size(), leaf.petiole.data());
  }
  Request request(blocks, nullptr);
  return model.grow(request, options.limits);
}

inline Result<Plant> request_tree(const SpaceOptions& options) {
  return request_plant(tree::model, tree::parameter_table, options);
}
inline Result<Plant> request_root(const SpaceOptions& options) {
  return request_plant(root::model, root::parameter_table, options);
}
inline Plant grow_tree(const SpaceOptions& options) {
  Result<Plant> plant = request_tree(options);
  REQUIRE_MESSAGE(plant, plant.error().message);
  return std::move(plant.value());
}
inline Plant grow_root(const SpaceOptions& options) {
  Result<Plant> plant = request_root(options);
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

// Where particles started: ends without children. (All of a grown plant's particles are such ends.)
inline std::vector<std::size_t> tips_of(const Plant& plant) {
  std::vector<std::uint8_t> has_child(plant.segments.size(), 0);
  for (const Segment& segment : plant.segments)
    if (segment.parent >= 0) has_child[static_cast<std::size_t>(segment.parent)] = 1;
  std::vector<std::size_t> tips;
  for (std::size_t i = 0; i < has_child.size(); ++i)
    if (!has_child[i]) tips.push_back(i);
  return tips;
}

// Checks the properties of every tree, independent of its options.
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

inline bool has_note(const Plant& plant, std::string_view words) {
  for (const std::string& note : plant.notes)
    if (english(note).find(words) != std::string::npos) return true;
  return false;
}

}  // namespace panicle::particles
