#include "models/bunch/measures/images/silhouette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace panicle::bunch {
namespace {

// The widest stretch of a row covered by shapes that are convex together.
struct Stretch {
  float least = 0, most = 0;
  bool empty = true;

  // Extends the stretch by the interval from `low` to `high`.
  void add(float low, float high) {
    least = empty ? low : std::min(least, low);
    most = empty ? high : std::max(most, high);
    empty = false;
  }
};

// Extends a stretch by the chord of a disc at height y, if they meet.
void add_disc(Stretch& stretch, glm::vec2 centre, float radius, float y) {
  const float up = y - centre.y, square = radius * radius - up * up;
  if (square < 0) return;
  const float half = std::sqrt(square);
  stretch.add(centre.x - half, centre.x + half);
}

// Extends a stretch by the point where the line from a to b crosses height y, if it does.
void add_edge(Stretch& stretch, glm::vec2 a, glm::vec2 b, float y) {
  if ((a.y < y) == (b.y < y)) return;
  const float x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
  stretch.add(x, x);
}

}  // namespace

// A grid of pixels, `pitch` wide, that covers the box from `low` to `high`, with so many pixels of margin on each side.
PixelGrid PixelGrid::over(glm::vec2 low, glm::vec2 high, float pitch, std::int32_t margin) {
  const auto m = static_cast<float>(margin);
  const float left = std::floor(low.x / pitch) - m, right = std::ceil(high.x / pitch) + m;
  const float bottom = std::floor(low.y / pitch) - m, top = std::ceil(high.y / pitch) + m;
  return {left * pitch, top * pitch, pitch, static_cast<std::int32_t>(right - left),
          static_cast<std::int32_t>(top - bottom)};
}

// Fills the ellipse of a projected berry, row by row, and counts its pixels. In pixels, a row at `up` from the centre
// meets the ellipse at middle ± half, where half² = (uu − up² (uu vv − uv²)) / uu².
DrawnPixels draw(BitImage& image, const PixelGrid& grid, const ProjectedBerry& berry) {
  const float square = grid.pitch * grid.pitch;
  const float uu = berry.uu * square, uv = berry.uv * square, vv = berry.vv * square;
  const float across = 1 / uu, determinant = uu * vv - uv * uv;
  const float x = (berry.centre.x - grid.left) / grid.pitch - 0.5f, y = (grid.top - berry.centre.y) / grid.pitch - 0.5f;
  DrawnPixels inked;
  const std::int32_t end = grid.end_row(berry.centre.y - berry.half.y);
  for (std::int32_t row = grid.first_row(berry.centre.y + berry.half.y); row < end; ++row) {
    const float up = y - static_cast<float>(row);
    const float rest = uu - determinant * up * up;
    if (!(rest >= 0)) continue;
    const float half = std::sqrt(rest) * across, middle = x - uv * across * up;
    std::int32_t pixels = 0;
    inked.fresh += image.fill(row, PixelGrid::whole_above(middle - half, grid.columns),
                              PixelGrid::whole_above(middle + half, grid.columns), &pixels);
    inked.pixels += pixels;
  }
  return inked;
}

// Fills the silhouette of a stem: a trapezium with a disc at each end. All lengths in the grid's unit.
void draw_stem(BitImage& image, const PixelGrid& grid, glm::vec2 start, float radius, glm::vec2 end, float radius_end) {
  const glm::vec2 along = end - start;
  const float length = std::sqrt(along.x * along.x + along.y * along.y);
  const glm::vec2 across = length > 0 ? glm::vec2(-along.y, along.x) / length : glm::vec2(0);
  const std::array<glm::vec2, 4> corners = {start + radius * across, end + radius_end * across,
                                            end - radius_end * across, start - radius * across};
  const std::int32_t last = grid.end_row(std::min(start.y - radius, end.y - radius_end));
  for (std::int32_t row = grid.first_row(std::max(start.y + radius, end.y + radius_end)); row < last; ++row) {
    const float y = grid.row_height(row);
    Stretch stretch;
    add_disc(stretch, start, radius, y);
    add_disc(stretch, end, radius_end, y);
    for (std::size_t i = 0; i < 4; ++i) add_edge(stretch, corners[i], corners[(i + 1) % 4], y);
    if (!stretch.empty) image.fill(row, grid.first_column(stretch.least), grid.end_column(stretch.most));
  }
}

}  // namespace panicle::bunch
