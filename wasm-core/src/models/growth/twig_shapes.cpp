#include "models/growth/twig_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "foundation/rotation.hpp"
#include "foundation/vectors.hpp"

namespace panicle::growth {
namespace {

// Shapes are shared by all trees of a species: their random values do not depend on a tree's seed.
constexpr std::uint64_t shape_seed = 0x74776967;
constexpr std::uint64_t stream_bend = 1, stream_pose = 2, stream_size = 3, stream_side = 4, stream_litter = 5;

constexpr float two_fifths = 144;  // degrees from one leaf to the next
constexpr std::uint32_t axis_pieces = 4, side_pieces = 2, corners = 3;
constexpr float first_node = 0.12f;                    // nothing grows below this share of an axis
constexpr float first_side = 0.22f, last_side = 0.8f;  // where side twigs leave
constexpr float side_angle = 48, longest_side = 0.52f, shortest_side = 0.26f;
constexpr float bent = 0.16f;  // sideways at the tip, in lengths of the axis
constexpr float zigzag = 0.012f;
constexpr float base_angle = 62, tip_angle = 26;  // of leaves to their axis, degrees
constexpr float least_leaf = 0.72f;
constexpr float flattened = 0.5f;                    // of leaves towards the twig's plane
constexpr float thin_end = 0.35f, thin_side = 0.6f;  // thickness at a tip, and of side twigs
constexpr float spur_length = 0.16f, spur_angle = 62;
constexpr float needle_width = 0.06f, single_needle_width = 0.13f, needle_base = 58, needle_tip = 22, pair_spread = 13;
constexpr float bud_width = 0.36f;
constexpr std::uint32_t spur_leaves = 6;

// An axis of a twig: a parabola from its start.
struct Axis {
  glm::vec3 start{0}, direction{0, 1, 0}, bend{0};
  float length = 1, thickness = 0;
  std::uint32_t pieces = axis_pieces;

  glm::vec3 at(float along) const { return start + along * length * direction + along * along * length * bend; }
  glm::vec3 tangent(float along) const { return glm::normalize(direction + 2 * along * bend); }
};

class ShapeBuilder {
 public:
  ShapeBuilder(const TwigHabit& habit, const Blade& blade, std::uint32_t number, float unfolded, bool buds)
      : habit_(habit), blade_(blade), number_(number), unfolded_(unfolded), buds_(buds) {}

  TwigShape run() {
    const bool spur = habit_.spurs > 0 && number_ + 1 == habit_.shapes;
    std::vector<Axis> axes = spur ? std::vector<Axis>{spur_axis()} : branched();
    float whole = 0;
    for (const Axis& axis : axes) whole += axis.length;
    std::uint32_t left = spur ? std::min(spur_leaves, habit_.leaves) : habit_.leaves;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto share =
          static_cast<std::uint32_t>(std::lround(static_cast<float>(left) * axes[i].length / std::max(whole, 1e-6f)));
      const std::uint32_t count = i + 1 == axes.size() ? left : std::min(std::max(share, 1u), left);
      whole -= axes[i].length;
      left -= count;
      add_wood(axes[i]);
      add_leaves(axes[i], count, spur);
      ++shape_.tips;
    }
    return std::move(shape_);
  }

 private:
  float random(std::uint64_t stream, std::uint64_t address) const {
    return random_unit(shape_seed, stream, hash_combine(number_, address));
  }

  Axis spur_axis() const {
    Axis axis;
    axis.length = spur_length;
    axis.thickness = 1.3f * habit_.thickness;
    axis.pieces = side_pieces;
    return axis;
  }

  // The main axis and its side twigs, which leave it by the arrangement of leaves.
  std::vector<Axis> branched() const {
    Axis main;
    const float turn = 360 * random(stream_bend, 0);
    const SinCos way = sincos_degrees(turn);
    main.bend = bent * glm::vec3(way.cosine, 0, 0.5f * way.sine);
    main.thickness = habit_.thickness;
    std::vector<Axis> axes{main};
    const std::vector<TwigNode> nodes = twig_nodes(habit_.phyllotaxis, std::max(habit_.sides, 1u), 0);
    for (std::uint32_t i = 0; i < habit_.sides; ++i) {
      const float share = habit_.sides > 1 ? static_cast<float>(i) / static_cast<float>(habit_.sides - 1) : 0.5f;
      const float noise = random(stream_side, i);
      const float along = std::clamp(glm::mix(first_side, last_side, share) + 0.06f * (noise - 0.5f), 0.1f, 0.9f);
      const SinCos angle = sincos_degrees(side_angle * (0.85f + 0.3f * random(stream_side, 64 + i)));
      const glm::vec3 forward = main.tangent(along), side = side_of(forward, nodes[i].azimuth, 0.55f);
      Axis axis;
      axis.start = main.at(along);
      axis.direction = glm::normalize(angle.cosine * forward + angle.sine * side);
      axis.length = glm::mix(longest_side, shortest_side, share) * (0.75f + 0.5f * random(stream_side, 128 + i));
      axis.bend = 0.18f * forward - glm::vec3(0, 0, habit_.droop);
      axis.thickness = thin_side * habit_.thickness;
      axis.pieces = side_pieces;
      axes.push_back(axis);
    }
    return axes;
  }

