#include "plant/model.hpp"

#include <glm/common.hpp>
#include <utility>

#include "models/particles/leaf/bending.hpp"
#include "models/particles/leaf/veins.hpp"
#include "models/particles/moment.hpp"
#include "plant/plain.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float thinnest = 5e-6f;  // radius of a vein, metres

Girth girth_of(const Values& values) {
  using enum Parameter;
  return {.law = static_cast<WidthLaw>(values.whole(law)),
          .exponent = values[exponent],
          .thickest = 0.0005f * values[vein],
          .thinnest = thinnest};
}

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

Result<Plant> grow(Request& request, const Limits&) {
  using enum Parameter;
  Plant plant;
  const auto asked = read_request(request, plant.notes);
  if (!asked) return asked.error();
  const Values& values = asked->values;
  auto grown = grow_veins(asked.value(), plant.notes);
  if (!grown) return grown.error();
  Veins& veins = grown.value();
  const Bending bending = bending_of(values, veins.outline);
  const float moment = 0.01f * values[age] * static_cast<float>(veins.tally.steps);
  std::vector<Trails> flat, bent;
  for (const Trails& trails : veins.crowds) flat.push_back(values[age] < 100 ? at_moment(trails, moment, veins.stride) : trails);
  bent = flat;
  for (Trails& trails : bent)
    for (glm::vec3& place : trails.places) place = bending({place.x, place.y});
  plant.tags = {"vein"};
  add_trails(plant, bent, veins.all, girth_of(values), {}, veins.tally, 0);
  std::vector<float> chart;
  for (const Trails& trails : flat)
    for (std::size_t i = 0; i < trails.size(); ++i) {
      if (trails.next[i] < 0) continue;
      const glm::vec3 &from = trails.places[static_cast<std::size_t>(trails.next[i])], &to = trails.places[i];
      chart.insert(chart.end(), {from.x, from.y, to.x, to.y});
    }
  plant.columns.add("segments.chart", std::move(chart), 4);
  plant.columns.add("margin", column_of<float>(veins.margin.points, 2, [](const glm::vec2& p, float* at) {
                      at[0] = p.x;
                      at[1] = p.y;
                    }), 2);
  plant.fingerprint = fingerprint_of(plant);
  return plant;
}

}  // namespace

extern const Model model;
const Model model{"leaf", grow};

}  // namespace panicle::particles::leaf
