// Growing leaves by name, for tests.
#pragma once

#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/leaf/parameters.generated.hpp"
#include "protocol/model.hpp"

namespace panicle::particles::leaf {

extern const Model model;

inline constexpr float absent = std::numeric_limits<float>::quiet_NaN();

struct CropTarget {
  std::map<Parameter, float> parameters = {};
  std::vector<float> outline = {};
  std::uint32_t seed = 1;
  std::string outputs = "";
  std::vector<float> detail = {};
};

inline Result<Plant> grown(const CropTarget& wish, const Limits& limits = {}) {
  std::vector<float> parameters(parameter_count, absent);
  for (const auto& [key, value] : wish.parameters) parameters[static_cast<std::size_t>(key)] = value;
  const std::string name = "leaf";
  const std::uint32_t seed[] = {wish.seed};
  const auto view = [](std::string_view block, const auto& values) {
    using Value = std::remove_cvref_t<decltype(values[0])>;
    return ColumnView{block, element_of<Value>(), 1, static_cast<std::uint32_t>(std::size(values)),
                      reinterpret_cast<const std::uint8_t*>(std::data(values))};
  };
  std::vector<ColumnView> blocks{view("model", name), view("seed", seed), view("parameters", parameters)};
  if (!wish.outputs.empty()) blocks.push_back(view("outputs", wish.outputs));
  if (!wish.outline.empty()) blocks.push_back(view("outline", wish.outline));
  if (!wish.detail.empty()) blocks.push_back(view("detail", wish.detail));
  Request request(blocks, nullptr);
  return leaf::model.grow(request, limits);
}

inline Plant leaf_of(const CropTarget& wish) {
  auto plant = grown(wish);
  REQUIRE(plant);
  return std::move(plant.value());
}

template <class Value>
std::span<const Value> column_at(const Plant& plant, std::string_view name) {
  for (std::size_t i = 0; i < plant.columns.size(); ++i)
    if (plant.columns[i].name == name) return plant.columns[i].as<Value>();
  return {};
}

inline std::uint32_t count_at(const Plant& plant, std::string_view name) {
  for (const Count& count : plant.counts)
    if (count.name == name) return count.value;
  return 0;
}

}  // namespace panicle::particles::leaf
