#include "models/bunch/fruit/flower.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"

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
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size() / 3);
    const std::size_t rings = path.size() - 2;
    for (std::size_t i = 1; i <= rings; ++i) ring(path[i - 1], path[i], path[i + 1], right);
    pole(path[0], glm::normalize(path[0].centre - path[1].centre));
    pole(path[rings + 1], glm::normalize(path[rings + 1].centre - path[rings].centre));
    const std::uint32_t row = sides + 1;
    const auto last = first + row * static_cast<std::uint32_t>(rings - 1);
    const std::uint32_t begin = last + row, end = begin + sides;
    for (std::uint32_t k = 0; k < sides; ++k) {
      triangle(begin + k, first + k + 1, first + k);
      for (std::uint32_t at = first + k; at < last; at += row) {
        triangle(at, at + 1, at + row + 1);
        triangle(at, at + row + 1, at + row);
      }
      triangle(end + k, last + k, last + k + 1);
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  void ring(const Station& before, const Station& here, const Station& after, const glm::vec3& right) {
    const glm::vec3 way = after.centre - before.centre;
    const glm::vec3 tangent = glm::normalize(way);
    const glm::vec3 ahead = glm::cross(tangent, right);
    const float slope = (after.radius - before.radius) / glm::length(way);
    for (std::uint32_t k = 0; k <= sides; ++k) {
      const SinCos angle = sincos_degrees(360 * static_cast<float>(k % sides) / sides);
      const glm::vec3 out = right * angle.cosine + ahead * angle.sine;
      vertex(here.centre + out * here.radius, glm::normalize(out - tangent * slope), static_cast<float>(k) / sides,
             here.v);
    }
  }

  void pole(const Station& station, const glm::vec3& normal) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      vertex(station.centre, normal, (static_cast<float>(k) + 0.5f) / sides, station.v);
    }
  }

  void vertex(const glm::vec3& position, const glm::vec3& normal, float u, float v) {
    mesh_.positions.insert(mesh_.positions.end(), {position.x, position.y, position.z});
    mesh_.normals.insert(mesh_.normals.end(), {normal.x, normal.y, normal.z});
    mesh_.uvs.insert(mesh_.uvs.end(), {u, v});
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  Mesh mesh_;
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
  return tubes.take();
}

}  // namespace panicle::bunch
