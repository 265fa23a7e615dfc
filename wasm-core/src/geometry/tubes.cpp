#include "geometry/tubes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/mathematics.hpp"
#include "geometry/stem_rings.hpp"

namespace panicle {
namespace {

// Cosine and sine of each side; the first again at the end, where the texture's seam is.
struct Circle {
  std::vector<SinCos> sides;
  std::vector<float> u;

  explicit Circle(std::uint32_t count) {
    for (std::uint32_t k = 0; k <= count; ++k) {
      const float turn = static_cast<float>(k) / static_cast<float>(count);
      sides.push_back(sincos_degrees(360 * (k < count ? turn : 0)));
      u.push_back(turn);
    }
  }
};

// Writes tubes one after the other into arrays of the right size.
class Writer {
 public:
  Writer(StemMesh& stem, std::uint32_t sides) : circle_(sides), sides_(sides), stem_(stem) {
    position_ = stem.mesh.positions.data();
    normal_ = stem.mesh.normals.data();
    uv_ = stem.mesh.uvs.data();
    index_ = stem.mesh.indices.data();
    internode_ = stem.internode.data();
  }

  void write(const Tube& tube, float scale) {
    const Ring& first = tube.rings.front();
    const Ring& last = tube.rings.back();
    write_pole(tube.first_pole * scale, -first.tangent, first);
    for (const Ring& ring : tube.rings) write_ring(ring, scale);
    write_pole(tube.last_pole * scale, last.tangent, last);
    write_triangles(static_cast<std::uint32_t>(tube.rings.size()));
  }

  std::uint32_t vertices() const { return vertices_; }
  std::uint32_t indices() const { return static_cast<std::uint32_t>(index_ - stem_.mesh.indices.data()); }

 private:
  void write_pole(const glm::vec3& position, const glm::vec3& normal, const Ring& ring) {
    for (int axis = 0; axis < 3; ++axis) {
      *position_++ = position[axis];
      *normal_++ = normal[axis];
    }
    *uv_++ = 0.5f;
    *uv_++ = ring.v;
    *internode_++ = ring.internode;
  }

  void write_ring(const Ring& ring, float scale) {
    const glm::vec3 centre = ring.centre * scale;
    const glm::vec3 right = ring.right * scale;
    const glm::vec3 forward = ring.forward * scale;
    for (std::uint32_t k = 0; k <= sides_; ++k) {
      const SinCos& side = circle_.sides[k];
      const glm::vec3 position = centre + right * side.cosine + forward * side.sine;
      position_[0] = position.x;
      position_[1] = position.y;
      position_[2] = position.z;
      uv_[0] = circle_.u[k];
      uv_[1] = ring.v;
      *internode_++ = ring.internode;
      position_ += 3;
      uv_ += 2;
    }
    ring.round ? write_round_normals(ring) : write_normals(ring);
  }

  // All lean against the tangent alike.
  void write_round_normals(const Ring& ring) {
    const float radius = glm::length(ring.right);
    const float slope = glm::dot(ring.right_change, ring.right) / radius;
    const float out = 1 / std::sqrt(1 + slope * slope);
    const glm::vec3 right = ring.right * (out / radius);
    const glm::vec3 forward = ring.forward * (out / radius);
    const glm::vec3 along = ring.tangent * (-slope * out);
    for (std::uint32_t k = 0; k <= sides_; ++k) {
      write_normal(right * circle_.sides[k].cosine + forward * circle_.sides[k].sine + along);
    }
  }

  // At right angles to the two directions within the surface, round the ring and along the axis.
  void write_normals(const Ring& ring) {
    for (std::uint32_t k = 0; k <= sides_; ++k) {
      const auto [sine, cosine] = circle_.sides[k];
      const glm::vec3 around = ring.forward * cosine - ring.right * sine;
      const glm::vec3 along = ring.tangent + ring.right_change * cosine + ring.forward_change * sine;
      write_normal(glm::normalize(glm::cross(around, along)));
    }
  }

  void write_normal(const glm::vec3& normal) {
    normal_[0] = normal.x;
    normal_[1] = normal.y;
    normal_[2] = normal.z;
    normal_ += 3;
  }

  // A fan, bands of two triangles a side, a fan; counter-clockwise from without.
  void write_triangles(std::uint32_t rings) {
    const std::uint32_t row = sides_ + 1;
    const std::uint32_t first_pole = vertices_;
    const std::uint32_t last_pole = first_pole + 1 + rings * row;
    std::uint32_t ring = first_pole + 1;
    for (std::uint32_t k = 0; k < sides_; ++k) write_triangle(first_pole, ring + k + 1, ring + k);
    for (std::uint32_t i = 1; i < rings; ++i, ring += row) {
      for (std::uint32_t k = ring; k < ring + sides_; ++k) {
        write_triangle(k, k + 1, k + row + 1);
        write_triangle(k, k + row + 1, k + row);
      }
    }
    for (std::uint32_t k = 0; k < sides_; ++k) write_triangle(last_pole, ring + k, ring + k + 1);
    vertices_ = last_pole + 1;
  }

  void write_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    index_[0] = a;
    index_[1] = b;
    index_[2] = c;
    index_ += 3;
  }

  const Circle circle_;
  const std::uint32_t sides_;
  StemMesh& stem_;
  std::uint32_t vertices_ = 0;
  float* position_;
  float* normal_;
  float* uv_;
  std::uint32_t* index_;
  std::uint32_t* internode_;
};

struct Size {
  std::uint64_t vertices = 0, indices = 0;
};

Size size_of(const StemAxes& axes, const TubeMaker& maker, std::uint32_t sides) {
  Size size;
  for (const StemAxis& axis : axes.axes) {
    const std::uint64_t rings = maker.count_rings(axis);
    size.vertices += rings * (sides + 1) + 2;
    size.indices += rings * sides * 6;
  }
  return size;
}

void allocate(StemMesh& stem, const Size& size) {
  stem.mesh.positions.resize(size.vertices * 3);
  stem.mesh.normals.resize(size.vertices * 3);
  stem.mesh.uvs.resize(size.vertices * 2);
  stem.mesh.indices.resize(size.indices);
  stem.internode.resize(size.vertices);
}

}  // namespace

StemMesh sweep_stems(std::span<const Internode> skeleton, const TubeOptions& options, float scale) {
  const StemAxes axes = find_stem_axes(skeleton);
  std::uint32_t sides = std::clamp(options.sides, 3u, 64u);
  TubeMaker maker(skeleton, axes);
  Size size = size_of(axes, maker, sides);
  while (size.vertices > options.most_vertices && sides > 3) {
    sides = std::max(sides / 2, 3u);
    size = size_of(axes, maker, sides);
  }
  if (size.vertices > options.most_vertices) {
    maker.coarsen();
    size = size_of(axes, maker, sides);
  }

  StemMesh stem;
  allocate(stem, size);
  Writer writer(stem, sides);
  Tube tube;
  for (const StemAxis& axis : axes.axes) {
    if (stem.parts.empty() || stem.parts.back().axis != axis.axis) {
      stem.parts.push_back({axis.axis, writer.vertices(), 0, writer.indices(), 0});
    }
    maker.make(axis, tube);
    writer.write(tube, scale);
    StemPart& part = stem.parts.back();
    part.vertex_count = writer.vertices() - part.first_vertex;
    part.index_count = writer.indices() - part.first_index;
  }
  return stem;
}

}  // namespace panicle
