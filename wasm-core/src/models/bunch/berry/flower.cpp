#include "models/bunch/berry/flower.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "stems/tube_writer.hpp"

namespace panicle::bunch {

// A pedicel is the stalk of one flower or berry.

namespace {

using Kind = FlowerPiece::Kind;

// v of the parts that have a colour of their own.
constexpr float green = 0.1f, filament = 0.4f, anther = 0.6f, petal = 0.9f;

// A station of a tube: distance from the axis, height of its middle, and radius. The first and the last are poles.
struct Station {
  float out, up, radius;
};

// A tube: `flat` times as thick in the plane of its path as across it.
struct Tubing {
  std::span<const Station> path;
  std::uint32_t sides;
  float v, flat = 1;
};

constexpr Station stalk_path[] = {{-0.05f, -0.01f, 0}, {0.01f, 0.08f, 0.2f}, {0.3f, 0.47f, 0.15f}, {0.42f, 0.82f, 0}};
constexpr Station head_path[] = {{0.14f, -0.5f, 0}, {0.06f, -0.2f, 0.34f}, {-0.06f, 0.3f, 0.32f}, {-0.14f, 0.55f, 0}};
// The style: hardly longer than wide, the stigma a little wider.
constexpr Station style_path[] = {{0, 0.8f, 0}, {0, 0.9f, 0.36f}, {0, 1.25f, 0.2f}, {0, 1.45f, 0}};
// The cap: a hood over the whole bud, blunt and widest above the middle.
constexpr Station cap_path[] = {{0, -0.75f, 0}, {0, -0.6f, 1}, {0, 0.5f, 1.3f}, {0, 1.5f, 0.95f}, {0, 1.8f, 0}};
constexpr Station pedicel_path[] = {{0, -6.2f, 0}, {0, -6, 0.3f}, {0, -0.9f, 0.34f}, {0, -0.6f, 0}};
constexpr Station ovary_path[] = {{0, -1, 0}, {0, -0.75f, 0.75f}, {0, 0, 1}, {0, 0.7f, 0.65f}, {0, 1.05f, 0}};
constexpr Station petal_path[] = {{1, -0.9f, 0}, {3, -0.7f, 2.2f}, {8, 0.6f, 4.6f}, {12, 2.2f, 3.4f}, {13.5f, 3, 0}};
// A sepal: pointed, and bent back from the fruit.
constexpr Station sepal_path[] = {
    {0.3f, -0.4f, 0}, {2, -0.3f, 2.1f}, {5.5f, -1.2f, 1.9f}, {9, -3.4f, 0.7f}, {10.5f, -4.8f, 0}};

constexpr Tubing stalk{stalk_path, 3, filament}, head{head_path, 3, anther}, style{style_path, 4, filament};
constexpr Tubing cap{cap_path, 6, green}, pedicel{pedicel_path, 3, green}, ovary{ovary_path, 5, green};
constexpr Tubing petal_blade{petal_path, 4, petal, 0.05f}, sepal{sepal_path, 4, green, 0.12f};

// Frame of one of several parts round the axis: `out` (away from the axis) and `sideways` span the ground.
struct PartFrame {
  glm::vec3 out{1, 0, 0}, sideways{0, 0, 1};
};

// The frame of part `i` of `count` round the axis; `uneven`: degrees over `count` by which parts are off at random.
PartFrame frame_of(std::uint64_t i, float count, float uneven) {
  constexpr std::uint64_t seed = 5;
  const SinCos angle =
      sincos_degrees((360 * static_cast<float>(i) + uneven * (random_unit(seed, 0, i) - 0.5f)) / count);
  return {{angle.cosine, 0, angle.sine}, {-angle.sine, 0, angle.cosine}};
}

// Builds closed tubes, a piece after the other: few sides and few rings, since there are hundreds of flowers.
class FlowerBuilder {
 public:
  // Starts a piece: everything added from now on is of that kind.
  void begin(Kind kind) { flower_.pieces.push_back({{vertices(), 0, indices(), 0}, kind}); }

