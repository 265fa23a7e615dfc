// The model `leaf`: blocks of the request are in request.hpp. The plant has, besides the contents described in
// trail_plant.hpp and dress.hpp: tag `vein`; organs `particle`, those on their way while age is below 100, on the bent
// blade; columns
//   segments.chart  float32 × 4: x, y of start and end in the flat chart, leaf lengths
//   segments.order  uint32: 1 primary, 2 secondary … (vein_orders.hpp)
//   margin          float32 × 2: the outline's polygon, teeth and all, counter-clockwise from the base
//   chart           float32 × 3: x, y of the square that textures show, and its side (blade.hpp)
#include "protocol/model.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "models/leaf/dress.hpp"
#include "models/leaf/measures/measures.hpp"
#include "models/leaf/shape/bending.hpp"
#include "models/leaf/shape/blade.hpp"
#include "models/leaf/shape/veins.hpp"
#include "models/particles/moment.hpp"
#include "models/particles/refusals.hpp"
#include "models/particles/vein_orders.hpp"
#include "plant/fingerprint.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float thinnest = 5e-6f;  // radius of a vein, metres
// Radius of a particle: over its trail's, over the room of each at first, and in leaf lengths; large enough to be
// visible, yet apart.
constexpr float ball_widens = 1.6f, ball_share = 0.3f, least_ball = 0.0022f, largest_ball = 0.006f;

// The law of the veins' radii, in metres.
Girth girth_of(const Values& values) {
  using enum Parameter;
  return {.law = static_cast<WidthLaw>(values.whole(law)),
          .exponent = values[exponent],
          .thickest = 0.0005f * values[vein],
          .thinnest = thinnest};
}

// Collects the parameters of the blade's bends; the half-width is that of the outline's box.
Bending bending_of(const Values& values, const Outline& outline) {
  using enum Parameter;
  const glm::vec3 size = outline.high() - outline.low();
  return {.scale = 0.001f * values[length],
          .half_width = 0.5f * size.x,
          .fold = values[fold],
          .curl = values[curl],
          .undulation = 0.01f * values[undulation],
          .waves = values[waves]};
}

// The trails at an age from 0 to 100 percent of the run.
std::vector<Trails> trails_at_age(const Veins& veins, float age) {
  if (!(age < 100)) return veins.crowds;
  const float moment = veins.timeline.moment(0.01f * age);
  std::vector<Trails> young;
  for (const Trails& trails : veins.crowds) young.push_back(at_moment(trails, moment, veins.stride));
  return young;
}

// Adds the particles that are still on their way: balls on the blade. `particles`: the number of all, before any meet.
void add_particles(Plant& plant, const Veins& veins, std::span<const Trails> flat, const Bending& bending,
                   const Girth& girth, float particles) {
  plant.organ_tags = {"particle"};
  const float room = std::sqrt(veins.outline.area() / std::max(particles, 1.0f));
  const float least = std::clamp(ball_share * room, least_ball, largest_ball) * bending.scale;
  for (std::size_t c = 0; c < flat.size(); ++c)
    for (std::size_t i = 1; i < flat[c].size(); ++i) {
      if (flat[c].next[i] >= 0) continue;
      const float radius = ball_widens * radius_of(girth, flat[c].energy[i], veins.all[c]);
      const float scale = std::max(radius, least);
      const glm::vec3& place = flat[c].places[i];
      plant.organs.push_back({0, -1, -1, bending({place.x, place.y}, scale), {0, 0, 0, 1}, scale});
    }
}

// Adds the column of the order of each vein segment. `segments` are their indices by target and place.
void add_orders(Plant& plant, std::span<const Vein> veins, const std::vector<std::vector<std::int32_t>>& segments) {
  std::vector<std::uint32_t> orders(plant.segments.size(), 0);
  for (const Vein& vein : veins)
    for (std::size_t k = 1; k < vein.places.size(); ++k)
      if (const std::int32_t segment = segments[vein.crowd][vein.places[k]]; segment >= 0)
        orders[static_cast<std::size_t>(segment)] = vein.order;
  plant.columns.add("segments.order", std::move(orders));
}

// Adds the columns of the flat leaf: both ends of each vein segment, the margin, and the square that textures show;
// leaf lengths.
void add_chart(Plant& plant, const Veins& veins, std::span<const Trails> flat) {
  std::vector<float> chart;
  for (const Trails& trails : flat)
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.next[i] < 0) continue;
      const glm::vec3 &from = trails.places[static_cast<std::size_t>(trails.next[i])], &to = trails.places[i];
      chart.insert(chart.end(), {from.x, from.y, to.x, to.y});
    }
  plant.columns.add("segments.chart", std::move(chart), 4);
  plant.columns.add("margin",
                    column_of<float>(veins.margin.points, 2,
                                     [](const glm::vec2& p, float* at) {
                                       at[0] = p.x;
                                       at[1] = p.y;
                                     }),
                    2);
  const ChartSquare square = chart_square(veins.outline);
  plant.columns.add("chart", std::vector<float>{square.low.x, square.low.y, square.size}, 3);
}

// Grows a leaf: veins in the flat outline, bent into space, then meshes and measures as requested.
Result<Plant> grow(Request& request, const Limits& limits) {
  using enum Parameter;
  Plant plant;
  const auto leaf_request = read_request(request, plant.notes);
  if (!leaf_request) return leaf_request.error();
  const Values& values = leaf_request->values;
  const auto grown = grow_veins(leaf_request.value(), limits, plant.notes);
  if (!grown) return grown.error();
  const Veins& veins = grown.value();
  const Bending bending = bending_of(values, veins.outline);
  const Girth girth = girth_of(values);
  const std::vector<Trails> flat = trails_at_age(veins, values[age]);
  std::vector<Trails> bent = flat;
  for (Trails& trails : bent)
    for (glm::vec3& place : trails.places) place = bending({place.x, place.y});

  plant.tags = {"vein"};
  const auto segments = add_trails(plant, bent, veins.all, girth, {}, veins.tally, 0);
  if (Diagnostic error = too_many_parts(limits, plant.segments.size(), 0); error.reason != Reason::none) return error;
  add_particles(plant, veins, flat, bending, girth, values[particles]);
  const std::vector<Vein> ordered = veins_of(flat);
  add_orders(plant, ordered, segments);
  add_chart(plant, veins, flat);
  if (leaf_request->measures)
    plant.measures = measures_of({veins.margin, veins.outline, flat, ordered, veins.all, girth, bending.scale});
  if (leaf_request->meshes) dress(plant, leaf_request.value(), veins, flat, bending, girth);
  set_fingerprints(plant, leaf_request->mesh_fingerprint);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"leaf", grow};

}  // namespace panicle::particles::leaf
