#include "models/bunch/measures/measures_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "models/bunch/measures/images/silhouette.hpp"

namespace panicle::bunch {
namespace {

constexpr float pixels_to_radius = 14;  // of the mean berry
constexpr float max_pixels = 1200;      // across the picture; coarser pixels beyond

constexpr View front_view{};
constexpr View side_view{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};

constexpr float upright = 0.1f;  // degrees; an outline that leans less is drawn as one that does not

// A point's place in a view: its coordinate to the right, and its height.
glm::vec2 projected(const View& view, const glm::vec3& p) {
  return {p.x * view.right.x + p.y * view.right.y + p.z * view.right.z, p.y};
}

// The frame of an outline that leans within a picture's plane, or in one that is seen on edge: the point at depth d
// along its axis, x to its even side, is foot + x · across + d · down.
struct LeaningFrame {
  LeaningFrame(const Stance& stance, const View& view)
      : turn(sincos_degrees(stance.lean)),
        sign(stance.side % 2 == 0 ? 1.0f : -1.0f),
        foot(projected(view, stance.foot)) {}
  SinCos turn;
  float sign;
  glm::vec2 foot;

  // Unit vectors across the outline's axis and down along it.
  glm::vec2 across() const { return {turn.cosine, sign * turn.sine}; }
  glm::vec2 down() const { return {sign * turn.sine, -turn.cosine}; }
};

// A rectangle that grows.
struct Box {
  glm::vec2 low{1e30f}, high{-1e30f};

  // Extends the box by a rectangle of that centre and half size.
  void add(glm::vec2 centre, glm::vec2 half) {
    low = {std::min(low.x, centre.x - half.x), std::min(low.y, centre.y - half.y)};
    high = {std::max(high.x, centre.x + half.x), std::max(high.y, centre.y + half.y)};
  }
};

// The greatest half-width of an outline on a side.
float largest_half_width(const Envelope& envelope, std::size_t side) {
  float most = 0;
  constexpr int samples = 64;
  for (int k = 0; k <= samples; ++k)
    most = std::max(most, envelope.half_width(side, envelope.length() * static_cast<float>(k) / samples));
  return most;
}

// Finds the box of all drawn parts in either view: (x, y) and (z, y) have their rows in common, so one box holds both.
Box box_of(const Subject& subject, std::span<const HungEnvelope> envelopes) {
  Box box;
  for (const BerryBody& berry : subject.berries)
    for (const View& view : {front_view, side_view}) {
      const float reach = std::max(berry.half_width, berry.half_length);
      box.add(projected(view, berry.centre), glm::vec2(reach));
    }
  for (const Segment& stem : subject.stems)
    for (const View& view : {front_view, side_view}) {
      box.add(projected(view, stem.start), glm::vec2(stem.radius));
      box.add(projected(view, stem.end), glm::vec2(stem.radius_end));
    }
  for (const HungEnvelope& hung : envelopes) {
    float reach = 0;
    for (std::size_t side = 0; side < 4; ++side) reach = std::max(reach, largest_half_width(hung.envelope, side));
    for (const View& view : {front_view, side_view}) {
      const LeaningFrame frame(hung.stance, view);
      const glm::vec2 down = hung.envelope.length() * frame.down();
      box.add(frame.foot, glm::vec2(reach));
      box.add(frame.foot + down, glm::vec2(reach));
      box.add(frame.foot + glm::vec2(0, down.y), glm::vec2(reach));
    }
  }
  return box;
}

// Whether all coordinates and sizes are finite. One sum finds out: infinities and NaN survive in it, and absolute
// values cannot cancel out.
bool all_finite(const Subject& subject) {
  float sum = 0;
  for (const BerryBody& berry : subject.berries)
    for (const float x : {berry.centre.x, berry.centre.y, berry.centre.z, berry.half_width, berry.half_length})
      sum += std::abs(x);
  for (const Segment& stem : subject.stems)
    for (const float x : {stem.start.x, stem.start.y, stem.start.z, stem.end.x, stem.end.y, stem.end.z})
      sum += std::abs(x);
  return std::isfinite(sum);
}

// Fills an outline that does not lean; its sides are `side` to the right and `side` + 1 to the left.
void draw_upright(BitImage& image, const PixelGrid& grid, const Envelope& envelope, glm::vec2 foot, std::size_t side) {
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    const float depth = foot.y - grid.row_height(row);
    if (depth < 0 || depth > envelope.length()) continue;
    image.fill(row, grid.first_column(foot.x - envelope.half_width(side + 1, depth)),
               grid.end_column(foot.x + envelope.half_width(side, depth)));
  }
}

// Draws an outline that leans within the picture: every pixel is turned back and looked up by its depth. `side`: the
// first of those seen.
void draw_leaning_across(BitImage& image, const PixelGrid& grid, const Envelope& envelope, const LeaningFrame& frame,
                         std::size_t side) {
  const float length = envelope.length();
  const auto steps = static_cast<std::size_t>(2 * length / grid.pitch) + 2;
  std::vector<std::array<float, 2>> widths(steps);
  for (std::size_t k = 0; k < steps; ++k) {
    const float depth = std::min(length, static_cast<float>(k) * grid.pitch / 2);
    widths[k] = {envelope.half_width(side, depth), envelope.half_width(side + 1, depth)};
  }
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    const float y = grid.row_height(row) - frame.foot.y;
    for (std::int32_t column = 0; column < grid.columns; ++column) {
      const float x = grid.left + (static_cast<float>(column) + 0.5f) * grid.pitch - frame.foot.x;
      const float depth = x * frame.down().x + y * frame.down().y;
      if (depth < 0 || depth > length) continue;
      const float across = x * frame.across().x + y * frame.across().y;
      const auto& [right, left] = widths[static_cast<std::size_t>(2 * depth / grid.pitch + 0.5f)];
      if (across <= right && across >= -left) image.fill(row, column, column + 1);
    }
  }
}

