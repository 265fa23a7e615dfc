// A flower at four distances.
#include "models/flower/levels.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "flowers.hpp"
#include "foundation/english.hpp"
#include "models/flower/skin.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

struct Seen {
  double area = 0;
  glm::dvec3 low{1e9}, high{-1e9};
};

Seen seen(const Mesh& mesh) {
  Seen all;
  const auto corner = [&](std::size_t i) {
    const float* const at = &mesh.positions[3 * std::size_t{mesh.indices[i]}];
    return glm::dvec3(at[0], at[1], at[2]);
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
    all.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    for (const glm::dvec3& each : {a, b, c}) all.low = glm::min(all.low, each), all.high = glm::max(all.high, each);
  }
  return all;
}

struct Levelled {
  Plant plant;
  Seen whole;
};

Levelled levelled(const std::string& text, const Given& given = {}) {
  const Program program = program_of(text);
  Derived derived = sound(derive(program, given));
  generalized_map::Embedding embedding;
  embedding.build(derived.map);
  const std::vector<VolumeValues> values = derived.values;
  FlowerLevels levels(program, given, {}, derived, embedding);
  CHECK(derived.values == values);
  Levelled made;
  std::vector<std::uint32_t> numbers;
  levels.add_to(made.plant, program, derived, embedding, numbers);
  Skin skin(derived, embedding, 1);
  embedding.place(skin.shapes(derived));
  Plant whole;
  skin.add_to(whole, program, derived, embedding, false);
  for (const PlantMesh& mesh : whole.meshes) {
    const Seen own = seen(mesh.mesh);
    made.whole.area += own.area;
    made.whole.low = glm::min(made.whole.low, own.low);
    made.whole.high = glm::max(made.whole.high, own.high);
  }
  return made;
}

// Surface area of a mesh by kind of material.
std::map<std::string, double> shares(const PlantMesh& mesh) {
  std::map<std::string, double> all;
  const double whole = seen(mesh.mesh).area;
  for (const MeshRun& run : mesh.runs) {
    Mesh part = mesh.mesh;
    part.indices.assign(mesh.mesh.indices.begin() + run.first_index,
                        mesh.mesh.indices.begin() + run.first_index + run.index_count);
    all[run.name] = seen(part).area / whole;
  }
  return all;
}

// Coordinates of a kind's vertices along their organ (0) or across it (1), in hundredths.
std::set<int> painted(const PlantMesh& mesh, std::string_view kind, std::size_t way) {
  std::set<int> found;
  for (const MeshRun& run : mesh.runs)
    for (std::uint32_t v = run.first_vertex; run.name == kind && v < run.first_vertex + run.vertex_count; ++v)
      found.insert(static_cast<int>(std::lround(100 * mesh.mesh.uvs[2 * v + way])));
  return found;
}

}  // namespace

TEST_CASE("a level has the colours of the skin at the middle, the margin and both ends of organs") {
  const Plant plant = levelled(leaf).plant;
  CHECK(painted(plant.meshes[0], "petal", 1) == std::set{0, 50, 100});
  CHECK(painted(plant.meshes[0], "petal", 0) == std::set{0, 25, 75, 100});
  CHECK(painted(plant.meshes[0], "stem", 1) == std::set{0});
}

TEST_CASE("levels have few triangles and keep the flower's extent, area and kinds of material") {
  constexpr std::array<std::size_t, level_count> most{6000, 2200, 800, 260};
  // Least share of the surface that remains; less for panicles and umbels of umbels with thousands of florets.
  constexpr std::array<double, level_count> least{0.9, 0.74, 0.6, 0.45}, of_thousands{0.6, 0.3, 0.2, 0.15};
  for (const auto& file : files()) {
    const std::string name = file.stem().string();
    // A meadow is a whole bed of plants.
    if (name.starts_with("meadow") || name == "petal" || name == "grass" || name == "table-3" || name == "figure-16")
      continue;
    CAPTURE(name);
    const auto [plant, whole] = levelled(content(file));
    REQUIRE(plant.meshes.size() == level_count);
    CHECK(plant.notes.empty());
    const auto near = shares(plant.meshes[0]);
    for (std::size_t k = 0; k < level_count; ++k) {
      CAPTURE(k);
      const PlantMesh& mesh = plant.meshes[k];
      const std::size_t triangles = mesh.mesh.indices.size() / 3;
      CHECK(triangles <= most[k]);
      CHECK(3 * triangles >= most[k]);
      const Seen own = seen(mesh.mesh);
      const bool thousands = name == "panicle" || name == "double-umbel";
      CHECK(own.area > (thousands ? of_thousands : least)[k] * whole.area);
      CHECK(own.area < 1.1 * whole.area);
      const double size = glm::length(own.high - own.low) / glm::length(whole.high - whole.low);
      CHECK(size > (k < 2 ? 0.97 : 0.87));
      CHECK(size < (k < 2 ? 1.03 : 1.25));
      if (k > 0 && !thousands)
        for (const auto& [kind, share] : shares(mesh))
          CHECK_MESSAGE(std::abs(share - near.at(kind)) < (k < 2 ? 0.25 : 0.32), kind, " ", share);
      for (std::size_t v = 0; v < mesh.mesh.normals.size(); v += 3) {
        const float* const n = &mesh.mesh.normals[v];
        REQUIRE(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] == doctest::Approx(1).epsilon(0.001));
      }
    }
  }
}

