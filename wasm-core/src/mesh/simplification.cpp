#include "mesh/simplification.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace panicle {
namespace {

using glm::dvec3;

// Long edges go last where all is flat: so much of their length counts as error.
constexpr double of_length = 0.015;
// The cosine of the largest turn of a triangle's normal.
constexpr double max_turned = 0.15;

// A vertex with more triangles about it stays, and its neighbours' costs are not recomputed when another collapses into
// it: else a fan of thousands would cost the square of its size, over and over.
constexpr std::size_t max_about = 96;

// Sum of squared distances from planes, weighted by area: a quadratic form of a point (Garland & Heckbert 1997).
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, x = 0, y = 0, z = 0, one = 0, weight = 0;

  // Adds the plane n · p + d = 0, n of length 1, with the weight w.
  void add_plane(const dvec3& n, double d, double w) {
    xx += w * n.x * n.x;
    xy += w * n.x * n.y;
    xz += w * n.x * n.z;
    yy += w * n.y * n.y;
    yz += w * n.y * n.z;
    zz += w * n.z * n.z;
    x += w * n.x * d;
    y += w * n.y * d;
    z += w * n.z * d;
    one += w * d * d;
    weight += w;
  }
  // Adds another quadric: the error of the sum is the sum of errors.
  void add(const Quadric& q) {
    xx += q.xx;
    xy += q.xy;
    xz += q.xz;
    yy += q.yy;
    yz += q.yz;
    zz += q.zz;
    x += q.x;
    y += q.y;
    z += q.z;
    one += q.one;
    weight += q.weight;
  }
  // The sum of weighted squared distances of a point.
  double at(const dvec3& p) const {
    return p.x * (xx * p.x + 2 * (xy * p.y + xz * p.z + x)) + p.y * (yy * p.y + 2 * (yz * p.z + y)) +
           p.z * (zz * p.z + 2 * z) + one;
  }
};

// The first grid has so many cells along the longest edge of the patch's box; those of each further one are larger.
constexpr double finest_cells = 1024, cell_growth = 1.25;

// A patch after all vertices within a cell of a grid have become one.
struct Coarse {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::uint32_t counted = 0;
  std::vector<Collapse> made;
};

// Whether a triangle has two equal corners, and so no area.
bool is_flat(const std::array<std::uint32_t, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

// Makes the vertices that are in one cell of size `cell` the first of them, and drops triangles that are flat then.
void merge_cells(const Patch& patch, double cell, const glm::vec3& low, float error,
                 std::vector<std::uint32_t>& vertices, Coarse& coarse) {
  using Keyed = std::pair<std::array<std::int32_t, 3>, std::uint32_t>;
  // Sorts the vertices by cell, then by number: those of a cell become its first.
  std::vector<Keyed> keyed;
  keyed.reserve(vertices.size());
  for (const std::uint32_t v : vertices) {
    const glm::vec3 at = patch.positions[v] - low;
    keyed.push_back({{static_cast<std::int32_t>(at.x / cell), static_cast<std::int32_t>(at.y / cell),
                      static_cast<std::int32_t>(at.z / cell)},
                     v});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> to(patch.positions.size());
  std::iota(to.begin(), to.end(), 0u);
  const std::size_t first = coarse.made.size();
  vertices.clear();
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    const bool begins = i == 0 || keyed[i].first != keyed[i - 1].first;
    if (begins) {
      vertices.push_back(keyed[i].second);
    } else {
      to[keyed[i].second] = vertices.back();
      coarse.made.push_back({keyed[i].second, vertices.back(), error, 0});
    }
  }
  // Triangles that do not count come behind the others, in either list.
  std::size_t left = 0;
  std::uint32_t counted = 0;
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> triangle = coarse.triangles[t];
    for (std::uint32_t& corner : triangle) corner = to[corner];
    if (is_flat(triangle)) continue;
    counted += t < coarse.counted;
    coarse.triangles[left++] = triangle;
  }
  coarse.triangles.resize(left);
  coarse.counted = counted;
  for (std::size_t i = first; i < coarse.made.size(); ++i) coarse.made[i].triangles = counted;
}

// Merges vertices cell by cell, on grids of larger and larger cells until a cell is about as large as the patch: the
// way for patches with very many triangles. Fixed vertices stay.
std::vector<Collapse> merged_on_grids(const Patch& patch) {
  Coarse coarse{patch.triangles, patch.counted, {}};
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const glm::vec3& each : patch.positions) low = glm::min(low, each), high = glm::max(high, each);
  const glm::vec3 box = high - low;
  double cell = std::max({box.x, box.y, box.z}) / finest_cells;
  if (!(cell > 0)) return {};
  std::vector<std::uint32_t> vertices;  // that may go
  for (std::uint32_t v = 0; v < patch.positions.size(); ++v)
    if (patch.is_fixed[v] == 0) vertices.push_back(v);
  double error = 0;
  for (double cells = finest_cells; cells >= 1; cells /= cell_growth, cell *= cell_growth) {
    error += std::sqrt(3.0) * cell;  // the diagonal of a cell, after those of smaller ones
    merge_cells(patch, cell, low, static_cast<float>(error), vertices, coarse);
  }
  return std::move(coarse.made);
}