// Draws an outline that leans towards the viewer or away: its sections, of four quarter ellipses, are seen aslant and
// together cover it. `side`: the first of those seen, `hidden` of those that it leans to.
void draw_leaning_away(BitImage& image, const PixelGrid& grid, const Envelope& envelope, const LeaningFrame& frame,
                       std::size_t side, std::size_t hidden) {
  const float slant = frame.across().y;  // height gained to a step across
  const auto steps = static_cast<std::int32_t>(2 * envelope.length() / grid.pitch) + 1;
  for (std::int32_t k = 0; k < steps; ++k) {
    const float depth = (static_cast<float>(k) + 0.5f) * envelope.length() / static_cast<float>(steps);
    const float right = envelope.half_width(hidden, depth), left = envelope.half_width(hidden + 1, depth);
    const float before = envelope.half_width(side, depth), behind = envelope.half_width(side + 1, depth);
    const float centre = frame.foot.y + depth * frame.down().y;
    const float ends[] = {centre + slant * right, centre - slant * left};
    const float high = std::max(ends[0], ends[1]), low = std::min(ends[0], ends[1]);
    const float half_pixel = grid.pitch / 2;
    for (std::int32_t row = grid.first_row(high + half_pixel); row < grid.end_row(low - half_pixel); ++row) {
      const float up = grid.row_height(row) - centre;
      const float beyond = std::max(0.0f, std::abs(up) - half_pixel);
      const float across = (up > 0 ? beyond : -beyond) / slant;
      const float share = across / std::max(across > 0 ? right : left, 1e-6f);
      const float width = std::sqrt(std::max(0.0f, 1 - share * share));
      image.fill(row, grid.first_column(frame.foot.x - behind * width), grid.end_column(frame.foot.x + before * width));
    }
  }
}

