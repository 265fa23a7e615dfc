#include "models/bunch/berry/fruit_skin.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

constexpr int drupelets = 48;
constexpr int tubercles = 110;

// The height of the scar. Angles from the tip and from the seat are in radians.
float scar(float from_tip) {
  const float dimple = -0.012f * hill(from_tip / 0.30f);
  const float style = 0.010f * hill(from_tip / 0.10f);
  return dimple + style;
}

// The height of the seat: a shallow hollow for the pedicel within the collar that it leaves.
float seat(float from_seat) {
  const float flat = -0.022f * hill(from_seat / 0.70f);
  const float collar = 0.014f * hill((from_seat - 0.19f) / 0.11f);
  return flat + collar;
}

// Remains of a currant's flower: a ragged hollow tuft, widest at its end.
float tuft(float from_tip, float round) {
  const float ragged = 0.8f + 0.2f * sine(3 * round) * sine(5 * round + 1);
  return 0.34f * ragged * (1 - smooth_step(0.06f, 0.11f, from_tip)) * (0.6f + 0.4f * smooth_step(0, 0.05f, from_tip));
}

// Points evenly over the sphere, on the golden spiral.
std::vector<glm::vec3> spiral(int count) {
  constexpr float golden = 137.50776f;
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i) {
    const float y = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count);
    const SinCos turn = sincos_degrees(golden * static_cast<float>(i));
    const float across = std::sqrt(1 - y * y);
    points.emplace_back(across * turn.cosine, y, across * turn.sine);
  }
  return points;
}

// The surface of a drupelet: a ball about its middle, seen from the centre; the receptacle beyond it.
float drupelet(float cosine_from_middle) {
  constexpr float middle = 0.76f, radius = 0.27f;
  const float across_squared = middle * middle * (1 - cosine_from_middle * cosine_from_middle);
  return middle * cosine_from_middle + std::sqrt(std::max(0.0f, radius * radius - across_squared));
}

// The surface of a tubercle: a plate with a small point in the middle, a groove between it and the next.
float tubercle(float nearest, float next) {
  const float from_middle = std::sqrt(std::max(0.0f, 2 - 2 * nearest));
  const float from_groove = std::sqrt(std::max(0.0f, 2 - 2 * next)) - from_middle;
  return -0.035f * (1 - smooth_step(0, 0.16f, from_groove)) + 0.030f * hill(from_middle / 0.15f);
}

}  // namespace

FruitSkin::FruitSkin(Fruit fruit, float relief) : fruit_(fruit), relief_(relief), leather_(2, 12) {
  if (fruit == Fruit::bramble) bumps_ = spiral(drupelets);
  if (fruit == Fruit::lychee) bumps_ = spiral(tubercles);
}

float FruitSkin::bumps(const glm::vec3& direction) const {
  float nearest = -1, next = -1;
  for (const glm::vec3& middle : bumps_) {
    const float cosine = glm::dot(middle, direction);
    next = std::max(next, std::min(cosine, nearest));
    nearest = std::max(nearest, cosine);
  }
  return fruit_ == Fruit::bramble ? drupelet(nearest) : 1 + tubercle(nearest, next);
}

float FruitSkin::height(const glm::vec3& direction) const { return 1 + relief_ * (grown_height(direction) - 1); }

float FruitSkin::grown_height(const glm::vec3& direction) const {
  const float across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  const float from_tip = arc_tangent(across, direction.y), from_seat = pi - from_tip;
  switch (fruit_) {
    case Fruit::grape:
      return 1 + scar(from_tip) + seat(from_seat);
    case Fruit::currant:
      return 1 + tuft(from_tip, arc_tangent(direction.z, direction.x)) + 0.5f * seat(from_seat);
    case Fruit::bramble:
    case Fruit::lychee:
      return bumps(direction) - 0.04f * hill(from_seat / 0.5f);
    case Fruit::longan:
      return 1 + 0.005f * leather_.at(direction).value + 1.5f * seat(from_seat);
    case Fruit::duku: {
      const float fifths = cosine(5 * arc_tangent(direction.z, direction.x)) * across * across;
      return 1 + 0.014f * fifths + 0.02f * hill(from_tip / 0.25f) + 1.6f * seat(from_seat);
    }
  }
  return 1;
}

float FruitSkin::highest() const {
  switch (fruit_) {
    case Fruit::currant:
      return 1.35f;
    case Fruit::bramble:
    case Fruit::lychee:
    case Fruit::longan:
    case Fruit::duku:
      return 1.04f;
    default:
      return 1.01f;
  }
}

float FruitSkin::folds() const {
  switch (fruit_) {
    case Fruit::lychee:
    case Fruit::longan:
    case Fruit::duku:
      return 0.25f;
    default:
      return 1;
  }
}

std::uint32_t FruitSkin::meridians(std::uint32_t segments) const {
  switch (fruit_) {
    case Fruit::bramble:
    case Fruit::lychee:
      return segments * 3;
    case Fruit::longan:
      return segments * 7 / 4;
    default:
      return segments * 5 / 4;
  }
}

}  // namespace panicle::bunch
