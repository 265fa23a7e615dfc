#include "foliage/blade.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

#include "foundation/golden_spiral.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"

namespace panicle {
namespace {

constexpr float arch_angle = 0.6f;       // radians a length, petiole and all
constexpr float pucker_height = 0.035f;  // of the blade between its veins
constexpr int needles = 5;
constexpr float needle_width = 0.06f;
constexpr int spray_needles = 20;
constexpr float spray_length = 0.32f;
// The poses of leaves on a twig: the distance between leaves in lengths of a leaf; in degrees, their angles to the twig
// at its foot and near its tip, and their largest turns about the midrib and out of the plane; half the width of the
// stem, in lengths of the twig.
constexpr float leaf_spacing = 0.3f, degrees_at_foot = 68, degrees_at_tip = 38, max_roll = 32, max_lift = 24,
                stem_half_width = 0.03f;
constexpr int petals = 5;
constexpr float blossom_stalk = 0.6f;

// Bends a point into the arch, which is level in the blade's middle: as a whole the blade looks to +Z.
glm::vec3 arched(glm::vec3 p) {
  p.y -= 0.5f;
  bend(p.y, p.z, arch_angle);
  return p;
}

// Adds a vertex with texture coordinates u and v.
void put_vertex(Mesh& mesh, const glm::vec3& p, const glm::vec3& normal, float u, float v) {
  mesh.positions.insert(mesh.positions.end(), {p.x, p.y, p.z});
  mesh.normals.insert(mesh.normals.end(), {normal.x, normal.y, normal.z});
  mesh.uvs.insert(mesh.uvs.end(), {u, v});
}

// Adds a petiole of one triangle, since thousands are drawn: widest at the foot of the leaf, which is at the origin, it
// ends beneath the midrib and has its colour. `foot`: where the foot of the arched leaf was before it was moved there.
void add_petiole(Mesh& mesh, const FlatLeaf& leaf, const glm::vec3& foot) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  const float half = 0.75f * leaf.petiole[1], u = leaf.uvs[0], v = leaf.uvs[1];
  const glm::vec3 top = arched({0, 0.04f, -0.004f}) - foot, side(half, 0, 0),
                  normal = glm::normalize(glm::cross(side, top));
  for (const glm::vec3& p : {-side, side, top}) put_vertex(mesh, p, normal, u, v);
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

// Adds a triangle that narrows from its foot to its tip: a needle, a petal's half, a stalk.
void put_spike(Mesh& mesh, const glm::vec3& foot, const glm::vec3& half_width, const glm::vec3& tip) {
  const glm::vec3 normal = glm::normalize(glm::cross(half_width, tip - foot));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  put_vertex(mesh, foot - half_width, normal, 0, 0);
  put_vertex(mesh, foot + half_width, normal, 1, 0);
  put_vertex(mesh, tip, normal, 0.5f, 1);
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

// The area of all triangles of a mesh.
float area_of(const Mesh& mesh) {
  float area = 0;
  const auto corner = [&](std::size_t i) { return vector_at(mesh.positions, mesh.indices[i]); };
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3)
    area += triangle_area(corner(t), corner(t + 1), corner(t + 2));
  return area;
}

}  // namespace

// A leaf with its petiole's foot at the origin and its tip towards +Y, of midrib length 1. `breadth`: factor of its
// width; `fold`: degrees that its halves rise from the midrib.
Blade make_blade(const FlatLeaf& leaf, float breadth, float fold) {
  if (leaf.points.empty()) return {};
  const auto [sine, cosine] = sincos_degrees(fold);
  const bool stalked = !leaf.petiole.empty() && leaf.petiole[0] > 0;
  const glm::vec3 foot = arched({0, stalked ? -leaf.petiole[0] : 0, 0});
  std::vector<glm::vec3> places;
  places.reserve(leaf.between.size());
  for (std::size_t i = 0; i < leaf.between.size(); ++i) {
    const float x = breadth * leaf.points[2 * i], between = leaf.between[i];
    places.push_back(
        arched({x * cosine, leaf.points[2 * i + 1], std::fabs(x) * sine + pucker_height * between * (2 - between)}) -
        foot);
  }
  Blade blade;
  blade.mesh = raised(leaf, places);
  blade.area = area_of(blade.mesh);
  if (stalked) add_petiole(blade.mesh, leaf, foot);
  return blade;
}

// The length of a twig with so many leaves, in lengths of a leaf.
float twig_length(std::uint32_t leaves) { return 1 + leaf_spacing * static_cast<float>(leaves - 1); }

// A twig of length 1 with copies of a leaf, alternately to both sides and one at its tip. Fewer than two leaves give
// the leaf itself.
Blade make_twig(const Blade& leaf, std::uint32_t leaves) {
  if (leaves < 2 || leaf.mesh.indices.empty()) return leaf;
  const float size = 1 / twig_length(leaves);
  const Mesh& one = leaf.mesh;
  const std::size_t vertices = one.positions.size() / 3;
  Blade twig;
  for (std::uint32_t i = 0; i < leaves; ++i) {
    const bool tip = i + 1 == leaves;
    const auto number = static_cast<float>(i);
    const float side = i % 2 == 0 ? 1.0f : -1.0f, share = number / static_cast<float>(leaves - 1);
    // Leaves vary by multiples of the golden ratio, not by random values: all trees share one mesh.
    const float scatter = golden_ratio * number - std::floor(golden_ratio * number),
                second_scatter = std::fmod(3.7f * scatter, 1.0f);
    const SinCos off = sincos_degrees(tip ? 0 : side * glm::mix(degrees_at_foot, degrees_at_tip, share));
    const SinCos roll = sincos_degrees(max_roll * (2 * scatter - 1)),
                 lift = sincos_degrees(max_lift * (2 * second_scatter - 1));
    const glm::vec3 direction(off.sine * lift.cosine, off.cosine * lift.cosine, lift.sine);
    const glm::vec3 level = glm::normalize(glm::cross(direction, {0, 0, 1})), face = glm::cross(level, direction);
    const glm::mat3 turn(roll.cosine * level + roll.sine * face, direction, roll.cosine * face - roll.sine * level);
    const auto first = static_cast<std::uint32_t>(twig.mesh.positions.size() / 3);
    for (std::size_t k = 0; k < vertices; ++k) {
      const auto at = [&](const std::vector<float>& from) { return turn * vector_at(from, k); };
      put_vertex(twig.mesh, size * (glm::vec3(0, leaf_spacing * number, 0) + at(one.positions)), at(one.normals),
                 one.uvs[2 * k], one.uvs[2 * k + 1]);
    }
    for (const std::uint32_t index : one.indices) twig.mesh.indices.push_back(first + index);
  }
  const float top = size * leaf_spacing * static_cast<float>(leaves - 1);
  // The twig's stem.
  put_spike(twig.mesh, {0, 0, 0}, {size * stem_half_width, 0, 0}, {0, top, 0});
  twig.area = static_cast<float>(leaves) * size * size * leaf.area;
  return twig;
}

// A short conifer twig with needles all round it.
Blade make_spray(float breadth) {
  Blade blade;
  for (int k = 0; k < spray_needles; ++k) {
    const auto turn = sincos_degrees(137.50776f * static_cast<float>(k));
    const float up = static_cast<float>(k) / spray_needles;
    const glm::vec3 out(turn.cosine, 0, turn.sine), foot(0, 0.8f * up, 0);
    const glm::vec3 way = glm::normalize(out + glm::vec3(0, 0.55f + 0.6f * up, 0));
    const glm::vec3 half = 0.5f * needle_width * breadth * glm::normalize(glm::cross(way, out));
    put_spike(blade.mesh, foot, half, foot + spray_length * way);
  }
  blade.area = area_of(blade.mesh);
  return blade;
}

// A flower of five petals on a stalk.
Blade make_blossom() {
  Blade blade;
  for (int k = 0; k < petals; ++k) {
    const auto turn = sincos_degrees(360.0f * static_cast<float>(k) / petals);
    const glm::vec3 out(turn.cosine, 0, turn.sine), across(-turn.sine, 0, turn.cosine), heart(0, blossom_stalk, 0);
    const glm::vec3 middle = heart + 0.34f * out + glm::vec3(0, 0.1f, 0),
                    tip = heart + 0.5f * out + glm::vec3(0, 0.13f, 0);
    put_spike(blade.mesh, middle, -0.21f * across, heart);
    put_spike(blade.mesh, middle, 0.21f * across, tip);
  }
  put_spike(blade.mesh, {0, blossom_stalk, 0}, {0.03f, 0, 0}, {0, 0, 0});
  blade.area = area_of(blade.mesh);
  return blade;
}

// A tuft of five needles from one point.
Blade make_needles(float breadth) {
  Blade blade;
  for (int k = 0; k < needles; ++k) {
    const auto turn = sincos_degrees(360.0f * static_cast<float>(k) / needles + 15);
    const glm::vec3 way = glm::normalize(glm::vec3(0.45f * turn.cosine, 1, 0.45f * turn.sine));
    const glm::vec3 side = glm::normalize(glm::cross(way, glm::vec3(turn.cosine, 0, turn.sine)));
    const glm::vec3 normal = glm::cross(side, way), half = 0.5f * needle_width * breadth * side;
    const auto first = static_cast<std::uint32_t>(blade.mesh.positions.size() / 3);
    put_vertex(blade.mesh, -half, normal, 0, 0);
    put_vertex(blade.mesh, half, normal, 1, 0);
    put_vertex(blade.mesh, way, normal, 0.5f, 1);
    blade.mesh.indices.insert(blade.mesh.indices.end(), {first, first + 1, first + 2});
  }
  blade.area = area_of(blade.mesh);
  return blade;
}

}  // namespace panicle
