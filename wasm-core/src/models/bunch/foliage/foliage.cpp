#include "models/bunch/foliage/foliage.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <iterator>

#include "foundation/easing.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "models/bunch/foliage/leaf.hpp"
#include "stems/tubes.hpp"

namespace panicle::bunch {
namespace {

constexpr std::uint32_t max_leaves = 5;
constexpr std::uint32_t sides = 12;
constexpr std::int32_t cane_group = -1;
constexpr float between_berries_and_leaf = 0.008f;
constexpr float blade_in_midribs = 1.25f;  // length from the petiole sinus to the tip

// Limits a value; NaN gives the least.
float clamped(float value, float least, float most) {
  return value >= least ? std::min(value, most) : least;  // NaN gives the least
}

// The place of a leaf: at which node of the cane (−1, 0, 1, before the sides are drawn), the offset of its blade, the
// directions of its tip and of its upper face. Blades hang beside and behind the bunch's shoulders or are above them,
// overlap like roof tiles, and look up and to the front, where the light is. In the order in which leaves are added.
struct Stand {
  int node;
  glm::vec3 blade;  // metres
  glm::vec2
      // further offset in half-widths of the bunch: outwards, along x, where that is wide; backwards, along −z
      by_bunch;
  glm::vec3 tip, upwards;
  float size;  // share of the largest; those of lateral shoots are smaller
};
constexpr Stand stands[max_leaves] = {
    {1, {0.014f, 0.024f, 0.012f}, {0.9f, 0}, {0.62f, -0.78f, 0.05f}, {0.18f, 0.45f, 0.88f}, 1},
    {-1, {0.020f, 0.012f, -0.018f}, {0, 1}, {-0.42f, -0.90f, -0.05f}, {-0.20f, 0.32f, 0.92f}, 0.98f},
    {0, {-0.008f, 0.050f, -0.034f}, {0, 0}, {-0.80f, 0.05f, -0.20f}, {0.05f, 0.60f, 0.80f}, 0.92f},
    {1, {-0.030f, 0.046f, -0.046f}, {0, 0}, {0.50f, 0.42f, -0.40f}, {0.10f, 0.70f, 0.70f}, 0.80f},
    {-1, {-0.026f, 0.048f, -0.030f}, {0.5f, 0}, {-0.92f, -0.25f, -0.05f}, {-0.28f, 0.50f, 0.82f}, 0.84f},
};

// Builds a cane with its leaves.
class Shoot {
 public:
  explicit Shoot(const FoliageOptions& options)
      : seed_(options.seed),
        flat_(options.leaf),
        leaves_(flat_.points.empty() ? 0 : std::min(options.leaves, max_leaves)),
        age_(clamped(options.age, 0, 125)),
        bunch_radius_(clamped(options.bunch_width, 0, 1) / 2),
        foot_(clamped(options.foot.x, -1, 1), clamped(options.foot.y, -1, 1), clamped(options.foot.z, -1, 1)),
        mirror_(random_unit(seed_, hash_text("foliage side"), 0) < 0.5f ? -1.0f : 1.0f),
        grown_(0.62f + 0.38f * smooth_step(0, 50, age_)) {}

  // Builds the cane, then each leaf with its petiole, and one mesh of all.
  Foliage grow() {
    build_cane();
    for (std::uint32_t k = 0; k < leaves_; ++k) place_leaf(k);
    sweep();
    for (std::uint32_t k = 0; k < leaves_; ++k) append(leaf_meshes_[k], FoliagePart::Kind::leaf);
    return std::move(foliage_);
  }

 private:
  // A random value from `low` to `high`, for a purpose and a number.
  float random_between(std::string_view purpose, std::uint64_t address, float low, float high) const {
    return low + (high - low) * random_unit(seed_, hash_text(purpose), address);
  }

  // Adds a stem piece between two points; `parent`: its index among the pieces, −1 for none; `group`: the cane's or a
  // leaf's.
  void add_stem(std::int32_t parent, std::int32_t group, const glm::vec3& from, const glm::vec3& to, float radius,
                float radius_end) {
    stems_.push_back({parent, 0, from, to, radius, radius_end});
    groups_.push_back(group);
  }