// Draws all outlines in one view, 0 from the front and 1 from the side: upright ones, ones that lean within the
// picture, and ones that lean towards the viewer or away.
BitImage outline(const PixelGrid& grid, std::span<const HungEnvelope> envelopes, std::size_t view) {
  BitImage image(grid.columns, grid.rows);
  for (const HungEnvelope& hung : envelopes) {
    const LeaningFrame frame(hung.stance, view == 0 ? front_view : side_view);
    if (std::abs(hung.stance.lean) < upright)
      draw_upright(image, grid, hung.envelope, frame.foot, 2 * view);
    else if (hung.stance.side / 2 == view)
      draw_leaning_across(image, grid, hung.envelope, frame, 2 * view);
    else
      draw_leaning_away(image, grid, hung.envelope, frame, 2 * view, 2 - 2 * view);
  }
  return image;
}

// The lowest height of all outlines' tips; 0 without outlines.
float lowest_of(std::span<const HungEnvelope> envelopes) {
  float lowest = 0;
  for (const HungEnvelope& hung : envelopes)
    lowest =
        std::min(lowest, hung.stance.foot.y + hung.envelope.length() * LeaningFrame(hung.stance, front_view).down().y);
  return lowest;
}

// Whether a stem is within the height of the outlines: the peduncle above p1 and stems below the tip are no space for
// berries.
bool within_height(const Segment& stem, float lowest) {
  return std::max(stem.start.y, stem.end.y) <= 1e-3f && std::min(stem.start.y, stem.end.y) >= lowest;
}

// The silhouette of berries and of stems within the height in a view.
BitImage silhouette(const Subject& subject, const PixelGrid& grid, const View& view, float lowest) {
  BitImage image(grid.columns, grid.rows);
  for (const BerryBody& berry : subject.berries) draw(image, grid, project(berry, view));
  for (const Segment& stem : subject.stems)
    if (within_height(stem, lowest))
      draw_stem(image, grid, projected(view, stem.start), stem.radius, projected(view, stem.end), stem.radius_end);
  return image;
}

}  // namespace

// Measures how well the bunch fills its outlines, in a picture from the front and one from the side. Returns false, and
// leaves `fitted`, if there is no berry or a number is not finite.
// The hull's volume: sum of ellipses whose widths are those of the closed silhouettes' rows.
bool fit(const Subject& subject, std::span<const HungEnvelope> envelopes, Fitted& fitted) {
  if (!(subject.mean_radius > 0) || !all_finite(subject)) return false;
  const Box box = box_of(subject, envelopes);
  const glm::vec2 size = box.high - box.low;
  const float pitch = std::max(subject.mean_radius / pixels_to_radius, std::max(size.x, size.y) / max_pixels);
  const float radius = subject.mean_radius / pitch;
  const PixelGrid grid = PixelGrid::over(box.low, box.high, pitch, static_cast<std::int32_t>(radius) + 3);
  const float lowest = lowest_of(envelopes);
  std::array<BitImage, 2> closed;
  for (std::size_t i = 0; i < 2; ++i) {
    const BitImage bunch = silhouette(subject, grid, i == 0 ? front_view : side_view, lowest);
    closed[i] = bunch.closed(radius);
    const BitImage wanted = outline(grid, envelopes, i);
    const auto area = [&](std::int64_t pixels) { return static_cast<float>(pixels) * pitch * pitch; };
    // The outermost pixels' centres lie half a pixel within the outline, on average.
    ViewFit& one = i == 0 ? fitted.front : fitted.side;
    one = {area(wanted.count()), area(closed[i].count_common(wanted)), area(bunch.count()),
           area(bunch.count() - bunch.count_common(wanted.dilated(radius + 0.5f)))};
  }
  std::int64_t sections = 0;
  for (std::int32_t row = 0; row < grid.rows; ++row)
    sections += static_cast<std::int64_t>(closed[0].count_row(row)) * closed[1].count_row(row);
  fitted.hull = pi / 4 * static_cast<float>(sections) * pitch * pitch * pitch;
  return true;
}

}  // namespace panicle::bunch
