#include "models/stand/trellises.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <span>
#include <utility>

#include "foundation/mathematics.hpp"

namespace panicle::stand {
namespace {

// Metres. Usual line and end posts of wood; the wire is galvanised, 2.5 mm thick.
constexpr float line_post = 0.035f, end_post = 0.055f, wire_radius = 0.00125f, sunk = 0.2f;
constexpr float beside = 0.08f;   // from the posts' middle to each wire of a pair
constexpr float leaning = 0.18f;  // slope of an end post, outwards against the pull of the wires
constexpr float guyed = 0.85f;    // height of the anchor wire on an end post, as a share of the post's height
constexpr float anchored = 0.5f;  // distance of the anchor from the post, as a share of the post's height
constexpr std::uint32_t post_sides = 8, wire_sides = 3;

// A rod along a path. Its rings lie in the plane of `u` and `v`, unit vectors that are orthogonal.
struct Rod {
  std::span<const glm::vec3> path;
  glm::vec3 u, v;
  float radius;
  std::uint32_t sides;
};

// Adds a round rod along a path: a tube without ends. Texture coordinates: u runs once around, v counts circumferences
// along.
void put_rod(Mesh& mesh, const Rod& rod) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  float length = 0;
  for (std::size_t i = 0; i < rod.path.size(); ++i) {
    if (i > 0) length += glm::distance(rod.path[i], rod.path[i - 1]);
    for (std::uint32_t k = 0; k <= rod.sides; ++k) {
      const float share = static_cast<float>(k) / static_cast<float>(rod.sides);
      const SinCos turn = sincos_degrees(360 * share);
      const glm::vec3 out = turn.cosine * rod.u + turn.sine * rod.v;
      put(mesh.positions, rod.path[i] + rod.radius * out);
      put(mesh.normals, out);
      put(mesh.uvs, glm::vec2(share, length / (2 * pi * rod.radius)));
    }
  }
  const std::uint32_t ring = rod.sides + 1;
  for (std::uint32_t i = 0; i + 1 < rod.path.size(); ++i)
    for (std::uint32_t k = 0; k < rod.sides; ++k) {
      const std::uint32_t a = first + ring * i + k, b = a + ring;
      put(mesh.indices, a, b, a + 1);
      put(mesh.indices, a + 1, b, b + 1);
    }
}

// Adds the flat end of a rod, at the last point of its path.
void put_end(Mesh& mesh, const Rod& rod, const glm::vec3& normal) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  for (std::uint32_t k = 0; k < rod.sides; ++k) {
    const SinCos turn = sincos_degrees(360 * static_cast<float>(k) / static_cast<float>(rod.sides));
    put(mesh.positions, rod.path.back() + rod.radius * (turn.cosine * rod.u + turn.sine * rod.v));
    put(mesh.normals, normal);
    put(mesh.uvs, glm::vec2(turn.cosine, turn.sine));
  }
  for (std::uint32_t k = 1; k + 1 < rod.sides; ++k) put(mesh.indices, first, first + k + 1, first + k);
}

// Builder of one row's posts and wires.
class Row {
 public:
  Row(const Layer& layer, const Relief& relief, const glm::vec2& origin, const glm::vec2& along, Trellises& out)
      : layer_(layer), trellis_(*layer.trellis), relief_(relief), origin_(origin), along_(along), out_(out) {}

