#include "models/bunch/measures/measures_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "foundation/mathematics.hpp"
#include "models/bunch/berry/pressing/projection.hpp"
#include "models/bunch/natural/peduncle.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

constexpr std::size_t slices = 48;    // of the bunch's height
constexpr float standing_out = 2.2f;  // farthest reach of a winged side over its median
constexpr float cylinder = 0.75f;     // lower width over upper from which a bunch is a cylinder
constexpr float early = 0.12f;  // the share of its upper width by which a funnel's middle is narrower than a cone's
constexpr float uniform_spread = 0.15f;  // of diameters

// How far the berries of the first bunch extend from the rachis to the right, left, front and back, by height.
class Reaches {
 public:
  // Measures the height of all berries of the first bunch first, then the reach to the four sides in each slice of it.
  explicit Reaches(const Subject& subject) {
    for (std::size_t i = 0; i < subject.berries.size(); ++i)
      if (subject.first[i]) extend(subject.berries[i]);
    if (!(low_ < high_)) return;
    for (std::size_t i = 0; i < subject.berries.size(); ++i) {
      if (!subject.first[i]) continue;
      add(project(subject.berries[i], View{}), 0, subject.mean_radius);
      add(project(subject.berries[i], View{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}), 2, subject.mean_radius);
    }
  }

  // Mean width over both views of the slices from `from` to `to`, shares of the height from the top.
  float width(float from, float to) const {
    float sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < slices; ++k) {
      const float at = (static_cast<float>(k) + 0.5f) / slices;
      if (at < from || at > to) continue;
      for (const auto& side : sides_) sum += side[k] / 2;
      ++count;
    }
    return sum / static_cast<float>(count);
  }

  // Whether a side has a branch that stands out from it, by two berries or more. `berry`: a mean berry's width.
  bool winged(std::size_t side, float berry) const {
    std::array<float, slices> sorted = sides_[side];
    std::sort(sorted.begin(), sorted.end());
    const float median = sorted[slices / 2];
    return sorted.back() > std::max(standing_out * median, median + 2 * berry);
  }

 private:
  // Extends the height to a berry's outline.
  void extend(const BerryBody& berry) {
    const ProjectedBerry seen = project(berry, View{});
    low_ = std::min(low_, seen.centre.y - seen.half.y);
    high_ = std::max(high_, seen.centre.y + seen.half.y);
  }

  // Extends the reach of the sides `side` (right) and `side` + 1 (left) of a view, in all slices that a berry's outline
  // meets. Berries are made higher by `more` at top and bottom: gaps between neighbours are no waists.
  void add(const ProjectedBerry& seen, std::size_t side, float more) {
    const float slice = (high_ - low_) / slices, shrink = seen.half.y / (seen.half.y + more);
    for (std::size_t k = 0; k < slices; ++k) {
      const float up = shrink * (high_ - (static_cast<float>(k) + 0.5f) * slice - seen.centre.y);
      if (std::abs(up) > seen.half.y) continue;
      const float lean = -seen.uv * up;
      const float half = std::sqrt(std::max(0.0f, lean * lean - seen.uu * (seen.vv * up * up - 1)));
      sides_[side][k] = std::max(sides_[side][k], seen.centre.x + (lean + half) / seen.uu);
      sides_[side + 1][k] = std::max(sides_[side + 1][k], -(seen.centre.x + (lean - half) / seen.uu));
    }
  }

  float low_ = std::numeric_limits<float>::max(), high_ = std::numeric_limits<float>::lowest();
  std::array<std::array<float, slices>, 4> sides_ = {};
};

// The shape of the bunch: 1 a cylinder, 2 a cone, 3 a funnel, whose middle is narrower than halfway between its upper
// and lower width.
float shape_of(const Reaches& reaches) {
  const float upper = reaches.width(0.1f, 0.35f), middle = reaches.width(0.35f, 0.65f),
              lower = reaches.width(0.65f, 0.9f);
  if (lower >= cylinder * upper) return 1;
  return middle < (upper + lower) / 2 - early * upper ? 3 : 2;
}

// The greatest width of the berries' silhouette over 16 horizontal directions.
float greatest_width(const Subject& subject) {
  constexpr int directions = 16;
  float widest = 0;
  for (int k = 0; k < directions; ++k) {
    const SinCos turn = sincos_degrees(180.0f / directions * static_cast<float>(k));
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const BerryBody& berry : subject.berries) {
      const float at = berry.centre.x * turn.cosine + berry.centre.z * turn.sine;
      const float along = berry.direction.x * turn.cosine + berry.direction.z * turn.sine;
      const float square = berry.half_width * berry.half_width;
      const float reach = std::sqrt(square + (berry.half_length * berry.half_length - square) * along * along);
      low = std::min(low, at - reach);
      high = std::max(high, at + reach);
    }
    widest = std::max(widest, high - low);
  }
  return widest;
}

// The distance of two points.
float length_between(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = b - a;
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

}  // namespace

// Measures the form from the extent of the berries' outlines along the vertical and from their reach to each of four
// sides.
BunchForm bunch_form(const Subject& subject) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const BerryBody& berry : subject.berries) {
    const ProjectedBerry seen = project(berry, View{});
    low = std::min(low, seen.centre.y - seen.half.y);
    high = std::max(high, seen.centre.y + seen.half.y);
  }
  const Reaches reaches(subject);
  float wings = 0;
  for (std::size_t side = 0; side < 4; ++side) wings += reaches.winged(side, 2 * subject.mean_radius);
  return {high - low, greatest_width(subject), shape_of(reaches), wings};
}

// The length from the top of the peduncle to the first branch, in millimetres.
float length_of_peduncle(const GrownBunch& grown) {
  constexpr float millimetres = 1000;
  return millimetres * length_to_first_branch(grown.internodes);
}

// Means over all berries; `spread` is the standard deviation of the diameters over their mean.
BerryMeans berry_means(const Subject& subject) {
  BerryMeans means;
  const auto count = static_cast<float>(subject.berries.size());
  means.diameter = 2 * subject.mean_radius;
  float variance = 0;
  for (std::size_t i = 0; i < subject.berries.size(); ++i) {
    means.width += 2 * subject.berries[i].half_width / count;
    means.length += 2 * subject.berries[i].half_length / count;
    const float off = 2 * subject.balls[i] - means.diameter;
    variance += off * off / count;
  }
  means.spread = std::sqrt(variance) / means.diameter;
  for (const Segment& stem : subject.pedicels) means.pedicel += length_between(stem.start, stem.end);
  means.pedicel /= static_cast<float>(subject.pedicels.size());
  return means;
}

// The shape note of a berry, 1 … 10 (OIV descriptor 223), by its form and proportion.
float berry_shape_note(const BerryForm& form, float length_over_width) {
  constexpr float tapered = 0.25f, blunt = 0.4f, finger = 2, horn = 0.4f;
  if (form.curve >= horn) return 9;
  if (length_over_width >= finger) return 10;
  if (form.taper <= -tapered) return form.blunt >= blunt ? 6 : 7;
  if (form.taper >= tapered) return 8;
  if (length_over_width < 0.95f) return 1;
  if (length_over_width < 1.1f) return 2;
  if (form.blunt >= blunt) return 5;
  return length_over_width < 1.4f ? 3 : 4;
}

// The uniformity of berry sizes: 2 uniform, 1 not. `spread`: standard deviation over the mean.
float uniformity_note(float spread) { return spread <= uniform_spread ? 2 : 1; }

}  // namespace panicle::bunch
