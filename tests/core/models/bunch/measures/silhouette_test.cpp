#include "models/bunch/measures/images/silhouette.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

using namespace panicle;
using namespace panicle::bunch;

namespace {

std::int32_t pick(std::uint64_t k, std::int32_t low, std::int32_t high) {
  return random_integer(11, hash_text("image"), k, low, high);
}

float uniform(std::uint64_t k) { return static_cast<float>(pick(k, 0, 1 << 20)) / (1 << 20); }

BitImage random_image(std::uint64_t seed, std::int32_t columns, std::int32_t rows, std::int32_t margin) {
  BitImage image(columns, rows);
  for (std::uint64_t k = 0; k < 12; ++k) {
    const std::int32_t column = pick(100 * seed + k, margin, columns - margin - 1);
    image.fill(pick(100 * seed + 50 + k, margin, rows - margin - 1), column,
               std::min(column + static_cast<std::int32_t>(k), columns - margin));
  }
  return image;
}

bool same(const BitImage& a, const BitImage& b) { return a.count() == b.count() && a.count_common(b) == a.count(); }

}  // namespace

TEST_CASE("filling counts newly set pixels, across words and within the picture only") {
  BitImage image(150, 4);
  std::int32_t wanted = 0;
  CHECK(image.fill(1, 60, 130, &wanted) == 70);
  CHECK(wanted == 70);
  CHECK(image.fill(1, 0, 64) == 60);
  CHECK(image.fill(1, -9, 999, &wanted) == 20);
  CHECK(wanted == 150);
  CHECK(image.fill(2, 64, 128) == 64);
  CHECK(image.fill(3, 7, 7) == 0);
  CHECK(image.fill(4, 0, 9, &wanted) == 0);
  CHECK(wanted == 0);
  CHECK(image.count() == 214);
  CHECK(image.count_row(2) == 64);
  CHECK(image.at(64, 2));
  CHECK_FALSE(image.at(63, 2));
  CHECK_FALSE(image.at(150, 1));
}

TEST_CASE("dilation is by a disc, pixel for pixel") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    const float radius = 7 * uniform(seed);
    const BitImage image = random_image(seed, pick(seed, 30, 140), 40, 0);
    const BitImage wide = image.dilated(radius);
    const auto reach = static_cast<std::int32_t>(radius);
    for (std::int32_t row = 0; row < image.rows(); ++row)
      for (std::int32_t column = 0; column < image.columns(); ++column) {
        bool near = false;
        for (std::int32_t y = -reach; y <= reach; ++y)
          for (std::int32_t x = -reach; x <= reach; ++x)
            near |= static_cast<float>(x * x + y * y) <= radius * radius && image.at(column + x, row + y);
        REQUIRE(wide.at(column, row) == near);
      }
  }
}

TEST_CASE("closing only adds pixels, and changes nothing the second time") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const BitImage image = random_image(seed, 130, 60, 9);
    const BitImage closed = image.closed(7);
    CHECK(image.count_common(closed) == image.count());
    CHECK(same(closed.closed(7), closed));
    CHECK(same(image.closed(0), image));
  }
  BitImage gap(80, 40);
  for (std::int32_t row = 12; row < 28; ++row) {
    gap.fill(row, 12, 30);
    gap.fill(row, 36, 54);
  }
  CHECK(gap.closed(2).at(33, 20) == false);
  CHECK(gap.closed(5).at(33, 20));
  CHECK(gap.closed(5).at(33, 12) == false);  // the disc dips between the corners
}

TEST_CASE("the drawn pixels are those within the outline") {
  const PixelGrid grid = PixelGrid::over({-4, -3}, {4, 5}, 0.11f, 2);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const auto draw_one = [&](int n) { return uniform(1000 + 20 * seed + static_cast<std::uint64_t>(n)); };
    const float angle = 360 * draw_one(0);
    const SinCos turn = sincos_degrees(angle);
    const BerryBody body{{6 * draw_one(1) - 3, 6 * draw_one(2) - 2, 0},
                         {turn.sine * 0.8f, turn.cosine * 0.8f, 0.6f},
                         0.2f + 2 * draw_one(3),
                         0.2f + 2 * draw_one(4)};
    const ProjectedBerry seen = project(body, View{});
    const glm::vec2 start{6 * draw_one(5) - 3, 6 * draw_one(6) - 2}, end{6 * draw_one(7) - 3, 6 * draw_one(8) - 2};
    BitImage berry(grid.columns, grid.rows), stem(grid.columns, grid.rows);
    const DrawnPixels inked = draw(berry, grid, seen);
    CHECK(inked.pixels == berry.count());
    CHECK(inked.fresh == berry.count());
    CHECK(draw(berry, grid, seen).fresh == 0);
    draw_stem(stem, grid, start, 0.4f, end, 0.4f);
    for (std::int32_t row = 0; row < grid.rows; ++row)
      for (std::int32_t column = 0; column < grid.columns; ++column) {
        const glm::vec2 at{grid.left + (static_cast<float>(column) + 0.5f) * grid.pitch, grid.row_height(row)};
        const float level = seen.level(at - seen.centre);
        if (std::abs(level - 1) > 1e-3f) CHECK(berry.at(column, row) == (level < 1));
        const glm::vec2 along = end - start, from = at - start;
        const float square = along.x * along.x + along.y * along.y;
        const float share = std::clamp((from.x * along.x + from.y * along.y) / square, 0.0f, 1.0f);
        const glm::vec2 off = from - share * along;
        const float distance = std::sqrt(off.x * off.x + off.y * off.y);
        if (std::abs(distance - 0.4f) > 1e-3f) CHECK(stem.at(column, row) == (distance < 0.4f));
      }
  }
}

TEST_CASE("places with NaN draw no pixels") {
  const PixelGrid grid = PixelGrid::over({-4, -3}, {4, 5}, 0.5f, 2);
  BitImage image(grid.columns, grid.rows);
  const float none = std::sqrt(-1.0f);
  CHECK(draw(image, grid, project({{none, 0, 0}, {0, -1, 0}, 1, 1}, View{})).pixels == 0);
  CHECK(draw(image, grid, project({{1e30f, -1e30f, 0}, {0, -1, 0}, 1, 1}, View{})).pixels == 0);
  draw_stem(image, grid, {none, none}, 1, {0, none}, 1);
  CHECK(image.count() == 0);
}
