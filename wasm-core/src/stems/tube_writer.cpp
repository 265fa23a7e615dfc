#include "stems/tube_writer.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "foundation/lane_vectors.hpp"
#include "foundation/lanes.hpp"
#include "foundation/mathematics.hpp"

namespace panicle {
namespace {

// A vector in three groups of four floats, as four vertices in a row have it: xyzx yzxy zxyz.
struct Repeated {
  Four part[3];

  explicit Repeated(const glm::vec3& v)
      : part{Four{v.x, v.y, v.z, v.x}, Four{v.y, v.z, v.x, v.y}, Four{v.z, v.x, v.y, v.z}} {}
};

// The parts of four vectors at right angles to a unit vector.
FourVectors perpendicular_part(const FourVectors& v, const glm::vec3& direction) {
  const Four part = v.x * direction.x + v.y * direction.y + v.z * direction.z;
  return {v.x - part * direction.x, v.y - part * direction.y, v.z - part * direction.z};
}

// share_a a + share_b b, for four pairs of vectors.
FourVectors mix(const FourVectors& a, float share_a, const FourVectors& b, float share_b) {
  return {a.x * share_a + b.x * share_b, a.y * share_a + b.y * share_b, a.z * share_a + b.z * share_b};
}

// base + a x + b y, for four pairs of factors x and y.
FourVectors sum(const glm::vec3& base, const glm::vec3& a, const Four& x, const glm::vec3& b, const Four& y) {
  return {base.x + a.x * x + b.x * y, base.y + a.y * x + b.y * y, base.z + a.z * x + b.z * y};
}

// Repeats a ring's first vertex behind its last, where the texture's seam is.
void close_ring(float* out, std::uint32_t sides) {
  for (std::uint32_t axis = 0; axis < 3; ++axis) out[3 * sides + axis] = out[axis];
}

}  // namespace

// Computes the pattern of rings with that number of sides. Vertex `sides` repeats the first, for the texture's seam.
RingPattern::RingPattern(std::uint32_t sides_) : sides(sides_), padded((sides_ + 3) / 4 * 4) {
  for (std::uint32_t k = 0; k < padded; ++k) {
    const SinCos angle = sincos_degrees(360 * static_cast<float>(k) / static_cast<float>(sides));
    cosine.push_back(angle.cosine);
    sine.push_back(angle.sine);
    cosine_thrice.insert(cosine_thrice.end(), 3, angle.cosine);
    sine_thrice.insert(sine_thrice.end(), 3, angle.sine);
  }
  const std::uint32_t row = sides + 1;
  for (std::uint32_t k = 0; k < row + row % 2; ++k)
    u.insert(u.end(), {static_cast<float>(k) / static_cast<float>(sides), 0});
  for (std::uint32_t k = 0; k < sides; ++k) band.insert(band.end(), {k, k + 1, k + row + 1, k, k + row + 1, k + row});
  while (band.size() % 4 != 0) band.push_back(0);
}

// Makes room for all vertices and triangles.
TubeWriter::TubeWriter(StemMesh& stem, std::uint64_t vertices, std::uint64_t triangles) : stem_(stem) {
  const auto room = static_cast<std::size_t>(vertices) + 4;
  // Made, not grown: in a wasm where some code is built for size, growing writes zeros one number at a time.
  stem.mesh.positions = std::vector<float>(room * 3);
  stem.mesh.normals = std::vector<float>(room * 3);
  stem.mesh.uvs = std::vector<float>(room * 2);
  stem.segment = std::vector<std::uint32_t>(room);
  stem.mesh.indices = std::vector<std::uint32_t>(static_cast<std::size_t>(triangles) * 3 + 4);
}

// Removes the room that is not used.
void TubeWriter::finish() {
  stem_.mesh.positions.resize(std::size_t{vertices_} * 3);
  stem_.mesh.normals.resize(std::size_t{vertices_} * 3);
  stem_.mesh.uvs.resize(std::size_t{vertices_} * 2);
  stem_.segment.resize(vertices_);
  stem_.mesh.indices.resize(indices_);
}

// Writes a tube, scaled: its triangles, then the vertices of the first pole, all rings and the last pole.
void TubeWriter::write(const Tube& tube, const RingPattern& pattern, float scale) {
  pattern_ = &pattern;
  const Ring& first = tube.rings.front();
  const Ring& last = tube.rings.back();
  write_triangles(vertices_, tube.collar.rows + static_cast<std::uint32_t>(tube.rings.size()));
  write_pole(tube.first_pole * scale, -first.tangent, first);
  write_collar(tube.collar, scale);
  for (const Ring& ring : tube.rings) write_ring(tube, ring, scale);
  write_pole(tube.last_pole * scale, last.tangent, last);
}

// Writes the vertex in the middle of a tube's end. `ring`: the one next to it.
void TubeWriter::write_pole(const glm::vec3& position, const glm::vec3& normal, const Ring& ring) {
  for (int axis = 0; axis < 3; ++axis) {
    stem_.mesh.positions[3 * vertices_ + axis] = position[axis];
    stem_.mesh.normals[3 * vertices_ + axis] = normal[axis];
  }
  stem_.mesh.uvs[2 * vertices_] = 0.5f * ring.turns;
  stem_.mesh.uvs[2 * vertices_ + 1] = ring.v;
  stem_.segment[vertices_] = ring.segment;
  ++vertices_;
}

// Writes the rows of a collar.
void TubeWriter::write_collar(const Collar& collar, float scale) {
  for (std::size_t i = 0; i < collar.positions.size(); ++i, ++vertices_) {
    const glm::vec3 position = collar.positions[i] * scale;
    for (int axis = 0; axis < 3; ++axis) {
      stem_.mesh.positions[3 * vertices_ + axis] = position[axis];
      stem_.mesh.normals[3 * vertices_ + axis] = collar.normals[i][axis];
    }
    stem_.mesh.uvs[2 * vertices_] = collar.uvs[i].x;
    stem_.mesh.uvs[2 * vertices_ + 1] = collar.uvs[i].y;
    stem_.segment[vertices_] = collar.segments[i];
  }
}

// Writes the vertices of a ring: positions, normals, texture coordinates and segment, four numbers at a time. The
// normals of a round ring form an ellipse, too, tilted by the slope of its radius.
void TubeWriter::write_ring(const Tube& tube, const Ring& ring, float scale) {
  write_ellipse(&stem_.mesh.positions[3 * vertices_], ring.centre * scale, ring.right * scale, ring.forward * scale);
  float* normals = &stem_.mesh.normals[3 * vertices_];
  if (ring.round) {
    const float out = 1 / std::sqrt(1 + ring.slope * ring.slope);
    const float unit = out / ring.radius;
    write_ellipse(normals, ring.tangent * (-ring.slope * out), ring.right * unit, ring.forward * unit);
  } else {
    write_normals(tube, ring, normals);
  }
  float* uvs = &stem_.mesh.uvs[2 * vertices_];
  const Four v{0, ring.v, 0, ring.v};
  const float* u = pattern_->u.data();
  for (const float* end = u + pattern_->u.size(); u < end; u += 4, uvs += 4) store(uvs, load(u) * ring.turns + v);
  std::uint32_t* segments = &stem_.segment[vertices_];
  const FourWords segment{ring.segment, ring.segment, ring.segment, ring.segment};
  for (std::uint32_t k = 0; k <= pattern_->sides; k += 4) store(segments + k, segment);
  vertices_ += pattern_->sides + 1;
}

// Writes centre + right cos a + forward sin a for the angle a of each side, and the first point again.
void TubeWriter::write_ellipse(float* out, const glm::vec3& centre, const glm::vec3& right,
                               const glm::vec3& forward) const {
  const Repeated c(centre), r(right), f(forward);
  const float* cosine = pattern_->cosine_thrice.data();
  const float* sine = pattern_->sine_thrice.data();
  for (std::uint32_t at = 0; at < 3 * pattern_->padded; at += 12) {
    store(out + at, c.part[0] + r.part[0] * load(cosine + at) + f.part[0] * load(sine + at));
    store(out + at + 4, c.part[1] + r.part[1] * load(cosine + at + 4) + f.part[1] * load(sine + at + 4));
    store(out + at + 8, c.part[2] + r.part[2] * load(cosine + at + 8) + f.part[2] * load(sine + at + 8));
  }
  close_ring(out, pattern_->sides);
}

// Writes the normals of a ring that is not round: at right angles to the two directions within the surface, around the
// ring and along the axis. Near the parent, they are blended with the parent's normals.
void TubeWriter::write_normals(const Tube& tube, const Ring& ring, float* out) const {
  const float* cosine = pattern_->cosine.data();
  const float* sine = pattern_->sine.data();
  for (std::uint32_t k = 0; k < pattern_->padded; k += 4) {
    const Four c = load(cosine + k), s = load(sine + k);
    const FourVectors around = sum(glm::vec3(0), ring.forward, c, -ring.right, s);
    const FourVectors along = sum(ring.tangent, ring.right_change, c, ring.forward_change, s);
    FourVectors normal = cross(around, along);
    if (ring.blend > 0) {
      // The parent's normal, shorter within it: zero on its axis, where there is none.
      const FourVectors from_point = sum(ring.centre - tube.parent_point, ring.right, c, ring.forward, s);
      const FourVectors away = perpendicular_part(from_point, tube.parent_direction);
      normal = mix(normal, (1 - ring.blend) / ring.radius, away, ring.blend / tube.parent_radius);
    }
    normal = unit(normal);
    const auto& [x, y, z] = normal;
    store(out + 3 * k, Four{x[0], y[0], z[0], x[1]});
    store(out + 3 * k + 4, Four{y[1], z[1], x[2], y[2]});
    store(out + 3 * k + 8, Four{z[2], x[3], y[3], z[3]});
  }
  close_ring(out, pattern_->sides);
}

// Writes the triangles of a tube: a fan, bands of two triangles a side, a fan; counter-clockwise from outside.
void TubeWriter::write_triangles(std::uint32_t first_pole, std::uint32_t rings) {
  const std::uint32_t row = pattern_->sides + 1;
  const std::uint32_t* band = pattern_->band.data();
  const std::size_t words = pattern_->band.size();
  std::uint32_t ring = first_pole + 1;
  std::uint32_t* out = &stem_.mesh.indices[indices_];
  const auto triangle = [&out](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out[0] = a;
    out[1] = b;
    out[2] = c;
    out += 3;
  };
  for (std::uint32_t k = 0; k < pattern_->sides; ++k) triangle(first_pole, ring + k + 1, ring + k);
  for (std::uint32_t i = 1; i < rings; ++i, ring += row, out += 6 * pattern_->sides) {
    const FourWords base{ring, ring, ring, ring};
    for (std::uint32_t k = 0; k < words; k += 4) store(out + k, load(band + k) + base);
  }
  const std::uint32_t last_pole = ring + row;
  for (std::uint32_t k = 0; k < pattern_->sides; ++k) triangle(last_pole, ring + k, ring + k + 1);
  indices_ += rings * pattern_->sides * 6;
}

}  // namespace panicle
