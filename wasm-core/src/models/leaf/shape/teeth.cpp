#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "models/leaf/messages.generated.hpp"
#include "models/leaf/shape/margin.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float lattice = 1048576;
// Near a lobe's tip teeth are no deeper than this share of their distance from it along the margin.
constexpr float slope_at_tips = 0.25f;
// Nor deeper than this share of the blade's width there: the opposite margin may have teeth too.
constexpr float share_of_width = 0.22f;
// Teeth that can be no deeper than this share of the requested depth are left out.
constexpr float least_left = 0.1f;
constexpr float shallowest = 0.2f;      // teeth that cross are halved down to this
constexpr float longest_edge = 0.015f;  // leaf lengths

// The shape of a tooth: along it towards the tip, and how far out, both 0 … 1. It begins at 0, 0; its end is the
// beginning of the next.
using Profile = std::span<const glm::vec2>;

// The profile of a tooth of a shape. Those of doubly serrate margins have a smaller tooth on the way to the tip.
Profile profile_of(ToothShape shape) {
  static constexpr glm::vec2 dentate[] = {{0, 0}, {0.22f, 0.4f}, {0.5f, 1}, {0.78f, 0.4f}};
  static constexpr glm::vec2 serrate[] = {{0, 0}, {0.25f, 0.42f}, {0.55f, 0.78f}, {0.86f, 1}, {0.93f, 0.4f}};
  static constexpr glm::vec2 crenate[] = {{0, 0},    {0.06f, 0.42f}, {0.18f, 0.74f}, {0.33f, 0.93f},
                                          {0.5f, 1}, {0.67f, 0.93f}, {0.82f, 0.74f}, {0.94f, 0.42f}};
  static constexpr glm::vec2 twice[] = {{0, 0},         {0.2f, 0.34f}, {0.36f, 0.52f}, {0.41f, 0.3f},
                                        {0.62f, 0.66f}, {0.88f, 1},    {0.95f, 0.45f}};
  static constexpr glm::vec2 blunt[] = {{0, 0},         {0.08f, 0.3f}, {0.2f, 0.57f},  {0.36f, 0.8f},
                                        {0.54f, 0.95f}, {0.7f, 1},     {0.83f, 0.93f}, {0.92f, 0.66f}};
  static constexpr Profile profiles[] = {dentate, serrate, crenate, twice, blunt};
  return profiles[static_cast<std::size_t>(shape)];
}

// A closed polygon, parametrised by the length along it from its first point.
class ArcLength {
 public:
  // Sums the lengths of a line's pieces.
  explicit ArcLength(std::span<const glm::vec2> points) : points_(points), lengths_{0} {
    for (std::size_t i = 0; i < points.size(); ++i)
      lengths_.push_back(lengths_[i] + glm::distance(points[i], points[(i + 1) % points.size()]));
  }
  float length() const { return lengths_.back(); }
  // The length at a point.
  float at(std::size_t point) const { return lengths_[point]; }
  // The edge that a length is on.
  std::size_t edge(float length) const {
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    const auto found = static_cast<std::size_t>(after - lengths_.begin());
    return std::min(found > 0 ? found - 1 : 0, points_.size() - 1);
  }
  // The point at a length.
  glm::vec2 place(float length) const {
    const std::size_t i = edge(length);
    const float edge_length = lengths_[i + 1] - lengths_[i];
    return points_[i] + (edge_length > 0 ? (length - lengths_[i]) / edge_length : 0) *
                            (points_[(i + 1) % points_.size()] - points_[i]);
  }
  // The unit vector into the blade at a length; averaged over `reach` to both sides, so that it does not jump at the
  // polygon's corners.
  glm::vec2 inwards(float length, float reach) const {
    const glm::vec2 chord = place(std::min(length + reach, lengths_.back())) - place(std::max(length - reach, 0.0f));
    const float chord_length = glm::length(chord);
    return chord_length > 0 ? glm::vec2(-chord.y, chord.x) / chord_length : glm::vec2(0);
  }

