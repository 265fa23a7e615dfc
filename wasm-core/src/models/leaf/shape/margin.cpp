#include "models/leaf/shape/margin.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "models/leaf/messages.generated.hpp"

namespace panicle::particles::leaf {
namespace {

constexpr std::size_t fewest_points = 3, max_points = 400;
constexpr float farthest = 4;        // leaf lengths from where the petiole joins
constexpr double least_area = 1e-3;  // square leaf lengths
constexpr float piece = 0.015f;      // length of the spline's pieces, about
constexpr float fewest_pieces = 2, max_pieces = 32;
constexpr float lattice = 1048576;      // 2²⁰
constexpr float flattest_tooth = 0.7f;  // cosine of the least turn of the margin at a tooth's tip

// Rounds a coordinate to the lattice, on which tests for crossings are exact.
float snapped(float v) { return std::floor(v * lattice + 0.5f) / lattice; }

// The signed area of a polygon, by the shoelace formula; positive if it runs counter-clockwise.
double area_of(std::span<const glm::vec2> points) {
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 a(points[i]), b(points[(i + 1) % points.size()]);
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

// The orientation of three lattice points: twice the signed area of their triangle, exactly; positive for a turn to the
// left.
std::int64_t orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const auto whole = [](float v) { return static_cast<std::int64_t>(v * lattice); };
  return (whole(b.x) - whole(a.x)) * (whole(c.y) - whole(a.y)) - (whole(b.y) - whole(a.y)) * (whole(c.x) - whole(a.x));
}

// Whether the range between a and b and that between c and d do not overlap.
bool ranges_apart(float a, float b, float c, float d) {
  return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

// Whether the segments ab and cd cross or touch.
bool segments_meet(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec2& d) {
  if (ranges_apart(a.x, b.x, c.x, d.x) || ranges_apart(a.y, b.y, c.y, d.y)) return false;
  const std::int64_t c_side = orientation(a, b, c), d_side = orientation(a, b, d), a_side = orientation(c, d, a),
                     b_side = orientation(c, d, b);
  return !((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0) || (a_side > 0 && b_side > 0) ||
           (a_side < 0 && b_side < 0));
}

// The Bézier handle of a centripetal Catmull-Rom spline at the point `at` on the way to `to`, where it comes from
// `before`.
glm::vec2 handle(const glm::vec2& before, const glm::vec2& at, const glm::vec2& to) {
  const float back = std::sqrt(glm::distance(at, before)), on = std::sqrt(glm::distance(to, at));
  if (back == 0 || on == 0) return at + (to - at) / 3.0f;
  return (back * back * to - on * on * before + (2 * back * back + 3 * back * on + on * on) * at) /
         (3 * back * (back + on));
}

// Whether the outline has a corner at such a point.
bool sharp(PointKind kind) { return kind == PointKind::corner || kind == PointKind::pointed_tip; }

// A cubic Bézier curve from one control point to the next; `first` and `second` are its handles.
struct Span {
  glm::vec2 from, first, second, to;

  // The point at t, 0 … 1, of the Bézier curve.
  glm::vec2 at(float t) const {
    const float s = 1 - t;
    return s * s * s * from + 3 * s * s * t * first + 3 * s * t * t * second + t * t * t * to;
  }
};

// Makes the cubic from control point `i` to the next one of the closed outline, by the neighbours of both.
Span span_after(std::span<const ControlPoint> points, std::size_t i) {
  const std::size_t count = points.size();
  const ControlPoint &b = points[i], &c = points[(i + 1) % count];
  const glm::vec2 before = points[(i + count - 1) % count].place, after = points[(i + 2) % count].place;
  Span span{b.place, b.place, c.place, c.place};
  if (!sharp(b.kind)) span.first = handle(before, b.place, c.place);
  if (!sharp(c.kind)) span.second = handle(after, c.place, b.place);
  // At a sharp point: halfway to the other end's control.
  if (sharp(b.kind)) span.first = sharp(c.kind) ? b.place + (c.place - b.place) / 3.0f : 0.5f * (b.place + span.second);
  if (sharp(c.kind)) span.second = sharp(b.kind) ? c.place + (b.place - c.place) / 3.0f : 0.5f * (c.place + span.first);
  return span;
}

// Calls `visit` with each pair of edges of a closed polygon that cross or touch, until it returns true. Edges are
// sorted into rows, and compared with the earlier ones of their rows.
template <class See>
void each_crossing(std::span<const glm::vec2> points, const See& visit) {
  const std::size_t count = points.size();
  float low = points[0].y, high = low;
  for (const glm::vec2& p : points) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const float rows = static_cast<float>(count);
  const auto row_of = [&](float y) {
    return static_cast<std::size_t>(std::clamp(rows * (y - low) / std::max(high - low, 1e-9f), 0.0f, rows - 1));
  };
  std::vector<std::vector<std::size_t>> edges(count);
  const auto end = [&](std::size_t i) { return points[(i + 1) % count]; };
  const auto met = [&](std::size_t k, std::size_t i) {
    const bool after = (k + 1) % count == i, before = (i + 1) % count == k;
    if (!after && !before) return segments_meet(points[k], end(k), points[i], end(i));
    // Neighbours share a corner; they must not overlap.
    const std::size_t first = after ? k : i;
    const glm::vec2 a = points[first], b = end(first), c = points[(first + 2) % count];
    return orientation(a, b, c) == 0 && glm::dot(b - a, c - b) < 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = row_of(std::min(points[i].y, end(i).y)), to = row_of(std::max(points[i].y, end(i).y));
    for (std::size_t row = from; row <= to; ++row) {
      for (const std::size_t k : edges[row])
        if (met(k, i) && visit(EdgePair{k, i})) return;
      edges[row].push_back(i);
    }
  }
}

// Lists the lobe tips, and finds the leaf's own tip: the highest of them, or the highest point where there is none.
void find_tips(std::span<const ControlPoint> points, Margin& margin) {
  std::size_t tip = 0;
  const auto higher = [&](std::size_t i) {
    if (tip_kind(points[i].kind) != tip_kind(points[tip].kind)) return tip_kind(points[i].kind);
    return points[i].place.y > points[tip].place.y;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (higher(i)) tip = i;
    if (tip_kind(points[i].kind)) margin.tips.push_back(margin.controls[i]);
  }
  margin.tip = margin.controls[tip];
}

// Finds the corners that stand out sharply, except the base.
void find_teeth(std::span<const ControlPoint> points, Margin& margin) {
  const std::size_t count = margin.points.size();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::size_t at = margin.controls[i];
    const glm::vec2 before = margin.points[at] - margin.points[(at + count - 1) % count],
                    after = margin.points[(at + 1) % count] - margin.points[at];
    const bool out = before.x * after.y - before.y * after.x > 0;
    if (points[i].kind == PointKind::corner && at != margin.tip && out &&
        glm::dot(before, after) < flattest_tooth * glm::length(before) * glm::length(after))
      margin.teeth.push_back(at);
  }
}

}  // namespace

// The outline where none is given: an ovate leaf with a pointed tip.
std::vector<ControlPoint> default_outline() {
  constexpr glm::vec2 half[] = {{0.16f, 0.05f}, {0.28f, 0.22f}, {0.3f, 0.4f}, {0.24f, 0.62f}, {0.12f, 0.84f}};
  std::vector<ControlPoint> points{{{0, 0}, PointKind::corner}};
  for (const glm::vec2& p : half) points.push_back({p, PointKind::smooth});
  points.push_back({{0, 1}, PointKind::pointed_tip});
  for (std::size_t i = std::size(half); i-- > 0;) points.push_back({{-half[i].x, half[i].y}, PointKind::smooth});
  return points;
}

// Reads an outline from rows of x, y and kind, and makes it counter-clockwise. Unknown kinds become smooth, with a
// note; fails for points too far away and outlines without area.
Result<std::vector<ControlPoint>> read_outline(std::span<const float> rows, std::vector<std::string>& notes) {
  if (rows.empty()) return default_outline();
  if (rows.size() % 3 != 0) return bad_input(message(messages::leaf::outline_not_rows));
  const std::size_t count = rows.size() / 3;
  if (count < fewest_points || count > max_points)
    return bad_input(message(messages::leaf::outline_point_count, count));
  std::vector<ControlPoint> points;
  bool odd = false;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 place(rows[3 * i], rows[3 * i + 1]);
    if (!(std::fabs(place.x) <= farthest && std::fabs(place.y) <= farthest))
      return bad_input(message(messages::leaf::outline_point_too_far, i + 1));
    const float kind = rows[3 * i + 2];
    const bool known = kind == 0 || kind == 1 || kind == 2 || kind == 3;
    odd = odd || !known;
    points.push_back({place, known ? static_cast<PointKind>(kind) : PointKind::smooth});
  }
  if (odd) notes.push_back(message(messages::leaf::outline_kinds_unknown));
  std::vector<glm::vec2> places;
  for (const ControlPoint& point : points) places.push_back(point.place);
  const double area = area_of(places);
  if (!(std::fabs(area) >= least_area)) return bad_input(message(messages::leaf::outline_without_area));
  if (area < 0) std::reverse(points.begin() + 1, points.end());
  return points;
}