  // Builds a row from its first plant at `first_plant`, in metres along the row, with `places` more plants.
  void build(float first_plant, std::uint32_t places) {
    const float step = layer_.along, start = first_plant - 0.5f * step;
    const auto steps_between_posts = std::max(1.0f, std::floor(trellis_.posts / step + 1e-3f));
    const auto post_interval = static_cast<std::uint32_t>(std::min(steps_between_posts, 1e6f)), step_count = places + 1;
    for (std::uint32_t i = 0; i < step_count; i += post_interval)
      post(start + step * static_cast<float>(i), i == 0 ? -1.0f : 0.0f);
    const float end = start + step * static_cast<float>(step_count);
    post(end, 1);
    for (const Wire& wire : trellis_.wires)
      for (const float side : {-1.0f, 1.0f}) {
        if (!wire.pair && side < 0) continue;
        std::vector<glm::vec3> path{post_point(start, -1, wire.high)};
        for (std::uint32_t i = 0; i <= places; ++i)
          path.push_back(above_ground(first_plant + step * static_cast<float>(i), wire.high));
        path.push_back(post_point(end, 1, wire.high));
        // A pair meets at the end posts.
        if (wire.pair)
          for (std::size_t i = 1; i + 1 < path.size(); ++i) path[i] += side * beside * across();
        put_rod(out_.metal, {path, across(), {0, 1, 0}, wire_radius, wire_sides});
      }
  }

 private:
  // Unit vectors in the ground's plane: across the row and along it.
  glm::vec3 across() const { return {-along_.y, 0, along_.x}; }
  // The unit vector along the row.
  glm::vec3 direction() const { return {along_.x, 0, along_.y}; }

  // The point at a height above the ground, `place` metres along the row.
  glm::vec3 above_ground(float place, float height) const {
    const glm::vec2 at = origin_ + place * along_;
    return {at.x, relief_.at(at.x, at.y) + height, at.y};
  }

  // A point on a post at a height; `side` −1 or 1: an end post that leans out, 0: a vertical post.
  glm::vec3 post_point(float place, float side, float height) const {
    return above_ground(place, height) + side * leaning * height * direction();
  }

  // Adds a post `place` metres along the row; an end post (`side` −1 or 1) also gets its anchor wire.
  void post(float place, float side) {
    ++out_.posts;
    const glm::vec3 path[]{post_point(place, side, -sunk), post_point(place, side, trellis_.high)};
    const glm::vec3 up = glm::normalize(path[1] - path[0]), out = glm::cross(up, across());
    const Rod rod{path, across(), -out, side == 0 ? line_post : end_post, post_sides};
    put_rod(out_.wood, rod);
    put_end(out_.wood, rod, up);
    if (side == 0) return;
    const float height = guyed * trellis_.high;
    const glm::vec3 guy[]{post_point(place, side, height),
                          above_ground(place + side * (leaning * height + anchored * trellis_.high), 0)};
    put_rod(out_.metal,
            {guy, across(), glm::normalize(glm::cross(across(), guy[1] - guy[0])), wire_radius, wire_sides});
  }

  const Layer& layer_;
  const Trellis& trellis_;
  const Relief& relief_;
  glm::vec2 origin_, along_;
  Trellises& out_;
};

}  // namespace

// Builds posts and wires for each row of a layer with a trellis, from the row's first plant to its last.
Trellises trellises_of(const Plan& plan, const Relief& relief, const std::vector<Placement>& plants) {
  Trellises all;
  // The numbers of a row's first and last plant.
  struct Ends {
    std::int32_t first, last;
  };
  std::map<std::pair<std::uint32_t, std::int32_t>, Ends> rows;
  for (const Placement& plant : plants) {
    if (!plan.layers[plant.layer].trellis || plant.parent >= 0) continue;
    Ends& ends = rows.try_emplace({plant.layer, plant.row}, Ends{plant.place, plant.place}).first->second;
    ends = {std::min(ends.first, plant.place), std::max(ends.last, plant.place)};
  }
  for (const auto& [key, ends] : rows) {
    const Layer& layer = plan.layers[key.first];
    const SinCos turn = sincos_degrees(layer.towards);
    const glm::vec2 along(turn.cosine, turn.sine), across(-turn.sine, turn.cosine);
    const glm::vec2 middle(0, middle_of(layer, plan.ground));
    Row(layer, relief, middle + layer.apart * static_cast<float>(key.second) * across, along, all)
        .build(layer.along * static_cast<float>(ends.first), static_cast<std::uint32_t>(ends.last - ends.first));
  }
  return all;
}

}  // namespace panicle::stand
