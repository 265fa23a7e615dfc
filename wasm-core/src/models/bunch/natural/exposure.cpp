#include "models/bunch/natural/exposure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "foundation/mathematics.hpp"
#include "models/bunch/fruit/projection.hpp"

namespace panicle::bunch {
namespace {

constexpr std::size_t samples = 37;  // of each disc
constexpr float penumbra = 0.25f;    // width of a shadow's edge, in radii of what casts it
constexpr float behind_at = 0.5f;    // by how many of its outer radii one berry lies before another to shade it in full
constexpr float golden_angle = 137.50776f;  // degrees

// Evenly over the unit disc: the sunflower's spiral (Vogel 1979).
std::array<glm::vec2, samples> even_disc() {
  std::array<glm::vec2, samples> points;
  for (std::size_t k = 0; k < samples; ++k) {
    const float radius = std::sqrt((static_cast<float>(k) + 0.5f) / samples);
    const SinCos turn = sincos_degrees(golden_angle * static_cast<float>(k));
    points[k] = {radius * turn.cosine, radius * turn.sine};
  }
  return points;
}

// Which berries may lie over a place of the picture: cells as wide as the widest berry, so that a berry's neighbours
// are in its own cell and the eight around it.
class Cells {
 public:
  explicit Cells(std::span<const ProjectedBerry> berries) {
    glm::vec2 low = berries[0].centre, high = low;
    float widest = 0;
    for (const ProjectedBerry& berry : berries) {
      low = {std::min(low.x, berry.centre.x), std::min(low.y, berry.centre.y)};
      high = {std::max(high.x, berry.centre.x), std::max(high.y, berry.centre.y)};
      widest = std::max(widest, berry.outer);
    }
    low_ = low;
    size_ = std::max(2 * (1 + penumbra / 2) * widest, std::max(high.x - low.x, high.y - low.y) / most_cells);
    columns_ = column(high.x) + 1;
    rows_ = row(high.y) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (const ProjectedBerry& berry : berries) ++first_[cell(berry) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    members_.resize(berries.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < berries.size(); ++i) members_[next[cell(berries[i])]++] = i;
  }

  template <typename Visit>
  void near(const ProjectedBerry& berry, Visit visit) const {
    const std::int32_t x = column(berry.centre.x), y = row(berry.centre.y);
    for (std::int32_t j = std::max(0, y - 1); j <= std::min(rows_ - 1, y + 1); ++j) {
      const std::int32_t left = std::max(0, x - 1), right = std::min(columns_ - 1, x + 1);
      const std::uint32_t end = first_[static_cast<std::size_t>(j) * columns_ + right + 1];
      for (std::uint32_t k = first_[static_cast<std::size_t>(j) * columns_ + left]; k < end; ++k) visit(members_[k]);
    }
  }

 private:
  static constexpr float most_cells = 128;  // a side

  std::int32_t column(float x) const { return static_cast<std::int32_t>((x - low_.x) / size_); }
  std::int32_t row(float y) const { return static_cast<std::int32_t>((y - low_.y) / size_); }
  std::size_t cell(const ProjectedBerry& berry) const {
    return static_cast<std::size_t>(row(berry.centre.y)) * columns_ + column(berry.centre.x);
  }

  glm::vec2 low_{0};
  float size_ = 1;
  std::int32_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_, members_;
};

// Darkens the samples of `lit` by what `shading` casts on it.
void shade(const ProjectedBerry& lit, const ProjectedBerry& shading, std::span<const glm::vec2> disc,
           std::array<float, samples>& light) {
  const float before = std::min(1.0f, (shading.depth - lit.depth) / (behind_at * lit.outer));
  const glm::vec2 between = shading.centre - lit.centre;
  for (std::size_t k = 0; k < samples; ++k) {
    const float out = std::sqrt(shading.level(disc[k] - between));
    const float cover = (1 + penumbra / 2 - out) / penumbra;
    light[k] *= 1 - before * std::clamp(cover, 0.0f, 1.0f);
  }
}

}  // namespace

std::vector<float> sun_exposure(std::span<const BerryBody> berries, glm::vec3 towards_sun) {
  std::vector<float> exposure(berries.size(), 1.0f);
  if (berries.size() < 2) return exposure;
  const View view = view_from(towards_sun);
  std::vector<ProjectedBerry> seen(berries.size());
  for (std::size_t i = 0; i < berries.size(); ++i) seen[i] = project(berries[i], view);
  const Cells cells(seen);
  const std::array<glm::vec2, samples> unit = even_disc();
  std::array<glm::vec2, samples> disc;
  std::array<float, samples> light;
  for (std::size_t i = 0; i < berries.size(); ++i) {
    const ProjectedBerry& lit = seen[i];
    for (std::size_t k = 0; k < samples; ++k) disc[k] = lit.on_disc(unit[k]);
    light.fill(1.0f);
    cells.near(lit, [&](std::uint32_t j) {
      const ProjectedBerry& other = seen[j];
      if (!(other.depth > lit.depth)) return;
      const glm::vec2 between = other.centre - lit.centre;
      const float reach = lit.outer + (1 + penumbra / 2) * other.outer;
      if (between.x * between.x + between.y * between.y < reach * reach) shade(lit, other, disc, light);
    });
    float sum = 0;
    for (const float share : light) sum += share;
    exposure[i] = sum / samples;
  }
  return exposure;
}

}  // namespace panicle::bunch
