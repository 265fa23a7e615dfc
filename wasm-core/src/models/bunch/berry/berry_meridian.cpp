#include "models/bunch/berry/berry_meridian.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

constexpr float sphere_volume = 4 * pi / 3;
constexpr float flattest = 8;  // limit of radii of curvature: straight sides have infinite ones

// The place of a normal (outward, up) in the table of supports, 0 at the tip to 1 at the seat: cheap to compute, and
// nearly even.
float place_of(const glm::vec2& normal) { return 0.5f - 0.5f * normal.y / (normal.x + std::fabs(normal.y)); }

// The form with the changes that its fruit brings: a bramble's is blunter and more conical.
BerryForm with_fruit_shape(const BerryForm& form) {
  BerryForm result = form;
  if (form.fruit == Fruit::bramble) {
    result.taper = std::max(-1.0f, form.taper - 0.5f);
    result.blunt = std::min(1.0f, form.blunt + 0.2f);
  }
  return result;
}

}  // namespace

// Prepares the profile across² + |x|^q = 1, where q grows with bluntness and x is the height moved by a projective map
// that tapers the form.
BerryMeridian::BerryMeridian(const BerryForm& form) {
  const BerryForm shape = with_fruit_shape(form);
  power_ = 2 + 3 * std::clamp(shape.blunt, 0.0f, 1.0f);
  shift_ = std::clamp(shape.taper, -1.0f, 1.0f) / 3;
  ball_ = power_ == 2 && shift_ == 0;
  volume_ = ball_ ? sphere_volume : sum_volume();
  if (!ball_) tabulate_supports();
}

// The gauge of the berry's form in a direction, 1 / distance to the surface, and its gradient.
BerryMeridian::Gauge BerryMeridian::gauge(const glm::vec3& direction) const {
  if (ball_) return {1, direction};
  const float across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  // Newton's method on F(r) = (r across)² + |x(r y)|^q − 1, which grows with r, from outside.
  float r = 1.3f, slope = 0;
  for (int step = 0; step < 12; ++step) {
    const float y = std::clamp(r * direction.y, -1.5f, 1.5f);
    const float below = 1 - shift_ * y;
    const float x = (y - shift_) / below;
    const float height = power(std::fabs(x), power_ - 1);
    slope = power_ * (x < 0 ? -height : height) * (1 - shift_ * shift_) / (below * below);
    const float over = r * across * r * across + height * std::fabs(x) - 1;
    const float change = over / (2 * r * across * across + slope * direction.y);
    r = std::clamp(r - change, 0.7f, 1.5f);
    if (std::fabs(change) < 1e-6f) break;
  }
  const glm::vec3 normal(2 * r * direction.x, slope, 2 * r * direction.z);
  return {1 / r, normal * (1 / (r * glm::dot(normal, direction)))};
}

// The curve by its parameter, 0 at the tip to π at the seat, and the unit normal there.
glm::vec2 BerryMeridian::point_at(float parameter, glm::vec2& normal) const {
  const float width = sine(parameter);
  const float c = cosine(parameter);
  const float height = power(std::max(std::fabs(c), 1e-4f), 2 / power_);
  const float x = c < 0 ? -height : height;
  const float y = (x + shift_) / (1 + shift_ * x);
  const float below = 1 - shift_ * y;
  const float slope = power_ * c * c / height * (1 - shift_ * shift_) / (below * below);
  normal = glm::normalize(glm::vec2(2 * width, c < 0 ? -slope : slope));
  return {width, y};
}

// Tabulates, by the direction of the normal, the point of the profile where the surface faces that way and its two
// radii of curvature (along the meridian and round the axis).
void BerryMeridian::tabulate_supports() {
  constexpr std::size_t last = 128;
  constexpr int samples = 256;
  glm::vec2 before_normal(0, 1), before(0, 1);
  std::size_t next = 1;
  supports_[0] = {before, flattest, flattest};
  for (int i = 1; i <= samples; ++i) {
    glm::vec2 normal(0, -1), point(0, -1);
    if (i < samples) point = point_at(pi * static_cast<float>(i) / samples, normal);
    outermost_ = std::max(outermost_, glm::length(point));
    const float from = place_of(before_normal), to = place_of(normal);
    const float turn = std::max(glm::length(normal - before_normal), 1e-6f);
    const float along = std::min(glm::length(point - before) / turn, flattest);
    for (; next <= last && static_cast<float>(next) / last <= to; ++next) {
      const float share = to > from ? (static_cast<float>(next) / last - from) / (to - from) : 1;
      const glm::vec2 here = before + (point - before) * share;
      const glm::vec2 facing = before_normal + (normal - before_normal) * share;
      supports_[next] = {here, along, std::min(here.x / std::max(facing.x, 1e-3f), flattest)};
    }
    before = point;
    before_normal = normal;
  }
  for (; next <= last; ++next) supports_[next] = {{0, -1}, flattest, flattest};
}

// The furthest point of the form in the direction `normal` (outward, up), and the radii of curvature there;
// interpolated in the table.
BerryMeridian::Support BerryMeridian::support(const glm::vec2& normal) const {
  if (ball_) return {glm::normalize(normal), 1, 1};
  const float place = place_of(normal) * static_cast<float>(supports_.size() - 1);
  const std::size_t at = std::min(static_cast<std::size_t>(std::max(place, 0.0f)), supports_.size() - 2);
  const float share = place - static_cast<float>(at);
  const Support& a = supports_[at];
  const Support& b = supports_[at + 1];
  return {a.point + (b.point - a.point) * share, a.along + (b.along - a.along) * share,
          a.round + (b.round - a.round) * share};
}

// The volume of the form, π ∫ across² dy, by the midpoints of 64 strips of x = sin a, where the integrand is smooth and
// flat at both ends.
float BerryMeridian::sum_volume() const {
  constexpr int strips = 64;
  float sum = 0;
  for (int i = 0; i < strips; ++i) {
    const float a = pi * ((static_cast<float>(i) + 0.5f) / strips - 0.5f);
    const float x = sine(a);
    const float stretch = 1 + shift_ * x;
    sum += (1 - power(std::fabs(x), power_)) * cosine(a) * (1 - shift_ * shift_) / (stretch * stretch);
  }
  return pi * sum * (pi / strips);
}

// The volume of a berry of that form and half sizes, in the cube of their unit.
float form_volume(const BerryForm& form, float half_width, float half_length) {
  return BerryMeridian(form).volume() * half_width * half_width * half_length;
}

}  // namespace panicle::bunch
