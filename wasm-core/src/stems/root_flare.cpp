#include "stems/root_flare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

namespace panicle {
namespace {

constexpr std::uint64_t stream_spur = 0xf007;
// In radii of the trunk: the length of its vertical piece, and the height of the flare.
constexpr float upright = 0.5f, flare_height = 3.2f;
// The flare's greatest height, and its depth below the ground, in metres; the depth in radii of thin trunks.
constexpr float highest_flare = 1.25f, depth = 0.3f, depth_of_thin = 1;
constexpr float stem_width = 0.92f;
// In radii: how far a tube goes on within its flare, and how wide it ends there.
constexpr float tuck = 0.15f, tuck_width = 0.96f;
// By how much a trunk is wider at the ground, in radii: 1.5 to 1.9 times as wide as above for usual flares.
constexpr float least_widening = 0.45f, more_widening = 0.6f, usual_flare = 0.15f;
constexpr std::uint32_t fewest_spurs = 4, most_spurs = 7;
// The share of the widening that is the same all around.
constexpr float hollow = 0.25f;
constexpr float spur_spread = 0.6f;  // by how much spurs run out below the ground, per unit of depth
// The flare has three times as many sides as the tube; rows of vertices above and below the ground.
constexpr std::uint32_t finer = 3, rows = 11, buried_rows = 1;

// The spurs of one trunk: at directions of their own, some larger and higher than others.
class Spurs {
 public:
  // `widening`: by how much wider the trunk is at the ground, in radii, in the mean over all directions.
  Spurs(std::uint64_t seed, float widening) {
    const auto at = [&](std::uint64_t i) { return random_unit(seed, stream_spur, i); };
    constexpr float choices = most_spurs - fewest_spurs + 1;
    count_ = std::min(fewest_spurs + static_cast<std::uint32_t>(choices * at(0)), most_spurs);
    for (std::uint32_t k = 0; k < count_; ++k) {
      Spur& spur = spurs_[k];
      spur.turn = (static_cast<float>(k) + 0.6f * (at(8 * k + 1) - 0.5f)) / static_cast<float>(count_);
      spur.size = 0.55f + 0.45f * at(8 * k + 2);
      spur.reach = 0.55f + 0.25f * at(8 * k + 3);
      spur.steepness = 1.7f + 1.5f * at(8 * k + 4);
      spur.drift = 0.05f * (at(8 * k + 5) - 0.5f);
    }
    set_down(1);
    scale_ = widening;
    for (int step = 0; step < 3 && widening > 0; ++step) scale_ *= widening / (mean_width() - 1);
  }

  // Sets the share of the way down to the ground for the next two functions.
  void set_down(float down) {
    hollow_ = hollow * down * down * down;
    for (std::uint32_t k = 0; k < count_; ++k) {
      Spur& spur = spurs_[k];
      spur.rise = down > 0 ? spur.size * power(down, spur.steepness) : 0;
      spur.middle = spur.turn + spur.drift * (1 - down);
      // Spurs get narrower towards the ground.
      spur.per_width = static_cast<float>(count_) / (spur.reach * (1.25f - 0.45f * down));
    }
  }
  // The widening in radii at a share of a whole turn.
  float widening(float turn) const { return scale_ * (hollow_ + (1 - hollow) * ridge(turn)); }
  // The spurs alone, 0 … 1.
  float ridge(float turn) const {
    float height = 0;
    for (std::uint32_t k = 0; k < count_; ++k) {
      const Spur& spur = spurs_[k];
      float off = turn - spur.middle;
      off -= std::floor(off + 0.5f);
      height += (1 - height) * spur.rise * hill(off * spur.per_width);
    }
    return height;
  }

 private:
  struct Spur {
    float turn = 0, size = 0, reach = 0, steepness = 0, drift = 0;
    float rise = 0, middle = 0, per_width = 0;  // at the height that is set
  };

  // The width in the mean over all directions, in diameters of the trunk.
  float mean_width() const {
    constexpr std::uint32_t samples = 48;
    std::array<float, samples> out{}, cosine{};
    for (std::uint32_t i = 0; i < samples; ++i) {
      const float turn = static_cast<float>(i) / samples;
      out[i] = 1 + widening(turn);
      cosine[i] = sincos_degrees(360 * turn).cosine;
    }
    float sum = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
      float farthest = 0;
      for (std::uint32_t k = 0; k < samples; ++k)
        farthest = std::max(farthest, out[k] * cosine[(k + samples - i) % samples]);
      sum += farthest;
    }
    return sum / samples;
  }

