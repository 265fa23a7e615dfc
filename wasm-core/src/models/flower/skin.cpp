#include "models/flower/skin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "environment/openness.hpp"
#include "generalized_map/boundary.hpp"
#include "lsystem/diagnostics.hpp"
#include "models/flower/ranks.hpp"
#include "models/flower/upright.hpp"

namespace panicle::flower {
namespace {

constexpr std::uint32_t most_triangles = 4'000'000;

struct Standard {
  const char* kind;
  std::uint32_t base, tip;
};

// For numbers that the text says nothing of.
constexpr std::array<Standard, 10> standards = {{{"stem", 0x6f8f4a, 0x6f8f4a},
                                                 {"stem", 0x5f8a3c, 0x76a04c},
                                                 {"leaf", 0x4f7f3a, 0x6a9a48},
                                                 {"sepal", 0x6a8f45, 0x8aa55a},
                                                 {"petal", 0xd9a441, 0xc8283c},
                                                 {"stamen", 0xe3d9a8, 0xe0b531},
                                                 {"stem", 0x6a9146, 0x7fa552},
                                                 {"pistil", 0x9db36a, 0xc7cf8c},
                                                 {"seed", 0x5a4630, 0x6b5438},
                                                 {"petal", 0xf4f1e8, 0xffffff}}};

// A closed skin as triangles, and whose each is.
struct Skin {
  ClosedSurface surface;
  std::vector<std::uint32_t> of_face;  // the boundary's face that each came from
};

Skin rounded(ClosedSurface surface, std::uint32_t rounds) {
  Skin skin{std::move(surface), {}};
  skin.of_face.resize(skin.surface.faces);
  for (std::uint32_t f = 0; f < skin.surface.faces; ++f) skin.of_face[f] = f;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    std::vector<std::uint32_t> finer(skin.surface.half_edges());
    for (std::uint32_t h = 0; h < skin.surface.half_edges(); ++h) finer[h] = skin.of_face[skin.surface.face[h]];
    skin.surface = subdivided(skin.surface);
    skin.of_face = std::move(finer);
  }
  return skin;
}

}  // namespace

Material material_of(const Program& program, std::uint32_t number) {
  for (const Material& material : program.materials)
    if (material.number == number) return material;
  const Standard& standard = standards[number % standards.size()];
  return {number, standard.kind, standard.base, standard.tip, {}};
}

Diagnostic add_skin(Plant& plant, const Program& program, const Derived& derived,
                    const generalized_map::Embedding& embedding, std::uint32_t rounds, bool sky) {
  const generalized_map::Boundary boundary = generalized_map::boundary_of(derived.map, embedding);
  std::uint64_t triangles = 2ull * boundary.surface.half_edges();
  for (std::uint32_t round = 1; round < rounds; ++round) triangles *= 4;
  if (triangles > most_triangles)
    return lsystem::error_at(Reason::limit, {},
                             "The flower has % triangles; the limit is %. Ask for it less smooth, or for fewer steps.",
                             {std::to_string(triangles), std::to_string(most_triangles)});
  const Skin skin = rounded(boundary.surface, rounds);
  const ClosedSurface& surface = skin.surface;
  const std::vector<glm::vec3> normals = normals_of(surface);
  const Ranks ranks = ranks_of(derived);

  // Where in its organ each vertex is: the mean of the volumes about it.
  std::vector<glm::vec2> places(surface.positions.size(), glm::vec2(0));
  std::vector<std::uint32_t> about(surface.positions.size(), 0);
  std::vector<glm::vec2> of_volume(derived.map.volumes());
  for (std::uint32_t v = 0; v < of_volume.size(); ++v) {
    const Rank rank = ranks.of_volume[v], most = ranks.most[derived.records[derived.record_of[v]].instance];
    of_volume[v] = {static_cast<float>(rank.along) / static_cast<float>(std::max<std::uint16_t>(most.along, 1)),
                    static_cast<float>(rank.beside) / static_cast<float>(std::max<std::uint16_t>(most.beside, 1))};
  }
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    places[surface.origin[h]] += of_volume[boundary.volume[skin.of_face[surface.face[h]]]];
    ++about[surface.origin[h]];
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    if (about[i] > 0) places[i] /= static_cast<float>(about[i]);

  // The first half-edge of each face, by what it is made of.
  std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
  bool strange = false;
  const auto number_of = [&](std::uint32_t volume) -> std::uint32_t {
    const float m = derived.values[derived.record_of[volume]][static_cast<std::size_t>(Field::material)];
    const bool is_number = m >= 0 && m < 256 && std::floor(m) == m;
    strange |= !is_number;
    return is_number ? static_cast<std::uint32_t>(m) : 0;
  };
  for (std::uint32_t h = 0, face = nobody; h < surface.half_edges(); ++h) {
    if (surface.face[h] == face) continue;
    face = surface.face[h];
    faces[number_of(boundary.volume[skin.of_face[face]])].push_back(h);
  }
  if (strange) plant.notes.emplace_back("Where m is no whole number from 0 to 255 it is taken for 0.");

  std::vector<PlantMesh> meshes;
  std::vector<Screen> screens;
  std::vector<std::uint32_t> corners, of_vertex(surface.positions.size(), nobody), used;
  for (const auto& [number, firsts] : faces) {
    PlantMesh& part = meshes.emplace_back();
    part.name = "m" + std::to_string(number);
    part.material = material_of(program, number).kind;
    Mesh& mesh = part.mesh;
    std::vector<std::uint32_t> volumes, own_faces;
    for (const std::uint32_t first : firsts) {
      const std::uint32_t from = skin.of_face[surface.face[first]];
      corners.clear();
      std::uint32_t edge = first;
      do {
        const std::uint32_t vertex = surface.origin[edge];
        std::uint32_t& here = of_vertex[vertex];
        if (here == nobody) {
          here = static_cast<std::uint32_t>(mesh.positions.size() / 3);
          used.push_back(vertex);
          put(mesh.positions, metres * upright(surface.positions[vertex]));
          put(mesh.normals, upright(normals[vertex]));
          put(mesh.uvs, places[vertex]);
        }
        corners.push_back(here);
        edge = surface.next[edge];
      } while (edge != first);
      for (std::size_t i = 2; i < corners.size(); ++i) {
        put(mesh.indices, corners[0], corners[i - 1], corners[i]);
        volumes.push_back(boundary.volume[from]);
        own_faces.push_back(boundary.face[from]);
      }
      if (!sky) continue;
      const std::uint32_t second = surface.next[first], third = surface.next[second];
      const glm::vec3& a = surface.positions[surface.origin[first]];
      const glm::vec3 b = surface.positions[surface.origin[second]] - a,
                      c = surface.positions[surface.origin[third]] - a;
      screens.push_back({metres * upright(a), 0.25f * metres * metres * glm::length(glm::cross(b, c))});
    }
    for (const std::uint32_t vertex : used) of_vertex[vertex] = nobody;
    used.clear();
    part.columns.add("volume", std::move(volumes));
    part.columns.add("face", std::move(own_faces));
  }
  std::optional<Openness> open;
  if (sky) open.emplace(plant.segments, screens);
  for (PlantMesh& part : meshes) {
    if (open) part.columns.add("sky", open->of(part.mesh));
    plant.meshes.push_back(std::move(part));
  }
  return {};
}

}  // namespace panicle::flower