  // The unit vector at right angles to an axis at an azimuth, pressed towards the twig's plane z = 0 by `depth`.
  static glm::vec3 side_of(const glm::vec3& forward, float azimuth, float depth) {
    const SinCos turn = sincos_degrees(azimuth);
    const glm::vec3 x = unit(glm::cross(forward, glm::vec3(0, 0, 1)), {1, 0, 0}), z = glm::cross(x, forward);
    return unit(turn.cosine * x + depth * turn.sine * z, x);
  }

  static glm::vec3 unit(const glm::vec3& v, const glm::vec3& otherwise) {
    const float length = glm::length(v);
    return length > 1e-5f ? v / length : otherwise;
  }

  // Adds a tube with three sides along an axis, which ends in a point; zigzag from node to node in two ranks.
  void add_wood(const Axis& axis) {
    Mesh& mesh = shape_.wood;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    const bool two_ranked = habit_.phyllotaxis == Phyllotaxis::two_ranked && axis.pieces == axis_pieces;
    for (std::uint32_t k = 0; k <= axis.pieces; ++k) {
      const float along = static_cast<float>(k) / static_cast<float>(axis.pieces);
      const glm::vec3 forward = axis.tangent(along), x = unit(glm::cross(forward, glm::vec3(0, 0, 1)), {1, 0, 0}),
                      z = glm::cross(x, forward);
      glm::vec3 place = axis.at(along);
      if (two_ranked && k > 0 && k < axis.pieces) place += (k % 2 == 0 ? zigzag : -zigzag) * x;
      const float radius = 0.5f * axis.thickness * (1 + (thin_end - 1) * along);
      if (k == axis.pieces) {
        put_vertex(mesh, place, forward, {0.5f, along});
        break;
      }
      for (std::uint32_t c = 0; c < corners; ++c) {
        const SinCos turn = sincos_degrees(360 * static_cast<float>(c) / corners);
        const glm::vec3 out = turn.cosine * x + turn.sine * z;
        put_vertex(mesh, place + radius * out, out, {static_cast<float>(c) / corners, along});
      }
    }
    const std::uint32_t tip = first + corners * axis.pieces;
    for (std::uint32_t k = 0; k < axis.pieces; ++k)
      for (std::uint32_t c = 0; c < corners; ++c) {
        const std::uint32_t here = first + corners * k + c, beside = first + corners * k + (c + 1) % corners;
        if (k + 1 == axis.pieces) {
          put(mesh.indices, beside, here, tip);
          continue;
        }
        put(mesh.indices, beside, here, here + corners);
        put(mesh.indices, beside, here + corners, beside + corners);
      }
  }

  // Adds the leaves of an axis, and buds in their places.
  void add_leaves(const Axis& axis, std::uint32_t count, bool rosette) {
    const bool needles = habit_.foliage != TwigHabit::Leaf::flat;
    const std::vector<TwigNode> nodes =
        needles ? needle_nodes(count) : twig_nodes(habit_.phyllotaxis, count, habit_.crowd);
    shape_.leaf_count += count;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      const float along = rosette ? 1 : nodes[i].along;
      const std::uint64_t address = hash_combine(shape_.tips, i);
      if (needles) {
        add_needle(axis, nodes[i], address);
        continue;
      }
      const bool last = i + 1 == nodes.size() && habit_.phyllotaxis != Phyllotaxis::opposite;
      const glm::vec3 forward = axis.tangent(along), side = side_of(forward, nodes[i].azimuth, 1);
      const float degrees = rosette ? spur_angle : last ? 12 : glm::mix(base_angle, tip_angle, along * along);
      const SinCos angle = sincos_degrees(degrees * (0.8f + 0.4f * random(stream_pose, address)));
      add_leaf(axis.at(along), unit(angle.cosine * forward + angle.sine * side, forward), address);
      if (buds_ && i % 2 == 0) add_bud(axis.at(along), unit(forward + 0.8f * side, forward));
    }
    if (buds_) add_bud(axis.at(0.99f), axis.tangent(1));
  }

