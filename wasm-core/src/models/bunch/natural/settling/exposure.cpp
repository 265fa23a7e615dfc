#include "models/bunch/natural/settling/exposure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "foundation/golden_spiral.hpp"
#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"
#include "models/bunch/berry/pressing/projection.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::bunch {
namespace {

constexpr std::size_t samples = 37;  // of each disc
constexpr float penumbra = 0.25f;    // width of a shadow's edge, in radii of the berry that casts it
// the depth, in its outer radii, by which a berry must be before another to shade it in full
constexpr float behind_at = 0.5f;

// The samples of a disc side by side, and a few more to make whole groups of four.
constexpr std::size_t padded = (samples + 3) / 4 * 4;
// The sample points of a disc, in the plane perpendicular to the sun's direction.
struct Disc {
  std::array<float, padded> x{}, y{};
};

// Points spread evenly over the unit disc.
Disc even_disc() {
  Disc disc;
  for (std::size_t k = 0; k < samples; ++k) {
    const glm::vec2 place = golden_disc_point(k, samples);
    disc.x[k] = place.x;
    disc.y[k] = place.y;
  }
  return disc;
}

// The disc that a berry turns to the sun, about its centre.
Disc disc_of(const ProjectedBerry& berry, const Disc& unit) {
  Disc disc;
  for (std::size_t k = 0; k < samples; ++k) {
    const glm::vec2 place = berry.on_disc({unit.x[k], unit.y[k]});
    disc.x[k] = place.x;
    disc.y[k] = place.y;
  }
  return disc;
}

// Which berries may lie over a place of the picture: cells as wide as the widest berry with its penumbra.
PointGrid grid_of(std::span<const ProjectedBerry> berries) {
  std::vector<glm::vec3> places;
  float widest = 0;
  for (const ProjectedBerry& berry : berries) {
    places.emplace_back(berry.centre, 0);
    widest = std::max(widest, berry.outer);
  }
  return {places, 2 * (1 + penumbra / 2) * widest};
}

// Darkens `light`, the light at the samples of the berry `lit`, by the shadow of the berry `shading`: fully inside its
// elliptic outline, fading over a penumbra, and less if `shading` is hardly before it.
// The quadratic form (uu, uv, vv) is 1 on the outline.
void shade(const ProjectedBerry& lit, const ProjectedBerry& shading, const Disc& disc,
           std::array<float, padded>& light) {
  const float before = std::min(1.0f, (shading.depth - lit.depth) / (behind_at * lit.outer));
  const glm::vec2 between = shading.centre - lit.centre;
  const Four zero{0, 0, 0, 0}, one = 1 - zero;
  for (std::size_t k = 0; k < padded; k += 4) {
    const Four x = load(&disc.x[k]) - between.x, y = load(&disc.y[k]) - between.y;
    const Four out = square_root(shading.uu * x * x + 2 * shading.uv * x * y + shading.vv * y * y);
    const Four cover = (1 + penumbra / 2 - out) / penumbra;
    const Four above = cover > zero ? cover : zero;
    store(&light[k], load(&light[k]) * (1 - before * (above < one ? above : one)));
  }
}

}  // namespace

// The share of each berry's disc, as seen from the sun, that no other berry shades; 0 … 1.
std::vector<float> sun_exposure(std::span<const BerryBody> berries, glm::vec3 towards_sun) {
  std::vector<float> exposure(berries.size(), 1.0f);
  if (berries.size() < 2) return exposure;
  const View view = view_from(towards_sun);
  std::vector<ProjectedBerry> seen(berries.size());
  for (std::size_t i = 0; i < berries.size(); ++i) seen[i] = project(berries[i], view);
  const PointGrid cells = grid_of(seen);
  const Disc unit = even_disc();
  std::array<float, padded> light;
  for (std::size_t i = 0; i < berries.size(); ++i) {
    const ProjectedBerry& lit = seen[i];
    const Disc disc = disc_of(lit, unit);
    light.fill(1.0f);
    cells.visit({lit.centre, 0}, [&](std::uint32_t j) {
      const ProjectedBerry& other = seen[j];
      if (!(other.depth > lit.depth)) return;
      const glm::vec2 between = other.centre - lit.centre;
      const float reach = lit.outer + (1 + penumbra / 2) * other.outer;
      if (between.x * between.x + between.y * between.y < reach * reach) shade(lit, other, disc, light);
    });
    float sum = 0;
    for (std::size_t k = 0; k < samples; ++k) sum += light[k];
    exposure[i] = sum / samples;
  }
  return exposure;
}

}  // namespace panicle::bunch
