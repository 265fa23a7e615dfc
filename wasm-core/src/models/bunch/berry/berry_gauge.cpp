#include "models/bunch/berry/berry_gauge.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"
#include "models/bunch/berry/wrinkles.hpp"

namespace panicle::bunch {
namespace {

// The direction, a unit vector, of the pattern's vertex `i` from the berry's centre.
glm::vec3 direction_of(const BerryPattern& pattern, std::size_t i) {
  return {pattern.directions[0][i], pattern.directions[1][i], pattern.directions[2][i]};
}

// The gradient of the skin's height over directions at the direction `e`, by central differences.
glm::vec3 slope_of(const FruitSkin& skin, const glm::vec3& e) {
  constexpr float step = 4e-3f;
  const glm::vec3 right = any_perpendicular(e);
  glm::vec3 slope(0);
  for (const glm::vec3& t : {right, glm::cross(e, right)}) {
    const float ahead = skin.height(glm::normalize(e + t * step));
    const float behind = skin.height(glm::normalize(e - t * step));
    slope += t * ((ahead - behind) / (2 * step));
  }
  return slope;
}

// Stores the gauge (1 / distance to the surface) and its gradient for direction `i`.
void set_entry(GaugeTable& table, std::size_t i, float value, const glm::vec3& gradient) {
  table.value[i] = value;
  table.x[i] = gradient.x;
  table.y[i] = gradient.y;
  table.z[i] = gradient.z;
}

// The values and slopes of a wrinkle field in all directions of the pattern.
GaugeTable tabulate(const BerryPattern& pattern, const Wrinkles& wrinkles) {
  GaugeTable table(pattern.padded());
  for (std::size_t i = 0; i < pattern.padded(); ++i) {
    const Wrinkles::Value wrinkle = wrinkles.at(direction_of(pattern, i));
    set_entry(table, i, wrinkle.value, wrinkle.slope);
  }
  return table;
}

constexpr float deepest_bow = 0.75f;   // over the half-width
constexpr float bow_at_middle = 0.8f;  // share of it; the ends move by the rest

// The gauge, 1 / distance to the surface, of a form that is curved like a horn, and its gradient, in a direction.
// Newton's method finds the distance at which the point, bent back to the straight form, is on its surface.
BerryMeridian::Gauge gauge_of(const BentForm& form, const glm::vec3& direction) {
  const BerryMeridian::Gauge straight = form.meridian.gauge(direction);
  const float bow = deepest_bow * form.curve;
  if (!(bow > 0)) return straight;
  float r = 1 / straight.value;
  glm::vec3 normal = straight.gradient;
  for (int step = 0; step < 8; ++step) {
    const float y = r * direction.y;
    const glm::vec3 unbent(r * direction.x - bow * (bow_at_middle - y * y), y, r * direction.z);
    const float length = glm::length(unbent);
    if (!(length > 1e-4f)) break;
    const BerryMeridian::Gauge there = form.meridian.gauge(unbent / length);
    normal = {there.gradient.x, there.gradient.y + 2 * bow * y * there.gradient.x, there.gradient.z};
    const float change = (there.value * length - 1) / glm::dot(normal, direction);
    r = std::clamp(r - change, 0.3f, 1.7f);
    if (std::fabs(change) < 1e-6f) break;
  }
  return {1 / r, normal * (1 / (r * glm::dot(normal, direction)))};
}

}  // namespace

// By how much, as a factor, a curved berry reaches further than a straight one.
float bow_reach(float curve) { return 1 + deepest_bow * bow_at_middle * curve; }

// The gauge (1 / distance to the surface) and gradient of a berry without neighbours, in all directions of the pattern:
// its form times the height of its skin.
GaugeTable free_gauge(const BerryPattern& pattern, const BentForm& bent, const FruitSkin& skin) {
  GaugeTable table(pattern.padded());
  for (std::size_t i = 0; i < pattern.padded(); ++i) {
    const glm::vec3 e = direction_of(pattern, i);
    const BerryMeridian::Gauge form = gauge_of(bent, e);
    const float height = skin.height(e);
    set_entry(table, i, form.value / height, (form.gradient - slope_of(skin, e) * (form.value / height)) / height);
  }
  return table;
}

// Tabulates four wrinkle fields: two fine ones for folds, two broad ones for their depth and for caved-in parts.
Furrows::Furrows(const BerryPattern& pattern)
    : first_(tabulate(pattern, Wrinkles(0, 6))),
      second_(tabulate(pattern, Wrinkles(1, 6))),
      broad_(tabulate(pattern, Wrinkles(3, 2.4f))),
      other_broad_(tabulate(pattern, Wrinkles(4, 2.4f))) {}

// Writes the gauge of a shrivelled berry into `result`: that of the fresh one, `free`, divided by the height that folds
// and dents leave. `id` chooses the mixture of the fields; `shrivel`: 0 … 1.
void Furrows::carve(const GaugeTable& free, std::uint32_t id, float shrivel, GaugeTable& result) const {
  constexpr float deepest = 0.24f, caved = 0.36f;  // over the distance from the centre
  constexpr float crest = 1.8f;                    // where the fold's back is flat
  constexpr float sharpness = 0.28f;
  constexpr float half_caved = 0.8f;  // the square of a field's value there
  const SinCos mix = sincos_degrees(360 * random_unit(id, 1, 0));
  const SinCos turn = sincos_degrees(360 * random_unit(id, 2, 0));
  const Four zero{0, 0, 0, 0};
  for (std::size_t i = 0; i < free.value.size(); i += 4) {
    // A fold's back is a parabola of the field's size f = √(w² + sharpness²): 1 − (1 − f / crest)² up to the crest.
    const Four w = load(&first_.value[i]) * mix.cosine + load(&second_.value[i]) * mix.sine;
    const Four size = square_root(w * w + sharpness * sharpness);
    const Four below = 1 - size * (1 / crest);
    const Four hollow = below > 0.0f ? below : zero;
    // Folds are as deep as one mix of the broad fields; the skin caves in where the other mix is above 0.
    const Four p = load(&broad_.value[i]) * turn.cosine + load(&other_broad_.value[i]) * turn.sine;
    const Four q = load(&other_broad_.value[i]) * turn.cosine - load(&broad_.value[i]) * turn.sine;
    const Four per_size = 1 / square_root(p * p + 1.0f);
    const Four depth = (0.55f + 0.45f * p * per_size) * (deepest * shrivel);
    const Four dent = q > 0.0f ? q : zero;
    const Four per_dent = 1 / (dent * dent + half_caved);
    const Four per_height = 1 / (1 - depth * hollow * hollow - dent * dent * per_dent * (caved * shrivel));
    // Derivative of the height by each of the fields.
    const Four by_fold = 2 / crest * depth * hollow * w / size;
    const Four by_depth = hollow * hollow * per_size * per_size * per_size * (-0.45f * deepest * shrivel);
    const Four by_dent = dent * per_dent * per_dent * (-2 * half_caved * caved * shrivel);
    const Four value = load(&free.value[i]) * per_height;
    const Four scale = value * per_height;
    store(&result.value[i], value);
    for (std::vector<float> GaugeTable::* axis : {&GaugeTable::x, &GaugeTable::y, &GaugeTable::z}) {
      const auto along = [axis, i](const GaugeTable& table) { return load(&(table.*axis)[i]); };
      const Four p_rises = along(broad_) * turn.cosine + along(other_broad_) * turn.sine;
      const Four q_rises = along(other_broad_) * turn.cosine - along(broad_) * turn.sine;
      const Four rise =
          by_fold * (along(first_) * mix.cosine + along(second_) * mix.sine) + by_depth * p_rises + by_dent * q_rises;
      store(&(result.*axis)[i], along(free) * per_height - scale * rise);
    }
  }
}

}  // namespace panicle::bunch
