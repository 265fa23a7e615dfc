#include "models/bunch/natural/ripening.hpp"

#include <doctest/doctest.h>

using namespace panicle::bunch;

TEST_CASE("a berry's width is a double sigmoid with a rest between, then shrinks") {
  CHECK(size_at(0) == doctest::Approx(0.08));
  CHECK(size_at(100) == doctest::Approx(1));
  for (float age = 0; age < 100; ++age) CHECK(size_at(age + 1) >= size_at(age));
  CHECK(size_at(57) - size_at(49) < 0.01f);
  CHECK(size_at(28) - size_at(20) > 0.1f);
  CHECK(size_at(82) - size_at(74) > 0.05f);
  CHECK(size_at(125) < 0.82f);
  CHECK(size_at(101) <= 1);
}

TEST_CASE("a fruit's relief comes out as it sets") {
  CHECK(relief_at(0) == 0);
  CHECK(relief_at(8) == 0);
  CHECK(relief_at(16) == doctest::Approx(0.5));
  CHECK(relief_at(30) == 1);
}

TEST_CASE("the sizes of every age end at its own size, and share the steps before") {
  const auto ripe = sizes_until(100);
  for (float age = 0; age <= 125; age += 2.5f) {
    const auto sizes = sizes_until(age);
    REQUIRE(!sizes.empty());
    CHECK(sizes.back() == doctest::Approx(size_at(age)).epsilon(1e-5));
    for (std::size_t k = 0; k + 1 < sizes.size() && k + 1 < ripe.size(); ++k) CHECK(sizes[k] == ripe[k]);
  }
}

TEST_CASE("flowers open in the middle, then at the base, then at the tip") {
  const auto opened = [](float along) { return stage_at(3.2f, {along, 0.5f, 0, 0, 1}).opened; };
  CHECK(opened(0.45f) > opened(0));
  CHECK(opened(0) > opened(1));
  for (const float along : {0.0f, 0.5f, 1.0f}) {
    CHECK(stage_at(7, {along, 1, 0, 0, 1}).opened == 1);
    CHECK(stage_at(15, {along, 1, 0, 0, 1}).set == 1);
  }
}

TEST_CASE("colour turns berry by berry between 55 and 100, in the sun first") {
  for (const float random_value : {0.0f, 0.3f, 0.7f, 1.0f})
    for (const float exposure : {0.0f, 1.0f}) {
      const BerryCircumstances berry{0.5f, random_value, exposure, 1, 1};
      CHECK(stage_at(50, berry).turned == 0);
      CHECK(stage_at(100, berry).turned == 1);
    }
  CHECK(stage_at(70, {0.5f, 0, 0.5f, 0, 1}).turned > stage_at(70, {0.5f, 1, 0.5f, 0, 1}).turned);
  CHECK(stage_at(75, {0.5f, 0.5f, 1, 1, 1}).turned > stage_at(75, {0.5f, 0.5f, 0, 1, 1}).turned);
  CHECK(stage_at(75, {0.5f, 0.5f, 1, 0, 1}).turned == stage_at(75, {0.5f, 0.5f, 0, 0, 1}).turned);
  CHECK(stage_at(75, {0.5f, 0.5f, 0.5f, 0, 1}).turned > stage_at(75, {0.5f, 0.5f, 0.5f, 0, 0}).turned);  // by vigour
  CHECK(stage_at(100, {}).shrivel == 0);
  CHECK(stage_at(125, {}).shrivel > 0.8f);
}
