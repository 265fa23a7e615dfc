// Data for the paint of a skin: positions of corners in their organs, and colours at an age.
#include "models/flower/skin.hpp"

#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "flowers.hpp"
#include "models/flower/units.hpp"

using namespace panicle;
using namespace panicle::flower;
using namespace panicle::flower::tests;

namespace {

std::vector<PlantMesh> painted(const std::string& text, std::uint32_t rounds) {
  const Flower flower = grown(text);
  generalized_map::Embedding embedding;
  embedding.build(flower.derived.map);
  Skin skin(flower.derived, embedding, rounds);
  embedding.place(skin.shapes(flower.derived));
  Plant plant;
  skin.add_to(plant, flower.program, flower.derived, embedding, false);
  return std::move(plant.meshes);
}

// Coordinates of a mesh's vertices along their organ (0) or across it (1), in hundredths.
std::set<int> found(const PlantMesh& mesh, std::size_t way) {
  std::set<int> found;
  for (std::size_t i = way; i < mesh.mesh.uvs.size(); i += 2)
    found.insert(static_cast<int>(std::lround(100 * mesh.mesh.uvs[i])));
  return found;
}

std::span<const std::uint32_t> numbers_of(const Columns& columns, std::string_view name) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return columns[i].as<std::uint32_t>();
  return {};
}

std::set<int> along(const PlantMesh& mesh) { return found(mesh, 0); }
std::set<int> across(const PlantMesh& mesh) { return found(mesh, 1); }

}  // namespace

TEST_CASE("coordinates across an organ: each lobe extends from the end of its inner neighbour to the next") {
  const std::vector<PlantMesh> bare = painted(leaf, 0);
  REQUIRE(bare.size() == 2);
  CHECK(across(bare[0]) == std::set{0});
  CHECK(across(bare[1]) == std::set{0, 50, 100});
}

TEST_CASE("coordinates across an organ are linear over faces after any number of rounds") {
  CHECK(across(painted(leaf, 1)[1]) == std::set{0, 25, 50, 75, 100});
  CHECK(across(painted(leaf, 2)[1]) == std::set{0, 13, 25, 38, 50, 63, 75, 88, 100});
}

TEST_CASE("coordinates along an organ: a segment ends where its neighbours begin") {
  CHECK(along(painted(leaf, 0)[1]) == std::set{0, 25, 75, 100});
}

TEST_CASE("coordinates of an organ attached to another begin at 0") {
  const std::string text = std::string("#define T(4, 0, 0, 0, 4, 2, 2, 2)\n#axiom: T\n#define finalStep=3\n") +
                           "T{}{step < 2}{} -> T[T]_{E}\nT{}{step == 2}{} -> T[&LEAF]_{C2}\n#module LEAF\n" + leaf;
  const std::vector<PlantMesh> bare = painted(text, 0);
  REQUIRE(bare.size() == 3);
  CHECK(along(bare[0]) == along(painted(leaf, 0)[0]));
  CHECK(across(bare[2]) == std::set{0, 50, 100});
}

TEST_CASE("each triangle has its volume and face, and every free face has triangles") {
  const Flower flower = grown(leaf);
  const generalized_map::Map& map = flower.derived.map;
  generalized_map::Embedding embedding;
  embedding.build(map);
  Skin skin(flower.derived, embedding, 0);
  embedding.place(skin.shapes(flower.derived));
  Plant plant;
  skin.add_to(plant, flower.program, flower.derived, embedding, false);
  std::set<std::pair<std::uint32_t, std::uint32_t>> named;
  for (const PlantMesh& mesh : plant.meshes) {
    const std::span<const std::uint32_t> volumes = numbers_of(mesh.columns, "volume"),
                                         faces = numbers_of(mesh.columns, "face");
    REQUIRE(3 * volumes.size() == mesh.mesh.indices.size());
    for (std::size_t t = 0; t < volumes.size(); ++t) {
      std::set<std::uint32_t> corners;
      const std::uint32_t first = map.dart_of(volumes[t], static_cast<generalized_map::Face>(faces[t]));
      CHECK(map.alpha(3, first) == first);
      std::uint32_t dart = first;
      do {
        corners.insert(embedding.vertex_of()[dart]);
        dart = map.alpha(1, map.alpha(0, dart));
      } while (dart != first);
      for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
        const float* const at = &mesh.mesh.positions[3 * std::size_t{mesh.mesh.indices[i]}];
        CHECK(std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
          const glm::vec3 place = metres * y_up(embedding.positions()[corner]);
          return place.x == at[0] && place.y == at[1] && place.z == at[2];
        }));
      }
      named.insert({volumes[t], faces[t]});
    }
  }
  std::size_t free = 0;
  for (std::uint32_t v = 0; v < map.volumes(); ++v)
    for (std::uint32_t face = 0; face < map.volume(v).order + 2; ++face)
      free += map.is_free(v, static_cast<generalized_map::Face>(face));
  CHECK(named.size() == free);
}

TEST_CASE("colours change quickly from bud to flower, and linearly to the wilted flower") {
  Material material;
  material.bud = {0x000000, 0x000000};
  material.open = {0x646464, 0xc8c8c8};
  material.wilted = {0x000000, 0x000000};
  CHECK(colours_at(material, 0).base == 0x000000);
  CHECK(colours_at(material, 0.5f).base == 0x4b4b4b);
  CHECK(colours_at(material, 1).tip == 0xc8c8c8);
  CHECK(colours_at(material, 1.5f).base == 0x323232);
  CHECK(colours_at(material, 2).base == 0x000000);
}
