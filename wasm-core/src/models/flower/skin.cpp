#include "models/flower/skin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "expression/diagnostics.hpp"
#include "expression/messages.generated.hpp"
#include "expression/number_text.hpp"
#include "foundation/bytes.hpp"
#include "light/sky_visibility.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/thickness.hpp"
#include "models/flower/units.hpp"

namespace panicle::flower {

// A dart is one of the two half-edges of an edge of a face.

namespace {

// The material of a number that the text does not define: kind, and colours 0xrrggbb at base and tip.
struct Standard {
  const char* kind;
  std::uint32_t base, tip;
};

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

// Interpolates two colours, channel by channel.
std::uint32_t mixed(std::uint32_t from, std::uint32_t to, float share) {
  std::uint32_t colour = 0;
  for (const std::uint32_t shift : {0u, 8u, 16u}) {
    const auto a = static_cast<float>(from >> shift & 255), b = static_cast<float>(to >> shift & 255);
    colour |= static_cast<std::uint32_t>(a + (b - a) * share + 0.5f) << shift;
  }
  return colour;
}

// Converts the value m of a volume to a material's number. Returns false, and number 0, if it is not a whole number
// from 0 to 255.
bool number_of(float m, std::uint8_t& number) {
  const bool is_number = m >= 0 && m < 256 && std::floor(m) == m;
  number = is_number ? static_cast<std::uint8_t>(m) : 0;
  return is_number;
}

// A note on a volume whose m is not a material's number, with the line that gives it.
std::string note_on_material(const Program& program, const Derived& derived, std::uint32_t volume) {
  std::vector<const GrowAction*> growths(program.growths, nullptr);
  std::vector<const Production*> splits(program.productions.size(), nullptr);
  for (const Production& production : program.productions) {
    splits[production.number] = &production;
    for (const GrowAction& growth : production.growths) growths[growth.number] = &growth;
  }
  expression::SourceLocation place;
  const auto gives = [&](const Description& description) {
    const bool does = place.line == 0 && description.has(Field::material);
    if (does) place = description.places[static_cast<std::size_t>(Field::material)];
  };
  for (const Record* record = &derived.records[derived.record_of[volume]]; place.line == 0;
       record = &derived.records[record->before]) {
    const bool grown = record->kind == Record::Kind::grown;
    if (grown) gives(growths[record->source]->arguments);
    if (record->kind == Record::Kind::rest) gives(splits[record->source]->rest_description);
    if (record->kind == Record::Kind::part) gives(splits[record->source]->part_description);
    const bool begins = record->before == invalid || record->instance != record->maker;
    if (begins) gives(program.grammars[derived.instances[record->instance].grammar].axiom_arguments);
    if (record->before == invalid || (grown && !record->inherits)) {
      gives(program.labels[record->label].description);
      break;
    }
  }
  if (place.line == 0) place = program.labels[derived.map.volume(volume).label].description.place;
  const float m = derived.values[derived.record_of[volume]][static_cast<std::size_t>(Field::material)];
  return message(messages::expression::at_line, place.line,
                 message(messages::flower::material_number, program.labels[derived.map.volume(volume).label].name,
                         expression::number_text(m)));
}

}  // namespace

// The material of a number: the text's own or a standard one.
Material material_of(const Program& program, std::uint32_t number) {
  for (const Material& material : program.materials)
    if (material.number == number) return material;
  const Standard& standard = standards[number % standards.size()];
  Material material;
  material.number = number;
  material.kind = standard.kind;
  material.open = material.bud = material.wilted = {standard.base, standard.tip};
  material.light = light_through(material.kind);
  return material;
}

// The colours of a material at an age: 0 bud, 1 open, 2 wilted.
Colours colours_at(const Material& material, float age) {
  const Colours &from = age < 1 ? material.bud : material.wilted, &to = material.open;
  // Buds colour before they open: half-way they would be brown, as red and green are together.
  const float share = age < 1 ? age * (2 - age) : 2 - age;
  return {mixed(from.base, to.base, share), mixed(from.tip, to.tip, share)};
}

// The rounds of subdivision, at most the requested ones, that keep the skin within the limit of triangles.
std::uint32_t Skin::rounds_for(const Derived& derived, std::uint32_t requested) {
  std::uint64_t free = 0;
  for (std::uint32_t dart = 0; dart < derived.map.darts(); ++dart) free += derived.map.alpha(3, dart) == dart;
  // There are two darts for each edge of a face, and so two triangles after the first round; each round makes four of
  // each.
  std::uint32_t rounds = requested;
  while (rounds > 1 && free << 2 * (rounds - 1) > max_triangles) --rounds;
  return rounds;
}

// Builds the topology of a flower's skin: its boundary and the surfaces refined from it.
Skin::Skin(const Derived& derived, const generalized_map::Embedding& embedding, std::uint32_t rounds) {
  const generalized_map::Map& map = derived.map;
  generalized_map::Boundary boundary = generalized_map::boundary_of(map, embedding);
  is_tube_ = tubes_of(derived, boundary);

  volume_ = std::move(boundary.volume);
  corners_.emplace(derived, boundary.surface, volume_);
  face_ = std::move(boundary.face);
  levels_.push_back(std::move(boundary.surface));
  for (std::uint32_t round = 0; round < rounds; ++round) {
    const ClosedSurface& surface = levels_.back();
    std::vector<std::uint32_t> volume(surface.half_edges());
    std::vector<generalized_map::Face> face(surface.half_edges());
    for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
      volume[h] = volume_[surface.face[h]];
      face[h] = face_[surface.face[h]];
    }
    volume_ = std::move(volume);
    face_ = std::move(face);
    levels_.push_back(refined(surface));
  }
  const ClosedSurface& last = levels_.back();
  begin_.reserve(last.faces + 1);
  // Half-edges of a face are consecutive.
  for (std::uint32_t h = 0, face = invalid; h < last.half_edges(); ++h) {
    if (last.face[h] == face) continue;
    face = last.face[h];
    begin_.push_back(h);
  }
  begin_.push_back(last.half_edges());
}

