// Leaves of published grammars: outlines of the topiary paper's table 2 match their botanical names, and the book's
// leaves of polygons.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "lsystem/published.hpp"

using namespace panicle;
using namespace panicle::tests;
using glm::vec3;

namespace {

class Blades : public Recorder {
 public:
  void polygon(const Turtle&, std::span<const vec3> corners, const Lineage&) override {
    polygons.emplace_back(corners.begin(), corners.end());
  }

  std::vector<std::vector<vec3>> polygons;
};

Blades drawing(const char* name, std::uint32_t steps, const Inputs& inputs = {}) {
  const BoundPointer bound = compiled_published(published(name), inputs);
  Blades blades;
  sound(lsystem::interpret(*bound, *derived(*bound, steps).string, upright, blades, 1, Limits{}));
  return blades;
}

// The constants of a preset, as variants.json has them: a preset a line.
Inputs constants_of(const std::string& name) {
  std::istringstream lines(
      file_text(panicle::tests::repository_folder() + "/wasm-core/grammars/grammar/variants.json"));
  Inputs inputs;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"" + name + "\"") == std::string::npos) continue;
    std::istringstream constants(line.substr(line.find("\"constants\": {") + 14));
    for (std::string each; std::getline(constants, each, ',');) {
      const std::size_t from = each.find('"'), to = each.find('"', from + 1);
      if (from == std::string::npos || to == std::string::npos) break;
      inputs.scalars.push_back({each.substr(from + 1, to - from - 1), std::stof(each.substr(to + 2))});
      if (each.find('}') != std::string::npos) return inputs;
    }
    return inputs;
  }
  FAIL("no preset " << name);
  return inputs;
}

bool cross(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
  const auto side = [](const vec3& p, const vec3& q, const vec3& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool crosses_itself(const std::vector<vec3>& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (cross(outline[i], outline[(i + 1) % n], outline[j], outline[(j + 1) % n])) return true;
  return false;
}

}  // namespace

TEST_CASE("the leaf of table 2 has the outlines of the botanical names") {
  struct Outline {
    const char* name;
    double slender, widest,
        sinus;  // length over width, where it is widest from its lowest point, and how deep its base is
  };
  const Outline outlines[] = {
      {"leaf-ovate", 1.60, .39, 0},       {"leaf-elliptic", 2.00, .47, 0},     {"leaf-lanceolate", 3.97, .35, 0},
      {"leaf-obovate", 1.87, .61, 0},     {"leaf-oblanceolate", 3.51, .64, 0}, {"leaf-orbicular", 1.00, .50, 0},
      {"leaf-deltoid", 1.13, .12, 0},     {"leaf-cordate", 1.15, .43, .22},    {"leaf-reniform", .89, .46, .60},
      {"leaf-five-lobed", .95, .53, .56}, {"leaf-three-lobed", .82, .25, .33}, {"leaf-toothed", 1.50, .39, .02}};
  for (const Outline& outline : outlines) {
    INFO(outline.name);
    Inputs inputs = constants_of(outline.name);
    inputs.scalars.push_back({"beta", 0});
    inputs.scalars.push_back({"stalk", 0});
    const BoundPointer bound = compiled_published(published("leaf"), inputs);
    const Blades leaf = drawing("leaf", lsystem::derivation_length(*bound).value(), inputs);
    REQUIRE(leaf.polygons.size() == 1);
    const std::vector<vec3>& corners = leaf.polygons.front();
    vec3 low = corners.front(), high = low;
    vec3 leftmost = low;
    for (const vec3& corner : corners) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
      if (corner.x > leftmost.x) leftmost = corner;
    }
    CHECK((high.y - low.y) / (high.x - low.x) == doctest::Approx(outline.slender).epsilon(0.015));
    CHECK((leftmost.y - low.y) / (high.y - low.y) == doctest::Approx(outline.widest).epsilon(0.001).scale(20));
    CHECK(std::abs(-low.y / high.y - outline.sinus) < 0.01);
    CHECK(high.x == doctest::Approx(-low.x));
    CHECK(high.z - low.z < 1e-4F);
    CHECK_FALSE(crosses_itself(corners));
    // Stalk, midrib, and side veins in pairs, none of which leaves the blade.
    float veins = 7;
    for (const auto& [name, value] : inputs.scalars)
      if (name == "veins") veins = value;
    CHECK(leaf.lines.size() == 1 + 2 * static_cast<std::size_t>(veins));
    CHECK(leaf.lines.front().after.width > leaf.lines.back().after.width);
  }
}

TEST_CASE("a bent leaf is as long as its veins, and both sides bend alike") {
  const Blades leaf = drawing("leaf", 25, Inputs{{{"beta", 2}, {"stalk", 0}}, {}});
  float lowest[2] = {};
  for (const vec3& corner : leaf.polygons.front()) {
    float& side = lowest[corner.x > 0];
    if (std::abs(corner.z) > std::abs(side)) side = corner.z;
  }
  CHECK(std::abs(lowest[0]) > 0.05F);
  CHECK(lowest[0] == doctest::Approx(lowest[1]));
}

TEST_CASE("figures 5.5, 5.6 and 5.8: leaves of polygons") {
  // Two polygons a step, of the corner at the base, where the two ribs end.
  const Blades cordate = drawing("cordate-leaf", 20);
  CHECK(cordate.polygons.size() == 40);
  const Blades simple = drawing("simple-leaf", 20);
  REQUIRE(simple.polygons.size() == 1);
  // The base, and a corner on either side for each of the twenty.
  CHECK(simple.polygons.front().size() == 41);
  const Blades rose = drawing("rose-leaf", 25);
  CHECK(rose.polygons.size() > 40);
  for (const Blades* blades : {&cordate, &simple, &rose}) {
    vec3 low{0}, high{0};
    for (const auto& polygon : blades->polygons)
      for (const vec3& corner : polygon) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
    CHECK(high.x == doctest::Approx(-low.x).epsilon(1e-3));
    CHECK(high.y > high.x);
  }
}