  // Builds the cane from one cut end to the other by three nodes, in a slight zigzag, as shoots grow.
  void build_cane() {
    const float rise = random_between("cane", 1, -0.06f, 0.12f);  // along x
    const float arch = random_between("cane", 2, 0.2f, 0.6f);     // down to both ends, per metre
    const float turn = random_between("cane", 3, -0.15f, 0.15f);
    const float radius = 0.5f * random_between("cane", 4, 0.0064f, 0.0088f) * (0.8f + 0.2f * smooth_step(0, 60, age_));
    const float ends[] = {-random_between("cane", 5, 0.085f, 0.118f), -random_between("cane", 6, 0.062f, 0.075f), 0,
                          random_between("cane", 7, 0.062f, 0.075f), random_between("cane", 8, 0.085f, 0.118f)};
    for (std::size_t i = 0; i < std::size(ends); ++i) {
      const float x = ends[i] * mirror_;
      const float zigzag = i % 2 == 0 ? -0.0015f : 0.0015f;
      places_[i] = foot_ + glm::vec3(x, rise * ends[i] - arch * x * x + (i == 2 ? 0 : zigzag), turn * x);
    }
    for (std::size_t i = 0; i + 1 < std::size(ends); ++i) {
      const float taper = 1 - 0.05f * static_cast<float>(i);
      const float start = i == 0 ? 0.8f * radius : radius * taper;  // ends are drawn wider than nodes
      add_stem(static_cast<std::int32_t>(i) - 1, cane_group, places_[i], places_[i + 1], start,
               radius * (taper - 0.05f));
    }
  }

  // Builds leaf `k` at its node, turned and moved so that it does not touch the berries, with its petiole.
  void place_leaf(std::uint32_t k) {
    const Stand& stand = stands[k];
    const auto vary = [&](std::uint64_t i, float by) { return random_between("leaf stand", 16 * k + i, -by, by); };
    const auto sided = [&](glm::vec3 v) { return glm::vec3(v.x * mirror_, v.y, v.z); };
    const float suited = clamped(0.045f + 1.0f * bunch_radius_, 0.08f, 0.14f);
    const float blade = clamped(suited * stand.size * (1 + vary(0, 0.08f)), 0.08f, 0.14f) * grown_;
    const float late = smooth_step(95, 125, age_);

    Mesh mesh = make_leaf(flat_, {hash_combine(seed_, k), 0.25f + 0.75f * smooth_step(0, 30, age_), late});
    const glm::vec3 upwards =
        glm::normalize(sided(stand.upwards) + glm::vec3(vary(1, 0.18f), vary(2, 0.15f), vary(3, 0.1f)));
    glm::vec3 tip = sided(stand.tip) + glm::vec3(vary(4, 0.15f), vary(5, 0.18f) - 0.25f * late, vary(6, 0.1f));
    tip = glm::normalize(tip - upwards * glm::dot(upwards, tip));
    const glm::vec3 right = glm::cross(tip, upwards);

    const int at = 2 + stand.node;
    glm::vec3 base = sided(stand.blade) + glm::vec3(vary(7, 0.006f), vary(8, 0.006f), vary(9, 0.006f));
    base *= blade / 0.105f;  // petioles grow in proportion to blades
    base.x += stand.by_bunch.x * static_cast<float>(stand.node) * mirror_ * std::max(0.0f, bunch_radius_ - 0.05f);
    base.z -= stand.by_bunch.y * bunch_radius_;
    base += places_[at];
    const float midrib = blade / blade_in_midribs;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      turn_into(&mesh.positions[i], right * midrib, tip * midrib, upwards * midrib);
      turn_into(&mesh.normals[i], right, tip, upwards);
    }
    base.y += height_to_clear_berries(mesh, base);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] += base[i % 3];
    build_petiole(k, at, base, upwards, midrib);
    leaf_meshes_[k] = std::move(mesh);
  }

