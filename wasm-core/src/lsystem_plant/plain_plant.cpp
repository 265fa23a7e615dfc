#include "lsystem_plant/plain_plant.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "light/plant_sky.hpp"
#include "lsystem_plant/messages.generated.hpp"
#include "mesh/uv_sphere.hpp"
#include "stems/tubes.hpp"

namespace panicle {
namespace {

// The shortest turn that takes +Y to `way`, a unit vector, as a quaternion.
glm::vec4 turn_from_up(const glm::vec3& way) {
  const float w = 1 + way.y;
  if (w < 1e-6f) return {1, 0, 0, 0};  // straight down: half round x
  const float length = std::sqrt(way.x * way.x + way.z * way.z + w * w);
  return {way.z / length, 0, -way.x / length, w / length};
}

// Makes the sky that organs, as balls, and segments, as specks, leave open. Owners are numbered: segments, then organs.
Sky build_sky(const Plant& plant) {
  std::vector<SkyBody> balls;
  for (const Organ& organ : plant.organs)
    balls.push_back(
        sky_ball(organ.position, organ.scale, static_cast<std::int32_t>(plant.segments.size() + balls.size())));
  std::vector<SkyBody> specks;
  for (const Segment& segment : plant.segments)
    add_specks(segment, static_cast<std::int32_t>(&segment - plant.segments.data()), specks);
  return Sky(balls, specks);
}

// How much sky each organ sees, 0 … 255: the mean over its ball, which hides nothing from itself.
std::vector<std::uint8_t> sky_of_organs(Sky& sky, const Plant& plant) {
  const Mesh ball = make_uv_sphere(8);
  std::vector<std::uint8_t> points(ball.positions.size() / 3), means;
  for (const Organ& organ : plant.organs) {
    sky.set_receiver(
        {organ.position, organ.scale, static_cast<std::int32_t>(plant.segments.size() + means.size()), organ.segment});
    sky.set_frame({.centre = organ.position, .scale = organ.scale});
    sky.sample(ball.positions, ball.normals, points);
    std::size_t sum = points.size() / 2;
    for (const std::uint8_t point : points) sum += point;
    means.push_back(static_cast<std::uint8_t>(sum / points.size()));
  }
  return means;
}

// Adds the meshes `stems` and, where there are organs, `balls`, whose index plant_of has set to 1.
void add_meshes(Plant& plant, const PlainOptions& options) {
  const TubeOptions tubes{.sides = options.sides};
  StemMesh stems = sweep_stems({plant.segments}, tubes, 1.0f);
  Columns columns;
  if (options.sky) {
    Sky sky = build_sky(plant);
    columns.add("sky", sky_of_stems(sky, stems, plant.segments));
    if (!plant.organs.empty()) plant.columns.add("organs.sky", sky_of_organs(sky, plant));
  }
  columns.add("segment", std::move(stems.segment));
  plant.meshes.push_back({"stems", "stem", std::move(stems.mesh), {}, std::move(columns)});
  if (!plant.organs.empty()) plant.meshes.push_back({"balls", "skin", make_uv_sphere(options.ball_segments), {}, {}});
}

}  // namespace

// Turns a drawing into a plant in metres, with meshes if requested.
Plant plant_of(const Drawing& drawing, const PlainOptions& options) {
  Plant plant;
  plant.tags = {"stem"};
  plant.organ_tags = {"ball"};
  plant.segments = drawing.segments;
  for (Segment& segment : plant.segments) scale(segment, options.metres);
  constexpr std::int32_t second_mesh = 1;
  for (const Ball& ball : drawing.balls)
    plant.organs.push_back({0, ball.segment, options.meshes ? second_mesh : -1, ball.centre * options.metres,
                            turn_from_up(ball.heading), ball.radius * options.metres});
  plant.counts = {{"segments", static_cast<std::uint32_t>(plant.segments.size())},
                  {"organs", static_cast<std::uint32_t>(plant.organs.size())}};
  if (plant.segments.empty() && plant.organs.empty())
    plant.notes.push_back(message(messages::lsystem_plant::nothing_drawn));
  if (options.meshes) add_meshes(plant, options);
  set_fingerprints(plant, options.meshes && options.mesh_fingerprint);
  return plant;
}

// Derives the string of an L-system, draws it, and makes a plant of the drawing.
Result<Plant> draw_plainly(std::shared_ptr<const lsystem::Program> program, const lsystem::Inputs& inputs,
                           const PlainOptions& options, const Limits& limits) {
  const auto bound = lsystem::bind(std::move(program), inputs, limits);
  if (!bound) return bound.error();
  const auto derived = lsystem::develop(*bound.value(), options.seed, options.steps, limits);
  if (!derived) return derived.error();
  Drawing drawing(limits);
  drawing.begin();
  const auto drawn =
      lsystem::interpret(*bound.value(), *derived->string, options.turtle, drawing, options.seed, limits);
  if (!drawn) return drawn.error();
  if (drawing.trouble().reason != Reason::none) return drawing.trouble();
  Plant plant = plant_of(drawing, options);
  for (const lsystem::Remark& remark :
       lsystem::remarks(lsystem::program_of(*bound.value()), inputs.scalars, options.steps))
    plant.notes.push_back(lsystem::to_text(remark));
  return plant;
}

}  // namespace panicle
