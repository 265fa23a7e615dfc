#include "mesh/triangulation.hpp"

#include <array>
#include <cmath>
#include <deque>
#include <utility>

namespace panicle {
namespace {

__extension__ typedef __int128 Wide;

constexpr std::int32_t none = -1;
// The corners of the triangle around everything: beyond the points' range.
constexpr std::int64_t beyond = std::int64_t{1} << 26;
constexpr std::size_t corners = 3;

struct Place {
  std::int64_t x = 0, y = 0;
};

struct Triangle {
  std::array<std::int32_t, 3> corner;  // counter-clockwise
  std::array<std::int32_t, 3> beside;  // the triangle across the edge opposite each corner
};

// Incremental constrained Delaunay triangulation of points on a lattice, in exact arithmetic: inserts the ring,
// enforces its edges, then inserts the points inside. Triangles are indices, −1 is none.
class Triangulation {
 public:
  // Begins with one triangle around all points. The first `ring` points are the polygon.
  Triangulation(std::span<const glm::vec2> points, std::size_t ring, std::uint64_t max_steps)
      : steps_left_(max_steps), ring_(static_cast<std::int32_t>(ring)) {
    const auto whole = [](float v) { return static_cast<std::int64_t>(std::floor(v * triangulation_lattice + 0.5f)); };
    places_.reserve(points.size() + corners);
    for (const glm::vec2& p : points) places_.push_back({whole(p.x), whole(p.y)});
    const auto first = static_cast<std::int32_t>(points.size());
    places_.insert(places_.end(), {{-beyond, -beyond}, {beyond, -beyond}, {0, beyond}});
    around_ = first;
    at_.assign(places_.size(), none);
    triangles_.reserve(2 * places_.size());
    triangles_.push_back({{first, first + 1, first + 2}, {none, none, none}});
    for (std::int32_t k = 0; k < 3; ++k) at_[static_cast<std::size_t>(first + k)] = 0;
  }

  // Inserts all points. Returns false if the ring crosses itself or the steps are used up.
  bool fill() {
    for (std::int32_t i = 0; i < ring_; ++i)
      if (!insert(i)) return false;
    for (std::int32_t i = 0; i < ring_; ++i)
      if (!enforce(i, (i + 1) % ring_)) return false;
    mark_outside();
    for (std::int32_t i = ring_; i < around_; ++i) insert(i);
    return steps_left_ > 0;
  }

  // The corners of all triangles inside the polygon.
  std::vector<std::uint32_t> inside() const {
    std::vector<std::uint32_t> indices;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (!outside_[t])
        for (const std::int32_t corner : triangles_[t].corner) indices.push_back(static_cast<std::uint32_t>(corner));
    return indices;
  }

 private:
  // Counts a step. Returns false if none are left.
  bool step() {
    if (steps_left_ > 0) --steps_left_;
    return steps_left_ > 0;
  }
  // The number of the corner after corner k, and of the one before, 0 … 2.
  static std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }
  // The corner before corner k of a triangle.
  static std::size_t before(std::size_t k) { return k == 0 ? 2 : k - 1; }
  Triangle& triangle(std::int32_t t) { return triangles_[static_cast<std::size_t>(t)]; }
  const Triangle& triangle(std::int32_t t) const { return triangles_[static_cast<std::size_t>(t)]; }
  const Place& place(std::int32_t i) const { return places_[static_cast<std::size_t>(i)]; }