  std::array<Spur, most_spurs> spurs_{};
  std::uint32_t count_ = 0;
  float hollow_ = 0, scale_ = 1;
};

// The ring between two rings.
Ring mix(const Ring& a, const Ring& b, float share) {
  Ring ring = b;
  ring.centre = glm::mix(a.centre, b.centre, share);
  ring.tangent = glm::normalize(glm::mix(a.tangent, b.tangent, share));
  ring.right = glm::mix(a.right, b.right, share);
  ring.forward = glm::mix(a.forward, b.forward, share);
  ring.radius = glm::mix(a.radius, b.radius, share);
  ring.slope = glm::mix(a.slope, b.slope, share);
  ring.v = glm::mix(a.v, b.v, share);
  ring.v_rate = glm::mix(a.v_rate, b.v_rate, share);
  ring.turns = glm::mix(a.turns, b.turns, share);
  return ring;
}

// The surface of a trunk's foot as a grid of points: rows from where the flare begins down to the ground and below.
class FootSurface {
 public:
  explicit FootSurface(const TrunkFoot& foot)
      : foot_(foot), around_(finer * foot.sides), spurs_(foot.flare.seed, foot.flare.widening) {
    for (std::uint32_t k = 0; k < around_; ++k) turns_.push_back(sincos_degrees(360 * turn(k)));
    for (std::uint32_t row = 0; row <= rows + buried_rows; ++row) add_row(row);
  }

  std::uint32_t around() const { return around_; }
  const glm::vec3& at(std::uint32_t row, std::uint32_t k) const { return points_[row * around_ + k % around_]; }
  const glm::vec3& middle(std::uint32_t row) const { return middles_[row]; }

  // The unit normal of a point, by the difference of its neighbours; of the first row that of the tube.
  glm::vec3 normal(std::uint32_t row, std::uint32_t k) const {
    if (row == 0) return glm::normalize(at(0, k) - middles_[0]);
    const glm::vec3 along = at(row - 1, k) - at(std::min(row + 1, rows + buried_rows), k);
    return glm::normalize(glm::cross(at(row, k + 1) - at(row, k + around_ - 1), along));
  }

 private:
  float turn(std::uint32_t k) const { return static_cast<float>(k) / static_cast<float>(around_); }

  // Adds a row; rows are denser towards the ground.
  void add_row(std::uint32_t row) {
    const float left = std::max(0.0f, 1 - static_cast<float>(row) / rows);
    const float down = 1 - left * std::sqrt(left);
    const float below = row > rows ? static_cast<float>(row - rows) / buried_rows : 0;
    const glm::vec3 sunk(0, -below * foot_.flare.depth, 0);
    const Ring ring = ring_at(1 - down);
    const float base = foot_.rings.front().radius;
    spurs_.set_down(down);
    middles_.push_back(ring.centre + sunk);
    for (std::uint32_t k = 0; k < around_; ++k) {
      const float out =
          base * spurs_.widening(turn(k)) + below * foot_.flare.depth * spur_spread * spurs_.ridge(turn(k));
      points_.push_back(ring.centre + sunk + edge(ring, k, down) * (1 + out / ring.radius));
    }
  }

  // The ring at a share of the height.
  Ring ring_at(float up) const {
    const std::vector<Ring>& rings = foot_.rings;
    const float low = rings.front().centre.y, y = low + up * (rings.back().centre.y - low);
    std::size_t i = 1;
    while (i + 1 < rings.size() && rings[i].centre.y < y) ++i;
    const float rise = rings[i].centre.y - rings[i - 1].centre.y;
    return mix(rings[i - 1], rings[i], rise > 0 ? std::clamp((y - rings[i - 1].centre.y) / rise, 0.0f, 1.0f) : 1);
  }

  // From a ring's centre to its edge: that of the tube's polygon where the flare begins, and a circle below.
  glm::vec3 edge(const Ring& ring, std::uint32_t k, float down) const {
    const auto on_circle = [&](std::uint32_t i) {
      const SinCos& angle = turns_[i % around_];
      return ring.right * angle.cosine + ring.forward * angle.sine;
    };
    const float flat = 1 - std::min(1.0f, 4 * down);
    const std::uint32_t corner = k / finer * finer;
    const glm::vec3 straight = glm::mix(on_circle(corner), on_circle(corner + finer),
                                        static_cast<float>(k - corner) / static_cast<float>(finer));
    return glm::mix(on_circle(k), straight, flat);
  }

  const TrunkFoot& foot_;
  std::uint32_t around_;
  Spurs spurs_;
  std::vector<SinCos> turns_;
  std::vector<glm::vec3> points_, middles_;
};

// Writer of vertices and triangles, all of the segment `number`.
class Writer {
 public:
  Writer(StemMesh& stems, std::uint32_t number, float scale) : stems_(stems), number_(number), scale_(scale) {}