 private:
  std::span<const glm::vec2> points_;
  std::vector<float> lengths_;
};

// A stretch between two corners of the margin without teeth in them; its teeth lean towards its end, or towards its
// beginning.
struct Stretch {
  std::size_t first, last;  // points; `last` may be the number of points, which is the base again
  bool to_end;
};

// Divides the margin into stretches from a sinus to a lobe's tip and on to the next sinus: the deepest point between
// two tips.
std::vector<Stretch> stretches_of(const Margin& margin) {
  const std::size_t count = margin.points.size();
  std::vector<std::size_t> tips = margin.tips;
  if (std::find(tips.begin(), tips.end(), margin.tip) == tips.end()) tips.push_back(margin.tip);
  std::erase(tips, 0u);
  std::sort(tips.begin(), tips.end());
  std::vector<Stretch> stretches;
  std::size_t start = 0;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    stretches.push_back({start, tips[k], true});
    std::size_t sinus = count;
    if (k + 1 < tips.size()) {
      sinus = tips[k] + 1;
      const glm::vec2 mid = 0.5f * (margin.points[tips[k]] + margin.points[tips[k + 1]]);
      float deepest = -1;
      for (std::size_t i = tips[k] + 1; i < tips[k + 1]; ++i)
        if (const float depth = glm::distance(margin.points[i], mid); depth > deepest) {
          deepest = depth;
          sinus = i;
        }
      // In lobes that are wider than their sinus is deep, a place about midway is as good.
    }
    stretches.push_back({tips[k], sinus, false});
    start = sinus;
  }
  return stretches;
}

// The width of the blade at each point of the margin: the diameter of the greatest inscribed disc that touches the
// margin there (the medial axis' measure of thickness), from the ends of the other edges and from the intersections
// with the inward normal.
std::vector<float> widths_of(std::span<const glm::vec2> points) {
  const std::size_t count = points.size();
  const auto cross = [](const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; };
  std::vector<float> widths(count, std::numeric_limits<float>::max());
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 point = points[i], tangent = points[(i + 1) % count] - points[(i + count - 1) % count];
    const float tangent_length = glm::length(tangent);
    if (!(tangent_length > 0)) continue;
    const glm::vec2 inwards = glm::vec2(-tangent.y, tangent.x) / tangent_length;
    for (std::size_t k = 0; k < count; ++k) {
      if (k == i) continue;
      const std::size_t next = k + 1 < count ? k + 1 : 0;
      const glm::vec2 edge_start = points[k] - point, edge_end = points[next] - point;
      if (const float ahead = glm::dot(inwards, edge_start); ahead > 0)
        widths[i] = std::min(widths[i], glm::dot(edge_start, edge_start) / ahead);
      const float cross_start = cross(inwards, edge_start), cross_end = cross(inwards, edge_end);
      if (next == i || (cross_start > 0) == (cross_end > 0)) continue;
      if (const float depth =
              glm::dot(inwards, edge_start + cross_start / (cross_start - cross_end) * (edge_end - edge_start));
          depth > 0)
        widths[i] = std::min(widths[i], depth);
    }
  }
  return widths;
}

// One tooth: its range along the margin, the stretch it is in, and its depth.
struct Tooth {
  float from, to;                    // along the margin
  bool to_end;                       // whether it leans towards `to`
  float stretch_start, stretch_end;  // along the margin
  float share = 1;                   // of its regular depth; 0: it is left out
};

// A margin while teeth are cut into it, with the tooth of each of its points.
struct Cut {
  Margin margin;
  std::vector<std::int32_t> owners;

  // Adds a point of the tooth `owner` (−1: none), rounded to the lattice, unless it repeats the last one.
  void add(const glm::vec2& p, std::int32_t owner) {
    const glm::vec2 place(std::floor(p.x * lattice + 0.5f) / lattice, std::floor(p.y * lattice + 0.5f) / lattice);
    if (!margin.points.empty() && margin.points.back() == place) return;
    margin.points.push_back(place);
    owners.push_back(owner);
  }
};

