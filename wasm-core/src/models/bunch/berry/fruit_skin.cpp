#include "models/bunch/berry/fruit_skin.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/easing.hpp"
#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"

namespace panicle::bunch {
namespace {

constexpr std::size_t drupelets = 48;
constexpr std::size_t tubercles = 110;

// The height of the scar at the tip, over the berry's radius: the rest of the style in a dimple. `from_tip`: angle in
// radians.
float scar(float from_tip) {
  const float dimple = -0.012f * hill(from_tip / 0.30f);
  const float style = 0.010f * hill(from_tip / 0.10f);
  return dimple + style;
}

// The height at the seat, where the pedicel was: a shallow hollow inside a collar. `from_seat`: angle in radians.
float seat(float from_seat) {
  const float flat = -0.022f * hill(from_seat / 0.70f);
  const float collar = 0.014f * hill((from_seat - 0.19f) / 0.11f);
  return flat + collar;
}

// The height of the remains of a currant's flower: a ragged hollow tuft, widest at its end. `from_tip` and `round`:
// angles in radians.
float tuft(float from_tip, float round) {
  const float ragged = 0.8f + 0.2f * sine(3 * round) * sine(5 * round + 1);
  return 0.34f * ragged * (1 - smooth_step(0.06f, 0.11f, from_tip)) * (0.6f + 0.4f * smooth_step(0, 0.05f, from_tip));
}

// Unit vectors evenly over the sphere.
std::vector<glm::vec3> even_directions(std::size_t count) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(golden_sphere_point(i, count));
  return points;
}

// The distance of a bramble's surface from its centre: one drupelet is a ball whose middle is an angle away, given by
// its cosine.
float drupelet(float cosine_from_middle) {
  constexpr float middle = 0.76f, radius = 0.27f;
  const float across_squared = middle * middle * (1 - cosine_from_middle * cosine_from_middle);
  return middle * cosine_from_middle + std::sqrt(std::max(0.0f, radius * radius - across_squared));
}

// The height of a lychee's tubercle: a plate with a small point in the middle and a groove round it. `nearest`, `next`:
// cosines of the angles to the nearest two middles.
float tubercle(float nearest, float next) {
  const float from_middle = std::sqrt(std::max(0.0f, 2 - 2 * nearest));
  const float from_groove = std::sqrt(std::max(0.0f, 2 - 2 * next)) - from_middle;
  return -0.035f * (1 - smooth_step(0, 0.16f, from_groove)) + 0.030f * hill(from_middle / 0.15f);
}

}  // namespace

// Places the bumps of brambles and lychees. `relief`, 0 … 1: how strongly the skin's relief is developed.
FruitSkin::FruitSkin(Fruit fruit, float relief) : fruit_(fruit), relief_(relief), leather_(2, 12) {
  if (fruit == Fruit::bramble) bumps_ = even_directions(drupelets);
  if (fruit == Fruit::lychee) bumps_ = even_directions(tubercles);
}

// The distance of a bumpy fruit's surface in a direction, by the two nearest bumps.
float FruitSkin::bumps(const glm::vec3& direction) const {
  float nearest = -1, next = -1;
  for (const glm::vec3& middle : bumps_) {
    const float cosine = glm::dot(middle, direction);
    next = std::max(next, std::min(cosine, nearest));
    nearest = std::max(nearest, cosine);
  }
  return fruit_ == Fruit::bramble ? drupelet(nearest) : 1 + tubercle(nearest, next);
}

// The distance of the skin from the centre in a direction, over that of the smooth form, at this age's relief.
float FruitSkin::height(const glm::vec3& direction) const { return 1 + relief_ * (grown_height(direction) - 1); }

// The distance of a grown fruit's skin from its centre in a direction, over that of its smooth form: scars, seats,
// tufts, bumps.
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

// An upper bound of the skin's height.
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

// How deep a dried fruit's folds are, over a grape's: leathery skins fold less.
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

// The number of meridians of the mesh for a wanted number of segments: more for fine relief.
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