  // The places of needles: all around the axis, closer than leaves.
  static std::vector<TwigNode> needle_nodes(std::uint32_t count) {
    std::vector<TwigNode> nodes(count);
    for (std::uint32_t i = 0; i < count; ++i)
      nodes[i] = {first_node + (1 - first_node) * (static_cast<float>(i) + 0.5f) / static_cast<float>(count),
                  golden_angle * static_cast<float>(i)};
    return nodes;
  }

  // Adds a needle, or a pair of needles of half the number each.
  void add_needle(const Axis& axis, const TwigNode& node, std::uint64_t address) {
    if (!(unfolded_ > 0)) return;
    const bool pair = habit_.foliage == TwigHabit::Leaf::pair;
    const glm::vec3 forward = axis.tangent(node.along), side = side_of(forward, node.azimuth, 1);
    const float noise = random(stream_pose, address);
    const SinCos angle = sincos_degrees(glm::mix(needle_base, needle_tip, node.along) * (0.8f + 0.4f * noise));
    const glm::vec3 way = unit(angle.cosine * forward + angle.sine * side, forward);
    const float length = unfolded_ * habit_.leaf * (least_leaf + (1 - least_leaf) * random(stream_size, address));
    const glm::vec3 across = unit(glm::cross(way, forward), {1, 0, 0});
    // A single needle stands for three or four, which are as dense as the teeth of a brush.
    const float half = 0.5f * (pair ? needle_width : single_needle_width) * habit_.needle_breadth * habit_.leaf;
    Mesh& mesh = shape_.leaves;
    const auto spike = [&](const glm::vec3& direction) {
      const glm::vec3 start = axis.at(node.along), normal = unit(glm::cross(across, direction), {0, 0, 1});
      const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
      put_vertex(mesh, start - half * across, normal, {0, 0});
      put_vertex(mesh, start + half * across, normal, {1, 0});
      put_vertex(mesh, start + length * direction, normal, {0.5f, 1});
      put(mesh.indices, first, first + 1, first + 2);
      shape_.area += half * length * glm::length(glm::cross(across, direction));
    };
    if (!pair) return spike(way);
    const SinCos spread = sincos_degrees(pair_spread);
    spike(spread.cosine * way + spread.sine * across);
    spike(spread.cosine * way - spread.sine * across);
  }

  // Adds a leaf whose petiole begins at a place and whose tip points to `out`, its face to the light.
  void add_leaf(const glm::vec3& place, const glm::vec3& out, std::uint64_t address) {
    const float size = habit_.leaf * (least_leaf + (1 - least_leaf) * random(stream_size, address));
    shape_.area += unfolded_ * unfolded_ * size * size * blade_.area;
    if (!(unfolded_ > 0) || blade_.mesh.indices.empty()) return;
    const glm::vec3 noise = random_direction(shape_seed, stream_pose, hash_combine(number_, ~address));
    const glm::vec3 tip = unit({out.x, out.y, (1 - flattened) * out.z - 0.12f}, {0, 1, 0});
    glm::vec3 face = glm::vec3(0, 0, 1) + 0.4f * habit_.stray * noise + 0.25f * glm::vec3(out.x, 0, 0);
    face = unit(face - glm::dot(face, tip) * tip, any_perpendicular(tip));
    append(blade_.mesh, place, glm::mat3(glm::cross(tip, face), tip, face), unfolded_ * size);
  }

  // Adds a copy of a mesh to the leaves.
  void append(const Mesh& from, const glm::vec3& place, const glm::mat3& turn, float size) {
    Mesh& mesh = shape_.leaves;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    for (std::size_t k = 0; k < from.positions.size() / 3; ++k)
      put_vertex(mesh, place + size * (turn * vector_at(from.positions, k)), turn * vector_at(from.normals, k),
                 {from.uvs[2 * k], from.uvs[2 * k + 1]});
    for (const std::uint32_t index : from.indices) mesh.indices.push_back(first + index);
  }

