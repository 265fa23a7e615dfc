#include "models/bunch/berry/berry_meridian.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

const BerryForm forms[] = {
    {}, {1, 0}, {-1, 0}, {0, 1}, {0, 0.4f}, {0.5f, 0.5f}, {-1, 1}, {1, 1}, {-0.3f, 0.1f}, {0, 0, Fruit::bramble},
};

// The volume by cones from the centre: ∫ r³ / 3 over all directions.
double volume_by_cones(const BerryMeridian& meridian) {
  constexpr int steps = 2000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double y = -1 + (2 * i + 1.0) / steps;
    const glm::vec3 direction(std::sqrt(1 - y * y), y, 0);
    sum += std::pow(meridian.gauge(direction).value, -3.0) / 3 * 4 * pi / steps;
  }
  return sum;
}

}  // namespace

TEST_CASE("a berry reaches as far as its half axes, in every form") {
  for (const BerryForm& form : forms) {
    const BerryMeridian meridian(form);
    CHECK(meridian.gauge({0, 1, 0}).value == doctest::Approx(1).epsilon(1e-4));
    CHECK(meridian.gauge({0, -1, 0}).value == doctest::Approx(1).epsilon(1e-4));
    double widest = 0;
    for (int i = 0; i <= 2000; ++i) {
      const SinCos a = sincos_degrees(static_cast<float>(i) * 0.09f);
      const double r = 1 / meridian.gauge({a.sine, a.cosine, 0}).value;
      CHECK(r <= meridian.outermost() * 1.001);
      widest = std::max(widest, r * a.sine);
    }
    CHECK(widest == doctest::Approx(1).epsilon(1e-4));
  }
}

TEST_CASE(
    "the volume is what cones from the centre add up to; an ellipsoid's "
    "is exact") {
  for (const BerryForm& form : forms) {
    const BerryMeridian meridian(form);
    CHECK(meridian.volume() == doctest::Approx(volume_by_cones(meridian)).epsilon(1e-3));
  }
  CHECK(form_volume({}, 2, 3) == doctest::Approx(4.0 / 3 * 3.14159265 * 12));
  CHECK(form_volume({0, 1}, 1, 1) == doctest::Approx(4.0 / 3 * 3.14159265 * 1.25).epsilon(1e-4));
  CHECK(form_volume({1, 0}, 1, 1) == doctest::Approx(form_volume({-1, 0}, 1, 1)));
  CHECK(form_volume({1, 0}, 1, 1) < form_volume({}, 1, 1));
}

TEST_CASE(
    "taper moves the widest parallel towards the tip, or back towards "
    "the seat") {
  for (const float taper : {-1.0f, -0.4f, 0.4f, 1.0f}) {
    const BerryMeridian meridian({taper, 0, Fruit::grape});
    float widest = 0, at = 0;
    for (int i = 0; i <= 2000; ++i) {
      const SinCos a = sincos_degrees(static_cast<float>(i) * 0.09f);
      const float r = 1 / meridian.gauge({a.sine, a.cosine, 0}).value;
      if (r * a.sine > widest) {
        widest = r * a.sine;
        at = r * a.cosine;
      }
    }
    CHECK(at == doctest::Approx(taper / 3).epsilon(0.03));
  }
}

TEST_CASE(
    "a gauge's gradient is its slope, and its product with the direction "
    "the gauge (Euler)") {
  for (const BerryForm& form : forms) {
    const BerryMeridian meridian(form);
    for (std::uint64_t i = 0; i < 50; ++i) {
      const glm::vec3 e = random_direction(1, 2, i), t = glm::normalize(glm::cross(e, random_direction(1, 3, i)));
      const BerryMeridian::Gauge gauge = meridian.gauge(e);
      CHECK(glm::dot(gauge.gradient, e) == doctest::Approx(gauge.value).epsilon(1e-4));
      const float step = 0.01f;
      const float ahead = meridian.gauge(glm::normalize(e + t * step)).value;
      const float behind = meridian.gauge(glm::normalize(e - t * step)).value;
      CHECK(std::fabs(glm::dot(gauge.gradient, t) - (ahead - behind) / (2 * step)) < 0.02f);
    }
  }
}

TEST_CASE("no point of the surface lies further in a direction than its support") {
  for (const BerryForm& form : forms) {
    const BerryMeridian meridian(form);
    for (int i = 1; i < 180; ++i) {
      const SinCos n = sincos_degrees(static_cast<float>(i));
      const BerryMeridian::Support support = meridian.support({n.sine * 3, n.cosine * 3});
      CHECK(support.along > 0);
      CHECK(support.round > 0);
      const float far = support.point.x * n.sine + support.point.y * n.cosine;
      float furthest = 0;
      for (int k = 0; k <= 720; ++k) {
        const SinCos a = sincos_degrees(static_cast<float>(k) / 4);
        const float r = 1 / meridian.gauge({a.sine, a.cosine, 0}).value;
        furthest = std::max(furthest, r * (a.sine * n.sine + a.cosine * n.cosine));
      }
      CHECK(std::fabs(far - furthest) < 2e-3f);
    }
  }
}
