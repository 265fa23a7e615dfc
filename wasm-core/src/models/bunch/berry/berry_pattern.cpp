#include "models/bunch/berry/berry_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "foundation/mathematics.hpp"
#include "mesh/ring_strips.hpp"

namespace panicle::bunch {
namespace {

// A ring of vertices round the berry's axis.
struct Ring {
  float from_tip;  // degrees
  std::uint32_t segments;
  std::uint32_t first = 0;  // vertex
};

// The rings of a berry of so many meridians, from tip to seat. They are even except near the two ends, where scar and
// collar need detail: the scar ends at 6.3° (v 0.965).
std::vector<Ring> build_rings(std::uint32_t meridians) {
  constexpr float tip_rings[] = {3.2f, 6.3f, 11};
  constexpr float seat_rings[] = {169, 174.5f};
  const float step = 360 * 0.87f / static_cast<float>(meridians);  // rows of equilateral triangles
  std::vector<float> angles(std::begin(tip_rings), std::end(tip_rings));
  const float span = seat_rings[0] - tip_rings[2];
  const auto intervals = std::max(2u, static_cast<std::uint32_t>(span / step + 0.5f));
  for (std::uint32_t i = 1; i < intervals; ++i) {
    angles.push_back(tip_rings[2] + span * static_cast<float>(i) / static_cast<float>(intervals));
  }
  angles.insert(angles.end(), std::begin(seat_rings), std::end(seat_rings));
  std::vector<Ring> rings;
  for (const float angle : angles) {
    const auto even = static_cast<std::uint32_t>(static_cast<float>(meridians) * sincos_degrees(angle).sine + 0.5f);
    rings.push_back({angle, std::clamp(even + 2, std::min(10u, meridians), meridians)});
  }
  return rings;
}

// Adds vertices and triangles to a pattern.
class PatternBuilder {
 public:
  explicit PatternBuilder(BerryPattern& pattern) : pattern_(pattern) {}

  // Adds the vertices of a ring; the first is repeated at the end, for the texture's seam.
  void ring(Ring& ring) {
    ring.first = pattern_.vertices;
    const SinCos from_tip = sincos_degrees(ring.from_tip);
    for (std::uint32_t i = 0; i <= ring.segments; ++i) {
      const float whole = static_cast<float>(ring.segments);
      const SinCos round = sincos_degrees(360 * static_cast<float>(i % ring.segments) / whole);
      vertex({from_tip.sine * round.cosine, from_tip.cosine, from_tip.sine * round.sine}, static_cast<float>(i) / whole,
             1 - ring.from_tip / 180);
    }
  }

  // Adds a pole (y is 1 at the tip, −1 at the seat) once for each segment of the ring beside it, so that u stays within
  // the segment. Returns the first one's index.
  std::uint32_t pole(float y, std::uint32_t segments) {
    const std::uint32_t first = pattern_.vertices;
    for (std::uint32_t i = 0; i < segments; ++i) {
      vertex({0, y, 0}, (static_cast<float>(i) + 0.5f) / static_cast<float>(segments), (1 + y) / 2);
    }
    return first;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    pattern_.indices.insert(pattern_.indices.end(), {a, b, c});
  }

  // Adds the triangles between two neighbouring rings.
  void band(const Ring& upper, const Ring& lower) {
    strip_between(upper.first, upper.segments, lower.first, lower.segments,
                  [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangle(a, b, c); });
  }

 private:
  // Adds a vertex in a direction from the centre, with texture coordinates.
  void vertex(const glm::vec3& direction, float u, float v) {
    for (int axis = 0; axis < 3; ++axis) pattern_.directions[axis].push_back(direction[axis]);
    pattern_.uvs.insert(pattern_.uvs.end(), {u, v});
    ++pattern_.vertices;
  }

  BerryPattern& pattern_;
};

// Computes the share of each triangle and vertex in the volume of a surface about the centre (triple product / 6), and
// extends the arrays to a multiple of four.
void compute_weights(BerryPattern& pattern) {
  pattern.shares.assign(pattern.vertices, 0);
  const auto direction = [&](std::uint32_t i) {
    return glm::vec3(pattern.directions[0][i], pattern.directions[1][i], pattern.directions[2][i]);
  };
  for (std::size_t t = 0; t < pattern.indices.size(); t += 3) {
    const std::uint32_t* corner = &pattern.indices[t];
    const float cell =
        glm::dot(direction(corner[0]), glm::cross(direction(corner[1]), direction(corner[2]))) * (1 / 6.0f);
    pattern.cells.push_back(cell);
    for (int k = 0; k < 3; ++k) pattern.shares[corner[k]] += cell / 3;
  }
  const std::size_t padded = (pattern.vertices + 3) / 4 * 4;
  pattern.shares.resize(padded, 0);
  for (auto& axis : pattern.directions) axis.resize(padded, axis.back());
}

}  // namespace

// The directions and triangles that all berries of a bunch share; each berry then has distances of its own from its
// centre.
BerryPattern make_berry_pattern(std::uint32_t meridians) {
  BerryPattern pattern;
  std::vector<Ring> rings = build_rings(std::clamp(meridians, 8u, 320u));
  PatternBuilder builder(pattern);
  for (Ring& ring : rings) builder.ring(ring);
  const Ring& first = rings.front();
  const Ring& last = rings.back();
  const std::uint32_t tip = builder.pole(1, first.segments);
  const std::uint32_t seat = builder.pole(-1, last.segments);
  for (std::uint32_t i = 0; i < first.segments; ++i) builder.triangle(tip + i, first.first + i + 1, first.first + i);
  for (std::size_t r = 1; r < rings.size(); ++r) builder.band(rings[r - 1], rings[r]);
  for (std::uint32_t i = 0; i < last.segments; ++i) builder.triangle(seat + i, last.first + i, last.first + i + 1);
  compute_weights(pattern);
  return pattern;
}

}  // namespace panicle::bunch