// All pairs of edges of a closed polygon that cross or touch.
std::vector<EdgePair> crossings(std::span<const glm::vec2> points) {
  std::vector<EdgePair> all;
  each_crossing(points, [&](const EdgePair& pair) {
    all.push_back(pair);
    return false;
  });
  return all;
}

// The first such pair; an EdgePair of equal edges if there is none.
EdgePair crossing(std::span<const glm::vec2> points) {
  EdgePair first;
  each_crossing(points, [&](const EdgePair& pair) {
    first = pair;
    return true;
  });
  return first;
}

// Samples the closed outline as a polygon, and finds its tips and teeth. Fails if it has no area or crosses itself.
Result<Margin> spline(std::span<const ControlPoint> points) {
  const std::size_t count = points.size();
  Margin margin;
  std::vector<std::size_t> control_of;  // of each place: the control point before it
  for (std::size_t i = 0; i < count; ++i) {
    const ControlPoint &b = points[i], &c = points[(i + 1) % count];
    const Span span = span_after(points, i);
    const float pieces = std::clamp(std::ceil(glm::distance(b.place, c.place) / piece), fewest_pieces, max_pieces);
    margin.controls.push_back(margin.points.size());
    for (float k = 0; k < pieces; ++k) {
      const glm::vec2 p = span.at(k / pieces), place(snapped(p.x), snapped(p.y));
      if (!margin.points.empty() && margin.points.back() == place) continue;
      margin.points.push_back(place);
      control_of.push_back(i);
    }
  }
  while (margin.points.size() > 1 && margin.points.back() == margin.points.front()) margin.points.pop_back();
  for (std::size_t& at : margin.controls) at = std::min(at, margin.points.size() - 1);
  if (margin.points.size() < fewest_points) return bad_input(message(messages::leaf::outline_without_area));
  if (const EdgePair cross = crossing(margin.points); cross.first != cross.second)
    return bad_input(
        message(messages::leaf::outline_crosses_itself, control_of[cross.first] + 1, control_of[cross.second] + 1));
  find_tips(points, margin);
  find_teeth(points, margin);
  return margin;
}

}  // namespace panicle::particles::leaf