// The shapes of all volumes, widened so that the refined skin has the widths of the text.
std::vector<generalized_map::Shape> Skin::shapes(const Derived& derived) const {
  return shapes_to_round(derived, is_tube_, rounds());
}

// Divides the faces of the refined surface into parts, one for each number of a material, with vertices of its own;
// faces become fans of triangles.
void Skin::build_parts(const std::vector<std::uint8_t>& numbers) {
  const ClosedSurface& surface = levels_.back();
  std::array<std::vector<std::uint32_t>, 256> faces;
  for (std::uint32_t f = 0; f < surface.faces; ++f) faces[numbers[volume_[f]]].push_back(f);
  parts_.clear();
  std::vector<std::uint32_t> part_vertex_of(surface.positions.size(), invalid);
  for (std::uint32_t number = 0; number < faces.size(); ++number) {
    const std::vector<std::uint32_t>& faces_of_part = faces[number];
    if (faces_of_part.empty()) continue;
    Part& part = parts_.emplace_back();
    part.number = number;
    std::size_t corners = 0;
    for (const std::uint32_t f : faces_of_part) corners += begin_[f + 1] - begin_[f];
    const std::size_t triangles = corners - 2 * faces_of_part.size();
    std::vector<std::uint32_t> volumes, own_faces;
    part.corners.reserve(corners);
    part.halves.reserve(corners);
    part.begins.reserve(faces_of_part.size() + 1);
    part.indices.reserve(3 * triangles);
    volumes.reserve(triangles);
    own_faces.reserve(triangles);
    for (const std::uint32_t f : faces_of_part) {
      const auto begin = static_cast<std::uint32_t>(part.corners.size());
      part.begins.push_back(begin);
      for (std::uint32_t edge = begin_[f]; edge < begin_[f + 1]; ++edge) {
        std::uint32_t& part_vertex = part_vertex_of[surface.origin[edge]];
        if (part_vertex == invalid) {
          part_vertex = static_cast<std::uint32_t>(part.vertices.size());
          part.vertices.push_back(surface.origin[edge]);
        }
        part.corners.push_back(part_vertex);
        part.halves.push_back(edge);
      }
      for (std::size_t i = begin + 2; i < part.corners.size(); ++i) {
        put(part.indices, part.corners[begin], part.corners[i - 1], part.corners[i]);
        volumes.push_back(volume_[f]);
        own_faces.push_back(face_[f]);
      }
    }
    part.begins.push_back(static_cast<std::uint32_t>(part.corners.size()));
    for (const std::uint32_t vertex : part.vertices) part_vertex_of[vertex] = invalid;
    part.volumes = std::make_shared<const std::vector<std::uint32_t>>(std::move(volumes));
    part.faces = std::make_shared<const std::vector<std::uint32_t>>(std::move(own_faces));
  }
}

