#include "boundary/sections.hpp"

#include <utility>

#include "foundation/bits.hpp"

namespace panicle::boundary {
namespace {

std::uint32_t word(float value) { return bit_cast<std::uint32_t>(value); }
std::uint32_t word(std::int32_t value) { return bit_cast<std::uint32_t>(value); }
std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }
std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }

void add(std::vector<std::uint32_t>& words, const glm::vec3& point) {
  words.push_back(word(point.x));
  words.push_back(word(point.y));
  words.push_back(word(point.z));
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

Sections::Sections(const Diagnostic& diagnostic) : text_(diagnostic.message) {
  pack(PANICLE_SECTION_STATUS, {static_cast<std::uint32_t>(diagnostic.reason), diagnostic.line, diagnostic.column});
  sections_[PANICLE_SECTION_MESSAGE] = bytes_of(text_);
}

Sections::Sections(bunch::Grown grown) : grown_(std::move(grown)) {
  pack(PANICLE_SECTION_STATUS, {0, 0, 0});
  for (const std::string& note : grown_.notes) text_ += (text_.empty() ? "" : "\n") + note;
  sections_[PANICLE_SECTION_NOTES] = bytes_of(text_);
  pack_plan(PANICLE_SECTION_PLAN, grown_.plan);
  if (grown_.second) pack_plan(PANICLE_SECTION_SECOND, *grown_.second);
  const bunch::Counts& counts = grown_.counts;
  pack(PANICLE_SECTION_COUNTS,
       {counts.end_structures, counts.internodes, counts.pedicels, counts.berries, counts.withered, counts.cut});
  pack_skeleton();
  pack(PANICLE_SECTION_FINGERPRINTS, {low(grown_.fingerprint), high(grown_.fingerprint), low(grown_.mesh_fingerprint),
                                      high(grown_.mesh_fingerprint)});
  pack_natural();
  pack_meshes();
}

std::span<const std::uint8_t> Sections::section(std::uint32_t id) const {
  return id < PANICLE_SECTION_COUNT ? sections_[id] : std::span<const std::uint8_t>();
}

void Sections::pack(std::uint32_t id, std::vector<std::uint32_t> words) {
  packed_[id] = std::move(words);
  show(id, packed_[id]);
}

template <class Value>
void Sections::show(std::uint32_t id, const std::vector<Value>& values) {
  sections_[id] = {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(Value)};
}

void Sections::pack_plan(std::uint32_t id, const bunch::Plan& plan) {
  std::vector<std::uint32_t> words;
  for (const bunch::SidePlan& side : plan.sides) {
    words.push_back(word(side.point.width));
    words.push_back(word(side.point.drop));
    words.push_back(word(side.n));
    words.push_back(word(side.rd));
  }
  words.push_back(word(plan.m));
  for (const std::int32_t n : plan.axes) words.push_back(word(n));
  pack(id, std::move(words));
}

void Sections::pack_skeleton() {
  std::vector<std::uint32_t> internodes, ends, radii, spheres, directions, parents;
  internodes.reserve(grown_.internodes.size() * 4);
  ends.reserve(grown_.internodes.size() * 6);
  for (const bunch::Internode& internode : grown_.internodes) {
    internodes.insert(internodes.end(), {word(internode.parent), static_cast<std::uint32_t>(internode.kind),
                                         word(internode.axis), static_cast<std::uint32_t>(internode.state)});
    add(ends, internode.start);
    add(ends, internode.end);
    radii.push_back(word(internode.radius));
    radii.push_back(word(internode.radius_end));
  }
  for (const bunch::Berry& berry : grown_.berries) {
    add(spheres, berry.centre);
    spheres.push_back(word(berry.radius));
    add(directions, berry.direction);
    parents.push_back(word(berry.parent));
  }
  pack(PANICLE_SECTION_INTERNODES, std::move(internodes));
  pack(PANICLE_SECTION_INTERNODE_ENDS, std::move(ends));
  pack(PANICLE_SECTION_INTERNODE_RADII, std::move(radii));
  pack(PANICLE_SECTION_BERRIES, std::move(spheres));
  pack(PANICLE_SECTION_BERRY_DIRECTIONS, std::move(directions));
  pack(PANICLE_SECTION_BERRY_PARENTS, std::move(parents));
}

void Sections::pack_natural() {
  pack(PANICLE_SECTION_PROCEDURE, {grown_.natural, static_cast<std::uint32_t>(grown_.form.fruit),
                                   word(grown_.form.taper), word(grown_.form.blunt)});
  std::vector<std::uint32_t> ids, thinned;
  for (const bunch::Berry& berry : grown_.berries) ids.push_back(berry.id);
  for (const bunch::Thinned& one : grown_.thinned) {
    thinned.push_back(one.id);
    thinned.push_back(static_cast<std::uint32_t>(one.why));
    add(thinned, one.place);
  }
  pack(PANICLE_SECTION_BERRY_IDS, std::move(ids));
  pack(PANICLE_SECTION_THINNED, std::move(thinned));
  show(PANICLE_SECTION_BERRY_TRAITS, grown_.traits);
  show(PANICLE_SECTION_MEASURES, grown_.measures);
  if (grown_.surfaces) {
    const bunch::BerrySurfaces& surfaces = *grown_.surfaces;
    show(PANICLE_SECTION_SURFACE_POSITIONS, surfaces.positions);
    show(PANICLE_SECTION_SURFACE_NORMALS, surfaces.normals);
    show(PANICLE_SECTION_SURFACE_UVS, surfaces.uvs);
    show(PANICLE_SECTION_SURFACE_INDICES, surfaces.indices);
    show(PANICLE_SECTION_SURFACE_PRESSED, surfaces.pressed);
  }
  if (grown_.foliage) {
    std::vector<std::uint32_t> parts;
    for (const bunch::FoliagePart& part : grown_.foliage->parts)
      parts.insert(parts.end(), {static_cast<std::uint32_t>(part.kind), part.first_vertex, part.vertex_count,
                                 part.first_index, part.index_count});
    pack(PANICLE_SECTION_FOLIAGE_PARTS, std::move(parts));
    show_mesh(PANICLE_SECTION_FOLIAGE_POSITIONS, grown_.foliage->mesh);
  }
  if (grown_.flower) show_mesh(PANICLE_SECTION_FLOWER_POSITIONS, *grown_.flower);
}

// Positions, normals, texture coordinates and indices stand in four sections in a row.
void Sections::show_mesh(std::uint32_t first, const Mesh& mesh) {
  show(first, mesh.positions);
  show(first + 1, mesh.normals);
  show(first + 2, mesh.uvs);
  show(first + 3, mesh.indices);
}

void Sections::pack_meshes() {
  if (grown_.stem) {
    const StemMesh& stem = *grown_.stem;
    show_mesh(PANICLE_SECTION_STEM_POSITIONS, stem.mesh);
    show(PANICLE_SECTION_STEM_INTERNODES, stem.segment);
    std::vector<std::uint32_t> parts;
    for (const StemPart& part : stem.parts)
      parts.insert(parts.end(),
                   {word(part.group), part.first_vertex, part.vertex_count, part.first_index, part.index_count});
    pack(PANICLE_SECTION_STEM_PARTS, std::move(parts));
  }
  if (grown_.berry) show_mesh(PANICLE_SECTION_BERRY_POSITIONS, *grown_.berry);
}

}  // namespace panicle::boundary
