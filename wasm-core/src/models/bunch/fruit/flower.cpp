#include "models/bunch/fruit/flower.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "geometry/tube_writer.hpp"

namespace panicle::bunch {
namespace {

constexpr int stamens = 5;
constexpr std::uint32_t sides = 5;

// A station of a tube: where its middle is, how thick it is there, and v.
struct Station {
  glm::vec3 centre;
  float radius, v;
};

// Closed tubes round a path, all into one mesh.
class Tubes {
 public:
  // The first and last stations are the poles. `right` is at right angles to the whole path, which is flat.
  void add(std::span<const Station> path, const glm::vec3& right) {
    Tube& tube = tubes_.emplace_back();
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const glm::vec3 way = path[i + 1].centre - path[i - 1].centre;
      Ring& ring = tube.rings.emplace_back();
      ring.centre = path[i].centre;
      ring.tangent = glm::normalize(way);
      ring.radius = path[i].radius;
      ring.right = right * ring.radius;
      ring.forward = glm::cross(ring.tangent, right) * ring.radius;
      ring.slope = (path[i + 1].radius - path[i - 1].radius) / glm::length(way);
      ring.v = path[i].v;
    }
    tube.first_pole = path.front().centre;
    tube.last_pole = path.back().centre;
    rings_ += tube.rings.size();
  }

  Mesh mesh() const {
    StemMesh stem;
    const RingPattern pattern(sides);
    TubeWriter writer(stem, TubeCount{rings_, tubes_.size()}.vertices(sides), std::uint64_t{2} * sides * rings_);
    for (const Tube& tube : tubes_) writer.write(tube, pattern, 1);
    writer.finish();
    return stem.mesh;
  }

 private:
  std::vector<Tube> tubes_;
  std::size_t rings_ = 0;
};

// How a stamen stands: `out` of the axis and `aside` span the ground, `reach` scales its length.
struct Stand {
  glm::vec3 out, aside;
  float reach;

  glm::vec3 at(float outwards, float up, float sideways = 0) const {
    return out * outwards + glm::vec3(0, up, 0) + aside * sideways;
  }
};

// From below the ovary, where the cap came off, outwards and up.
void add_filament(Tubes& tubes, const Stand& stand) {
  const float r = stand.reach;
  const std::array path = {
      Station{stand.at(0.70f, -0.80f), 0, 0},
      Station{stand.at(0.90f, -0.66f), 0.105f, 0.05f},
      Station{stand.at(1 + 0.42f * r, -0.66f + 0.90f * r), 0.085f, 0.2f},
      Station{stand.at(1 + 0.66f * r, -0.66f + 1.85f * r), 0.065f, 0.36f},
      Station{stand.at(1 + 0.72f * r, -0.66f + 2.60f * r), 0.045f, 0.48f},
      Station{stand.at(1 + 0.72f * r, -0.66f + 2.68f * r), 0, 0.5f},
  };
  tubes.add(path, stand.aside);
}

// Two lobes side by side on the filament's end, leaning inwards, where they open.
void add_anther(Tubes& tubes, const Stand& stand) {
  for (const float side : {-1.0f, 1.0f}) {
    constexpr float lean = -0.22f, length = 0.80f, radius = 0.19f;
    const auto station = [&](float along, float width) {
      const float up = -0.66f + 2.60f * stand.reach + length * (along - 0.35f);
      const float outwards = 1 + 0.72f * stand.reach - 0.06f + lean * (along - 0.35f);
      return Station{stand.at(outwards, up, side * 0.155f), radius * width, 0.5f + 0.5f * along};
    };
    const std::array path = {station(0, 0), station(0.14f, 0.72f), station(0.5f, 1), station(0.86f, 0.68f),
                             station(1, 0)};
    tubes.add(path, stand.aside);
  }
}

// Hardly longer than wide, the stigma a little wider than the style.
void add_style(Tubes& tubes) {
  const auto station = [](float up, float radius, float v) { return Station{{0, up, 0}, radius, v}; };
  const std::array path = {station(0.80f, 0.4f, 0), station(0.94f, 0.32f, 0.1f), station(1.16f, 0.17f, 0.3f),
                           station(1.32f, 0.22f, 0.45f), station(1.38f, 0, 0.5f)};
  tubes.add(path, {1, 0, 0});
}

}  // namespace

Mesh make_flower() {
  constexpr std::uint64_t seed = 5;
  Tubes tubes;
  add_style(tubes);
  for (std::uint64_t i = 0; i < stamens; ++i) {
    const float turn = 360 * static_cast<float>(i) / stamens + 14 * (random_unit(seed, 0, i) - 0.5f);
    const SinCos angle = sincos_degrees(turn);
    const Stand stand{
        {angle.cosine, 0, angle.sine}, {-angle.sine, 0, angle.cosine}, 0.92f + 0.16f * random_unit(seed, 1, i)};
    add_filament(tubes, stand);
    add_anther(tubes, stand);
  }
  return tubes.mesh();
}

}  // namespace panicle::bunch
