// Storage roots.
#include "models/root/storage.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "models/particles/space_growing.hpp"

namespace panicle::particles {
namespace {

TEST_CASE("a storage root tapers to nothing at its reach") {
  const root::StorageHabit habit{0.02f, 0.3f};
  CHECK(root::storage_radius(habit, 0) == doctest::Approx(0.02f));
  CHECK(root::storage_radius(habit, -1) == doctest::Approx(0.02f));
  CHECK(root::storage_radius(habit, 0.3f) == 0);
  for (float below = 0; below < 0.28f; below += 0.02f)
    CHECK(root::storage_radius(habit, below) > root::storage_radius(habit, below + 0.02f));
}

TEST_CASE("the main root swells over its reach; side roots do not, and stay on it") {
  const auto grown = [](float storage, float age = 100) {
    return grow_root({.parameters = {{"storage", storage},
                                     {"storage_reach", 0.5f},
                                     {"slant", 0.2f},
                                     {"girth", 1},
                                     {"particles", 800},
                                     {"reach", 0.4f},
                                     {"width", 0.2f},
                                     {"depth", 0.2f},
                                     {"sway", 0.05f},
                                     {"age", age}}});
  };
  const Plant plain = grown(0), plant = grown(6);
  check_sound(plant, 1);
  REQUIRE(plain.segments.size() == plant.segments.size());
  float thickest = 0;
  std::uint32_t swollen = 0;
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const Segment& segment = plant.segments[i];
    thickest = std::max(thickest, segment.radius);
    if (segment.radius <= plain.segments[i].radius) continue;
    ++swollen;
    CHECK(segment.start.y > -0.2f);
    CHECK(segment.radius_end <= segment.radius);
    // One line from the collar on.
    if (segment.parent >= 0) {
      const auto parent = static_cast<std::size_t>(segment.parent);
      CHECK(plant.segments[parent].radius > plain.segments[parent].radius);
      CHECK(plant.segments[parent].radius_end == doctest::Approx(segment.radius).epsilon(0.01));
    }
  }
  CHECK(thickest == doctest::Approx(0.03f));
  CHECK(swollen > 3);
  // A young root is thin.
  const auto collar = [](const Plant& each) {
    float radius = 0;
    for (const Segment& segment : each.segments) radius = std::max(radius, segment.radius);
    return radius;
  };
  float before = 0;
  bool between = false;
  for (float age = 10; age <= 100; age += 10) {
    const float now = collar(grown(6, age));
    CHECK(now >= before);
    between = between || (now > 0.3f * thickest && now < 0.95f * thickest);
    before = now;
  }
  CHECK(between);
  CHECK(before == thickest);
}

}  // namespace
}  // namespace panicle::particles
