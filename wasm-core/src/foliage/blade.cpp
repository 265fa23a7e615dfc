#include "foliage/blade.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

constexpr float arch = 0.6f;      // radians a length, petiole and all
constexpr float pucker = 0.035f;  // of the blade between its veins
constexpr int needles = 5;
constexpr float needle_width = 0.06f;
constexpr int spray_needles = 20;
constexpr float spray_length = 0.32f;
// The poses of leaves on a twig: the distance between leaves in lengths of a leaf, degrees off the twig at its foot and
// near its tip, and the largest turn about the midrib and out of the plane.
constexpr float apart = 0.3f, off_foot = 68, off_tip = 38, rolled = 32, lifted = 24, twig_width = 0.03f;
constexpr int petals = 5;
constexpr float stalk = 0.6f;

// Bends a point into the arch, which is level in the blade's middle: as a whole the blade looks to +Z.
glm::vec3 arched(glm::vec3 p) {
  p.y -= 0.5f;
  bend(p.y, p.z, arch);
  return p;
}

void put_vertex(Mesh& mesh, const glm::vec3& p, const glm::vec3& normal, float u, float v) {
  mesh.positions.insert(mesh.positions.end(), {p.x, p.y, p.z});
  mesh.normals.insert(mesh.normals.end(), {normal.x, normal.y, normal.z});
  mesh.uvs.insert(mesh.uvs.end(), {u, v});
}

// A petiole of one triangle from the foot, widest there, to beneath the midrib, with the midrib's colour: thousands are
// drawn.
void add_petiole(Mesh& mesh, const FlatLeaf& leaf, const glm::vec3& foot) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  const float half = 0.75f * leaf.petiole[1], u = leaf.uvs[0], v = leaf.uvs[1];
  const glm::vec3 top = arched({0, 0.04f, -0.004f}) - foot, side(half, 0, 0),
                  normal = glm::normalize(glm::cross(side, top));
  for (const glm::vec3& p : {-side, side, top}) put_vertex(mesh, p, normal, u, v);
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

// Adds a needle, or a petal's half: widest where it begins.
void put_point(Mesh& mesh, const glm::vec3& foot, const glm::vec3& half, const glm::vec3& tip) {
  const glm::vec3 normal = glm::normalize(glm::cross(half, tip - foot));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
  put_vertex(mesh, foot - half, normal, 0, 0);
  put_vertex(mesh, foot + half, normal, 1, 0);
  put_vertex(mesh, tip, normal, 0.5f, 1);
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
}

float area_of(const Mesh& mesh) {
  float area = 0;
  const auto point = [&](std::uint32_t i) {
    return glm::vec3(mesh.positions[3 * i], mesh.positions[3 * i + 1], mesh.positions[3 * i + 2]);
  };
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::vec3 a = point(mesh.indices[t]);
    area += 0.5f * glm::length(glm::cross(point(mesh.indices[t + 1]) - a, point(mesh.indices[t + 2]) - a));
  }
  return area;
}

}  // namespace

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
        arched({x * cosine, leaf.points[2 * i + 1], std::fabs(x) * sine + pucker * between * (2 - between)}) - foot);
  }
  Blade blade;
  blade.mesh = raised(leaf, places);
  blade.area = area_of(blade.mesh);
  if (stalked) add_petiole(blade.mesh, leaf, foot);
  return blade;
}

float twig_length(std::uint32_t leaves) { return 1 + apart * static_cast<float>(leaves - 1); }

Blade make_twig(const Blade& leaf, std::uint32_t leaves) {
  if (leaves < 2 || leaf.mesh.indices.empty()) return leaf;
  const float size = 1 / twig_length(leaves);
  const Mesh& one = leaf.mesh;
  const std::size_t vertices = one.positions.size() / 3;
  Blade twig;
  for (std::uint32_t i = 0; i < leaves; ++i) {
    const bool tip = i + 1 == leaves;
    const auto place = static_cast<float>(i);
    const float side = i % 2 == 0 ? 1.0f : -1.0f, share = place / static_cast<float>(leaves - 1);
    // Leaves vary by multiples of the golden ratio, not by random values: all trees share one mesh.
    const float scatter = 0.618034f * place - std::floor(0.618034f * place), other = std::fmod(3.7f * scatter, 1.0f);
    const SinCos off = sincos_degrees(tip ? 0 : side * glm::mix(off_foot, off_tip, share));
    const SinCos roll = sincos_degrees(rolled * (2 * scatter - 1)), lift = sincos_degrees(lifted * (2 * other - 1));
    const glm::vec3 way(off.sine * lift.cosine, off.cosine * lift.cosine, lift.sine);
    const glm::vec3 level = glm::normalize(glm::cross(way, {0, 0, 1})), face = glm::cross(level, way);
    const glm::mat3 turn(roll.cosine * level + roll.sine * face, way, roll.cosine * face - roll.sine * level);
    const auto first = static_cast<std::uint32_t>(twig.mesh.positions.size() / 3);
    for (std::size_t k = 0; k < vertices; ++k) {
      const auto at = [&](const std::vector<float>& from) {
        return turn * glm::vec3(from[3 * k], from[3 * k + 1], from[3 * k + 2]);
      };
      put_vertex(twig.mesh, size * (glm::vec3(0, apart * place, 0) + at(one.positions)), at(one.normals),
                 one.uvs[2 * k], one.uvs[2 * k + 1]);
    }
    for (const std::uint32_t index : one.indices) twig.mesh.indices.push_back(first + index);
  }
  const float top = size * apart * static_cast<float>(leaves - 1);
  put_point(twig.mesh, {0, 0, 0}, {size * twig_width, 0, 0}, {0, top, 0});
  twig.area = static_cast<float>(leaves) * size * size * leaf.area;
  return twig;
}

Blade make_spray(float breadth) {
  Blade blade;
  for (int k = 0; k < spray_needles; ++k) {
    const auto turn = sincos_degrees(137.50776f * static_cast<float>(k));
    const float up = static_cast<float>(k) / spray_needles;
    const glm::vec3 out(turn.cosine, 0, turn.sine), foot(0, 0.8f * up, 0);
    const glm::vec3 way = glm::normalize(out + glm::vec3(0, 0.55f + 0.6f * up, 0));
    const glm::vec3 half = 0.5f * needle_width * breadth * glm::normalize(glm::cross(way, out));
    put_point(blade.mesh, foot, half, foot + spray_length * way);
  }
  blade.area = area_of(blade.mesh);
  return blade;
}

Blade make_blossom() {
  Blade blade;
  for (int k = 0; k < petals; ++k) {
    const auto turn = sincos_degrees(360.0f * static_cast<float>(k) / petals);
    const glm::vec3 out(turn.cosine, 0, turn.sine), across(-turn.sine, 0, turn.cosine), heart(0, stalk, 0);
    const glm::vec3 middle = heart + 0.34f * out + glm::vec3(0, 0.1f, 0),
                    tip = heart + 0.5f * out + glm::vec3(0, 0.13f, 0);
    put_point(blade.mesh, middle, -0.21f * across, heart);
    put_point(blade.mesh, middle, 0.21f * across, tip);
  }
  put_point(blade.mesh, {0, stalk, 0}, {0.03f, 0, 0}, {0, 0, 0});
  blade.area = area_of(blade.mesh);
  return blade;
}

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
