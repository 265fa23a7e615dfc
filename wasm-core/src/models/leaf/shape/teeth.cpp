#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

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

// A closed polygon, parametrised by length.
class Rail {
 public:
  explicit Rail(std::span<const glm::vec2> points) : points_(points), lengths_{0} {
    for (std::size_t i = 0; i < points.size(); ++i)
      lengths_.push_back(lengths_[i] + glm::distance(points[i], points[(i + 1) % points.size()]));
  }
  float length() const { return lengths_.back(); }
  float at(std::size_t point) const { return lengths_[point]; }
  std::size_t edge(float length) const {
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    const auto found = static_cast<std::size_t>(after - lengths_.begin());
    return std::min(found > 0 ? found - 1 : 0, points_.size() - 1);
  }
  glm::vec2 place(float length) const {
    const std::size_t i = edge(length);
    const float whole = lengths_[i + 1] - lengths_[i];
    return points_[i] +
           (whole > 0 ? (length - lengths_[i]) / whole : 0) * (points_[(i + 1) % points_.size()] - points_[i]);
  }
  // The direction into the blade, unit; averaged over `reach`, so that it does not jump at the polygon's corners.
  glm::vec2 inwards(float length, float reach) const {
    const glm::vec2 way = place(std::min(length + reach, lengths_.back())) - place(std::max(length - reach, 0.0f));
    const float size = glm::length(way);
    return size > 0 ? glm::vec2(-way.y, way.x) / size : glm::vec2(0);
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

std::vector<Stretch> stretches_of(const Margin& margin) {
  const std::size_t count = margin.points.size();
  std::vector<std::size_t> tips = margin.tips;
  if (std::find(tips.begin(), tips.end(), margin.tip) == tips.end()) tips.push_back(margin.tip);
  std::erase(tips, 0u);
  std::sort(tips.begin(), tips.end());
  std::vector<Stretch> all;
  std::size_t from = 0;
  for (std::size_t k = 0; k < tips.size(); ++k) {
    all.push_back({from, tips[k], true});
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
    all.push_back({tips[k], sinus, false});
    from = sinus;
  }
  return all;
}

// The width of the blade at each point of the margin: the diameter of the greatest inscribed disc that touches the
// margin there (the medial axis' measure of thickness), from the ends of the other edges and from the intersections
// with the inward normal.
std::vector<float> widths_of(std::span<const glm::vec2> points) {
  const std::size_t count = points.size();
  const auto cross = [](const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; };
  std::vector<float> widths(count, std::numeric_limits<float>::max());
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 here = points[i], along = points[(i + 1) % count] - points[(i + count - 1) % count];
    const float size = glm::length(along);
    if (!(size > 0)) continue;
    const glm::vec2 inwards = glm::vec2(-along.y, along.x) / size;
    for (std::size_t k = 0; k < count; ++k) {
      if (k == i) continue;
      const std::size_t next = k + 1 < count ? k + 1 : 0;
      const glm::vec2 from = points[k] - here, to = points[next] - here;
      if (const float ahead = glm::dot(inwards, from); ahead > 0)
        widths[i] = std::min(widths[i], glm::dot(from, from) / ahead);
      const float one = cross(inwards, from), other = cross(inwards, to);
      if (next == i || (one > 0) == (other > 0)) continue;
      if (const float far = glm::dot(inwards, from + one / (one - other) * (to - from)); far > 0)
        widths[i] = std::min(widths[i], far);
    }
  }
  return widths;
}

struct Tooth {
  float from, to;     // along the margin
  bool to_end;        // whether it leans towards `to`
  float first, last;  // of its stretch
  float share = 1;    // of its regular depth; 0: it is left out
};

// A margin while teeth are cut into it, with the tooth of each of its points.
struct Cut {
  Margin margin;
  std::vector<std::int32_t> owners;

  void add(const glm::vec2& p, std::int32_t owner) {
    const glm::vec2 place(std::floor(p.x * lattice + 0.5f) / lattice, std::floor(p.y * lattice + 0.5f) / lattice);
    if (!margin.points.empty() && margin.points.back() == place) return;
    margin.points.push_back(place);
    owners.push_back(owner);
  }
};

class Cutter {
 public:
  Cutter(const Margin& margin, const Teeth& teeth)
      : margin_(margin),
        options_(teeth),
        rail_(margin.points),
        widths_(widths_of(margin.points)),
        stretches_(stretches_of(margin)) {
    const float side = 0.5f * rail_.length(), entire = options_.entire * side;
    for (const Stretch& one : stretches_) {
      const float first = std::max(rail_.at(one.first), entire),
                  last = std::min(rail_.at(one.last), rail_.length() - entire);
      const float count = std::floor(static_cast<float>(options_.count) * (last - first) / (side - entire) + 0.5f);
      const auto at = [&](float k) { return k < count ? first + k / count * (last - first) : last; };
      for (float k = 0; k < count; ++k) teeth_.push_back({at(k), at(k + 1), one.to_end, first, last});
    }
    for (Tooth& tooth : teeth_)
      if (deepest(tooth) < least_left * options_.depth * (tooth.to - tooth.from)) tooth.share = 0;
  }

