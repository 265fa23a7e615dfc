#include "models/bunch/paper/envelope.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/mathematics.hpp"
#include "models/bunch/plan.hpp"

namespace panicle::bunch {
namespace {

constexpr int slices = 64;  // of numeric integration over the depth

}  // namespace

// The azimuth of a direction round the rachis, counted from the right side towards the back: the two sides of the
// outline that it lies between, and its cosine and sine.
Azimuth azimuth_of(float degrees) {
  const SinCos way = sincos_degrees(degrees);
  return {way.cosine >= 0 ? 0u : 1u, way.sine <= 0 ? 2u : 3u, std::abs(way.cosine), std::abs(way.sine)};
}

// Builds the outline of each side from its handles: a quarter ellipse for the shoulder, a line to the waist, straight
// down, and a rounded end. `pixel`: millimetres of a profile's pixel; `end_reach`: sideways reach of an end structure.
Envelope::Envelope(const Profile& profile, float pixel, float end_reach) : length_(profile.length * pixel) {
  for (std::size_t i = 0; i < 4; ++i) {
    Side& side = sides_[i];
    side.width = profile.sides[i].width * pixel;
    side.narrow = profile.sides[i].width >= pixels_per_axis_segment / 2 ? std::min(side.width, end_reach) : side.width;
    side.shoulder = std::min(profile.sides[i].drop * pixel, length_);
    side.rounding = std::min(side.narrow, (length_ - side.shoulder) / 2);
    const float axis_rd = profile.sides[i].drop * axes_per_pixel_of_drop + static_cast<float>(i) + 1;
    side.waist = std::clamp(axis_rd * pixels_per_rachis_segment * pixel, side.shoulder,
                            std::max(side.shoulder, length_ - side.rounding));
  }
}

// The half-width of side `i` (right, left, front, back) at a depth; 0 above and below the outline.
float Envelope::half_width(std::size_t i, float depth) const {
  const Side& side = sides_[i];
  if (depth < 0 || depth > length_) return 0;
  if (depth < side.shoulder) {
    const float up = 1 - depth / side.shoulder;
    return side.width * std::sqrt(std::max(0.0f, 1 - up * up));
  }
  if (depth < side.waist)
    return side.width + (side.narrow - side.width) * (depth - side.shoulder) / (side.waist - side.shoulder);
  const float into = depth - (length_ - side.rounding);
  if (into <= 0 || side.rounding <= 0) return side.narrow;
  const float share = into / side.rounding;
  return side.narrow * std::sqrt(std::max(0.0f, 1 - share * share));
}

// The radius at an azimuth and a depth: that of the ellipse with the half-widths a and b of the two sides beside it, a
// b / √(b² cos² + a² sin²).
float Envelope::radius(const Azimuth& round, float depth) const {
  const float a = half_width(round.across, depth), b = half_width(round.along, depth);
  const float far = std::sqrt(b * b * round.cosine * round.cosine + a * a * round.sine * round.sine);
  return far > 0 ? a * b / far : 0;
}

// The area of the horizontal section at a depth: four quarter ellipses.
float Envelope::section(float depth) const {
  const float right = half_width(0, depth), left = half_width(1, depth);
  const float front = half_width(2, depth), back = half_width(3, depth);
  return pi / 4 * (right + left) * (front + back);
}

// The volume, a sum of slices.
float Envelope::volume() const {
  float sum = 0;
  for (int k = 0; k < slices; ++k) sum += section(length_ * (static_cast<float>(k) + 0.5f) / slices);
  return sum * length_ / slices;
}

// The area of the outline as seen with the sides `first` and `first` + 1 to the right and left.
float Envelope::area(std::size_t first) const {
  float sum = 0;
  for (int k = 0; k < slices; ++k) {
    const float depth = length_ * (static_cast<float>(k) + 0.5f) / slices;
    sum += half_width(first, depth) + half_width(first + 1, depth);
  }
  return sum * length_ / slices;
}

}  // namespace panicle::bunch
