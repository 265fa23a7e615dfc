#include "light/voxel_light.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t across = 40, up = 24;
constexpr float edge = 0.25f;

// A box 10 × 6 × 10 from the origin, with `k` in all of it, or above and below two heights only.
VoxelLight filled(float k, const std::vector<LightDirection>& lamps, float from = 0, float to = 100) {
  std::vector<float> matter;
  for (std::uint32_t z = 0; z < across; ++z)
    for (std::uint32_t y = 0; y < up; ++y)
      for (std::uint32_t x = 0; x < across; ++x) {
        const float height = (static_cast<float>(y) + 0.5f) * edge;
        matter.push_back(height > from && height < to ? k : 0);
      }
  return {{0, 0, 0}, edge, across, up, across, matter, lamps};
}

TEST_CASE("from above, light falls by the law of Beer and Lambert") {
  const VoxelLight light = filled(0.4f, {{{0, 1, 0}, 1}});
  for (float y = 0.125f; y < 6; y += 0.25f)
    CHECK(light.at({5, y, 5}) == doctest::Approx(std::exp(-0.4f * (6 - y))).epsilon(1e-3));
}

TEST_CASE("slanting light takes the longer way through a layer, in each direction") {
  for (const glm::vec3& way : {glm::vec3(0.6f, 0.8f, 0), glm::vec3(-0.36f, 0.8f, 0.48f), glm::vec3(0, 0.8f, -0.6f)}) {
    const VoxelLight light = filled(0.5f, {{way, 1}}, 3, 4);
    // Below the layer of 1 m, away from the box's sides.
    CHECK(light.at({5, 1.125f, 5}) == doctest::Approx(std::exp(-0.5f / 0.8f)).epsilon(0.01));
    CHECK(light.at({5, 5, 5}) == doctest::Approx(1).epsilon(1e-4));
  }
  // Level, through 5 m.
  const VoxelLight level = filled(0.1f, {{{1, 0, 0}, 1}});
  CHECK(level.at({5.125f, 3, 5}) == doctest::Approx(std::exp(-0.1f * 4.875f)).epsilon(2e-3));
}

TEST_CASE("light is interpolated between cells, and beyond the box is that of its edge") {
  const VoxelLight light = filled(1, {{{0, 1, 0}, 1}});
  const float above = light.at({5, 3.125f, 5}), below = light.at({5, 2.875f, 5});
  CHECK(light.at({5, 3, 5}) == doctest::Approx(0.5f * (above + below)).epsilon(1e-4));
  CHECK(light.at({5, -50, 5}) == light.at({5, 0, 5}));
  CHECK(light.at({-9, 3, 5}) == light.at({0, 3, 5}));
}

TEST_CASE("a block casts its shadow away from the light, and nowhere else") {
  std::vector<float> matter(std::size_t{across} * up * across, 0);
  const auto at = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return (std::size_t{z} * up + y) * across + x;
  };
  for (std::uint32_t z = 16; z < 24; ++z)
    for (std::uint32_t y = 12; y < 16; ++y)
      for (std::uint32_t x = 16; x < 24; ++x) matter[at(x, y, z)] = 50;
  const glm::vec3 way = glm::normalize(glm::vec3(1, 1, 0));
  const VoxelLight light({0, 0, 0}, edge, across, up, across, matter, std::vector<LightDirection>{{way, 1}});
  const glm::vec3 block(5, 3.5f, 5);
  CHECK(light.at(block - 2.5f * way) < 0.01f);
  CHECK(light.at(block + 2.5f * way) > 0.99f);
  CHECK(light.at({5, 1, 5}) > 0.5f);  // straight below it is lit from the side
  CHECK(light.at(block - 2.5f * way + glm::vec3(0, 0, 3)) > 0.99f);
}

TEST_CASE("without matter all light arrives") {
  for (const auto& lamps : {overcast(24), all_round(32)}) {
    float shares = 0;
    glm::vec3 mean(0);
    for (const LightDirection& lamp : lamps) {
      CHECK(glm::length(lamp.towards) == doctest::Approx(1).epsilon(1e-5));
      shares += lamp.share;
      mean += lamp.share * lamp.towards;
    }
    CHECK(shares == doctest::Approx(1));
    CHECK(filled(0, lamps).at({5, 3, 5}) == doctest::Approx(1));
    CHECK(std::fabs(mean.x) < 0.03f);
    CHECK(std::fabs(mean.z) < 0.03f);
  }
  // The mean height of a cosine weighted sky is 2/3; of all directions 0.
  float sky = 0, all = 0;
  for (const LightDirection& lamp : overcast(24)) {
    CHECK(lamp.towards.y > 0);
    sky += lamp.share * lamp.towards.y;
  }
  for (const LightDirection& lamp : all_round(32)) all += lamp.share * lamp.towards.y;
  CHECK(sky == doctest::Approx(2.0f / 3).epsilon(0.01));
  CHECK(std::fabs(all) < 0.01f);
}

TEST_CASE("light below a deep layer under an overcast sky equals the integral over the sky") {
  // ∫ e^(−τ/cos θ) 2 cos θ d(cos θ) = 2 E₃(τ); for τ = 0.5: 0.4432.
  const VoxelLight light = filled(0.5f, overcast(96), 4, 5);
  CHECK(light.at({5, 3.5f, 5}) == doctest::Approx(0.4432f).epsilon(0.03));
}

}  // namespace
}  // namespace panicle