// Cutter of teeth into a margin. Teeth that turn out to cross others are made less deep with `lower`, then all are cut
// again.
class Cutter {
 public:
  Cutter(const Margin& margin, const Teeth& teeth)
      : margin_(margin),
        options_(teeth),
        arc_length_(margin.points),
        widths_(widths_of(margin.points)),
        stretches_(stretches_of(margin)) {
    const float side = 0.5f * arc_length_.length(), entire = options_.entire * side;
    for (const Stretch& stretch : stretches_) {
      const float first = std::max(arc_length_.at(stretch.first), entire),
                  last = std::min(arc_length_.at(stretch.last), arc_length_.length() - entire);
      const float count = std::floor(static_cast<float>(options_.count) * (last - first) / (side - entire) + 0.5f);
      const auto tooth_start = [&](float k) { return k < count ? first + k / count * (last - first) : last; };
      for (float k = 0; k < count; ++k)
        teeth_.push_back({tooth_start(k), tooth_start(k + 1), stretch.to_end, first, last});
    }
    for (Tooth& tooth : teeth_)
      if (greatest_depth(tooth) < least_left * options_.depth * (tooth.to - tooth.from)) tooth.share = 0;
  }

  // Cuts all teeth with their present depths.
  Cut cut() const {
    Cut cut;
    std::size_t tooth = 0;
    for (const Stretch& stretch : stretches_) {
      float position = arc_length_.at(stretch.first);
      const float end = arc_length_.at(stretch.last);
      cut.add(margin_.points[stretch.first], -1);
      if (std::find(margin_.tips.begin(), margin_.tips.end(), stretch.first) != margin_.tips.end())
        cut.margin.tips.push_back(cut.margin.points.size() - 1);
      if (stretch.first == margin_.tip) cut.margin.tip = cut.margin.points.size() - 1;
      for (; tooth < teeth_.size() && teeth_[tooth].from < end; ++tooth) {
        add_plain(cut, position, teeth_[tooth].from, -1);
        add_tooth(cut, tooth);
        position = teeth_[tooth].to;
      }
      add_plain(cut, position, end, -1);
    }
    while (cut.margin.points.back() == cut.margin.points.front()) cut.margin.points.pop_back();
    return cut;
  }

  // Halves the depth of the teeth `owners` (−1: none), and leaves out those that would get too shallow. Returns false
  // if all of them are left out already.
  bool lower(std::span<const std::int32_t> owners) {
    bool any = false;
    for (const std::int32_t owner : owners) {
      if (owner < 0) continue;
      float& share = teeth_[static_cast<std::size_t>(owner)].share;
      any = any || share > 0;
      share = 0.5f * share < shallowest ? 0 : 0.5f * share;
    }
    return any;
  }

  // The numbers of all teeth and of those left out.
  std::size_t number() const { return teeth_.size(); }
  // The number of teeth for which there was no room.
  std::size_t left_out() const {
    return static_cast<std::size_t>(
        std::count_if(teeth_.begin(), teeth_.end(), [](const Tooth& tooth) { return tooth.share == 0; }));
  }

 private:
  // The width of the blade at a length along the margin, interpolated between its points.
  float width(float length) const {
    const std::size_t i = arc_length_.edge(length);
    const float edge_start = arc_length_.at(i), edge_end = arc_length_.at(i + 1),
                t = edge_end > edge_start ? (length - edge_start) / (edge_end - edge_start) : 0;
    return (1 - t) * widths_[i] + t * widths_[(i + 1) % widths_.size()];
  }

  // The depth of a tooth with a share of 1 at a position along the margin.
  float depth_at(const Tooth& tooth, float length) const {
    const float near_end = std::min(length - tooth.stretch_start, tooth.stretch_end - length);
    return std::max(
        std::min({options_.depth * (tooth.to - tooth.from), slope_at_tips * near_end, share_of_width * width(length)}),
        0.0f);
  }