  // Adds a closed tube along its path, scaled and then moved by `from`, in the plane of `frame`.
  void add(const Tubing& tubing, const PartFrame& frame = {}, float scale = 1, const Station& from = {}) {
    Tube tube;
    const std::span<const Station> path = tubing.path;
    std::vector<glm::vec3> middles;
    for (const Station& one : path)
      middles.push_back(frame.out * (from.out + one.out * scale) + glm::vec3(0, from.up + one.up * scale, 0));
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const glm::vec3 way = middles[i + 1] - middles[i - 1];
      const float length = glm::length(way), gain = (path[i + 1].radius - path[i - 1].radius) / length;
      Ring& ring = tube.rings.emplace_back();
      ring.centre = middles[i];
      ring.tangent = way / length;
      const glm::vec3 forward = glm::cross(ring.tangent, frame.sideways) * tubing.flat;
      ring.radius = path[i].radius * tubing.flat;
      ring.slope = gain * tubing.flat;
      ring.right = frame.sideways * path[i].radius;
      ring.forward = forward * path[i].radius;
      ring.right_change = frame.sideways * gain;
      ring.forward_change = forward * gain;
      ring.round = false;
      ring.v = tubing.v;
    }
    tube.first_pole = middles.front();
    tube.last_pole = middles.back();
    append(tube, tubing);
  }

  FlowerMesh take() { return std::move(flower_); }

 private:
  // The number of vertices and indices so far.
  std::uint32_t vertices() const { return static_cast<std::uint32_t>(flower_.mesh.uvs.size() / 2); }
  std::uint32_t indices() const { return static_cast<std::uint32_t>(flower_.mesh.indices.size()); }

  // Writes a tube's mesh at the end of the flower's, as part of the current piece.
  void append(const Tube& tube, const Tubing& tubing) {
    StemMesh stem;
    const std::size_t rings = tube.rings.size();
    const RingPattern pattern(tubing.sides);
    TubeWriter writer(stem, TubeCount{rings, 1}.vertices(tubing.sides), std::uint64_t{2} * tubing.sides * rings);
    writer.write(tube, pattern, 1);
    writer.finish();
    Mesh& all = flower_.mesh;
    const std::uint32_t first = vertices();
    for (const float x : stem.mesh.positions) all.positions.push_back(x);
    for (const float x : stem.mesh.normals) all.normals.push_back(x);
    for (std::size_t i = 0; i < stem.mesh.uvs.size(); ++i) all.uvs.push_back(i % 2 == 0 ? stem.mesh.uvs[i] : tubing.v);
    for (const std::uint32_t index : stem.mesh.indices) all.indices.push_back(first + index);
    FlowerPiece& piece = flower_.pieces.back();
    piece.vertex_count = vertices() - piece.first_vertex;
    piece.index_count = indices() - piece.first_index;
  }

  FlowerMesh flower_;
};

// The number of stamens, and their length in radii of the ovary.
struct Stamens {
  float count, length;
};

// The stamens of a fruit's flower.
Stamens stamens_of(Fruit fruit) {
  constexpr Stamens all[] = {{5, 3.8f}, {5, 1.6f}, {22, 4.5f}, {7, 4}, {7, 4}, {5, 1.6f}};  // by the fruits' numbers
  return all[static_cast<std::size_t>(fruit)];
}

// Adds stamens: from below the ovary outwards and up, the anther across the end.
void add_stamens(FlowerBuilder& builder, const Stamens& stamens) {
  for (std::uint64_t i = 0; static_cast<float>(i) < stamens.count; ++i) {
    const PartFrame frame = frame_of(i, stamens.count, 80);
    const float length = stamens.length * (0.85f + 0.3f * random_unit(5, 1, i));
    builder.add(stalk, frame, length, {1, -0.7f, 0});
    builder.add(head, frame, 1, {1 + 0.42f * length, 0.82f * length - 0.7f, 0});
  }
}

// Adds five petals or sepals round the axis.
void add_whorl_of_five(FlowerBuilder& builder, const Tubing& blade) {
  for (std::uint64_t i = 0; i < 5; ++i) builder.add(blade, frame_of(i, 5, 60));
}

}  // namespace

// Makes the mesh of a flower of a fruit, in pieces by kind of organ.
FlowerMesh make_flower(Fruit fruit) {
  FlowerBuilder builder;
  builder.begin(Kind::stamens);
  builder.add(style);
  add_stamens(builder, stamens_of(fruit));
  if (fruit == Fruit::bramble) {
    builder.begin(Kind::petals);
    add_whorl_of_five(builder, petal_blade);
    builder.begin(Kind::calyx);
    add_whorl_of_five(builder, sepal);
    return builder.take();
  }
  if (fruit == Fruit::grape) {
    builder.begin(Kind::cap);
    builder.add(cap);
  }
  builder.begin(Kind::pistil);
  builder.add(pedicel);
  builder.add(ovary);
  return builder.take();
}

}  // namespace panicle::bunch