  // Adds a bud: a spindle with three sides.
  void add_bud(const glm::vec3& place, const glm::vec3& direction) {
    Mesh& mesh = shape_.wood;
    const glm::vec3 x = any_perpendicular(direction), z = glm::cross(x, direction);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    const float radius = 0.5f * bud_width * habit_.bud;
    for (std::uint32_t c = 0; c < corners; ++c) {
      const SinCos turn = sincos_degrees(360 * static_cast<float>(c) / corners);
      const glm::vec3 out = turn.cosine * x + turn.sine * z;
      put_vertex(mesh, place + 0.4f * habit_.bud * direction + radius * out, out,
                 {static_cast<float>(c) / corners, 0.5f});
    }
    put_vertex(mesh, place, -direction, {0.5f, 0});
    put_vertex(mesh, place + habit_.bud * direction, direction, {0.5f, 1});
    for (std::uint32_t c = 0; c < corners; ++c) {
      const std::uint32_t here = first + c, beside = first + (c + 1) % corners;
      put(mesh.indices, here, first + corners + 1, beside);
      put(mesh.indices, here, beside, first + corners);
    }
  }

  static void put_vertex(Mesh& mesh, const glm::vec3& place, const glm::vec3& normal, const glm::vec2& uv) {
    put(mesh.positions, place);
    put(mesh.normals, normal);
    put(mesh.uvs, uv);
  }

  const TwigHabit& habit_;
  const Blade& blade_;
  const std::uint32_t number_;
  const float unfolded_;
  const bool buds_;
  TwigShape shape_;
};

}  // namespace

std::vector<TwigNode> twig_nodes(Phyllotaxis phyllotaxis, std::uint32_t count, float crowd) {
  std::vector<TwigNode> nodes(count);
  const bool pairs = phyllotaxis == Phyllotaxis::opposite;
  const std::uint32_t places = pairs ? (count + 1) / 2 : count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t place = pairs ? i / 2 : i;
    const float share = places > 1 ? static_cast<float>(place) / static_cast<float>(places - 1) : 1;
    // Crowded leaves: the square root moves them towards the tip.
    nodes[i].along = first_node + (1 - first_node) * glm::mix(share, std::sqrt(share), crowd);
    switch (phyllotaxis) {
      case Phyllotaxis::spiral:
        nodes[i].azimuth = std::fmod(two_fifths * static_cast<float>(i), 360.0f);
        break;
      case Phyllotaxis::two_ranked:
        nodes[i].azimuth = i % 2 == 0 ? 0.0f : 180.0f;
        break;
      case Phyllotaxis::opposite:
        nodes[i].azimuth = 90.0f * static_cast<float>(place % 2) + (i % 2 == 0 ? 0.0f : 180.0f);
        break;
    }
  }
  return nodes;
}

std::vector<TwigShape> twig_shapes(const TwigHabit& habit, const Blade& blade, const std::vector<float>& unfolded,
                                   bool with_buds) {
  std::vector<TwigShape> shapes;
  for (std::uint32_t i = 0; i < habit.shapes; ++i)
    shapes.push_back(ShapeBuilder(habit, blade, i, unfolded[i], with_buds && habit.bud > 0).run());
  return shapes;
}

Mesh leaf_litter(const TwigHabit& habit, const Blade& blade, std::uint32_t leaves) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < leaves && !blade.mesh.indices.empty(); ++i) {
    const glm::vec2 on_disc = 0.6f * golden_disc_point(i, leaves);
    const SinCos turn = sincos_degrees(360 * random_unit(shape_seed, stream_litter, i));
    const float size = habit.leaf * (least_leaf + (1 - least_leaf) * random_unit(shape_seed, stream_size, i));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    const auto turned = [&](const glm::vec3& v) {
      return glm::vec3(turn.cosine * v.x - turn.sine * v.y, turn.sine * v.x + turn.cosine * v.y, v.z);
    };
    for (std::size_t k = 0; k < blade.mesh.positions.size() / 3; ++k) {
      put(mesh.positions, glm::vec3(on_disc, 0) + size * turned(vector_at(blade.mesh.positions, k)));
      put(mesh.normals, turned(vector_at(blade.mesh.normals, k)));
      put(mesh.uvs, glm::vec2(blade.mesh.uvs[2 * k], blade.mesh.uvs[2 * k + 1]));
    }
    for (const std::uint32_t index : blade.mesh.indices) mesh.indices.push_back(first + index);
  }
  return mesh;
}

}  // namespace panicle::growth
