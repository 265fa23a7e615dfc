// Sky visibility of a tree's own wood and leaves: each organ hides sky in proportion to its area.
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "models/growth/foliage.hpp"
#include "models/growth/model.hpp"
#include "models/growth/parameters.generated.hpp"
#include "models/growth/texts.hpp"

using namespace panicle;
using namespace panicle::growth;
using namespace panicle::growth::tests;

namespace {

using Chosen = std::map<Parameter, float>;

Plant tree(const Chosen& chosen) {
  std::vector<float> parameters(parameter_count, std::numeric_limits<float>::quiet_NaN());
  for (const auto& [key, value] : chosen) parameters[static_cast<std::size_t>(key)] = value;
  const std::string name = "growth", outputs = "meshes sky", rules = text_named("table-1-sigma1");
  const auto view = [](std::string_view block, const auto& values) {
    using Value = std::remove_cvref_t<decltype(values[0])>;
    return ColumnView{block, element_of<Value>(), 1, static_cast<std::uint32_t>(values.size()),
                      reinterpret_cast<const std::uint8_t*>(values.data())};
  };
  const std::vector<ColumnView> blocks{view("model", name), view("outputs", outputs), view("rules", rules),
                                       view("parameters", parameters)};
  Request request(blocks, nullptr);
  return sound(model.grow(request, Limits{}));
}

std::vector<std::uint8_t> sky_of(const Columns& columns, std::string_view name) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return {columns[i].data, columns[i].data + columns[i].rows};
  FAIL("there is no column " << name);
  return {};
}

double brightness(const Plant& plant) {
  const auto sky = sky_of(plant.meshes[0].columns, "sky");
  return std::accumulate(sky.begin(), sky.end(), 0.0) / static_cast<double>(sky.size());
}

}  // namespace

TEST_CASE("places for bunches hide no sky") {
  const Chosen needles{{Parameter::leaf_kind, 1}};
  Chosen with_bunches = needles;
  with_bunches[Parameter::bunches] = 3;
  const Plant without = tree(needles), with = tree(with_bunches);
  REQUIRE(with.organs.size() > without.organs.size());
  CHECK(with.organs.back().tag == bunch_tag);
  CHECK(sky_of(with.meshes[0].columns, "sky") == sky_of(without.meshes[0].columns, "sky"));
  auto leaves = sky_of(with.columns, "organs.sky");
  CHECK(leaves.size() == with.organs.size());
  leaves.resize(without.organs.size());
  CHECK(leaves == sky_of(without.columns, "organs.sky"));
}

TEST_CASE("blossoms hide sky in proportion to their own area") {
  Chosen bare{{Parameter::leaf_kind, 0}, {Parameter::season, 0.2f}};
  Chosen small = bare, large = bare;
  small[Parameter::blossoms] = large[Parameter::blossoms] = 8;
  small[Parameter::blossom_size] = 1;
  large[Parameter::blossom_size] = 10;
  const Plant none = tree(bare), some = tree(small), full = tree(large);
  REQUIRE(full.organs.size() > 100);
  CHECK(full.organs.back().tag == blossom_tag);
  CHECK(brightness(full) < brightness(some) - 1);
  CHECK(brightness(some) <= brightness(none));
}