  // The greatest depth along a tooth, sampled.
  float greatest_depth(const Tooth& tooth) const {
    constexpr float samples = 6;
    float greatest = 0;
    for (float k = 0; k <= samples; ++k)
      greatest = std::max(greatest, depth_at(tooth, tooth.from + k / samples * (tooth.to - tooth.from)));
    return greatest;
  }

  // Adds the margin's own points between two lengths.
  void add_plain(Cut& cut, float from, float to, std::int32_t owner) const {
    for (std::size_t i = arc_length_.edge(from) + 1; i < margin_.points.size() && arc_length_.at(i) < to; ++i)
      if (arc_length_.at(i) > from) cut.add(margin_.points[i], owner);
  }

  // Adds a tooth, with the notch towards the tip that it leans away from, if it has a neighbour there.
  void add_tooth(Cut& cut, std::size_t number) const {
    const Tooth& tooth = teeth_[number];
    const auto owner = static_cast<std::int32_t>(number);
    if (tooth.share == 0) return add_plain(cut, tooth.from, tooth.to, owner);
    const float tooth_length = tooth.to - tooth.from;
    const Profile profile = profile_of(options_.shape);
    std::vector<glm::vec2> places;  // along the margin, how far out
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const glm::vec2 corner = profile[i], next_corner = i + 1 < profile.size() ? profile[i + 1] : glm::vec2(1, 0);
      const float pieces = std::clamp(std::ceil(tooth_length * (next_corner.x - corner.x) / longest_edge), 1.0f, 64.0f);
      for (float piece = 0; piece < pieces; ++piece) {
        const glm::vec2 profile_point = corner + (piece / pieces) * (next_corner - corner);
        places.push_back(
            {tooth.to_end ? tooth.from + profile_point.x * tooth_length : tooth.to - profile_point.x * tooth_length,
             profile_point.y});
      }
    }
    if (!tooth.to_end) std::reverse(places.begin(), places.end());
    for (const glm::vec2& place : places) {
      const float length = place.x, out = place.y;
      const bool notch = out == 0;
      if (notch && (length <= tooth.stretch_start || length >= tooth.stretch_end)) continue;
      glm::vec2 p = arc_length_.place(length);
      const float share = notch ? std::min(tooth.share, notch_neighbour_share(number)) : tooth.share;
      if (const float inwards = (1 - out) * share * depth_at(tooth, length); inwards > 0)
        p += inwards * arc_length_.inwards(length, 0.5f * longest_edge);
      cut.add(p, owner);
      if (out == 1) cut.margin.teeth.push_back(cut.margin.points.size() - 1);
    }
  }

  // The share of the tooth on the other side of a tooth's notch.
  float notch_neighbour_share(std::size_t number) const {
    return teeth_[teeth_[number].to_end ? number - 1 : number + 1].share;
  }

  const Margin& margin_;
  const Teeth& options_;
  ArcLength arc_length_;
  std::vector<float> widths_;
  std::vector<Stretch> stretches_;
  std::vector<Tooth> teeth_;
};

}  // namespace

// Cuts teeth into a margin; teeth that would meet are lowered or left out, with a note.
Margin toothed(const Margin& margin, const Teeth& teeth, std::vector<std::string>& notes) {
  if (teeth.count == 0) return margin;
  Cutter cutter(margin, teeth);
  Cut cut = cutter.cut();
  for (;;) {
    std::vector<std::int32_t> met;
    const std::size_t count = cut.margin.points.size();
    for (const auto& [first, second] : crossings(cut.margin.points))
      for (const std::size_t edge : {first, second})
        for (const std::size_t point : {edge, (edge + 1) % count}) met.push_back(cut.owners[point]);
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    if (!cutter.lower(met)) break;
    cut = cutter.cut();
  }
  if (const std::size_t out = cutter.left_out(); out > 0)
    notes.push_back(message(messages::leaf::teeth_left_out, out, cutter.number()));
  return std::move(cut.margin);
}

}  // namespace panicle::particles::leaf
