// The order in which GLM computes: fingerprints of frozen links depend on it. 0.9.9.8 (in Debian 12 and 13) and 1.0.1
// compute as written here; for any other version this test shows whether it does.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "foundation/bits.hpp"
#include "foundation/random.hpp"

namespace {

using panicle::bit_cast;

// Numbers of very different sizes, so that another order rounds otherwise.
float number(std::uint64_t stream, std::uint64_t i) {
  const float unit = panicle::random_unit(11, stream, i), exponent = 12 * panicle::random_unit(12, stream, i) - 6;
  return (2 * unit - 1) * std::pow(10.0f, exponent);
}
glm::vec3 vector(std::uint64_t stream, std::uint64_t i) {
  return {number(stream, 3 * i), number(stream, 3 * i + 1), number(stream, 3 * i + 2)};
}

bool same(float a, float b) { return bit_cast<std::uint32_t>(a) == bit_cast<std::uint32_t>(b); }
bool same(const glm::vec3& a, const glm::vec3& b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

}  // namespace

TEST_CASE("GLM adds up products of vectors from the first to the last") {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 a = vector(1, i), b = vector(2, i);
    const glm::vec2 c(a), d(b);
    CHECK(same(glm::dot(a, b), a.x * b.x + a.y * b.y + a.z * b.z));
    CHECK(same(glm::dot(c, d), c.x * d.x + c.y * d.y));
    const glm::vec4 e(a, b.x), f(b, a.y);
    CHECK(same(glm::dot(e, f), (e.x * f.x + e.y * f.y) + (e.z * f.z + e.w * f.w)));
    CHECK(same(glm::cross(a, b), {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y}));
    const glm::dvec3 g(a), h(b);
    CHECK(glm::dot(g, h) == g.x * h.x + g.y * h.y + g.z * h.z);
  }
}

TEST_CASE("GLM computes lengths as roots of sums of squares, and normalises by reciprocals") {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 a = vector(3, i), b = vector(4, i);
    const glm::vec3 way = b - a;
    CHECK(same(glm::length(a), std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z)));
    CHECK(same(glm::distance(a, b), std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z)));
    CHECK(same(glm::normalize(a), a * (1 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z))));
    const glm::dvec3 c(a);
    CHECK(glm::length(c) == std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z));
    CHECK(glm::normalize(c) == c * (1 / std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z)));
  }
}

TEST_CASE("GLM's mix, min, max and fract work by component") {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 a = vector(5, i), b = vector(6, i);
    const float t = panicle::random_unit(13, 1, i);
    const auto mixed = [t](float x, float y) { return x * (1 - t) + y * t; };
    CHECK(same(glm::mix(a, b, t), {mixed(a.x, b.x), mixed(a.y, b.y), mixed(a.z, b.z)}));
    CHECK(same(glm::min(a, b), {std::fmin(a.x, b.x), std::fmin(a.y, b.y), std::fmin(a.z, b.z)}));
    CHECK(same(glm::max(a, b), {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)}));
    CHECK(same(glm::abs(a), {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}));
    CHECK(same(glm::floor(a), {std::floor(a.x), std::floor(a.y), std::floor(a.z)}));
    CHECK(same(glm::clamp(a, -1.0f, 1.0f), glm::min(glm::max(a, -1.0f), 1.0f)));
  }
}

TEST_CASE("GLM turns vectors by quaternions and matrices in one order") {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const glm::vec3 axis = glm::normalize(vector(7, i)), v = vector(8, i);
    const glm::quat q(number(9, i), axis.x, axis.y, axis.z);
    const glm::vec3 part(q.x, q.y, q.z), one = glm::cross(part, v), other = glm::cross(part, one);
    CHECK(same(q * v, v + ((one * q.w) + other) * 2.0f));
    const glm::quat back = glm::conjugate(q);
    CHECK(same(glm::vec3(back.x, back.y, back.z), -part));
    CHECK(same(back.w, q.w));
    const glm::mat3 m(vector(14, i), vector(15, i), vector(16, i));
    const auto row = [&](int k) { return m[0][k] * v.x + m[1][k] * v.y + m[2][k] * v.z; };
    CHECK(same(m * v, {row(0), row(1), row(2)}));
  }
}
