#include "models/grammar/sketch.hpp"

#include <algorithm>

#include "mesh/uv_sphere.hpp"
#include "models/grammar/messages.generated.hpp"
#include "models/grammar/surfaces.hpp"

namespace panicle::grammar {

// A lineage is the address of a module and the symbols of its ancestors; the turtle is the moving pen that draws a
// string.

namespace {

// Default colours of lines, blades and balls, as in the table of parameters.
constexpr std::uint8_t of_lines = 1, of_blades = 3, of_balls = 7;
constexpr std::uint32_t disc_surface = 4;
// Bytes in a file of a line's tube, and of each corner of a polygon. Building and writing take about four times as
// much.
constexpr std::uint64_t line_bytes = 800, corner_bytes = 100;
constexpr std::size_t max_unknown = 12;  // most unknown surfaces that notes name

// The size of a mesh in bytes.
std::uint64_t bytes_of(const Mesh& mesh) {
  return 4 * (mesh.positions.size() + mesh.normals.size() + mesh.uvs.size() + mesh.indices.size());
}

// The module and colour of a drawn part: the colour that the turtle has set, where 1 stands for the default `natural`.
Mark mark_of(const lsystem::Turtle& turtle, const lsystem::Lineage& lineage, std::uint8_t natural) {
  const auto colour = static_cast<std::uint8_t>(std::clamp<std::int32_t>(turtle.colour, 1, colours));
  return {lineage.module, colour == 1 ? natural : colour};
}

}  // namespace

// Prepares the sizes, in bytes, that organs of each kind take in a file.
Sketch::Sketch(const Limits& limits) : Drawing(limits) {
  bytes_ = {bytes_of(make_uv_sphere(many_ball_segments)), corner_bytes};
  for (std::uint32_t which = 0; which < surfaces.size(); ++which) bytes_.push_back(bytes_of(make_surface(which, true)));
}

// Reserves so many bytes of the file's limit; false, with an error, if they exceed it.
bool Sketch::has_room(std::uint64_t bytes) {
  WorkBudget* const budget = limits().budget;
  if (budget == nullptr || budget->hold(bytes)) return true;
  if (trouble().reason == Reason::none)
    fail({Reason::limit, message(messages::grammar::file_limit, budget->bytes() / 1'000'000), 0, 0});
  return false;
}

// Whether the limits allow another organ of a kind.
bool Sketch::can_add_organ(std::uint32_t tag) {
  return within(organs.size(), limits().spheres, messages::grammar::organ_limit) && has_room(bytes_[tag]);
}

// Draws a line, with its colour and module.
void Sketch::line(std::int32_t id, const lsystem::Turtle& before, const lsystem::Turtle& after,
                  const lsystem::Lineage& lineage) {
  if (has_room(line_bytes)) Drawing::line(id, before, after, lineage);
  if (lines.size() < segments.size()) lines.push_back(mark_of(after, lineage, of_lines));
}

// Adds an organ at the turtle's place and in its frame; `natural`: its default colour.
void Sketch::add_organ(std::uint32_t tag, const lsystem::Turtle& turtle, float size, std::uint8_t natural,
                       const lsystem::Lineage& lineage) {
  // A plant that has reached its limit of segments may lack some.
  const std::int32_t segment = std::min(segment_of(turtle), static_cast<std::int32_t>(segments.size()) - 1);
  organs.push_back({tag, segment, turtle.position, glm::mat3(-turtle.left, turtle.heading, turtle.up), size,
                    mark_of(turtle, lineage, natural)});
}

// Adds a ball.
void Sketch::sphere(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  if (can_add_organ(ball_tag)) add_organ(ball_tag, turtle, radius, of_balls, lineage);
}

// Adds a filled polygon.
void Sketch::polygon(const lsystem::Turtle& turtle, std::span<const glm::vec3> corners,
                     const lsystem::Lineage& lineage) {
  plate(turtle, corners, 0, lineage);
}

// Adds a polygon and its corners as an organ, within the limits. `thickness` 0: a sheet.
void Sketch::plate(const lsystem::Turtle& turtle, std::span<const glm::vec3> corners, float thickness,
                   const lsystem::Lineage& lineage) {
  if (!can_add_organ(polygon_tag) || !has_room(corner_bytes * corners.size())) return;
  if (!within(polygons.corners.size() + corners.size(), limits().moves, messages::grammar::corner_limit)) return;
  add_organ(polygon_tag, turtle, 1, of_blades, lineage);
  polygons.all.push_back({static_cast<std::uint32_t>(polygons.corners.size()),
                          static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(organs.size() - 1),
                          thickness, organs.back().mark});
  polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
}

// Adds a surface by its name. An unknown name adds nothing but a note, once each, for the first few names.
void Sketch::surface(const lsystem::Turtle& turtle, std::string_view name, float size,
                     const lsystem::Lineage& lineage) {
  const auto which = surface_named(name);
  if (!which) {
    if (unknown_.size() == max_unknown || unknown_.contains(name)) return;
    unknown_.emplace(name);
    std::string known;
    for (const NamedSurface& one : surfaces) known.append(known.empty() ? "~" : ", ~").append(one.name);
    notes.push_back(message(messages::grammar::unknown_surface, name, known));
    if (unknown_.size() == max_unknown) notes.push_back(message(messages::grammar::more_surfaces));
    return;
  }
  if (size != 0 && can_add_organ(first_surface_tag + *which))
    add_organ(first_surface_tag + *which, turtle, size, surfaces[*which].colour, lineage);
}

// Adds a disc at right angles to the heading.
void Sketch::disc(const lsystem::Turtle& turtle, float radius, const lsystem::Lineage& lineage) {
  if (radius != 0 && can_add_organ(first_surface_tag + disc_surface))
    add_organ(first_surface_tag + disc_surface, turtle, 2 * radius, surfaces[disc_surface].colour, lineage);
}

}  // namespace panicle::grammar