  Cut cut() const {
    Cut cut;
    std::size_t tooth = 0;
    for (const Stretch& one : stretches_) {
      float at = rail_.at(one.first);
      const float end = rail_.at(one.last);
      cut.add(margin_.points[one.first], -1);
      if (std::find(margin_.tips.begin(), margin_.tips.end(), one.first) != margin_.tips.end())
        cut.margin.tips.push_back(cut.margin.points.size() - 1);
      if (one.first == margin_.tip) cut.margin.tip = cut.margin.points.size() - 1;
      for (; tooth < teeth_.size() && teeth_[tooth].from < end; ++tooth) {
        add_plain(cut, at, teeth_[tooth].from, -1);
        add_tooth(cut, tooth);
        at = teeth_[tooth].to;
      }
      add_plain(cut, at, end, -1);
    }
    while (cut.margin.points.back() == cut.margin.points.front()) cut.margin.points.pop_back();
    return cut;
  }

  // Cuts those teeth less deep, and leaves out those that would get too shallow. Returns false if all of them are left
  // out already.
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

  std::size_t number() const { return teeth_.size(); }
  std::size_t left_out() const {
    return static_cast<std::size_t>(
        std::count_if(teeth_.begin(), teeth_.end(), [](const Tooth& tooth) { return tooth.share == 0; }));
  }

 private:
  float width(float length) const {
    const std::size_t i = rail_.edge(length);
    const float from = rail_.at(i), to = rail_.at(i + 1), t = to > from ? (length - from) / (to - from) : 0;
    return (1 - t) * widths_[i] + t * widths_[(i + 1) % widths_.size()];
  }

  float deep(const Tooth& tooth, float length) const {
    const float near_end = std::min(length - tooth.first, tooth.last - length);
    return std::max(
        std::min({options_.depth * (tooth.to - tooth.from), slope_at_tips * near_end, share_of_width * width(length)}),
        0.0f);
  }

  float deepest(const Tooth& tooth) const {
    constexpr float places = 6;
    float most = 0;
    for (float k = 0; k <= places; ++k)
      most = std::max(most, deep(tooth, tooth.from + k / places * (tooth.to - tooth.from)));
    return most;
  }

  // Adds the margin's own points in between.
  void add_plain(Cut& cut, float from, float to, std::int32_t owner) const {
    for (std::size_t i = rail_.edge(from) + 1; i < margin_.points.size() && rail_.at(i) < to; ++i)
      if (rail_.at(i) > from) cut.add(margin_.points[i], owner);
  }

  // Adds a tooth, with the notch towards the tip that it leans away from, if it has a neighbour there.
  void add_tooth(Cut& cut, std::size_t number) const {
    const Tooth& tooth = teeth_[number];
    const auto owner = static_cast<std::int32_t>(number);
    if (tooth.share == 0) return add_plain(cut, tooth.from, tooth.to, owner);
    const float whole = tooth.to - tooth.from;
    const Profile profile = profile_of(options_.shape);
    std::vector<glm::vec2> places;  // along the margin, how far out
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const glm::vec2 here = profile[i], next = i + 1 < profile.size() ? profile[i + 1] : glm::vec2(1, 0);
      const float pieces = std::clamp(std::ceil(whole * (next.x - here.x) / longest_edge), 1.0f, 64.0f);
      for (float piece = 0; piece < pieces; ++piece) {
        const glm::vec2 at = here + (piece / pieces) * (next - here);
        places.push_back({tooth.to_end ? tooth.from + at.x * whole : tooth.to - at.x * whole, at.y});
      }
    }
    if (!tooth.to_end) std::reverse(places.begin(), places.end());
    for (const glm::vec2& place : places) {
      const float length = place.x, out = place.y;
      const bool notch = out == 0;
      if (notch && (length <= tooth.first || length >= tooth.last)) continue;
      glm::vec2 p = rail_.place(length);
      const float share = notch ? std::min(tooth.share, beyond(number)) : tooth.share;
      if (const float inwards = (1 - out) * share * deep(tooth, length); inwards > 0)
        p += inwards * rail_.inwards(length, 0.5f * longest_edge);
      cut.add(p, owner);
      if (out == 1) cut.margin.teeth.push_back(cut.margin.points.size() - 1);
    }
  }

  // The share of the tooth on the other side of a tooth's notch.
  float beyond(std::size_t number) const { return teeth_[teeth_[number].to_end ? number - 1 : number + 1].share; }

  const Margin& margin_;
  const Teeth& options_;
  Rail rail_;
  std::vector<float> widths_;
  std::vector<Stretch> stretches_;
  std::vector<Tooth> teeth_;
};

}  // namespace

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
    notes.push_back("Teeth that would have met were left out: " + std::to_string(out) + " of " +
                    std::to_string(cutter.number()) + ".");
  return std::move(cut.margin);
}

}  // namespace panicle::particles::leaf
