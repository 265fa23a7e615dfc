#include "stems/collar.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

// In radii of the branch: the length of the fillet around it, and the additional length on the upper side, where the
// angle to the parent is acute.
constexpr float fillet = 0.9f, crotch = 0.6f;
// The fillet's greatest length in radii of the parent, and how far its edge lies within the parent's surface.
constexpr float fillet_limit = 0.5f, sunk = 0.045f;
// Normals turn from the parent's to the branch's within this distance from the parent, in lengths of the fillet.
constexpr float normal_reach = 0.45f;
// The height of the branch bark ridge on the upper side, in radii of the branch.
constexpr float ridge_height = 0.1f;
// How far along its axis, in its radii, a parent's surface counts.
constexpr float parent_reach = 3;

// A place on one side of a tube: between the rings `ring` and the next one.
struct SidePlace {
  std::size_t ring = 0;
  float share = 0;
  glm::vec3 point{0};
};

// One side of a tube as a line from ring to ring.
class SideLine {
 public:
  SideLine(std::span<const Ring> rings, float degrees) : rings_(rings), angle_(sincos_degrees(degrees)) {}

  glm::vec3 at(std::size_t ring) const {
    return rings_[ring].centre + rings_[ring].right * angle_.cosine + rings_[ring].forward * angle_.sine;
  }
  // The unit vector from the branch's axis to this side, at a ring.
  glm::vec3 outward(std::size_t ring) const { return glm::normalize(at(ring) - rings_[ring].centre); }

  // Finds where the line leaves the parent for the last time; false if it ends within it.
  bool leave(const ParentSurface& parent, SidePlace& place) const {
    std::size_t inside = 0;
    float depth = 0;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const float distance = parent.from(at(i)).value;
      if (i == 0 || distance <= 0) {
        inside = i;
        depth = std::min(distance, 0.0f);
      } else if (distance > parent.radius()) {
        break;
      }
    }
    if (inside + 1 >= rings_.size()) return false;
    // Two steps of regula falsi from ring to ring.
    const glm::vec3 from = at(inside), way = at(inside + 1) - from;
    float low = 0, high = 1, low_value = depth, high_value = parent.from(from + way).value;
    for (int step = 0; step < 3 && low_value < 0 && high_value > 0; ++step) {
      const float share = low + (high - low) * low_value / (low_value - high_value);
      const float value = parent.from(from + way * share).value;
      (value < 0 ? low : high) = share;
      (value < 0 ? low_value : high_value) = value;
    }
    const float share = low_value < 0 ? low + (high - low) * low_value / (low_value - high_value) : 0;
    place = {inside, share, from + way * share};
    return true;
  }

  // Moves a place on along the line; false if the line ends before.
  bool advance(SidePlace& place, float distance) const {
    glm::vec3 from = place.point;
    for (std::size_t i = place.ring; i + 1 < rings_.size(); ++i) {
      const glm::vec3 to = at(i + 1);
      const float length = glm::distance(from, to);
      if (length >= distance && length > 0) {
        place.ring = i;
        place.point = from + (to - from) * (distance / length);
        return true;
      }
      distance -= length;
      from = to;
    }
    return false;
  }

 private:
  std::span<const Ring> rings_;
  SinCos angle_;
};

// The parabola of one side: from the parent's surface by the corner to the branch.
struct Fillet {
  glm::vec3 start{0}, corner{0}, end{0};
  glm::vec3 away{0};  // from the parent's axis, at the start
  float length = 0;   // from the corner to either end
  float ridge = 0;    // height of the bark ridge

  glm::vec3 at(float t) const {
    const float u = 1 - t;
    return start * (u * u) + corner * (2 * u * t) + end * (t * t) + away * (ridge * hill(2.5f * (t - 0.4f)));
  }
};

}  // namespace

// Collects the pieces of the parent's axis on both sides of the fork, nearest first.
ParentSurface::ParentSurface(const StemAxes& axes, std::uint32_t fork) {
  radius_ = axes.nodes[fork].radius;
  direction_ = axes.nodes[fork].tangent;
  // Axes are in the order of their nodes.
  const auto axis =
      std::prev(std::upper_bound(axes.axes.begin(), axes.axes.end(), fork,
                                 [](std::uint32_t node, const StemAxis& each) { return node < each.first; }));
  const auto add = [&](std::uint32_t node) {
    const Node &a = axes.nodes[node - 1], &b = axes.nodes[node];
    const glm::vec3 along = b.position - a.position;
    pieces_[count_++] = {a.position, along, 1 / glm::dot(along, along), a.radius, b.radius - a.radius};
  };
  const float reach = parent_reach * radius_;
  float covered = 0;
  for (std::uint32_t i = fork + 1; i < axis->first + axis->count && count_ < most_pieces / 2 && covered < reach; ++i) {
    add(i);
    covered += axes.nodes[i].length;
  }
  covered = 0;
  for (std::uint32_t i = fork; i > axis->first && count_ < most_pieces && covered < reach; --i) {
    add(i);
    covered += axes.nodes[i].length;
  }
}