  // The orientation of three points: above 0 if c lies to the left of a → b, 0 on the line.
  std::int64_t side(std::int32_t a, std::int32_t b, std::int32_t c) const {
    const Place &p = place(a), &q = place(b), &r = place(c);
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  // Whether d lies inside the circle through a, b and c, which are counter-clockwise: the sign of the in-circle
  // determinant.
  bool in_circle(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const {
    const Place& o = place(d);
    const auto row = [&](std::int32_t i) { return Place{place(i).x - o.x, place(i).y - o.y}; };
    const Place p = row(a), q = row(b), r = row(c);
    // In double precision where that is certain: each term is off by less than 2⁻⁵⁰ of its size.
    const auto px = static_cast<double>(p.x), py = static_cast<double>(p.y), qx = static_cast<double>(q.x),
               qy = static_cast<double>(q.y), rx = static_cast<double>(r.x), ry = static_cast<double>(r.y);
    const double pp = px * px + py * py, qq = qx * qx + qy * qy, rr = rx * rx + ry * ry;
    const double sum = pp * (qx * ry - qy * rx) + qq * (rx * py - ry * px) + rr * (px * qy - py * qx);
    const double size = pp * (std::fabs(qx * ry) + std::fabs(qy * rx)) +
                        qq * (std::fabs(rx * py) + std::fabs(ry * px)) + rr * (std::fabs(px * qy) + std::fabs(py * qx));
    if (std::fabs(sum) > size * 0x1p-48) return sum > 0;
    const auto square = [](const Place& v) { return Wide{v.x} * v.x + Wide{v.y} * v.y; };
    const auto cross = [](const Place& v, const Place& w) { return Wide{v.x} * w.y - Wide{v.y} * w.x; };
    return square(p) * cross(q, r) + square(q) * cross(r, p) + square(r) * cross(p, q) > 0;
  }

  // Whether a and b are neighbours in the polygon, once its edges are enforced.
  bool is_polygon_edge(std::int32_t a, std::int32_t b) const {
    if (!enforced_ || a >= ring_ || b >= ring_) return false;
    return (a + 1) % ring_ == b || (b + 1) % ring_ == a;
  }

  // Finds the triangle that contains a point: {triangle, corner opposite the edge that the point lies on, or none};
  // {triangle, −2} if the point is one of its corners. Walks there from the last triangle; if that goes in circles,
  // tests all.
  std::pair<std::int32_t, std::int32_t> locate(std::int32_t i) {
    const auto look = [&](std::int32_t t, std::int32_t& out, std::int32_t& on) {
      const Triangle& here = triangle(t);
      out = on = none;
      std::int32_t zeros = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t turn = side(here.corner[next(k)], here.corner[before(k)], i);
        if (turn < 0) {
          out = static_cast<std::int32_t>(k);
          return;
        }
        if (turn == 0) {
          on = static_cast<std::int32_t>(k);
          ++zeros;
        }
      }
      if (zeros == 2) on = -2;
    };
    std::int32_t t = last_, out = none, on = none;
    for (std::size_t k = 0; k < triangles_.size() && t != none && step(); ++k) {
      look(t, out, on);
      if (out == none) return {t, on};
      t = triangle(t).beside[static_cast<std::size_t>(out)];
    }
    for (t = 0; t < static_cast<std::int32_t>(triangles_.size()) && step(); ++t) {
      look(t, out, on);
      if (out == none) return {t, on};
    }
    return {none, none};
  }

  // Makes two triangles neighbours: `other` across edge `edge` of t, and t in the place of `instead_of` in `other`.
  void join(std::int32_t t, std::size_t edge, std::int32_t other, std::int32_t instead_of) {
    triangle(t).beside[edge] = other;
    if (other == none) return;
    for (std::int32_t& beside : triangle(other).beside)
      if (beside == instead_of) {
        beside = t;
        return;
      }
  }

  // Records a triangle at each of its corners.
  void note_corners(std::int32_t t) {
    for (const std::int32_t corner : triangle(t).corner) at_[static_cast<std::size_t>(corner)] = t;
  }

  // Appends a triangle; returns its index.
  std::int32_t add(const Triangle& triangle, bool outside) {
    triangles_.push_back(triangle);
    if (enforced_) outside_.push_back(outside);
    return static_cast<std::int32_t>(triangles_.size()) - 1;
  }

  // Inserts a point and restores the Delaunay property. Returns false for a point that is there already, is outside, or
  // lies on an edge of the polygon.
  bool insert(std::int32_t i) {
    const auto [t, on] = locate(i);
    if (t == none || on == -2) return false;
    last_ = t;
    if (enforced_ && outside_[static_cast<std::size_t>(t)]) return false;
    if (on >= 0) {
      const auto k = static_cast<std::size_t>(on);
      if (triangle(t).beside[k] == none || is_polygon_edge(triangle(t).corner[next(k)], triangle(t).corner[before(k)]))
        return false;
      split_edge(t, k, i);
    } else {
      split(t, i);
    }
    settle(i);
    return true;
  }

  // Splits a triangle into three.
  void split(std::int32_t t, std::int32_t i) {
    const Triangle old = triangle(t);
    const auto [a, b, c] = old.corner;
    const std::int32_t u = add({{b, c, i}, {}}, false), v = add({{c, a, i}, {}}, false);
    triangle(t) = {{a, b, i}, {u, v, none}};
    triangle(u).beside = {v, t, none};
    triangle(v).beside = {t, u, none};
    join(t, 2, old.beside[2], t);
    join(u, 2, old.beside[0], t);
    join(v, 2, old.beside[1], t);
    for (const std::int32_t each : {t, u, v}) {
      note_corners(each);
      open_.push_back(each);
    }
  }

  // Splits two triangles at an edge into four.
  void split_edge(std::int32_t t, std::size_t k, std::int32_t i) {
    const std::int32_t o = triangle(t).beside[k];
    const Triangle one = triangle(t), other = triangle(o);
    std::size_t m = 0;
    while (other.beside[m] != t) ++m;
    const std::int32_t a = one.corner[k], b = one.corner[next(k)], c = one.corner[before(k)], d = other.corner[m];
    const std::int32_t beside_ab = one.beside[before(k)], beside_ca = one.beside[next(k)];
    const std::int32_t beside_db = other.beside[next(m)], beside_cd = other.beside[before(m)];
    const std::int32_t u = add({{c, a, i}, {}}, false), v = add({{d, c, i}, {}}, false);
    triangle(t) = {{a, b, i}, {o, u, none}};
    triangle(o) = {{b, d, i}, {v, t, none}};
    triangle(u).beside = {t, v, none};
    triangle(v).beside = {u, o, none};
    join(t, 2, beside_ab, t);
    join(u, 2, beside_ca, t);
    join(o, 2, beside_db, o);
    join(v, 2, beside_cd, o);
    for (const std::int32_t each : {t, o, u, v}) {
      note_corners(each);
      open_.push_back(each);
    }
  }

  // Flips the edges around a new point until they are Delaunay; for each open triangle, tests the edge opposite the
  // point.
  void settle(std::int32_t i) {
    while (!open_.empty()) {
      if (!step()) return open_.clear();
      const std::int32_t t = open_.back();
      open_.pop_back();
      std::size_t k = 0;
      while (k < 3 && triangle(t).corner[k] != i) ++k;
      if (k == 3) continue;
      const std::int32_t o = triangle(t).beside[k];
      if (o == none || is_polygon_edge(triangle(t).corner[next(k)], triangle(t).corner[before(k)])) continue;
      const Triangle& other = triangle(o);
      std::size_t m = 0;
      while (other.beside[m] != t) ++m;
      const auto& [a, b, c] = triangle(t).corner;
      if (!in_circle(a, b, c, other.corner[m])) continue;
      flip(t, k);
      open_.push_back(t);
      open_.push_back(o);
    }
  }

  // Flips the edge of a triangle opposite corner k: replaces it by the other diagonal of the two triangles.
  void flip(std::int32_t t, std::size_t k) {
    const std::int32_t o = triangle(t).beside[k];
    const Triangle one = triangle(t), other = triangle(o);
    std::size_t m = 0;
    while (other.beside[m] != t) ++m;
    const std::int32_t a = one.corner[k], b = one.corner[next(k)], c = one.corner[before(k)], d = other.corner[m];
    const std::int32_t beside_ca = one.beside[next(k)], beside_db = other.beside[next(m)];
    const std::int32_t beside_ab = one.beside[before(k)], beside_cd = other.beside[before(m)];
    triangle(t) = {{a, b, d}, {none, o, none}};
    triangle(o) = {{a, d, c}, {none, none, t}};
    join(t, 0, beside_db, o);
    join(t, 2, beside_ab, t);
    join(o, 0, beside_cd, o);
    join(o, 1, beside_ca, t);
    note_corners(t);
    note_corners(o);
  }

  // The triangle to the left of the edge a → b and the corner opposite; none where there is no such edge.
  std::pair<std::int32_t, std::size_t> edge(std::int32_t a, std::int32_t b) const {
    const std::int32_t first = at_[static_cast<std::size_t>(a)];
    for (std::int32_t t = first; t != none;) {
      std::size_t k = 0;
      while (triangle(t).corner[k] != a) ++k;
      if (triangle(t).corner[next(k)] == b) return {t, before(k)};
      t = triangle(t).beside[next(k)];  // the one across the edge a – before: counter-clockwise about a
      if (t == first) break;
    }
    return {none, 0};
  }

  // Makes a → b an edge, by flips of the edges that cross it. Returns false if a point lies on the way.
  bool enforce(std::int32_t a, std::int32_t b) {
    if (edge(a, b).first != none) return true;
    std::deque<std::pair<std::int32_t, std::int32_t>> crossed;
    // The triangle at a that the way to b leaves by the edge opposite a.
    const std::int32_t first = at_[static_cast<std::size_t>(a)];
    std::int32_t t = first;
    std::size_t k = 0;
    for (bool found = false; !found;) {
      k = 0;
      while (triangle(t).corner[k] != a) ++k;
      const std::int32_t right = triangle(t).corner[next(k)], left = triangle(t).corner[before(k)];
      if (side(a, b, right) == 0 && side(a, right, left) > 0 && is_ahead(a, b, right))
        return false;  // a corner on the way
      found = side(a, b, right) < 0 && side(a, b, left) > 0;
      if (found) break;
      t = triangle(t).beside[next(k)];
      if (t == first || t == none) return false;
    }
    for (;;) {
      const std::int32_t right = triangle(t).corner[next(k)], left = triangle(t).corner[before(k)];
      crossed.push_back({right, left});
      const std::int32_t o = triangle(t).beside[k];
      if (o == none) return false;
      std::size_t m = 0;
      while (triangle(o).beside[m] != t) ++m;
      const std::int32_t apex = triangle(o).corner[m];
      if (apex == b) break;
      const std::int64_t turn = side(a, b, apex);
      if (turn == 0) return false;
      t = o;
      // Continues by the edge whose ends lie on both sides.
      const std::int32_t stays = turn > 0 ? left : right;
      k = 0;
      while (triangle(t).corner[k] != stays) ++k;
    }
    // Quadrilaterals that are not convex wait until others are flipped.
    for (std::size_t turns = 0, most = 64 + 16 * crossed.size() * crossed.size(); !crossed.empty(); ++turns) {
      if (turns > most || !step()) return false;
      const auto [right, left] = crossed.front();
      crossed.pop_front();
      const auto [u, j] = edge(right, left);
      if (u == none) return false;
      const std::int32_t o = triangle(u).beside[j];
      std::size_t m = 0;
      while (triangle(o).beside[m] != u) ++m;
      const std::int32_t p = triangle(u).corner[j], q = triangle(o).corner[m];
      if (!(side(p, q, right) < 0 && side(p, q, left) > 0) && !(side(p, q, right) > 0 && side(p, q, left) < 0)) {
        crossed.push_back({right, left});
        continue;
      }
      flip(u, j);
      const std::int64_t from_p = side(a, b, p), from_q = side(a, b, q);
      const bool ends = p == a || p == b || q == a || q == b;
      if (!ends && ((from_p < 0 && from_q > 0) || (from_p > 0 && from_q < 0))) {
        if (from_p < 0)
          crossed.push_back({p, q});
        else
          crossed.push_back({q, p});
      }
    }
    return edge(a, b).first != none;
  }

  // Whether c lies in the direction of b, seen from a.
  bool is_ahead(std::int32_t a, std::int32_t b, std::int32_t c) const {
    const Place &p = place(a), &q = place(b), &r = place(c);
    return (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y) > 0;
  }

  // Marks the triangles outside the polygon: from the outermost triangles to the polygon's edges.
  void mark_outside() {
    enforced_ = true;
    outside_.assign(triangles_.size(), 0);
    std::vector<std::int32_t> open;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const std::int32_t corner : triangles_[t].corner)
        if (corner >= around_ && !outside_[t]) {
          outside_[t] = 1;
          open.push_back(static_cast<std::int32_t>(t));
        }
    while (!open.empty()) {
      const Triangle here = triangle(open.back());
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t o = here.beside[k];
        if (o == none || outside_[static_cast<std::size_t>(o)]) continue;
        if (is_polygon_edge(here.corner[next(k)], here.corner[before(k)])) continue;
        outside_[static_cast<std::size_t>(o)] = 1;
        open.push_back(o);
      }
    }
  }

  std::uint64_t steps_left_;
  std::int32_t ring_, around_ = 0;
  bool enforced_ = false;
  std::int32_t last_ = 0;
  std::vector<Place> places_;
  std::vector<Triangle> triangles_;
  std::vector<std::int32_t> at_;  // of each place: a triangle that it is a corner of
  std::vector<std::uint8_t> outside_;
  std::vector<std::int32_t> open_;
};

}  // namespace

// Triangulates a polygon, the first `ring` points, with the points inside it. Empty if it crosses itself or takes too
// many steps.
std::vector<std::uint32_t> triangulate(std::span<const glm::vec2> points, std::size_t ring, std::uint64_t max_steps) {
  if (ring < 3 || ring > points.size()) return {};
  Triangulation triangulation(points, ring, max_steps);
  return triangulation.fill() ? triangulation.inside() : std::vector<std::uint32_t>{};
}

}  // namespace panicle