TEST_CASE("plants of one map have the same triangles at each distance, at other places") {
  const std::string text = text_named("tulip");
  const Plant one = levelled(text).plant;
  Given other;
  other.seed = 77;
  other.age = 0.3f;
  other.values = {{"length", 200}};
  const Plant two = levelled(text, other).plant;
  for (std::size_t k = 0; k < level_count; ++k) {
    CHECK(one.meshes[k].mesh.indices == two.meshes[k].mesh.indices);
    CHECK(one.meshes[k].mesh.positions.size() == two.meshes[k].mesh.positions.size());
    CHECK(one.meshes[k].mesh.positions != two.meshes[k].mesh.positions);
  }
  // Given and drawn values of variables that the map depends on have the same effect.
  const std::string bells = text_named("bluebell");
  Given seeded;
  std::size_t same = 0;
  for (seeded.seed = 1; seeded.seed < 9; ++seeded.seed) {
    Given given;
    given.values = {{"bells", 8}};
    const Plant set_by_value = levelled(bells, given).plant, drawn = levelled(bells, seeded).plant;
    same += set_by_value.meshes[0].mesh.indices == drawn.meshes[0].mesh.indices;
  }
  CHECK(same > 0);
  CHECK(same < 8);
}

TEST_CASE("of a crowd of organs some remain from afar, wider") {
  const Plant plant = levelled(text_named("dandelion")).plant;
  const auto petals = [&](std::size_t k) {
    for (const MeshRun& run : plant.meshes[k].runs)
      if (run.name == "petal") return run;
    return MeshRun{};
  };
  CHECK(petals(0).index_count > 20 * petals(3).index_count);
  CHECK(petals(3).index_count > 30);
  const auto share = shares(plant.meshes[3]);
  CHECK(share.at("petal") > 0.15);
}

TEST_CASE("organs that are all different are omitted where they are too many") {
  // Of 480 organs each has another number of sides, another size, or both.
  const std::string text =
      "#define S(12,0,0,0,2,2,2,1)\n#axiom: S\n#define finalStep=40\nS -> S[S]_{E}\n"
      "S -> S[&M]_{C1,C2,C3,C4,C5,C6,C7,C8,C9,C10,C11,C12}\n#module M\n#define n=3+floor(ran(30))\n"
      "#define l=exp(ran(9))\n#define P(n,0,0,0,l,l,l,1)\n#define Q(n,0,0,0,1,1,1,1)\n#axiom: P\n#define finalStep=3\n"
      "P -> Q[P]_{E}\n";
  constexpr std::array<std::size_t, level_count> most{6000, 2200, 800, 260};
  const Plant plant = levelled(text).plant;
  for (std::size_t k = 0; k < level_count; ++k) {
    CHECK(plant.meshes[k].mesh.indices.size() / 3 <= most[k]);
    CHECK(plant.meshes[k].mesh.indices.size() / 3 > most[k] / 4);
  }
}

TEST_CASE("organs of thousands of sides are thinned like others") {
  const Plant plant =
      levelled(
          "#define S(4,0,0,0,2,2,2,1)\n#axiom: S\n#define finalStep=20\nS -> S[S]_{E}\nS -> S[&M]_{C1}\n"
          "#module M\n#define n=3000+floor(ran(1000))\n#define P(n,0,0,0,9,9,9,1)\n#axiom: P\n"
          "#define finalStep=1\nP -> P[P]_{E}\n")
          .plant;
  CHECK(plant.meshes[0].mesh.indices.size() / 3 <= 6000);
  CHECK(plant.meshes[3].mesh.indices.size() / 3 <= 260);
}

TEST_CASE("an organ of more triangles than are compared is simplified on grids, with a note") {
  const Program program = program_of("#define S(4)\n#axiom: S\nS -> S[S]_{E}[S]_{C1,C2,C3,C4}\n");
  Limits limits;
  limits.darts = 700'000;
  WorkBudget budget(limits.work, limits.bytes);
  limits.budget = &budget;
  auto grown = derive(program, {}, limits);
  REQUIRE(grown);
  Derived derived = std::move(grown.value());
  generalized_map::Embedding embedding;
  embedding.build(derived.map);
  const std::uint64_t before = budget.spent();
  FlowerLevels levels(program, {}, limits, derived, embedding);
  CHECK(budget.spent() == before);
  Plant plant;
  std::vector<std::uint32_t> numbers;
  levels.add_to(plant, program, derived, embedding, numbers);
  REQUIRE(plant.notes.size() == 1);
  CHECK(english(plant.notes[0]).find("more than 100000 triangles") != std::string::npos);
  constexpr std::array<std::size_t, level_count> most{6000, 2200, 800, 260};
  for (std::size_t k = 0; k < level_count; ++k) {
    CHECK(plant.meshes[k].mesh.indices.size() / 3 <= most[k]);
    CHECK(plant.meshes[k].mesh.indices.size() / 3 > most[k] / 10);
  }
}