ParentSurface::Distance ParentSurface::from(const glm::vec3& point) const {
  Distance nearest{1e30f, {0, 1, 0}};
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Piece& piece = pieces_[i];
    const glm::vec3 offset = point - piece.start;
    const float share = std::clamp(glm::dot(offset, piece.along) * piece.per_square, 0.0f, 1.0f);
    const glm::vec3 off = offset - piece.along * share;
    const float length = glm::length(off);
    const float distance = length - (piece.radius + piece.gain * share);
    if (distance < nearest.value) nearest = {distance, length > 0 ? off / length : nearest.away};
  }
  return nearest;
}

void add_collar(Tube& tube, const ParentSurface& parent, std::uint32_t parent_segment, std::uint32_t sides,
                std::uint32_t rows, std::size_t body) {
  const std::span<const Ring> rings(tube.rings.data(), body);
  const glm::vec3 upward = parent.direction();
  std::vector<Fillet> fillets(sides);
  std::size_t joined = 0;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const SideLine line(rings, 360 * static_cast<float>(k) / static_cast<float>(sides));
    SidePlace place;
    if (!line.leave(parent, place)) return;
    Fillet& made = fillets[k];
    made.corner = place.point;
    const glm::vec3 outward = line.outward(place.ring);
    const float radius = rings[place.ring].radius, upper = std::max(0.0f, glm::dot(outward, upward));
    const float length = std::min(radius * (fillet + crotch * upper), fillet_limit * parent.radius());
    if (!line.advance(place, length)) return;
    made.end = place.point;
    joined = std::max(joined, place.ring + 1);
    made.length = length;
    // From the corner along the parent's surface, away from the branch, and back to the surface.
    glm::vec3 away = parent.from(made.corner).away;
    const glm::vec3 along = outward - away * glm::dot(outward, away);
    const float steep = glm::length(along);
    const glm::vec3 edge_guess = made.corner + (steep > 1e-3f ? along * (length / steep) : glm::vec3(0));
    const ParentSurface::Distance edge = parent.from(edge_guess);
    made.away = edge.away;
    made.start = edge_guess - edge.away * (edge.value + sunk * parent.radius());
    made.ridge = ridge_height * radius * smooth(std::clamp(2 * upper - 1, 0.0f, 1.0f));
  }
  if (joined + 1 >= body) return;

  const Ring& after = tube.rings[joined];
  const float per_side = after.turns / static_cast<float>(sides);
  Collar& collar = tube.collar;
  collar.rows = rows;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const float t = static_cast<float>(row) / static_cast<float>(rows - 1);
    for (std::uint32_t k = 0; k <= sides; ++k) {
      const Fillet &made = fillets[k % sides], &next = fillets[(k + 1) % sides],
                   &last = fillets[(k + sides - 1) % sides];
      const glm::vec3 point = made.at(t);
      glm::vec3 normal = made.away;
      if (row > 0) {
        const glm::vec3 along = made.at(std::min(t + 0.1f, 1.0f)) - made.at(t - 0.1f);
        const glm::vec3 across = glm::cross(next.at(t) - last.at(t), along);
        const float size = glm::length(across);
        if (size > 0) normal = across / size;
        const ParentSurface::Distance off = parent.from(point);
        const float near = 1 - std::clamp(off.value / (normal_reach * made.length), 0.0f, 1.0f);
        normal = glm::normalize(normal + (off.away - normal) * smooth(near));
      }
      const glm::vec3 rim = SideLine(rings, 360 * static_cast<float>(k % sides) / static_cast<float>(sides)).at(joined);
      const float before = glm::distance(made.end, rim) +
                           (1 - t) * (glm::distance(made.start, made.corner) + glm::distance(made.corner, made.end));
      collar.positions.push_back(point);
      collar.normals.push_back(normal);
      collar.uvs.push_back({per_side * static_cast<float>(k), after.v - before * after.v_rate});
      collar.segments.push_back(t < 0.5f ? parent_segment : after.segment);
    }
  }
  tube.rings.erase(tube.rings.begin(), tube.rings.begin() + static_cast<std::ptrdiff_t>(joined));
}

}  // namespace panicle