  // Turns the vector v[0..2] into the frame of the axes x, y, z.
  static void turn_into(float* v, const glm::vec3& x, const glm::vec3& y, const glm::vec3& z) {
    const glm::vec3 turned = x * v[0] + y * v[1] + z * v[2];
    for (int axis = 0; axis < 3; ++axis) v[axis] = turned[axis];
  }

  // How much higher, in metres, a leaf at `base` must be to be clear of the berries and not to hide them from the
  // front; 0 if it is.
  float height_to_clear_berries(const Mesh& mesh, const glm::vec3& base) const {
    const float room = bunch_radius_ + between_berries_and_leaf;
    float wanted = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      const glm::vec3 p = base + glm::vec3(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
      const bool above_berries = p.x * p.x + p.z * p.z < room * room;
      const bool in_front = p.z > 0 && std::fabs(p.x) < room;
      if (above_berries || in_front) wanted = std::max(wanted, between_berries_and_leaf - p.y);
    }
    return wanted;
  }

  // Builds a petiole that rises from the node and comes to the blade from below.
  void build_petiole(std::uint32_t k, int at, const glm::vec3& base, const glm::vec3& upwards, float midrib) {
    const glm::vec3 from = places_[at];
    const float length = glm::length(base - from);
    const glm::vec3 middle = from + 0.55f * (base - from) + length * (glm::vec3(0, 0.10f, 0) - 0.14f * upwards);
    const float radius = clamped(0.019f * midrib, 0.0009f, 0.0018f);
    const auto group = static_cast<std::int32_t>(k);
    add_stem(at - 1, group, from, middle, 1.3f * radius, radius);
    add_stem(static_cast<std::int32_t>(stems_.size()) - 1, group, middle, base, radius, 0.9f * radius);
  }

  // Builds the mesh of all stem pieces, in parts for the cane and the petioles.
  void sweep() {
    StemMesh swept = sweep_stems({stems_, groups_}, {sides}, 1);
    for (const StemPart& part : swept.parts) {
      const auto kind = part.group == cane_group ? FoliagePart::Kind::cane : FoliagePart::Kind::petiole;
      foliage_.parts.push_back({part, kind});
    }
    foliage_.mesh = std::move(swept.mesh);
  }

  // Adds a leaf's mesh to the foliage as a part of its own.
  void append(const Mesh& part, FoliagePart::Kind kind) {
    Mesh& whole = foliage_.mesh;
    const auto first_vertex = static_cast<std::uint32_t>(whole.positions.size() / 3);
    const auto first_index = static_cast<std::uint32_t>(whole.indices.size());
    foliage_.parts.push_back({{first_vertex, static_cast<std::uint32_t>(part.positions.size() / 3), first_index,
                               static_cast<std::uint32_t>(part.indices.size())},
                              kind});
    whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
    whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
    whole.uvs.insert(whole.uvs.end(), part.uvs.begin(), part.uvs.end());
    for (const std::uint32_t i : part.indices) whole.indices.push_back(first_vertex + i);
  }

  const std::uint64_t seed_;
  const FlatLeaf flat_;
  const std::uint32_t leaves_;
  const float age_, bunch_radius_;
  const glm::vec3 foot_;
  const float mirror_;        // −1 mirrors the whole foliage
  const float grown_;         // size of leaves at this age
  glm::vec3 places_[5] = {};  // cut end, three nodes, cut end
  std::vector<Segment> stems_;
  std::vector<std::int32_t> groups_;  // the cane's, then a petiole's each, in the order of leaves
  Mesh leaf_meshes_[max_leaves];
  Foliage foliage_;
};

}  // namespace

// A piece of cane with leaves, above a bunch; empty if neither is requested.
Foliage grow_foliage(const FoliageOptions& options) {
  if (options.leaves == 0 && !options.cane) return {};
  return Shoot(options).grow();
}

}  // namespace panicle::bunch
