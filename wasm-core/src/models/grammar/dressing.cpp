#include "models/grammar/dressing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <utility>

#include "foundation/mathematics.hpp"
#include "geometry/ball.hpp"
#include "geometry/tubes.hpp"
#include "models/grammar/openness.hpp"

namespace panicle::grammar {
namespace {

constexpr std::uint32_t ball_tag = 0;
constexpr std::int32_t ball_mesh = 1;
constexpr std::uint32_t ball_segments = 16;
// What is thinner than this share of the plant's largest extent is a pixel wide.
constexpr float thin = 0.002f;
constexpr std::uint32_t thin_sides = 5;
constexpr std::uint64_t most_vertices = 4'000'000;

// The shortest turn that takes +Y to `way`, a unit vector, as a quaternion.
glm::vec4 turn_from_up(const glm::vec3& way) {
  const float w = 1 + way.y;
  if (w < 1e-6f) return {1, 0, 0, 0};  // straight down: half round x
  const float length = std::sqrt(way.x * way.x + way.z * way.z + w * w);
  return {way.z / length, 0, -way.x / length, w / length};
}

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

// Of each thing its module and its colour.
void add_marks(Columns& columns, const std::string& of, std::span<const Mark> marks) {
  columns.add(of + ".module",
              column_of<std::uint32_t>(marks, 1, [](const Mark& mark, std::uint32_t* at) { *at = mark.module; }));
  columns.add(of + ".colour",
              column_of<std::uint8_t>(marks, 1, [](const Mark& mark, std::uint8_t* at) { *at = mark.colour; }));
}

// Tubes, a run a colour.
PlantMesh stems_of(const std::vector<Segment>& segments, std::span<const Mark> marks, std::uint32_t sides) {
  std::vector<std::int32_t> groups;
  groups.reserve(marks.size());
  for (const Mark& mark : marks) groups.push_back(mark.colour);
  const TubeOptions options{.sides = sides,
                            .most_vertices = most_vertices,
                            .thin = thin * extent_of(segments),
                            .thin_sides = std::min(sides, thin_sides),
                            .thin_plain = true};
  StemMesh stems = sweep_stems({.segments = segments, .groups = groups, .jointed = false}, options, 1.0f);
  PlantMesh mesh{"stems", "stem", std::move(stems.mesh), {}, {}};
  std::vector<std::uint8_t> colour;
  for (const StemPart& part : stems.parts) {
    mesh.runs.push_back({"Lines", part.first_vertex, part.vertex_count, part.first_index, part.index_count});
    colour.push_back(static_cast<std::uint8_t>(part.group));
  }
  mesh.columns.add("segment", std::move(stems.segment));
  mesh.columns.add("colour", std::move(colour));
  return mesh;
}

std::vector<Screen> screens_of(const Plant& plant) {
  std::vector<Screen> screens;
  for (const Organ& organ : plant.organs) screens.push_back({organ.position, pi * organ.scale * organ.scale});
  return screens;
}

void add_meshes(Plant& plant, const Sketch& sketch, const Dress& habit) {
  PlantMesh stems = stems_of(plant.segments, sketch.lines, habit.sides);
  if (habit.sky) {
    const Openness open(plant.segments, screens_of(plant));
    stems.columns.add("sky", open.of(stems.mesh));
    std::vector<std::uint8_t> of_organs;
    for (const Organ& organ : plant.organs) of_organs.push_back(open.at(organ.position));
    if (!of_organs.empty()) plant.columns.add("organs.sky", std::move(of_organs));
  }
  plant.meshes.push_back(std::move(stems));
  if (!plant.organs.empty()) plant.meshes.push_back({"balls", "skin", make_ball(ball_segments), {}, {}});
}

}  // namespace

void dress(Plant& plant, const Sketch& sketch, const Dress& habit) {
  plant.tags = {"stem"};
  plant.organ_tags = {"ball"};
  plant.segments = sketch.segments;
  for (Segment& segment : plant.segments) {
    segment.start *= habit.metres;
    segment.end *= habit.metres;
    segment.radius *= habit.metres;
    segment.radius_end *= habit.metres;
  }
  for (const Ball& ball : sketch.balls)
    plant.organs.push_back({ball_tag, ball.segment, habit.meshes ? ball_mesh : -1, ball.centre * habit.metres,
                            turn_from_up(ball.heading), ball.radius * habit.metres});
  add_marks(plant.columns, "segments", sketch.lines);
  if (!plant.organs.empty()) add_marks(plant.columns, "organs", sketch.spheres);
  if (habit.meshes) add_meshes(plant, sketch, habit);
}

}  // namespace panicle::grammar
