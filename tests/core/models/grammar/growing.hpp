// Helpers that grow any grammar in tests.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foundation/english.hpp"
#include "models/grammar/model.hpp"
#include "models/grammar/parameters.generated.hpp"

namespace panicle::grammar {

struct GrammarRequest {
  std::string text;
  std::vector<std::pair<std::string_view, float>> parameters = {};
  std::vector<std::pair<std::string_view, float>> constants = {};
  std::optional<std::uint32_t> steps = {};
  std::uint32_t seed = 1;
  std::string outputs = {};
  Limits limits = {};
  std::vector<ColumnView> more = {};  // additional blocks
};

inline Result<Plant> try_grow(const GrammarRequest& wanted) {
  std::vector<float> values(parameter_count, NAN);
  for (const auto& [key, value] : wanted.parameters) {
    bool known = false;
    for (std::size_t i = 0; i < parameter_count; ++i) {
      if (parameter_table[i].key != key) continue;
      values[i] = value;
      known = true;
    }
    REQUIRE_MESSAGE(known, key);
  }
  std::string names;
  std::vector<float> constants;
  for (const auto& [name, value] : wanted.constants) {
    names.append(names.empty() ? "" : "\n").append(name);
    constants.push_back(value);
  }
  std::vector<ColumnView> blocks;
  const auto add = [&blocks](std::string_view name, Element element, std::size_t rows, const void* data) {
    blocks.push_back({name, element, 1, static_cast<std::uint32_t>(rows), static_cast<const std::uint8_t*>(data)});
  };
  const std::uint32_t steps = wanted.steps.value_or(0);
  add("model", Element::text, model.name.size(), model.name.data());
  add("seed", Element::uint32, 1, &wanted.seed);
  add("outputs", Element::text, wanted.outputs.size(), wanted.outputs.data());
  add("parameters", Element::float32, values.size(), values.data());
  add("grammar", Element::text, wanted.text.size(), wanted.text.data());
  if (wanted.steps) add("steps", Element::uint32, 1, &steps);
  if (!constants.empty()) {
    add("constants.names", Element::text, names.size(), names.data());
    add("constants.values", Element::float32, constants.size(), constants.data());
  }
  blocks.insert(blocks.end(), wanted.more.begin(), wanted.more.end());
  Request request(blocks, nullptr);
  return model.grow(request, wanted.limits);
}

inline Plant grow(const GrammarRequest& wanted) {
  Result<Plant> plant = try_grow(wanted);
  REQUIRE_MESSAGE(plant, english(plant.error().message));
  return std::move(plant.value());
}

template <class Value>
std::vector<Value> column_in(const Columns& columns, std::string_view name) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name != name) continue;
    std::vector<Value> values(columns[i].rows * columns[i].width);
    std::memcpy(values.data(), columns[i].data, values.size() * sizeof(Value));
    return values;
  }
  FAIL("no column " << std::string(name));
  return {};
}

inline std::uint32_t count_of(const Plant& plant, std::string_view name) {
  for (const Count& count : plant.counts)
    if (count.name == name) return count.value;
  FAIL("no count " << std::string(name));
  return 0;
}

inline const PlantMesh* mesh_of(const Plant& plant, std::string_view name) {
  for (const PlantMesh& mesh : plant.meshes)
    if (mesh.name == name) return &mesh;
  return nullptr;
}

}  // namespace panicle::grammar
