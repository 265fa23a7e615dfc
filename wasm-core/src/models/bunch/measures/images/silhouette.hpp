// Silhouettes: the outlines of berries and stems, filled on a grid of pixels.
#pragma once

#include <glm/vec2.hpp>

#include "models/bunch/berry/pressing/projection.hpp"
#include "models/bunch/measures/images/bit_image.hpp"

namespace panicle::bunch {

// The grid of a picture's pixels: square ones, of `pitch`, the first row at the top. A pixel is at its centre.
struct PixelGrid {
  float left = 0, top = 0;
  float pitch = 1;
  std::int32_t columns = 0, rows = 0;

  // A grid over a box, with a margin of `margin` pixels. Centres lie at odd multiples of half a pitch, for every box.
  static PixelGrid over(glm::vec2 low, glm::vec2 high, float pitch, std::int32_t margin);

  // The height of a row's middle.
  float row_height(std::int32_t row) const { return top - (static_cast<float>(row) + 0.5f) * pitch; }
  // The rows and columns whose centres lie in a stretch go from the first up to but not the end; far outside the
  // picture they are held just outside it.
  std::int32_t first_row(float highest) const { return whole_above((top - highest) / pitch - 0.5f, rows); }
  // The row after the last, and the first and last columns, whose middles are within a range; then the row and column
  // that contain a point.
  std::int32_t end_row(float lowest) const { return whole_above((top - lowest) / pitch - 0.5f, rows); }
  std::int32_t first_column(float least) const { return whole_above((least - left) / pitch - 0.5f, columns); }
  std::int32_t end_column(float most) const { return whole_above((most - left) / pitch - 0.5f, columns); }
  std::int32_t row_at(float height) const { return whole_above((top - height) / pitch, rows) - 1; }
  std::int32_t column_at(float across) const { return whole_above((across - left) / pitch, columns) - 1; }

  // The least whole number above x or at it, held in −1 … most + 1.
  static std::int32_t whole_above(float x, std::int32_t most) {
    const float held = x > -1 ? x < static_cast<float>(most) ? x : static_cast<float>(most) + 1 : -1;
    const auto whole = static_cast<std::int32_t>(held);
    return whole + (static_cast<float>(whole) < held);
  }
};

// The number of pixels of an outline in the picture, and of those that it was the first to set.
struct DrawnPixels {
  std::int32_t pixels = 0, fresh = 0;
};

DrawnPixels draw(BitImage& image, const PixelGrid& grid, const ProjectedBerry& berry);

// Draws a stem: all points within a radius that changes evenly from that at `start` to that at `end`.
void draw_stem(BitImage& image, const PixelGrid& grid, glm::vec2 start, float radius, glm::vec2 end, float radius_end);

}  // namespace panicle::bunch
