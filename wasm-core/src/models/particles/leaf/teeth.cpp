#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "models/particles/leaf/margin.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr float lattice = 1048576;
// At a tip teeth are no deeper than this share of their distance from it along the margin.
constexpr float slope_at_tips = 0.25f;
constexpr float longest_edge = 0.015f;  // leaf lengths
constexpr int attempts = 4;

// Places on a tooth: along it towards the tip, and how far out, both 0 … 1. It begins at 0, 0; the next one's is its
// end.
using Profile = std::span<const glm::vec2>;

Profile profile_of(ToothShape shape) {
  static constexpr glm::vec2 dentate[] = {{0, 0}, {0.22f, 0.4f}, {0.5f, 1}, {0.78f, 0.4f}};
  static constexpr glm::vec2 serrate[] = {{0, 0}, {0.25f, 0.42f}, {0.55f, 0.78f}, {0.86f, 1}, {0.93f, 0.4f}};
  static constexpr glm::vec2 crenate[] = {{0, 0},    {0.06f, 0.42f}, {0.18f, 0.74f}, {0.33f, 0.93f},
                                          {0.5f, 1}, {0.67f, 0.93f}, {0.82f, 0.74f}, {0.94f, 0.42f}};
  static constexpr glm::vec2 twice[] = {{0, 0},         {0.2f, 0.34f}, {0.36f, 0.52f}, {0.41f, 0.3f},
                                        {0.62f, 0.66f}, {0.88f, 1},    {0.95f, 0.45f}};
  if (shape == ToothShape::dentate) return dentate;
  if (shape == ToothShape::serrate) return serrate;
  return shape == ToothShape::crenate ? Profile(crenate) : Profile(twice);
}

// A closed polygon by the length along it.
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
  // Into the blade, unit; across what is near, so that it does not jump at the polygon's corners.
  glm::vec2 inwards(float length, float reach) const {
    const glm::vec2 way = place(std::min(length + reach, lengths_.back())) - place(std::max(length - reach, 0.0f));
    const float size = glm::length(way);
    return size > 0 ? glm::vec2(-way.y, way.x) / size : glm::vec2(0);
  }

 private:
  std::span<const glm::vec2> points_;
  std::vector<float> lengths_;
};

// Between two corners of the margin that teeth leave alone; its teeth lean towards its end, or towards its beginning.
struct Stretch {
  std::size_t first, last;  // points; last may be their number, which is the base again
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
      // Of lobes that are wider than their sinus is deep, the place midway is as good.
    }
    all.push_back({tips[k], sinus, false});
    from = sinus;
  }
  return all;
}

struct Cutter {
  const Rail& rail;
  const Teeth& teeth;
  float depth;  // over width
  float side;   // length of a side of the margin
  Margin& cut;

  void lay(float length, float inwards) const {
    glm::vec2 p = rail.place(length);
    if (inwards > 0) p += inwards * rail.inwards(length, 0.5f * longest_edge);
    cut.points.push_back({std::floor(p.x * lattice + 0.5f) / lattice, std::floor(p.y * lattice + 0.5f) / lattice});
  }

  void stretch(float from, float to, bool to_end) const {
    const float length = to - from;
    const float count = std::floor(static_cast<float>(teeth.count) * length / side + 0.5f);
    if (!(count >= 1)) return;
    const float width = length / count;
    const Profile profile = profile_of(teeth.shape);
    const auto lay_at = [&](float along, float out) {  // counted from the end that teeth lean away from
      if (out == 1) cut.teeth.push_back(cut.points.size());
      const float near_end = std::min(along, length - along);
      const float deep = std::min(depth * width, slope_at_tips * near_end);
      lay(to_end ? from + along : to - along, (1 - out) * deep);
    };
    std::vector<glm::vec2> places;
    for (float k = 0; k < count; ++k)
      for (std::size_t i = 0; i < profile.size(); ++i) {
        const glm::vec2 here = profile[i], next = i + 1 < profile.size() ? profile[i + 1] : glm::vec2(1, 0);
        const float pieces = std::clamp(std::ceil(width * (next.x - here.x) / longest_edge), 1.0f, 64.0f);
        for (float piece = 0; piece < pieces; ++piece) {
          const glm::vec2 at = here + (piece / pieces) * (next - here);
          places.push_back({(k + at.x) * width, at.y});
        }
      }
    if (to_end)
      for (std::size_t i = 1; i < places.size(); ++i) lay_at(places[i].x, places[i].y);
    else
      for (std::size_t i = places.size(); i-- > 1;) lay_at(places[i].x, places[i].y);
  }
};

}  // namespace

Margin toothed(const Margin& margin, const Teeth& teeth, std::vector<std::string>& notes) {
  if (teeth.count == 0) return margin;
  const Rail rail(margin.points);
  const std::vector<Stretch> stretches = stretches_of(margin);
  const std::size_t count = margin.points.size();
  float depth = teeth.depth;
  for (int attempt = 0; attempt < attempts; ++attempt, depth *= 0.5f) {
    Margin cut;
    for (const Stretch& one : stretches) {
      const float from = rail.at(one.first), to = rail.at(one.last);
      const bool tip = std::find(margin.tips.begin(), margin.tips.end(), one.first) != margin.tips.end();
      if (tip) cut.tips.push_back(cut.points.size());
      if (one.first == margin.tip) cut.tip = cut.points.size();
      cut.points.push_back(margin.points[one.first]);
      const std::size_t before = cut.points.size();
      Cutter{rail, teeth, depth, 0.5f * rail.length(), cut}.stretch(from, to, one.to_end);
      if (cut.points.size() == before)  // too short for a tooth: as it was
        for (std::size_t i = one.first + 1; i < std::min(one.last, count); ++i) cut.points.push_back(margin.points[i]);
    }
    bool twice = false;
    for (std::size_t i = 0; i < cut.points.size(); ++i)
      twice = twice || cut.points[i] == cut.points[(i + 1) % cut.points.size()];
    const EdgePair cross = twice ? EdgePair{0, 1} : crossing(cut.points);
    if (cross.first != cross.second) continue;
    if (attempt > 0) notes.push_back("Teeth would have met: they are cut less deep.");
    return cut;
  }
  notes.push_back("Teeth would have met: the margin was left without.");
  return margin;
}

}  // namespace panicle::particles::leaf
