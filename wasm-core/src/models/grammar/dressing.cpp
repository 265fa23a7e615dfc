#include "models/grammar/dressing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/rotation.hpp"
#include "light/sky_visibility.hpp"
#include "lsystem/trace/derivation_trace.hpp"
#include "mesh/uv_sphere.hpp"
#include "models/grammar/blades.hpp"
#include "models/grammar/messages.generated.hpp"
#include "models/grammar/surfaces.hpp"
#include "stems/tubes.hpp"

namespace panicle::grammar {
namespace {

// Lines thinner than this share of the plant's largest extent are about a pixel wide.
constexpr float thin = 0.002f;
constexpr std::uint32_t thin_sides = 5, thinnest_sides = 3;
constexpr std::uint64_t max_vertices = 4'000'000;
// From this number of lines on each is a speck of the whole: thin ones have the fewest sides, and the sky visibility of
// a line is sampled once and not at each of its vertices.
constexpr std::size_t many = 30'000;
// Strokes that turn by more than 35° meet at a corner, as those of curves and tilings do; stems bend smoothly.
constexpr float cosine_of_corner = 0.8192f;
// From this number of organs of one surface on, each is small beside the plant and gets a simpler mesh.
constexpr std::size_t many_surfaces = 4000;
// From this number of lines on meshing takes longer than all else and is too slow for a step of a drag.
constexpr std::size_t many_in_preview = 2'000;

// The longest edge of the lines' bounding box.
float extent_of(std::span<const Segment> segments) {
  if (segments.empty()) return 0;
  glm::vec3 low = segments[0].start, high = low;
  for (const Segment& segment : segments) {
    low = glm::min(low, glm::min(segment.start, segment.end));
    high = glm::max(high, glm::max(segment.start, segment.end));
  }
  const glm::vec3 size = high - low;
  return std::max({size.x, size.y, size.z});
}

// Adds the columns `.module` (or none) and `.colour` of each row.
template <class Rows, class Read>
void add_marks(Columns& columns, const std::string& of, bool marked, const Rows& rows, Read mark_of) {
  columns.add(of + ".module", column_of<std::uint32_t>(rows, 1, [&](const auto& row, std::uint32_t* at) {
                *at = marked ? mark_of(row).module : lsystem::TraceEntry::none;
              }));
  columns.add(of + ".colour",
              column_of<std::uint8_t>(rows, 1, [&](const auto& row, std::uint8_t* at) { *at = mark_of(row).colour; }));
}

// Sky visibility of the stems' vertices; where there are very many lines, of each line's middle for all of its
// vertices.
std::vector<std::uint8_t> sky_of(const SkyVisibility& visible_sky, const std::vector<Segment>& segments,
                                 const StemMesh& stems) {
  if (segments.size() < many) return visible_sky.of(stems.mesh);
  std::vector<std::uint8_t> of_segments;
  of_segments.reserve(segments.size());
  for (const Segment& segment : segments) of_segments.push_back(visible_sky.at(0.5f * (segment.start + segment.end)));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(stems.segment.size());
  for (const std::uint32_t segment : stems.segment) bytes.push_back(of_segments[segment]);
  return bytes;
}

// The point at a distance from an organ's base, along its axis.
glm::vec3 point_on_axis(const Organ& organ, float distance) {
  const glm::quat turned(organ.rotation.w, organ.rotation.x, organ.rotation.y, organ.rotation.z);
  return organ.position + turned * glm::vec3(0, distance, 0);
}

// Sky visibility of an organ. A cell of the visibility grid has one value, so a leaf that reaches out of its cell uses
// the value beyond its tip.
std::uint8_t sky_of(const SkyVisibility& visible_sky, const Organ& organ) {
  const std::uint8_t base = visible_sky.at(organ.position);
  return organ.tag < first_surface_tag
             ? base
             : std::max(base, visible_sky.at(point_on_axis(organ, organ.scale + visible_sky.edge())));
}

// Options of the tubes of lines.
TubeOptions tubes_of(const std::vector<Segment>& segments, const DressOptions& options) {
  const bool coarse = options.coarse && segments.size() >= many_in_preview;
  return {.sides = options.sides,
          .max_vertices = max_vertices,
          .thin = coarse ? std::numeric_limits<float>::max() : thin * extent_of(segments),
          .thin_sides = segments.size() < many ? std::min(options.sides, thin_sides) : thinnest_sides,
          .thin_plain = true};
}

// Makes the mesh of lines as tubes, with a run for each colour.
PlantMesh stems_of(const std::vector<Segment>& segments, std::span<const Mark> marks, const DressOptions& options,
                   const SkyVisibility* visible_sky) {
  std::vector<std::int32_t> groups;
  groups.reserve(marks.size());
  for (const Mark& mark : marks) groups.push_back(mark.colour);
  StemMesh stems = sweep_stems({.segments = segments, .groups = groups, .jointed = false, .corner = cosine_of_corner},
                               tubes_of(segments, options), 1.0f);
  Columns columns;
  if (visible_sky) columns.add("sky", sky_of(*visible_sky, segments, stems));
  PlantMesh mesh{"stems", "stem", std::move(stems.mesh), {}, std::move(columns)};
  std::vector<std::uint8_t> colour;
  for (const StemPart& part : stems.parts) {
    mesh.runs.push_back({part, "Lines"});
    colour.push_back(static_cast<std::uint8_t>(part.group));
  }
  mesh.columns.add("segment", std::move(stems.segment));
  mesh.columns.add("colour", std::move(colour));
  return mesh;
}

// The occluder of a polygon: it hides half of its area, the mean of its projections over all directions.
Occluder occluder_of(std::span<const glm::vec3> corners, float metres) {
  glm::vec3 sum(0), twice(0);
  for (const glm::vec3& corner : corners) sum += corner;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    twice += glm::cross((corners[i] - corners[0]) * metres, (corners[i + 1] - corners[0]) * metres);
  return {sum * (metres / static_cast<float>(std::max<std::size_t>(corners.size(), 1))), 0.25f * glm::length(twice)};
}

// The occluders of balls, surfaces and polygons, in metres. A surface counts half at its base and half at its tip.
std::vector<Occluder> occluders_of(const Plant& plant, const Sketch& sketch, float metres) {
  std::vector<Occluder> occluders;
  for (const Organ& organ : plant.organs) {
    const float square = organ.scale * organ.scale;
    if (organ.tag == ball_tag) occluders.push_back({organ.position, pi * square});
    if (organ.tag < first_surface_tag) continue;
    const float half = 0.5f * surfaces[organ.tag - first_surface_tag].area * square;
    occluders.push_back({organ.position, half});
    occluders.push_back({point_on_axis(organ, organ.scale), half});
  }
  for (const Polygon& polygon : sketch.polygons.all)
    occluders.push_back(occluder_of(std::span(sketch.polygons.corners).subspan(polygon.first, polygon.count), metres));
  return occluders;
}

// Adds the meshes that organs share, for the tags in use, and sets each organ's mesh index.
void add_shared(Plant& plant) {
  std::array<std::int32_t, first_surface_tag + surfaces.size()> meshes;
  std::array<std::size_t, meshes.size()> counts{};
  meshes.fill(-1);
  for (const Organ& organ : plant.organs) ++counts[organ.tag];
  for (Organ& organ : plant.organs) {
    if (organ.tag == polygon_tag) continue;
    std::int32_t& mesh = meshes[organ.tag];
    if (mesh < 0) {
      mesh = static_cast<std::int32_t>(plant.meshes.size());
      if (organ.tag == ball_tag) {
        plant.meshes.push_back({"balls",
                                "skin",
                                make_uv_sphere(counts[ball_tag] > many_surfaces ? many_ball_segments : ball_segments),
                                {},
                                {}});
      } else {
        const std::uint32_t which = organ.tag - first_surface_tag;
        const NamedSurface& surface = surfaces[which];
        plant.meshes.push_back({std::string(surface.name),
                                std::string(surface.material),
                                make_surface(which, counts[organ.tag] > many_surfaces),
                                {},
                                {}});
      }
    }
    organ.mesh = mesh;
  }
}

// Adds a note if polygons have no area.
void note_empty(Plant& plant, std::uint32_t empty) {
  if (empty == 0) return;
  plant.notes.push_back(message(messages::grammar::flat_polygons, empty));
}

// Adds the meshes of lines, polygons and organs, with their sky visibility if requested.
void add_meshes(Plant& plant, const Sketch& sketch, const DressOptions& options) {
  std::optional<SkyVisibility> visible_sky;
  if (options.sky) visible_sky.emplace(plant.segments, occluders_of(plant, sketch, options.metres));
  PlantMesh stems = stems_of(plant.segments, sketch.lines, options, visible_sky ? &*visible_sky : nullptr);
  std::uint32_t empty = 0;
  PlantMesh blades = blades_of(sketch.polygons, options.metres, empty, options.budget);
  note_empty(plant, empty);
  if (visible_sky) {
    if (!blades.runs.empty()) blades.columns.add("sky", visible_sky->of(blades.mesh));
    std::vector<std::uint8_t> of_organs;
    for (const Organ& organ : plant.organs) of_organs.push_back(sky_of(*visible_sky, organ));
    if (!of_organs.empty()) plant.columns.add("organs.sky", std::move(of_organs));
  }
  plant.meshes.push_back(std::move(stems));
  if (!blades.runs.empty()) plant.meshes.push_back(std::move(blades));
  add_shared(plant);
}

}  // namespace

// Turns the sketch, the drawn lines and organs in the text's unit, into a plant in metres, with meshes if requested.
void dress(Plant& plant, const Sketch& sketch, const DressOptions& options) {
  plant.tags = {"stem"};
  plant.organ_tags = {"ball", "polygon"};
  for (const NamedSurface& surface : surfaces) plant.organ_tags.emplace_back(surface.name);
  plant.segments = sketch.segments;
  for (Segment& segment : plant.segments) scale(segment, options.metres);
  for (const SketchOrgan& one : sketch.organs)
    plant.organs.push_back(
        {one.tag, one.segment, -1, one.place * options.metres, quaternion_of(one.frame), one.size * options.metres});
  add_marks(plant.columns, "segments", options.marked, sketch.lines, [](const Mark& mark) { return mark; });
  if (!plant.organs.empty())
    add_marks(plant.columns, "organs", options.marked, sketch.organs, [](const SketchOrgan& one) { return one.mark; });
  if (options.meshes) add_meshes(plant, sketch, options);
}

}  // namespace panicle::grammar