// Simplifier of a patch by edge collapses in the order of their quadric errors. A quadric is the sum of squared
// distances to the planes of triangles, as a quadratic form of the place (Garland and Heckbert 1997).
class Thinner {
 public:
  // Computes the quadrics of all vertices from their triangles.
  explicit Thinner(const Patch& patch) : patch_(patch), triangles_(patch.triangles), left_(patch.counted) {
    const std::size_t vertices = patch.positions.size();
    places_.reserve(vertices);
    for (const glm::vec3& each : patch.positions) places_.emplace_back(each.x, each.y, each.z);
    quadrics_.resize(vertices);
    about_.resize(vertices);
    stamps_.assign(vertices, 0);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto [a, b, c] = triangles_[t];
      for (const std::uint32_t v : {a, b, c}) about_[v].push_back(t);
      const dvec3 normal = glm::cross(places_[b] - places_[a], places_[c] - places_[a]);
      const double twice = glm::length(normal);
      if (!(twice > 0)) continue;
      const dvec3 unit = normal / twice;
      for (const std::uint32_t v : {a, b, c}) quadrics_[v].add_plane(unit, -glm::dot(unit, places_[a]), twice);
    }
  }

  // Collapses vertices until none can; returns the collapses with their errors, which do not decrease.
  std::vector<Collapse> run() {
    for (std::uint32_t v = 0; v < places_.size(); ++v) offer(v);
    float error = 0;
    while (!offers_.empty()) {
      const auto [cost, vertex, into, stamp] = offers_.top();
      offers_.pop();
      if (stamp != stamps_[vertex] || about_[vertex].empty()) continue;
      collapse(vertex, into);
      error = std::max(error, static_cast<float>(std::sqrt(cost)));
      made_.push_back({vertex, into, error, left_});
    }
    return std::move(made_);
  }
  std::uint64_t looks() const { return looks_; }

 private:
  using Offer = std::tuple<double, std::uint32_t, std::uint32_t, std::uint32_t>;

  // Whether a triangle has a vertex.
  bool has(std::uint32_t triangle, std::uint32_t vertex) const {
    const auto& corners = triangles_[triangle];
    return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
  }

  // The normal of a triangle when one of its vertices has moved.
  dvec3 normal_of(std::uint32_t triangle, std::uint32_t moved, const dvec3& to) const {
    std::array<dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = triangles_[triangle][i] == moved ? to : places_[triangles_[triangle][i]];
    return glm::cross(p[1] - p[0], p[2] - p[0]);
  }

  // Whether a collapse turns the normal of a triangle too far.
  bool turns_triangle(std::uint32_t vertex, std::uint32_t into) const {
    for (const std::uint32_t t : about_[vertex]) {
      if (has(t, into)) continue;
      const dvec3 before = normal_of(t, vertex, places_[vertex]), behind = normal_of(t, vertex, places_[into]);
      const double sizes = glm::length(before) * glm::length(behind);
      if (glm::length(before) > 0 && !(glm::dot(before, behind) > max_turned * sizes)) return true;
    }
    return false;
  }

  // Puts the cheapest collapse of a vertex into a neighbour into the queue, in place of the one before. Its cost is the
  // squared distance to the planes of both, by their quadrics, and a small share of the squared length.
  void offer(std::uint32_t vertex) {
    const std::uint32_t stamp = ++stamps_[vertex];
    if (patch_.is_fixed[vertex] != 0 || about_[vertex].size() > max_about) return;
    double least = -1;
    std::uint32_t best = 0;
    for (const std::uint32_t t : about_[vertex])
      for (const std::uint32_t into : triangles_[t]) {
        if (into == vertex) continue;
        ++looks_;
        Quadric both = quadrics_[vertex];
        both.add(quadrics_[into]);
        const dvec3 way = places_[into] - places_[vertex];
        const double cost = std::max(0.0, both.at(places_[into])) / std::max(both.weight, 1e-30) +
                            of_length * of_length * glm::dot(way, way);
        if (least >= 0 && (cost > least || (cost == least && into >= best))) continue;
        if (turns_triangle(vertex, into)) continue;
        least = cost;
        best = into;
      }
    if (least >= 0) offers_.push({least, vertex, best, stamp});
  }

  // Collapses a vertex into a neighbour: removes the triangles that both have, and recomputes the offers nearby.
  void collapse(std::uint32_t vertex, std::uint32_t into) {
    std::vector<std::uint32_t> near;
    for (const std::uint32_t t : about_[vertex]) {
      near.insert(near.end(), triangles_[t].begin(), triangles_[t].end());
      if (has(t, into)) {
        left_ -= t < patch_.counted;
        for (const std::uint32_t v : triangles_[t])
          if (v != vertex) std::erase(about_[v], t);
        continue;
      }
      std::replace(triangles_[t].begin(), triangles_[t].end(), vertex, into);
      about_[into].push_back(t);
    }
    about_[vertex].clear();
    quadrics_[into].add(quadrics_[vertex]);
    if (about_[into].size() <= max_about)
      for (const std::uint32_t t : about_[into]) near.insert(near.end(), triangles_[t].begin(), triangles_[t].end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::uint32_t v : near)
      if (v != vertex) offer(v);
  }

  const Patch& patch_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<dvec3> places_;
  std::vector<Quadric> quadrics_;
  std::vector<std::vector<std::uint32_t>> about_;  // by vertex, triangles
  std::vector<std::uint32_t> stamps_;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
  std::uint32_t left_;
  std::vector<Collapse> made_;
  std::uint64_t looks_ = 0;
};

}  // namespace

// Lists the collapses that simplify a patch, least error first. Patches with more than `most` triangles are merged on
// grids, which is coarser; `looks`, unless null, counts the work.
std::vector<Collapse> thinning_of(const Patch& patch, std::uint32_t most, std::uint64_t* looks) {
  if (patch.triangles.size() > most) return merged_on_grids(patch);
  Thinner thinner(patch);
  std::vector<Collapse> made = thinner.run();
  if (looks != nullptr) *looks += thinner.looks();
  return made;
}

}  // namespace panicle
