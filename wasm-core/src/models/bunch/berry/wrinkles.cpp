#include "models/bunch/berry/wrinkles.hpp"

#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle::bunch {
namespace {

constexpr std::uint64_t seed = 0x5eed;
constexpr float share = 0.577f;  // of a wave, so that the sum has unit variance

}  // namespace

// A random field on the sphere: a sum of sine waves. `which` chooses the field; `pitch`: radians of a wave over the
// radius.
Wrinkles::Wrinkles(std::uint64_t which, float pitch) {
  for (std::uint64_t i = 0; i < waves_.size(); ++i) {
    const glm::vec3 flattened = random_direction(seed, 2 * which, i) * glm::vec3(1, 0.5f, 1);
    const float frequency = pitch * (0.8f + 0.6f * static_cast<float>(i) / static_cast<float>(waves_.size() - 1));
    waves_[i] = {glm::normalize(flattened) * frequency, 2 * pi * random_unit(seed, 2 * which + 1, i)};
  }
}

// The field in a direction, a unit vector, and its gradient without the part along that direction.
Wrinkles::Value Wrinkles::at(const glm::vec3& direction) const {
  Value result{0, glm::vec3(0)};
  for (const Wave& wave : waves_) {
    const float angle = glm::dot(wave.way, direction) + wave.phase;
    result.value += share * sine(angle);
    result.slope += wave.way * (share * cosine(angle));
  }
  result.slope -= direction * glm::dot(result.slope, direction);
  return result;
}

}  // namespace panicle::bunch