// Places the refined surface by the flower's values and adds one mesh for each material. Returns the numbers of the
// materials.
std::vector<std::uint32_t> Skin::add_to(Plant& plant, const Program& program, const Derived& derived,
                                        const generalized_map::Embedding& embedding, bool sky) {
  // Places the refined surface, its normals and its positions in organs.
  std::copy(embedding.positions().begin(), embedding.positions().end(), levels_.front().positions.begin());
  for (std::size_t i = 1; i < levels_.size(); ++i) place_refined(levels_[i - 1], levels_[i]);
  const ClosedSurface& surface = levels_.back();
  const std::vector<glm::vec3> normals = normals_of(surface);
  std::vector<glm::vec2> places = corners_->places(derived);
  for (std::size_t i = 1; i < levels_.size(); ++i) places = refined_places(levels_[i - 1], places);

  // Materials by volume; a visible volume without a valid one is noted, and parts are built anew only if any differs.
  std::vector<std::uint8_t> numbers(derived.map.volumes());
  std::uint32_t invalid_volume = invalid;
  std::vector<std::uint8_t> is_seen(derived.map.volumes(), 0);
  for (const std::uint32_t volume : volume_) is_seen[volume] = 1;
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    const float m = derived.values[derived.record_of[v]][static_cast<std::size_t>(Field::material)];
    if (!number_of(m, numbers[v]) && is_seen[v] != 0 && invalid_volume == invalid) invalid_volume = v;
  }
  if (invalid_volume != invalid) plant.notes.push_back(note_on_material(program, derived, invalid_volume));
  if (numbers != numbers_ || parts_.empty()) build_parts(numbers);
  numbers_ = std::move(numbers);

  std::vector<std::uint32_t> materials;
  std::vector<Occluder> occluders;
  for (const Part& part : parts_) {
    materials.push_back(part.number);
    PlantMesh& mesh = plant.meshes.emplace_back();
    mesh.name = std::string("m").append(std::to_string(part.number));
    mesh.material = material_of(program, part.number).kind;
    mesh.mesh.indices = part.indices;
    const std::size_t vertices = part.vertices.size();
    mesh.mesh.positions.resize(3 * vertices);
    mesh.mesh.normals.resize(3 * vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      put(metres * y_up(surface.positions[part.vertices[i]]), &mesh.mesh.positions[3 * i]);
      put(y_up(normals[part.vertices[i]]), &mesh.mesh.normals[3 * i]);
    }
    // Positions of vertices in their organs: the mean over the corners there, which differ between organs.
    std::vector<glm::vec2> sums(vertices, glm::vec2(0));
    std::vector<float> about(vertices, 0);
    for (std::size_t c = 0; c < part.corners.size(); ++c) {
      sums[part.corners[c]] += places[part.halves[c]];
      about[part.corners[c]] += 1;
    }
    mesh.mesh.uvs.resize(2 * vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      mesh.mesh.uvs[2 * i] = sums[i].x / about[i];
      mesh.mesh.uvs[2 * i + 1] = sums[i].y / about[i];
    }
    mesh.columns.share("volume", part.volumes);
    mesh.columns.share("face", part.faces);
    if (!sky) continue;
    for (std::size_t f = 0; f + 1 < part.begins.size(); ++f) {
      const auto corner = [&](std::uint32_t i) -> const glm::vec3& {
        return surface.positions[part.vertices[part.corners[part.begins[f] + i]]];
      };
      const glm::vec3 &a = corner(0), b = corner(1) - a, c = corner(2) - a;
      occluders.push_back({metres * y_up(a), 0.25f * metres * metres * glm::length(glm::cross(b, c))});
    }
  }
  if (!sky) return materials;
  const SkyVisibility open(plant.segments, occluders);
  for (PlantMesh& mesh : plant.meshes) mesh.columns.add("sky", open.of(mesh.mesh));
  return materials;
}

// The memory that it holds, roughly.
std::uint64_t Skin::bytes() const {
  std::uint64_t bytes =
      bytes_of(volume_) + corners_->bytes() + bytes_of(face_) + bytes_of(begin_) + 2 * bytes_of(numbers_);
  for (const ClosedSurface& level : levels_) bytes += 16ull * level.half_edges() + bytes_of(level.positions);
  for (const Part& part : parts_)
    bytes += bytes_of(part.vertices) + bytes_of(part.corners) + bytes_of(part.halves) + bytes_of(part.begins) +
             bytes_of(part.indices) + bytes_of(*part.volumes) + bytes_of(*part.faces);
  return bytes;
}

}  // namespace panicle::flower
