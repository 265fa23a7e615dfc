#include "models/bunch/fruit/berry_gauge.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/bunch/fruit/wrinkles.hpp"

namespace panicle::bunch {
namespace {

glm::vec3 direction_of(const BerryPattern& pattern, std::size_t i) {
  return {pattern.directions[0][i], pattern.directions[1][i], pattern.directions[2][i]};
}

// How the skin's height changes along the sphere, by central differences.
glm::vec3 slope_of(const FruitSkin& skin, const glm::vec3& e) {
  constexpr float step = 4e-3f;
  const glm::vec3 right = glm::normalize(std::fabs(e.y) < 0.9f ? glm::vec3(e.z, 0, -e.x) : glm::vec3(0, e.z, -e.y));
  glm::vec3 slope(0);
  for (const glm::vec3& t : {right, glm::cross(e, right)}) {
    const float ahead = skin.height(glm::normalize(e + t * step));
    const float behind = skin.height(glm::normalize(e - t * step));
    slope += t * ((ahead - behind) / (2 * step));
  }
  return slope;
}

void put(GaugeTable& table, std::size_t i, float value, const glm::vec3& gradient) {
  table.value[i] = value;
  table.x[i] = gradient.x;
  table.y[i] = gradient.y;
  table.z[i] = gradient.z;
}

GaugeTable tabulate(const BerryPattern& pattern, const Wrinkles& wrinkles) {
  GaugeTable table(pattern.padded());
  for (std::size_t i = 0; i < pattern.padded(); ++i) {
    const Wrinkles::Value wrinkle = wrinkles.at(direction_of(pattern, i));
    put(table, i, wrinkle.value, wrinkle.slope);
  }
  return table;
}

}  // namespace

GaugeTable free_gauge(const BerryPattern& pattern, const BerryMeridian& meridian, const FruitSkin& skin) {
  GaugeTable table(pattern.padded());
  for (std::size_t i = 0; i < pattern.padded(); ++i) {
    const glm::vec3 e = direction_of(pattern, i);
    const BerryMeridian::Gauge form = meridian.gauge(e);
    const float height = skin.height(e);
    put(table, i, form.value / height, (form.gradient - slope_of(skin, e) * (form.value / height)) / height);
  }
  return table;
}

Furrows::Furrows(const BerryPattern& pattern)
    : first_(tabulate(pattern, Wrinkles(0, 6))), second_(tabulate(pattern, Wrinkles(1, 6))) {}

void Furrows::carve(const GaugeTable& free, std::uint32_t id, float shrivel, GaugeTable& result) const {
  constexpr float deepest = 0.26f;  // over the distance from the centre
  constexpr float crest = 1.8f;     // where the fold's back is flat
  constexpr float sharpness = 0.28f;
  const SinCos mix = sincos_degrees(360 * random_unit(id, 1, 0));
  const float depth = deepest * shrivel;
  for (std::size_t i = 0; i < free.value.size(); i += 4) {
    // A fold's back is a parabola of the field's size f = √(w² + sharpness²): 1 − (1 − f / crest)² up to the crest.
    const Four w = load(&first_.value[i]) * mix.cosine + load(&second_.value[i]) * mix.sine;
    const Four size = square_root(w * w + sharpness * sharpness);
    const Four below = 1 - size * (1 / crest);
    const Four hollow = below > 0.0f ? below : Four{0, 0, 0, 0};
    const Four per_height = 1 / (1 - depth * hollow * hollow);
    const Four rise = 2 * depth / crest * hollow * w / size;  // of the height, by the field
    const Four value = load(&free.value[i]) * per_height;
    const Four slope = value * rise * per_height;
    store(&result.value[i], value);
    const auto carve_axis = [&](const std::vector<float>& f, const std::vector<float>& a, const std::vector<float>& b,
                                std::vector<float>& out) {
      const Four along = load(&a[i]) * mix.cosine + load(&b[i]) * mix.sine;
      store(&out[i], load(&f[i]) * per_height - slope * along);
    };
    carve_axis(free.x, first_.x, second_.x, result.x);
    carve_axis(free.y, first_.y, second_.y, result.y);
    carve_axis(free.z, first_.z, second_.z, result.z);
  }
}

}  // namespace panicle::bunch