  // Adds a vertex; returns its index.
  std::uint32_t vertex(const glm::vec3& place, const glm::vec3& normal, float u, float v) {
    Mesh& mesh = stems_.mesh;
    put(mesh.positions, place * scale_);
    put(mesh.normals, normal);
    mesh.uvs.insert(mesh.uvs.end(), {u, v});
    stems_.segment.push_back(number_);
    return static_cast<std::uint32_t>(stems_.segment.size()) - 1;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { put(stems_.mesh.indices, a, b, c); }

 private:
  StemMesh& stems_;
  std::uint32_t number_;
  float scale_;
};

// The height of a trunk's vertical piece at its foot.
float upright_height(const Segment& base) {
  return std::min(upright * base.radius, 0.4f * (base.end.y - base.start.y));
}

}  // namespace

std::vector<std::int32_t> trunk_bases(std::span<const Segment> segments, std::span<const glm::vec3> targets) {
  std::vector<std::int32_t> bases(targets.size(), -1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].parent >= 0) continue;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      if (segments[i].start != targets[k]) continue;
      std::int32_t& base = bases[k];
      if (base < 0 || segments[i].radius > segments[static_cast<std::size_t>(base)].radius)
        base = static_cast<std::int32_t>(i);
    }
  }
  return bases;
}

std::vector<Segment> base_pieces(const Segment& base, const RootFlareOptions& options) {
  Segment rest = base, first = base;
  if (options.standing) {
    const float rise = upright_height(base);
    if (!(rise > 0)) return {base};
    first.end = rest.start = base.start + glm::vec3(0, rise, 0);
    first.radius_end = base.radius;
    return {first, rest};
  }
  if (!(options.stump > 0)) return {base};
  first.start.y += options.stump;
  first.end = base.start;
  first.radius = stem_width * base.radius;
  first.radius_end = base.radius;
  return {first, rest};
}

RootFlare root_flare_of(const Segment& base, std::uint32_t number, const RootFlareOptions& options) {
  return {.segment = number,
          .widening = least_widening * std::min(1.0f, options.flare / usual_flare) + more_widening * options.flare,
          .height = std::min(flare_height * base.radius, highest_flare),
          .depth = std::min(depth, depth_of_thin * base.radius),
          .seed = options.seed};
}

TrunkFoot take_foot(Tube& tube, const RootFlare& flare, std::uint32_t sides) {
  TrunkFoot foot{flare, sides, {}};
  std::vector<Ring>& rings = tube.rings;
  const float ground = tube.parent_point.y, top = ground + flare.height;
  std::size_t i = 0;
  for (; i < rings.size() && rings[i].centre.y < top; ++i)
    if (rings[i].centre.y >= ground) foot.rings.push_back(rings[i]);
  if (i == rings.size() || foot.rings.empty()) return {flare, sides, {}};
  const Ring& below = foot.rings.back();
  Ring join = mix(below, rings[i], (top - below.centre.y) / (rings[i].centre.y - below.centre.y));
  join.run = 0;
  foot.rings.push_back(join);
  // The tube ends a little within the foot: between their edges no gap shows.
  Ring tucked = join;
  const float way = tuck * join.radius;
  tucked.centre -= way * join.tangent;
  tucked.radius *= tuck_width;
  tucked.right *= tuck_width;
  tucked.forward *= tuck_width;
  tucked.v -= way * join.v_rate;
  rings.erase(rings.begin(), rings.begin() + static_cast<std::ptrdiff_t>(i));
  rings.insert(rings.begin(), {tucked, join});
  tube.first_pole = tucked.centre;
  return foot;
}

void add_root_flare(StemMesh& stems, const TrunkFoot& foot, float scale) {
  if (foot.rings.empty()) return;
  const FootSurface surface(foot);
  const Ring& join = foot.rings.back();
  Writer writer(stems, foot.flare.segment, scale);
  const std::uint32_t around = surface.around(), line = around + 1, last = rows + buried_rows;
  const auto first = static_cast<std::uint32_t>(stems.segment.size());
  float v = join.v;
  for (std::uint32_t row = 0; row <= last; ++row) {
    if (row > 0) {
      // The bark keeps its proportions where the foot is wider.
      float way = 0, girth = 0;
      for (std::uint32_t k = 0; k < around; ++k) {
        way += glm::distance(surface.at(row, k), surface.at(row - 1, k)) / static_cast<float>(around);
        girth += glm::distance(surface.at(row, k), surface.at(row, k + 1));
      }
      v -= way * join.v_rate * 2 * pi * join.radius / girth;
    }
    for (std::uint32_t k = 0; k <= around; ++k)
      writer.vertex(surface.at(row, k), surface.normal(row, k),
                    join.turns * static_cast<float>(k) / static_cast<float>(around), v);
  }
  for (std::uint32_t row = 0; row < last; ++row)
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t at = first + row * line + k;
      writer.triangle(at, at + line, at + line + 1);
      writer.triangle(at, at + line + 1, at + 1);
    }
  // Discs close both ends.
  for (const std::uint32_t row : {0u, last}) {
    const glm::vec3 normal(0, row == 0 ? 1 : -1, 0);
    const std::uint32_t middle = writer.vertex(surface.middle(row), normal, 0, v);
    for (std::uint32_t k = 0; k <= around; ++k) writer.vertex(surface.at(row, k), normal, 0, v);
    for (std::uint32_t k = 0; k < around; ++k)
      writer.triangle(middle, middle + (row == 0 ? 1 : 2) + k, middle + (row == 0 ? 2 : 1) + k);
  }
}

}  // namespace panicle
